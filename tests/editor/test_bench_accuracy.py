# SPDX-License-Identifier: GPL-3.0-or-later
"""What `./run bench --accuracy` compares: the work, its gate, its tables, and ours; no clock."""

from __future__ import annotations

import json
import math
import sys
from dataclasses import asdict
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.study.contact_reference import read_contact_file

BENCH = Path(__file__).resolve().parents[1] / "bench"
sys.path[:0] = [str(BENCH / "accuracy"), str(BENCH / "peers")]

import accuracy_chart  # noqa: E402
import accuracy_table  # noqa: E402
import compare_accuracy  # noqa: E402
import organ_meshes as meshes  # noqa: E402
import palpate_tissue  # noqa: E402
import work as common  # noqa: E402
import write_work  # noqa: E402
from ladder import LADDER, SOLID, WALL, Entry, Try, tries  # noqa: E402

SQUARE = np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]])
FACES = np.array([[0, 1, 2], [0, 2, 3]])


def make_work(**more: object) -> common.Work:
    known: dict = {
        "name": "plain",
        "title": "plain",
        "shipped": "none",
        "young_modulus": 5e3,
        "poisson_ratio": 0.45,
        "density": 1000.0,
        "wall_thickness": None,
        "radius": 5e-3,
        "point": (0.0, 0.0, 0.0),
        "direction": (0.0, 0.0, 1.0),
        "depths": (1e-3, 2e-3),
        "forces": (0.01, 0.03),
    }
    return common.Work(**{**known, **more})


def test_the_ball_touches_after_the_approach_and_rests_at_every_depth():
    work = make_work()
    touch = 5e-3

    def sunk(moment: float) -> float:
        return touch - work.place(moment, touch)[2]

    assert sunk(0.0) == pytest.approx(-common.CLEARANCE)
    assert sunk(common.APPROACH) == pytest.approx(0.0, abs=1e-12)
    first = common.APPROACH + common.RAMP
    assert sunk(first) == sunk(first + common.HOLD) == pytest.approx(1e-3)
    assert sunk(work.duration) == pytest.approx(2e-3)


def test_force_is_read_at_the_ends_of_the_holds_alone():
    work = make_work()
    end = common.APPROACH + common.RAMP + common.HOLD

    assert work.find_hold(end) == 0
    assert work.find_hold(end - 0.99 * common.READ) == 0
    assert work.find_hold(end - 1.01 * common.READ) is None
    assert work.find_hold(end + 1e-3) is None
    assert work.find_hold(work.duration) == 1


def test_a_plane_is_touched_by_its_faces_sooner_than_by_its_corners():
    body = meshes.Body(make_work(shipped="spleen"), np.array([0]))
    faces, vertices = body.find_touches(1e-3 * SQUARE, FACES)

    assert faces == pytest.approx(5e-3)
    # the corners are sqrt(2) mm aside
    assert vertices == pytest.approx(math.sqrt(25e-6 - 2e-6))
    assert body.find_touches(1e-3 * SQUARE, FACES, 1e-3)[0] == pytest.approx(6e-3)


def test_a_press_reads_a_spring_as_what_it_is_and_counts_every_step_in_touch():
    work, dt, touch = make_work(), 1e-3, 5e-3
    stiffness, height = 10.0, [touch]

    def step(centre: np.ndarray) -> None:
        height[0] = float(centre[2])

    def force() -> float:
        return stiffness * max(touch - height[0], 0.0)

    rest = np.zeros((1, 3))
    row = common.press(common.Engine(step, force, lambda: rest), work, rest, touch, dt)

    assert row["forces"] == pytest.approx([0.01, 0.02])
    assert row["steps"] == round((work.duration - common.APPROACH) / dt)
    assert common.compute_errors(work, row["forces"]) == pytest.approx([0.0, -1.0 / 3.0])


def test_a_body_that_flies_away_is_a_wreck_and_no_row():
    work, rest = make_work(), np.zeros((1, 3))
    engine = common.Engine(lambda _: None, lambda: 0.0, lambda: rest + np.nan)

    assert common.press(engine, work, rest, 5e-3, 1e-3)["why"].startswith("blew up")


@pytest.mark.parametrize(
    ("errors", "passed"),
    [([0.1, -0.1], True), ([0.0, 0.1001], False), ([-0.11, 0.0], False), ([0.03, 0.0], True)],
)
def test_a_force_counts_only_within_a_tenth_at_both_depths(errors, passed):
    assert common.passes({"errors": errors}) is passed


def test_a_run_without_a_force_does_not_count():
    assert not common.passes({"why": "given up"})


