# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes damaged in twelve ways are repaired by Repair all, back to their volume."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from damaged_shapes import COPIES, DAMAGES, SHAPES, compute_volume, damage
from foreign_files import write_obj
from palpate.cli.main import main
from palpate_editor.authoring import inspect_mesh
from palpate_editor.check import assess
from palpate_editor.document import EMPTY, Organ, Surface, phrase
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.document.problems import Problem
from palpate_editor.edits import EditError, RepairAll, import_file
from palpate_editor.edits.inspected import mesh_of
from palpate_editor.edits.ladder import State, climb, find_left
from palpate_editor.repair_all import repair_problems
from palpate_meshes.generate import ellipsoid

CLOSE = 0.01
"""[-] of the volume."""
SEEDS = range(6)
SAMPLE = [
    *(("sphere", name) for name in ("holes", "crossed", "non-manifold edge", "T-junctions")),
    *(("torus", name) for name in ("one face missing", "unwelded", "doubled")),
    *(("spleen", name) for name in ("scale 1000", "flipped")),
]


def repair(shape: str, name: str, seed: int, folder: Path) -> Organ:
    path = folder / f"{seed}.obj"
    write_obj(path, *damage(shape, name, seed))
    imported = import_file(path)(EMPTY)
    return climb(imported).organ


def find_fault(shape: str, name: str, organ: Organ) -> str:
    """What is wrong with a shape that was repaired; empty where nothing is."""
    report = inspect_mesh(mesh_of(organ.surface))
    if not report.closed or report.non_manifold_edges or not report.outward:
        return f"{len(report.border_loops)} holes, outward {report.outward}"
    if report.self_intersecting_faces:
        return f"{report.self_intersecting_faces} crossing"
    whole = 1e-3 * COPIES.get(name, 1.0) * compute_volume(*SHAPES[shape]())
    ratio = report.volume_ml / whole
    return "" if abs(ratio - 1.0) < CLOSE else f"volume {ratio:.4f}"


@pytest.mark.parametrize(("shape", "name"), SAMPLE)
def test_a_damaged_shape_gets_its_volume_back(shape, name, tmp_path):
    assert find_fault(shape, name, repair(shape, name, 0, tmp_path)) == ""


@pytest.mark.landing
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("name", DAMAGES)
def test_every_damage_of_every_shape_is_mended(shape, name, tmp_path):
    faults = {seed: find_fault(shape, name, repair(shape, name, seed, tmp_path)) for seed in SEEDS}

    assert not any(faults.values()), faults


def organ_of(x: np.ndarray, t: np.ndarray) -> Organ:
    surface = Surface(1e-3 * x, t)
    return replace(EMPTY.with_surface(surface), imported=surface)


def test_what_nobody_cleaned_before_is_mended_too():
    """A surface that came past the import: soup of triangles, some doubled."""
    x, t = damage("sphere", "unwelded", 0)
    organ = organ_of(x, np.concatenate([t, t[:40]]))

    found = climb(organ)

    assert find_fault("sphere", "unwelded", found.organ) == ""
    assert found.left == ()
    assert {rung.title for rung in found.rungs} >= {"Clean up", "Stitch borders"}


def test_each_rung_says_what_it_did_and_nothing_says_nothing():
    rungs = climb(organ_of(*damage("sphere", "holes", 1))).rungs

    [filled] = [rung for rung in rungs if rung.title == "Fill holes"]
    assert any("holes, now 0" in text for text in filled.did)
    assert any(text.startswith("closed now, volume") for text in filled.did)
    with pytest.raises(EditError, match="nothing to repair"):
        RepairAll()(organ_of(*SHAPES["sphere"]()))


def test_the_mouth_of_a_bowl_and_the_rim_of_a_sheet_are_no_damage():
    x, t = SHAPES["sphere"]()
    bowl = organ_of(x, t[x[t].mean(axis=1)[:, 2] < 0.0])

    found = climb(bowl)

    assert len(palpate.find_border_loops(found.organ.surface.triangles)) == 1
    assert any("hollow" in text for text in found.left)


def test_holes_that_no_patch_fits_are_told_from_those_that_are_no_damage():
    x, t = ellipsoid(200)
    bowl = organ_of(x, t[(x[t].mean(axis=1) - x.mean(axis=0))[:, 2] < 0.0])

    (no_damage,) = find_left(State.of(bowl))
    (no_patch,) = find_left(State.of(organ_of(x, t[1:])))

    assert str(no_damage).startswith("1 holes that are no damage: a hollow organ")
    assert str(no_patch).startswith("1 small holes that no patch fits")


