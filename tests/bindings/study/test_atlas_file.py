# SPDX-License-Identifier: BSD-3-Clause
"""Atlases of organs as files and pictures: they come back as they were, or are refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import palpate
import pytest
from made_up_atlases import LIMIT, make_atlas
from palpate.files.file_kind import ATLAS, PICTURE, SVG, find_kind
from palpate.files.refusal import Refusal
from palpate.study import atlas as study_atlas
from palpate.study.atlas import NEVER, OWN, Spot
from palpate.study.atlas_file import read_atlas, write_atlas
from palpate.study.atlas_plot import save_atlas
from palpate.study.atlas_words import count_substeps, say_present, say_row
from row_files import check_schema_fields, spoil

SCHEMA = json.loads(
    (Path(palpate.__file__).parent / "schemas" / "atlas.schema.json").read_text(encoding="utf-8")
)


def test_an_atlas_comes_back_as_it_was_written_and_fits_its_schema(tmp_path):
    atlas, path = make_atlas(), tmp_path / "atlas.json"
    write_atlas(path, atlas)

    assert read_atlas(path) == atlas
    assert find_kind(path) == ATLAS
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    jsonschema.Draft202012Validator(SCHEMA).validate(json.loads(path.read_text(encoding="utf-8")))


def test_the_schema_has_every_field_of_an_atlas():
    check_schema_fields(SCHEMA, study_atlas, study_atlas.Atlas)


FAULTS = [
    (lambda d: d.update(format="palpate chart"), "got the chart of an organ, expected an atlas"),
    (lambda d: d.update(version=2), "version"),
    (lambda d: d.pop("present"), "no present"),
    (lambda d: d.update(rows={}), "rows"),
    (lambda d: d.update(rate=0.0), "rate"),
    (lambda d: d["present"].update(step=-1e-3), "present.step"),
    (lambda d: d["present"].update(predicted=0.0), "present.predicted"),
    (lambda d: d["present"].update(kind="jelly"), "present.kind"),
    (lambda d: d["rows"][0].update(number=7), r"rows\[0\].number"),
    (lambda d: d["rows"][0].update(outcome="fine"), "outcome"),
    (lambda d: d["rows"][0].update(reason="none"), "reason"),
    (lambda d: d["rows"][0].update(predicted=None), "predicted"),
    (lambda d: d["rows"][0].update(held=1.0), r"rows\[0\].held"),
    (lambda d: d["rows"][0].update(failed=float("nan")), "a finite number"),
    (lambda d: d["rows"][0]["spot"].update(stiffness=0.0), "spot.stiffness"),
    (lambda d: d["rows"][0]["spot"].update(mesh="huge"), "spot.mesh"),
    (lambda d: d["rows"][0].update(integrator="guess"), "integrator"),
]


@pytest.mark.parametrize(("change", "said"), FAULTS, ids=[said for _, said in FAULTS])
def test_an_atlas_that_does_not_fit_together_is_refused(change, said, tmp_path):
    path = tmp_path / "atlas.json"
    write_atlas(path, make_atlas())
    spoil(path, change)

    with pytest.raises(Refusal, match=said):
        read_atlas(path)


def test_a_number_that_was_changed_is_noticed_by_the_hash(tmp_path):
    path = tmp_path / "atlas.json"
    write_atlas(path, make_atlas())
    spoil(path, lambda d: d["rows"][0].update(held=1e-6), hashed=False)

    with pytest.raises(Refusal, match="sha256"):
        read_atlas(path)


@pytest.mark.parametrize("integrator", ["symplectic_euler", "implicit_euler"])
@pytest.mark.parametrize(("ending", "kind"), [("png", PICTURE), ("svg", SVG)])
def test_an_equal_atlas_is_an_equal_picture(ending, kind, integrator, tmp_path):
    one, other = tmp_path / f"one.{ending}", tmp_path / f"other.{ending}"

    save_atlas(one, make_atlas(integrator=integrator))
    save_atlas(other, make_atlas(integrator=integrator))

    assert find_kind(one) == kind
    assert one.read_bytes() == other.read_bytes()


def test_a_picture_says_the_margin_of_the_scene_and_what_each_method_does(tmp_path):
    save_atlas(tmp_path / "a.svg", make_atlas())

    said = (tmp_path / "a.svg").read_text(encoding="utf-8")

    for words in ("this scene: 0.5 of 1.1 ms used", "2 steps a tick", "swallows 30 %",
                  "Spleen: how long a time step", "it blows up"):  # fmt: skip
        assert words in said


def test_an_atlas_without_rows_is_no_picture(tmp_path):
    with pytest.raises(ValueError, match="no row"):
        save_atlas(tmp_path / "a.png", replace(make_atlas(), rows=()))


def test_rows_are_found_by_what_they_are():
    atlas = make_atlas()
    line = atlas.list_line("solid", "symplectic_euler")

    assert [row.spot.stiffness for row in line] == [0.01, 0.1, 1.0, 10.0, 100.0]
    assert line[2].measured == pytest.approx(1.1 * LIMIT, rel=1e-3)
    assert atlas.find_row(Spot("solid", OWN, "none", "own"), "midpoint").outcome == NEVER
    assert atlas.find_usual("molecular", "xpbd").spot.kind == "molecular"
    assert atlas.find_usual("shell", "xpbd") is None


def test_a_tick_needs_as_many_steps_as_its_limit_and_the_reserve_say():
    atlas = make_atlas()
    row = atlas.find_usual("solid", "symplectic_euler")

    assert count_substeps(row, 1000.0) == 2  # 0.9 of 1 ms is less than a tick
    assert count_substeps(row, 2000.0) == 1
    assert say_row(row, 1000.0) == ("to 1.1 ms", "2 steps a tick")
    assert say_present(atlas.present) == "this scene: 0.5 of 1.1 ms used"