def test_newtons_constants_give_tissue_of_lames_constants_in_small_strain():
    mu, lam = common.find_lame(make_work())
    k_mu, k_lambda = common.convert_for_newton(mu, lam)

    def stress(f: np.ndarray) -> np.ndarray:
        volume = np.linalg.det(f)
        part = k_mu * f * (1.0 - 1.0 / ((f**2).sum() + 1.0))
        rest = 1.0 + 0.75 * k_mu / k_lambda
        return part + k_lambda * (volume - rest) * volume * np.linalg.inv(f).T

    h = 1e-5 * np.array([[1.0, 0.3, -0.2], [0.1, -0.5, 0.4], [0.6, 0.2, 0.7]])
    one = np.eye(3)
    expected = mu * (h + h.T) + lam * np.trace(h) * one
    np.testing.assert_allclose(stress(one), 0.0, atol=1e-9)
    np.testing.assert_allclose((stress(one + h) - stress(one - h)) / 2.0, expected, rtol=1e-6)


def test_the_works_are_the_references_at_their_moduli():
    spleen, reference = write_work.make_work("spleen")
    wall, thin = write_work.make_work("wall")

    assert reference.young_modulus == 10e3
    assert spleen.young_modulus == 5e3
    [case] = [
        c for c in reference.list_cases("linear") if c.place == "outside" and c.radius == 8e-3
    ]
    assert spleen.forces == pytest.approx([0.5 * result.force for result in case.results[:2]])
    assert wall.wall_thickness == 2e-3
    # linear truth of a wall: no deeper than a third of it
    assert wall.depths[-1] < wall.wall_thickness / 3.0
    assert thin.find_place("outside").direction == wall.direction
    assert all(result.force_error < 0.01 for case in thin.cases for result in case.results)


def test_the_wall_stands_on_the_shipped_gallbladder():
    thin = read_contact_file(write_work.HERE / "wall_2mm.json")
    shipped = write_work.SHIPPED / "gallbladder.json"

    assert thin.shape.sha256 == read_contact_file(shipped).shape.sha256
    assert thin.fixed == read_contact_file(shipped).fixed


def test_a_work_is_read_as_it_was_written(tmp_path):
    work = make_work()
    path = tmp_path / "plain.json"
    path.write_text(json.dumps(asdict(work)), encoding="utf-8")

    assert common.read_work(path) == work


@pytest.mark.parametrize("entry", LADDER, ids=lambda entry: entry.engine)
def test_every_engine_is_tried_on_every_work_and_also_quickly(entry):
    assert set(entry.tries) == {*SOLID, *WALL}
    for attempts in entry.tries.values():
        assert any(attempt.quick for attempt in attempts)
    assert (BENCH / "accuracy" / entry.program).is_file()


def row_of(engine: str, work: str, words: str, cost: float, errors: list, dt: float = 1.0) -> dict:
    return {
        "engine": engine,
        "work": work,
        "words": words,
        "cells": 100,
        "dt_ms": dt,
        "errors": errors,
        "cpu_per_second": cost,
        "ratio_to_loop": 10.0 * cost,
        "anchors_apart": 0.0,
        "passes": common.passes({"errors": errors}),
    }


ROWS = [
    row_of("Palpate", "spleen", "600", 0.05, [0.01, 0.01]),
    row_of("Palpate", "spleen", "3000", 0.2, [0.01, 0.01]),
    row_of("Palpate", "spleen_top", "600", 0.04, [0.2, 0.3]),
    row_of("Palpate", "spleen_top", "3000", 0.3, [0.05, 0.09]),
    row_of("MuJoCo", "spleen", "coarse", 0.5, [-0.3, 0.0], 20.0),
    row_of("MuJoCo", "spleen", "fine", 2.0, [0.05, 0.05], 20.0),
    row_of("MuJoCo", "spleen", "fine, short steps", 9.0, [0.04, 0.04], 1.0),
]


def make_report() -> dict:
    works = {name: asdict(make_work(name=name)) for name in ("spleen", "spleen_top")}
    return compare_accuracy.make_report(works, ROWS, [])


def test_the_cheapest_that_passes_counts_and_not_the_cheapest():
    best = make_report()["best"]["spleen"]

    assert best["Palpate"]["any_step"]["words"] == "600"
    assert best["MuJoCo"]["any_step"]["words"] == "fine"
    assert best["MuJoCo"]["one_ms"]["words"] == "fine, short steps"
    assert best["Newton"]["any_step"] is None


def test_at_both_places_it_is_the_same_configuration_and_the_costlier_run():
    both = make_report()["best_at_both_places"]

    assert both["Palpate"]["words"] == "3000"
    assert both["Palpate"]["cpu_per_second"] == 0.3
    assert both["Palpate"]["errors"] == [0.01, 0.01, 0.05, 0.09]
    assert both["MuJoCo"] is None


