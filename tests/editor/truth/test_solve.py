# SPDX-License-Identifier: GPL-3.0-or-later
"""Truths as they are solved: beside formulas, beside the references that ship, and stopped."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from palpate.study.contact_reference import Case, read_contact_reference
from palpate.study.half_space import compute_sphere_force
from palpate.study.truth import Truth
from palpate_editor.truth import solve
from palpate_editor.truth.levels import MOST_MEMORY, Station, TooLarge, estimate_memory
from palpate_editor.truth.paths import Way
from palpate_editor.truth.progress import Progress, Stopped

sys.path.insert(0, str(Path(__file__).parents[2] / "references"))
from contact_bodies import Pressed, build_blocks, build_layer, press_box  # noqa: E402

RADIUS = 3e-3
SMALL, BALL = (0.04, 0.04, 0.02), 5e-3
"""[m] Of a block that is solved in seconds, and of a ball for it."""


def find_way(pressed: Pressed, radius: float) -> Way:
    return Way("press", (pressed.spots[0].stand(pressed.subject, radius),), 1.0, "radius")


def build_small() -> Pressed:
    return press_box("small", SMALL, {"middle": (0.0, 0.0)}, ((3, 3, 2), (4, 4, 2), (4, 4, 3)))


@cache
def solve_small() -> tuple[Truth, list[Progress]]:
    """The two coarser meshes."""
    pressed, said = build_small(), []
    truth = solve.solve_way(
        pressed.subject, find_way(pressed, BALL), BALL, np.array([0.5e-3, 1e-3]), "small",
        said.append, finest=1,
    )  # fmt: skip
    return truth, said


def read_case(name: str, place: str) -> Case:
    cases = read_contact_reference(name).list_cases("linear")
    return next(case for case in cases if case.place == place and case.radius == RADIUS)


def test_a_ball_on_a_block_feels_nearly_what_theory_says_of_a_layer():
    truth, _ = solve_small()

    # a little less: a ball is beside a paraboloid, and the block ends
    for depth, force in zip(truth.depth, truth.force[0], strict=True):
        layer = compute_sphere_force(depth, BALL, SMALL[2], 5e3, 0.45)
        assert 0.94 * layer < force < 1.02 * layer
    # narrower than Hertz has it, for what the base holds back
    part = truth.contact_radius[0] / np.sqrt(BALL * truth.depth)
    assert (part > 0.7).all() and (part < 1.02).all()


def test_the_surface_is_displaced_and_not_where_it_is_held():
    truth, _ = solve_small()

    held = truth.surface[:, 2] < 1e-6
    assert held.any() and not held.all()
    assert np.abs(truth.displacement[0][:, held]).max() == 0.0
    # the block's surface has beside those the corners of its upper face, far from the ball
    far = np.linalg.norm(truth.displacement[0][:, ~held], axis=2)
    assert (far > 0.0).all()
    assert (far < 0.1 * truth.depth[:, None]).all()
    assert (truth.displacement_error < 0.01).all()


def test_progress_names_every_stage_of_every_mesh_and_ends_at_all_of_it():
    _, said = solve_small()

    assert [p.fraction for p in said] == sorted(p.fraction for p in said)
    assert said[-1].fraction == pytest.approx(1.0)
    for level in (0, 1):
        stages = [p.stage for p in said if p.level == level]
        assert list(dict.fromkeys(stages)) == ["mesh", "stiffness", "factor", "response"]
    assert said[0].left is None and said[-1].left == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("calls", [0, 1, 2, 4])
def test_a_truth_is_stopped_between_stages_and_within_them(calls):
    pressed = build_small()
    left = iter([False] * calls + [True])

    with pytest.raises(Stopped):
        solve.solve_way(
            pressed.subject, find_way(pressed, BALL), BALL, np.array([1e-3]), "", None,
            lambda: next(left),
        )  # fmt: skip


def test_what_does_not_fit_into_memory_is_not_begun(monkeypatch):
    pressed = build_small()
    monkeypatch.setattr("palpate_editor.truth.levels.MOST_MEMORY", 1e8)

    with pytest.raises(TooLarge, match="freedoms, which takes .* GB, expected at most 0.1 GB"):
        solve.solve_way(pressed.subject, find_way(pressed, BALL), BALL, np.array([1e-3]), "")


def test_a_mesh_of_what_a_machine_has_may_have_two_hundred_thousand_freedoms():
    assert estimate_memory(200_000) < MOST_MEMORY < estimate_memory(400_000)


@pytest.mark.landing
def test_a_finer_mesh_that_does_not_fit_leaves_the_coarser_one_with_its_error(monkeypatch):
    pressed = build_small()
    monkeypatch.setattr(solve, "CHANGE", 0.0)
    whole = solve.solve_level

    def solve_some(subject, stations, radius, depths, level, watch, before):
        if level == 2:
            raise TooLarge("truth: got a large mesh")
        return whole(subject, stations, radius, depths, level, watch, before)

    monkeypatch.setattr(solve, "solve_level", solve_some)
    truth = solve.solve_way(pressed.subject, find_way(pressed, BALL), BALL, np.array([1e-3]), "")

    assert truth.remarks[0] == "not solved on the finest mesh: truth: got a large mesh"
    assert truth.remarks[1].startswith("the last refinement of the mesh still changed a force by ")


@pytest.mark.landing
def test_a_ball_in_a_block_feels_what_the_reference_that_ships_says():
    pressed, case = build_blocks(), read_case("block", "middle")
    depths = np.array([result.depth for result in case.results])

    truth = solve.solve_way(pressed.subject, find_way(pressed, RADIUS), RADIUS, depths, "")

    for k, result in enumerate(case.results):
        assert truth.force[0, k] == pytest.approx(result.force, rel=result.force_error)
        assert truth.contact_radius[0, k] == pytest.approx(result.contact_radius, rel=0.03)
        assert truth.force_error[0, k] < 0.03


@pytest.mark.landing
def test_a_layer_gives_what_theory_gives_it():
    """Of a paraboloid: a ball differs from one by more than the solver is off beyond R / 8."""
    pressed = build_layer()
    depths = RADIUS * np.array([1 / 32, 1 / 16, 1 / 8])
    truth = solve.solve_way(pressed.subject, find_way(pressed, RADIUS), RADIUS, depths, "")

    for depth, force in zip(depths, truth.force[0], strict=True):
        assert force == pytest.approx(
            compute_sphere_force(depth, RADIUS, 0.02, 5e3, 0.45), rel=0.03
        )


@pytest.mark.landing
@pytest.mark.parametrize("name", ["kidney", "spleen"])
def test_an_organ_that_ships_feels_as_its_reference_says(name):
    from palpate_editor.open_organ import open_organ
    from palpate_editor.truth.subject import take_subject
    from palpate_meshes.catalogue import PUBLISHED

    place, case = read_contact_reference(name).find_place("top"), read_case(name, "top")
    subject = take_subject(open_organ(PUBLISHED / f"{name}.palpate"))
    station = Station(np.array(place.point), np.array(place.direction), case.touch, place.thickness)
    depths = np.array([result.depth for result in case.results])
    truth = solve.solve_way(subject, Way("press", (station,), 1.0, ""), RADIUS, depths, "")

    for result, force in zip(case.results, truth.force[0], strict=True):
        assert force == pytest.approx(result.force, rel=0.03)
