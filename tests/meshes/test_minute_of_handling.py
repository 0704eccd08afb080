# SPDX-License-Identifier: BSD-3-Clause
"""A probe on the spleen and a grasper at the kidney stone, for a minute: no alarm and no drift."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate import scenario
from palpate.assessment.hand import Hand
from palpate.assessment.publish import read_assessment, with_assessment
from palpate_meshes.catalogue import PUBLISHED
from stone_hands import ASIDE, BEFORE_MOUTH, CALYX, OUTWARDS, TICK, Driver, Goal, take

MESHES = Path(palpate_meshes.__file__).parent
CYCLE = 3.0
"""[s] of the probe"""
DEPTH, SIDE = 0.004, 0.004
"""[m] The probe is pressed so deep, and drawn aside so far."""
PRESSED = slice(700, 1000)
"""Ticks of a cycle in which it stands still on the tissue, before it is drawn aside."""
AWAY = slice(2800, 2900)
ALIKE = 0.02
"""[-] by which a press of the same place may differ from the first."""
LIFTED = 0.003
"""[m] along the tract"""
SOFTLY = 0.03
"""[m] No grasp, lift or fall takes the stone farther than that from where it lay."""


def rub(count: int) -> tuple[np.ndarray, str]:
    """[N] (count, ticks of a cycle, 3) under a probe that presses a pole of the spleen, is drawn
    aside and back, and lifted; and the hash of the end."""
    path = MESHES / "scenarios" / "spleen_probe.json"
    made = with_assessment(path, read_assessment(path), scenario.read(PUBLISHED / "spleen.palpate"))
    scene, task = made.scene, scenario.draw_task(made).task
    hand = Hand(scene, task)
    point, normal = hand.find_anchor(task.places[task.steps[0].place])
    across = np.linalg.svd(np.asarray(normal)[None])[2][1]
    frames = [
        palpate.KeyFrame(
            number * CYCLE + time,
            hand.surface.above(point, normal, height) + side * across,
        )
        for number in range(count)
        for time, height, side in (
            *((0.0, 0.015, 0.0), (0.5, -DEPTH, 0.0), (1.0, -DEPTH, 0.0), (1.5, -DEPTH, SIDE)),
            *((2.0, -DEPTH, 0.0), (2.4, 0.015, 0.0)),
        )
    ]
    device, world, felt = palpate.ScriptedDevice(frames), palpate.World(scene), []
    for tick in range(round(count * CYCLE * scene.rate)):
        felt.append(palpate.tick(scene, device.read(tick * TICK), TICK, world).force)
        assert not world.alarm, (tick, world.alarm)
    return np.array(felt).reshape(count, -1, 3), palpate.compute_hash(world)


def check_rubbed(felt: np.ndarray) -> None:
    pressed = np.linalg.norm(felt[:, PRESSED], axis=2)
    assert pressed.min() > 0.02
    assert (np.ptp(pressed[:, -100:], axis=1) < 0.01 * pressed.mean(axis=1) + 1e-3).all()
    means = pressed.mean(axis=1)
    assert (np.abs(means - means[0]) < ALIKE * means[0]).all(), means
    assert np.abs(felt[:, AWAY]).max() == 0.0


@pytest.mark.landing
def test_a_probe_presses_and_rubs_a_spleen_with_the_same_bits_each_time():
    felt, found = rub(1)
    check_rubbed(felt)
    assert rub(1)[1] == found


@pytest.mark.verify
def test_a_minute_of_rubbing_has_no_alarm_and_no_drift():
    check_rubbed(rub(round(60.0 / CYCLE))[0])


def lift_and_put_back(stone: np.ndarray) -> list[Goal]:
    """In from before the mouth, the stone out of the calyx and back to where it lay, and out."""
    around = stone - 0.002 * OUTWARDS + (0.0, 0.0, 0.001)
    return [
        *take(stone),
        Goal(CALYX + 0.004 * OUTWARDS, speed=0.02, stay=0.3),
        Goal(around, speed=0.02, stay=0.3),
        Goal(around, closed=False, stay=0.3),
        Goal(CALYX + 0.014 * OUTWARDS, closed=False),
        Goal(BEFORE_MOUTH, closed=False),
    ]


def handle_stone(cycles: int, seconds: float) -> tuple[list[bool], str]:
    """Which of the grasps have drawn the stone out of where it lay, up to `cycles` of them or
    `seconds` [s]; and the hash of the end."""
    path = MESHES / "scenarios" / "kidney_stone_removal.json"
    organ = scenario.read(MESHES / "scenes" / "kidney_stone_removal.palpate")
    scene = with_assessment(path, read_assessment(path), organ).scene
    world = palpate.World(scene)
    parked = palpate.HapticSample(position=ASIDE)
    driver = Driver(BEFORE_MOUTH, [Goal(BEFORE_MOUTH, stay=1.0)])
    driver.turn = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    held: list[bool] = []
    lain = lies = None
    while True:
        if not driver.goals:
            at = np.array(world.rigid[0].position)
            lain = at if lain is None else lain
            assert np.linalg.norm(at - lain) < SOFTLY, (world.tick_count, at, lain)
            if len(held) == cycles or world.tick_count * TICK > seconds:
                return held, palpate.compute_hash(world)
            lies = at
            driver.goals = lift_and_put_back(at)
            driver.left = driver.goals[0].stay
        lifts = len(driver.goals) == 5
        samples = [driver.move(), parked]
        commands = palpate.tick(scene, samples, TICK, world)
        assert not world.alarm, (world.tick_count, world.alarm)
        assert np.isfinite(commands[0].force).all()
        if lifts and len(driver.goals) == 4:
            drawn = (np.asarray(world.rigid[0].position) - lies) @ OUTWARDS
            held.append(bool(drawn > LIFTED))


@pytest.mark.verify
def test_a_stone_is_lifted_and_put_back_with_the_same_bits_each_time():
    held, found = handle_stone(1, 60.0)
    assert held == [True]
    assert handle_stone(1, 60.0)[1] == found


@pytest.mark.verify
def test_a_minute_of_a_grasper_at_the_stone_has_no_alarm():
    held, _ = handle_stone(1000, 60.0)
    assert sum(held) > 0.8 * len(held), held