def test_the_table_says_how_many_times_ours_and_what_came_nearest():
    text = accuracy_table.describe(make_report())

    assert "   40.0   fine\n" in text
    assert "none; nearest: no run came to its end" in text
    assert "none; nearest: 3000" not in text
    assert "* 3000" in text


def test_the_chart_is_drawn_with_engines_that_have_no_row(tmp_path):
    path = tmp_path / "chart.png"

    accuracy_chart.save_accuracy_chart(path, make_report())

    assert path.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def test_an_engine_that_cannot_be_run_is_missing_with_its_sentence(tmp_path, monkeypatch):
    runner = compare_accuracy.Runner("anchor", sys.executable, tmp_path)
    monkeypatch.setattr(runner, "loop", lambda *_: {"median_us": 100.0})
    entry = Entry("Missing", "no_such_engine.py", {name: tries("x") for name in (*SOLID, *WALL)})
    monkeypatch.setattr(compare_accuracy, "LADDER", (entry,))

    rows, missing = compare_accuracy.run_ladder(runner, quick=False)

    assert rows == []
    assert missing[0].startswith("Missing: spleen: no_such_engine.py:")
    assert len(missing) == 3


class Told(compare_accuracy.Runner):
    """A runner whose plain loop and engine answer what they are told."""

    def __init__(self, anchors: list[float], answer: dict):
        self.python, self.folder = sys.executable, Path()
        self.anchors, self.answer, self.asked = anchors, answer, 0

    def loop(self, *_, **__) -> dict:
        return {"median_us": self.anchors.pop(0)}

    def run(self, *_) -> dict:
        self.asked += 1
        return dict(self.answer)


ANSWER = {"cpu_per_second": 0.5, "errors": [0.0, 0.0], "dt_ms": 1.0}


def test_a_run_between_anchors_that_differ_is_done_again_and_its_cost_is_a_ratio():
    runner = Told([100.0, 120.0, 100.0, 100.0], ANSWER)

    row = compare_accuracy.measure(runner, LADDER[0], "spleen", Try(("600",)))

    assert runner.asked == 2
    assert row["anchors_apart"] == 0.0
    assert row["passes"]
    # half a second a second, of a loop of 100 us at 1 kHz
    assert row["ratio_to_loop"] == pytest.approx(5.0)


def feel(name: str, size: int, *words: str) -> list[float]:
    work, _ = write_work.make_work(name)
    row = palpate_tissue.press_organ(work, size, *words)
    return common.compute_errors(work, row["forces"])


@pytest.mark.parametrize("name", SOLID)
def test_ours_is_within_a_tenth_of_the_truth_at_its_cheapest(name):
    assert common.passes({"errors": feel(name, 300, "linear", "facets", "hz:100")})


@pytest.mark.landing
@pytest.mark.parametrize(
    ("name", "size", "words"),
    [
        ("spleen", 300, "linear facets"),
        ("spleen", 600, "facets"),
        ("spleen_top", 300, "linear facets"),
        ("spleen_top", 600, "facets"),
        ("spleen_top", 3000, "facets"),
        ("spleen_top", 12000, "mesh"),
        ("wall", 300, "damping:0.02"),
        ("wall", 400, "damping:0.02"),
        ("wall", 600, "damping:0.02"),
    ],
)
def test_ours_is_within_a_tenth_of_the_truth_where_the_page_says_so(name, size, words):
    assert common.passes({"errors": feel(name, size, *words.split())})


@pytest.mark.landing
def test_a_coarse_solid_is_felt_too_stiff_where_the_spleen_is_thin():
    errors = feel("spleen_top", 1000, "mesh")

    assert min(errors) > common.GATE


@pytest.mark.landing
def test_as_curved_as_vertices_are_the_thin_top_is_just_beyond_the_gate_and_facets_are_not():
    coarse, fine = feel("spleen_top", 600), feel("spleen_top", 2000)
    facets = feel("spleen_top", 600, "facets"), feel("spleen_top", 2000, "facets")

    assert fine == pytest.approx(coarse, abs=0.03)
    assert all(-0.15 < error < -common.GATE for error in (*coarse, *fine))
    assert all(abs(error) < 0.05 for errors in facets for error in errors)


