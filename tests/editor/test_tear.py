# SPDX-License-Identifier: GPL-3.0-or-later
"""Tissue that tears where instruments stretch it too far: document, verb, published file, task."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from organs import surface_of
from palpate import scenario
from palpate.cli.main import main
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.files import pack_organ, read_organ, unpack_organ, write_organ
from palpate_editor.edits import FixLowest

SAID = "tear_stretch"


@pytest.fixture
def organ() -> Organ:
    surface = surface_of(300)
    return FixLowest(0.1)(replace(EMPTY.with_surface(surface), imported=surface))


def tearing(organ: Organ, stretch: float = 1.6, kind: str = "mass_spring") -> Organ:
    return replace(organ, model=replace(organ.model, tear_stretch=stretch, kind=kind))


def test_the_verb_says_where_tissue_tears_and_the_published_file_has_it(organ, tmp_path, capsys):
    file, published = tmp_path / "organ.organ", tmp_path / "organ.palpate"
    write_organ(file, organ)

    assert main(["material", str(file), "--tear-stretch", "1.6", "-o", str(file), "--json"]) == 0
    capsys.readouterr()
    assert main(["publish", str(file), "-o", str(published), "--title", "Tearing"]) == 0

    assert read_organ(file).model == tearing(organ).model
    assert scenario.read(published).scene.bodies[0].tear_stretch == 1.6


def test_a_file_of_tissue_that_does_not_tear_is_as_it_was_before_any_did(organ):
    content, arrays = pack_organ(organ)
    torn, _ = pack_organ(tearing(organ))

    assert SAID not in content["model"] and torn["model"][SAID] == 1.6
    content = json.loads(json.dumps(content))
    assert unpack_organ(content, arrays, 16, "old.organ").model == organ.model


@pytest.mark.parametrize("stretch", ["0.9", "-1", "11"])
def test_a_stretch_at_which_nothing_could_tear_is_refused(organ, tmp_path, capsys, stretch):
    file, published = tmp_path / "organ.organ", tmp_path / "organ.palpate"
    write_organ(file, organ)

    said = main(["material", str(file), f"--tear-stretch={stretch}", "-o", str(file)])
    said = said or main(["publish", str(file), "-o", str(published), "--title", "Tearing"])

    assert said != 0 and not published.exists()
    assert "tear" in capsys.readouterr().err


def test_tetrahedra_at_finite_strain_do_not_tear_and_the_verb_says_so(organ, tmp_path, capsys):
    file = tmp_path / "organ.organ"
    write_organ(file, organ)

    words = ["--kind", "neo-hookean", "--tear-stretch", "1.6"]
    assert main(["material", str(file), *words, "-o", str(file)]) != 0
    assert "--tear-stretch: got 1.6" in capsys.readouterr().err


def test_tissue_that_relaxes_does_not_tear_as_well(organ):
    both = tearing(organ)
    both = replace(both, model=replace(both.model, relaxation=0.5))

    with pytest.raises(ValueError, match="tear_stretch: got 1.6 of a tissue that relaxes"):
        compile_organ(both)


@pytest.mark.parametrize("kind", ["mass_spring", "molecular"])
def test_a_scene_has_it(organ, kind):
    assert compile_organ(tearing(organ, kind=kind)).bodies[0].tear_stretch == 1.6
    assert compile_organ(organ).bodies[0].tear_stretch == 0.0
