# SPDX-License-Identifier: BSD-3-Clause
"""What organs bear: no press, flick or pull ends a run while the simulation is sound."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.runs.press import find_place, find_top
from palpate.runs.run import read_scene
from palpate_editor.shipped import list_organs
from scripted_hands import SPRINGS, find_scattered_place, open_organ_scene, press, pull
from tiers import keep_everyday

ORGANS = [entry.name for entry, _ in list_organs()]
EVERYDAY = ("gallbladder", "spleen")
"""A wall and a solid; the others at a landing."""
NONE = palpate.AlarmKind.none
PRESSES, FLICKS = range(100), range(60)
AFTER = 500
"""Ticks of a pull after it was let go by the button."""


def open_springs() -> palpate.Scene:
    return read_scene(SPRINGS / "gallbladder.palpate")


def find_ends(places, **script) -> dict[int, str]:
    """Which of the presses of a gallbladder of springs ended in an alarm, and in which."""
    scene = open_springs()
    felt = {k: press(scene, find_scattered_place(scene, k), **script) for k in places}
    return {k: run.alarm.name for k, run in felt.items() if run.alarm != NONE}


@pytest.mark.landing
def test_a_wall_that_snaps_through_ends_no_press_and_feels_as_with_four_times_the_substeps():
    scene, finer = open_springs(), open_springs()
    finer.bodies[0].substeps, finer.bodies[0].substeps_max = (
        4 * scene.bodies[0].substeps,
        4 * scene.bodies[0].substeps_max,
    )
    place = find_place(scene, np.array([20.06e-3, 2.55e-3, 40.53e-3]))

    coarse, fine = (press(s, place, depth=8e-3) for s in (scene, palpate.build_scene(finer)))

    assert coarse.alarm == fine.alarm == NONE
    # it snaps a tick sooner or later
    assert max(coarse.force) == pytest.approx(max(fine.force), rel=0.02)
    apart = np.abs(np.array(coarse.force) - np.array(fine.force)).mean()
    assert apart < 0.02 * max(fine.force)


@pytest.mark.landing
def test_none_of_five_presses_of_10_mm_ends_for_no_reason():
    # some of those that did
    assert find_ends([20, 40, 51, 69, 84], depth=10e-3) == {}


@pytest.mark.landing
def test_none_of_three_flicks_of_12_mm_at_1_m_s_ends_for_no_reason():
    assert find_ends(FLICKS[::20], depth=12e-3, speed=1.0) == {}


@pytest.mark.verify
def test_none_of_a_hundred_presses_of_10_mm_ends_for_no_reason():
    assert find_ends(PRESSES, depth=10e-3) == {}


@pytest.mark.verify
def test_none_of_sixty_flicks_of_12_mm_at_1_m_s_ends_for_no_reason():
    assert find_ends(FLICKS, depth=12e-3, speed=1.0) == {}


RIGID = "kidney_stone"
"""Gives nowhere, so that a hand 20 mm up pulls harder than any grip holds."""


def check_pull(name: str, place_number: int | None, hold: float) -> None:
    """It is held to the end, or slips off at the hand's largest force, and lets go in 30 ms."""
    scene = open_organ_scene(name)
    at = find_top(scene) if place_number is None else find_scattered_place(scene, place_number)

    felt = pull(scene, at, height=20e-3, hold=hold)

    assert felt.alarm == NONE, (name, place_number)
    force, held = np.array(felt.force), np.array(felt.held)
    assert held.any() and not held[-1]
    released = int(np.flatnonzero(held)[-1])
    load = force[released - 40 : released + 1].max()
    slipped = released < len(held) - AFTER
    assert not slipped or load == pytest.approx(scene.instruments[0].coupling.force_max), (
        name,
        place_number,
    )
    assert not slipped or name == RIGID or place_number is not None
    assert np.diff(force[released - 40 :]).min() > -0.1 * max(load, 0.1)


@pytest.mark.parametrize("name", keep_everyday(ORGANS, EVERYDAY))
def test_an_organ_bears_a_pull_of_20_mm_and_lets_go_without_a_kick(name):
    check_pull(name, None, hold=1.0)


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_an_organ_bears_being_held_20_mm_up_for_ten_seconds(name):
    for number in (None, 1, 2, 3):
        check_pull(name, number, hold=10.0)


@pytest.mark.verify
@pytest.mark.parametrize("speed", [0.2, 1.0, 3.0])
@pytest.mark.parametrize("name", ORGANS)
def test_a_hand_that_jerks_an_organ_away_ends_no_run(name, speed):
    scene = open_organ_scene(name)
    for number in range(8):
        place = find_scattered_place(scene, number)

        felt = pull(scene, place, height=0.15, hold=0.1, speed=speed)

        assert felt.alarm == NONE, number


@pytest.mark.landing
@pytest.mark.parametrize(
    ("name", "number", "speed"), [("kidney", 1, 3.0), ("kidney", 3, 3.0), ("stomach", 6, 1.0)]
)
def test_the_jerks_that_have_ended_a_run_end_none(name, number, speed):
    scene = open_organ_scene(name)

    felt = pull(scene, find_scattered_place(scene, number), height=0.15, hold=0.1, speed=speed)

    assert felt.alarm == NONE


@pytest.mark.landing
@pytest.mark.parametrize(
    "name",
    [
        "stomach",
        *(pytest.param(name, marks=pytest.mark.landing) for name in ("gallbladder", "liver")),
    ],
)
def test_a_hand_that_pulls_on_and_on_slips_off(name):
    scene = open_organ_scene(name)

    felt = pull(scene, find_scattered_place(scene, 3), height=0.15, hold=0.2)

    force, held = np.array(felt.force), np.array(felt.held)
    assert felt.alarm == NONE
    slipped = int(np.flatnonzero(held)[-1])
    assert slipped < len(held) - AFTER - 200  # before it is let go
    assert force.max() <= scene.instruments[0].coupling.force_max * (1 + 1e-9)
    assert force[slipped - 40] > 0.8 * scene.instruments[0].coupling.force_max
    assert force[slipped + 1 :].max() < 1e-3
    assert np.diff(force[slipped - 40 : slipped + 1]).min() > -0.1 * force[slipped - 40]