def test_a_word_changes_the_scene_and_another_is_refused():
    work, _ = write_work.make_work("spleen")
    words = ("linear", "facets", "hz:100", "damping:0.02", "sleeps:0.5")

    organ = palpate_tissue.make_work_organ(work, 300, *words)

    assert organ.model.kind == "linear_solid" and organ.model.contact_curvature == "facets"
    assert organ.hand.rate == 100.0 and organ.hand.force_error == pytest.approx(5e-4)
    assert organ.material.damping_ratio == 0.02 and organ.far_field is not None
    for word in ("mesh", "implicit_damping"):
        assert palpate_tissue.make_work_organ(work, 300, word) != organ
    with pytest.raises(ValueError, match="quick"):
        palpate_tissue.make_work_organ(work, 300, "quick")


def test_beside_a_report_others_run_their_cheapest_alone():
    report = {**make_report(), "rows": ROWS}
    entry = Entry("MuJoCo", "mujoco_tissue.py", {"spleen": tries("coarse", "fine", "new")})

    kept = [
        compare_accuracy.find_kept(report, entry, "spleen", attempt)
        for attempt in entry.tries["spleen"]
    ]

    assert kept[0] is not None and kept[0]["errors"] == [-0.3, 0.0] and kept[0]["kept"]
    assert kept[1:] == [None, None]
    assert compare_accuracy.find_kept(report, LADDER[0], "spleen", Try(("600",))) is None
    assert compare_accuracy.find_kept(None, entry, "spleen", Try(("coarse",))) is None


def make_body(name: str) -> meshes.Body:
    work, reference = write_work.make_work(name)
    return meshes.Body(work, np.array(reference.fixed))


def test_a_solids_mesh_is_fine_under_the_ball_and_held_as_the_reference():
    body = make_body("spleen")
    coarse, fine = body.make_mesh("coarse"), body.make_mesh("coarse:2.0:1.1")

    def find_edge(mesh: common.Mesh) -> float:
        corners = mesh.x[mesh.cells]
        near = np.argsort(np.linalg.norm(corners.mean(axis=1) - body.work.point, axis=1))[:8]
        return float(np.linalg.norm(corners[near][:, 0] - corners[near][:, 1], axis=1).mean())

    sides = body.skin.x[body.skin.triangles]
    mass = body.work.density * np.linalg.det(sides).sum() / 6.0
    assert find_edge(fine) < 0.5 * find_edge(coarse)
    for mesh in (coarse, fine):
        corners = mesh.x[mesh.cells]
        assert (np.linalg.det(corners[:, 1:] - corners[:, :1]) > 0.0).all()
        assert len(mesh.held) > 3
        assert mesh.touch_vertices <= mesh.touch_faces
        assert mesh.find_mass(body.work) * len(mesh.x) == pytest.approx(mass, rel=0.05)


def test_a_walls_middle_surface_is_touched_where_its_wall_is():
    body = make_body("wall")
    wall, shell = body.make_mesh("coarse"), body.make_mesh("shell_coarse")

    assert not wall.is_shell and shell.is_shell
    assert len(shell.x) == meshes.WALL_VERTICES["coarse"]
    assert shell.touch_faces == pytest.approx(wall.touch_faces, abs=2e-4)
    assert len(shell.held) > 3
    # of one wall
    total = [mesh.find_mass(body.work) * len(mesh.x) for mesh in (wall, shell)]
    assert total[0] == pytest.approx(total[1], rel=0.05)


def test_a_work_is_written_with_a_mesh_for_every_recipe_that_is_tried(tmp_path, monkeypatch):
    monkeypatch.setattr(write_work, "list_recipes", lambda name: ["shell_coarse", "coarse:1.5:1.1"])

    write_work.write(tmp_path, "wall")

    work = common.read_work(tmp_path / "wall.json")
    assert work == write_work.make_work("wall")[0]
    made = make_body("wall").make_mesh("coarse:1.5:1.1")
    read = common.read_mesh(tmp_path, work, "coarse:1.5:1.1")
    np.testing.assert_array_equal(read.x, made.x)
    np.testing.assert_array_equal(read.held, made.held)
    assert (read.touch_faces, read.touch_vertices) == (made.touch_faces, made.touch_vertices)


def test_recipes_are_those_of_the_other_engines():
    recipes = write_work.list_recipes("wall")

    assert "shell_coarse" in recipes
    assert len(recipes) == len(set(recipes))
    assert not any(recipe.isdecimal() for recipe in recipes)


def test_a_scene_of_ours_has_the_works_ball_and_modulus():
    work, _ = write_work.make_work("wall")

    organ = palpate_tissue.make_work_organ(work, 300, "1e8")

    assert organ.material.young_modulus == 250e3
    assert organ.material.wall_thickness == 2e-3
    assert organ.tool.radius == 5e-3
    assert organ.tool.stiffness == 1e8
    assert organ.vertex_count == 300
    assert palpate.__version__