def find_problems_of(organ: Organ) -> tuple[Problem, ...]:
    return assess(organ).problems


def nest(*shapes: tuple[float, int]) -> Organ:
    """One shape in these sizes about one place, that faces outwards where 1 stands beside it."""
    x, t = ellipsoid(200)
    faces = [(t if out > 0 else t[:, ::-1]) + i * len(x) for i, (_, out) in enumerate(shapes)]
    middle = x.mean(axis=0)
    places = [middle + size * (x - middle) for size, _ in shapes]
    return organ_of(np.vstack(places), np.vstack(faces))


def test_a_part_inside_an_organ_that_faces_outwards_too_is_dropped():
    organ = nest((1.0, 1), (0.5, 1))

    found = climb(organ)

    assert [rung.title for rung in found.rungs] == ["Drop pieces that are counted twice"]
    assert len(found.organ.surface.triangles) == len(organ.surface.triangles) // 2
    assert found.left == ()


def test_what_counts_twice_is_said_and_a_cavity_does_not():
    (said,) = (p for p in find_problems_of(nest((1.0, 1), (0.5, 1))) if p.key == "inner")
    (cavity,) = (p for p in find_problems_of(nest((1.0, 1), (0.5, -1))) if p.key == "inner")

    assert "1 of them face outwards too: they count twice in the volume" in str(said.got)
    assert "twice" not in str(cavity.got)


def test_filling_warns_of_what_it_leaves_hollow(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", nest((1.0, 1), (0.5, 1)))

    assert main(["fill", str(tmp_path / "a.organ"), "--tetrahedra", "500"]) == 0

    assert "are filled hollow" in capsys.readouterr().out


def test_a_cavity_and_what_lies_in_it_are_kept():
    assert climb(nest((1.0, 1), (0.5, -1))).rungs == ()
    assert climb(nest((1.0, 1), (0.5, -1), (0.2, 1))).rungs == ()


def test_a_hollow_organ_keeps_its_holes():
    organ = organ_of(*damage("sphere", "one face missing", 0))
    hollow = replace(organ, material=replace(organ.material, wall_thickness=0.002))

    assert inspect_mesh(mesh_of(climb(hollow).organ.surface)).border_loops == [3]
    assert inspect_mesh(mesh_of(climb(organ).organ.surface)).closed


def test_the_verb_does_the_same_and_a_dry_run_writes_nothing(tmp_path, capsys):
    path, out = tmp_path / "a.obj", tmp_path / "b.organ"
    write_obj(path, 1e-3 * damage("sphere", "crossed", 0)[0], damage("sphere", "crossed", 0)[1])

    assert main(["repair", str(path), "--all", "--dry-run", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["out"] is None and "Remove crossings" in told["done"]
    assert main(["repair", str(path), "--all", "-o", str(out), "--json"]) == 0
    again = json.loads(capsys.readouterr().out)
    assert again["steps"] == told["steps"] and again["left"] == []
    assert find_fault("sphere", "crossed", read_organ(out)) == ""
    assert main(["repair", str(path), "--all"]) == 1
    assert "--dry-run" in capsys.readouterr().err


def test_a_fix_that_is_refused_loses_nothing_of_what_was_repaired():
    x, t = SHAPES["torus"]()
    organ = organ_of(x, t[:, ::-1])

    def refuse(problem: Problem, organ: Organ) -> Organ:
        raise EditError(phrase("It stays."))

    assessment, done = repair_problems(organ, apply=refuse)

    assert done == [] and "inward" in {problem.key for problem in assessment.problems}
    assert repair_problems(organ)[1][0] == "Turn triangles outward"
    with pytest.raises(EditError, match="It stays"):
        repair_problems(organ, ["inward"], apply=refuse)


def test_a_wrap_that_gave_up_is_told(monkeypatch):
    x, t = SHAPES["torus"]()
    spiral = np.concatenate([x, x[:, [2, 0, 1]]])
    organ = organ_of(spiral, np.concatenate([t, t[:-1] + len(x)]))
    monkeypatch.setattr("palpate_editor.edits.wrap.SECONDS", 0.0)

    left = climb(replace(organ, material=replace(organ.material, wall_thickness=0.002))).left

    assert any("was not finished in 0 s" in text for text in left), left
