# SPDX-License-Identifier: GPL-3.0-or-later
"""Tissue that relaxes: chosen for an organ, kept in its files, felt in the tick."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from organs import make_organ
from palpate import scenario
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import pack_organ, read_organ, unpack_organ, write_organ

RATIO, TIME = 0.8, 0.05
DT = 1e-3


@pytest.fixture
def organ():
    """A closed organ of bonds and angles, with home springs, which do not relax."""
    plain = make_organ(imported=None)
    model = replace(plain.model, kind="molecular")
    hand = replace(plain.hand, gravity=(0.0, 0.0, 0.0), force_error=0.0)
    return replace(plain, model=model, hand=hand)


def relaxing(organ, ratio: float = RATIO):
    return replace(organ, model=replace(organ.model, relaxation=ratio, relaxation_time=TIME))


def press_and_hold(scene: palpate.Scene, depth: float, seconds: float) -> np.ndarray:
    """[N] along the normal, per tick, on a hand that goes `depth` into the top and stays."""
    world = palpate.World(scene)
    place = find_top(scene)
    radius = scene.instruments[0].tool.radius
    forces = []
    for tick in range(-60, int(seconds / DT)):
        gone = min((tick + 20) / 20, 1.0) * depth
        position = place.point + (radius - gone) * place.outward
        sample = palpate.HapticSample(time=tick * DT, position=position)
        forces.append(palpate.tick(scene, sample, DT, world).force @ place.outward)
    assert not world.alarm
    return np.array(forces[60:])


def test_a_held_press_fades_to_the_force_of_tissue_without_branches(organ):
    relaxed = press_and_hold(compile_organ(relaxing(organ)), 0.002, 12 * TIME)
    elastic = press_and_hold(compile_organ(organ), 0.002, 12 * TIME)

    assert relaxed[20] > 1.03 * elastic[20] > 0.0
    assert relaxed[20] > relaxed[120] > relaxed[320]
    assert relaxed[-1] == pytest.approx(elastic[-1], rel=1e-4)


def test_the_verb_gives_an_organ_its_relaxation_and_the_published_file_has_it(
    organ, tmp_path, capsys
):
    file, published = tmp_path / "organ.organ", tmp_path / "organ.palpate"
    write_organ(file, organ)
    words = ["--relaxation", "0.8", "--relaxation-time", "0.05s"]

    assert main(["material", str(file), *words, "-o", str(file), "--json"]) == 0
    capsys.readouterr()
    assert main(["publish", str(file), "-o", str(published), "--title", "Relaxing"]) == 0

    assert read_organ(file).model == relaxing(organ).model
    tissue = scenario.read(published).scene.bodies[0].tissue
    assert (tissue.maxwell.ratio, tissue.maxwell.time) == (0.8, 0.05)
    assert "relaxing by 44.4444 % in 0.05 s" in palpate.describe(tissue)


def test_a_document_of_before_is_one_that_does_not_relax(organ):
    content, arrays = pack_organ(organ)
    content = json.loads(json.dumps(content))
    del content["model"]["relaxation"], content["model"]["relaxation_time"]

    model = unpack_organ(content, arrays, 5, "old.organ").model

    assert (model.relaxation, model.relaxation_time) == (0.0, 0.5)


@pytest.mark.parametrize("words", [("--relaxation", "-1"), ("--relaxation-time", "0s")])
def test_a_relaxation_that_no_tissue_has_is_refused(organ, tmp_path, capsys, words):
    file = tmp_path / "organ.organ"
    write_organ(file, organ)

    assert main(["material", str(file), f"{words[0]}={words[1]}", "-o", str(file)]) != 0
    assert words[0].lstrip("-").split("-")[0] in capsys.readouterr().err


def test_what_relaxes_is_moved_whole(organ):
    sleeping = replace(organ, hand=replace(organ.hand, force_error=1e-3))

    with pytest.raises(ValueError, match="a tissue that relaxes"):
        compile_organ(
            relaxing(replace(sleeping, model=replace(sleeping.model, home_stiffness=1e6)))
        )
