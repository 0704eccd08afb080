# SPDX-License-Identifier: BSD-3-Clause
"""The scene of a kidney stone that comes with Palpate: it lies still, and can be taken out."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate import scenario
from palpate.layout.assemble import build, read_assembly
from palpate.layout.layout_file import read_layout
from palpate.layout.publish import make_scenario
from palpate_meshes.generate.collecting_system import ENTRY, MOUTH
from palpate_meshes.stone_scene import PORT, TRAY, TRAY_DEPTH, TRAY_HALF, find_turn, make_tray

SCENES = Path(palpate_meshes.__file__).parent / "scenes"
LAYOUT = SCENES / "kidney_stone_removal.layout.json"
PUBLISHED = SCENES / "kidney_stone_removal.palpate"
TICK = 1e-3
PARKED = palpate.HapticSample(position=(0.2, 0.0, 0.2))

CALYX, TRACT_MOUTH = (1e-3 * find_turn().apply(point) for point in (ENTRY, MOUTH))
OUTWARDS = (TRACT_MOUTH - CALYX) / np.linalg.norm(TRACT_MOUTH - CALYX)
OVER = np.array([TRAY[0], TRAY[1], 0.012])
"""[m] Over the tray."""
CROSSWISE = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
"""[-] How a device is turned so that jaws open above and below the stone."""


@pytest.fixture(scope="module")
def shipped() -> scenario.Scenario:
    return scenario.read(PUBLISHED)


@dataclass
class Goal:
    """Where a hand goes, and what it does with the jaws there."""

    to: np.ndarray
    """[m]"""
    closed: bool
    speed: float = 0.05
    """[m/s]"""
    stay: float = 0.1
    """[s]"""


@dataclass
class Attempt:
    stone: np.ndarray
    """[m] Where it is at the end."""
    wall: float
    """[N] The most with which tissue and stone push each other."""
    felt: float
    """[N] likewise, what the hand has felt."""
    hashes: list[int]
    """Of the world, every tenth of a second."""


def plan(stone: np.ndarray, reach: float = 0.002, put: np.ndarray | None = None) -> list[Goal]:
    """The careful hand: in with closed jaws, open before the stone, `reach` [m] past its middle,
    closed, out, and down into the tray."""
    put = np.array(TRAY) + (0.0, 0.0, 0.009) if put is None else put
    over = np.array([put[0], put[1], OVER[2]])
    before = stone + 0.008 * OUTWARDS + (0.0, 0.0, 0.001)
    around = stone - reach * OUTWARDS + (0.0, 0.0, 0.001)
    return [
        Goal(TRACT_MOUTH + 0.03 * OUTWARDS, True),
        Goal(CALYX + 0.014 * OUTWARDS - (0.0, 0.0, 0.001), True),
        Goal(before, True),
        Goal(before, False, stay=0.2),
        Goal(around, False, speed=0.02),
        Goal(around, True, stay=0.5),
        Goal(CALYX + 0.012 * OUTWARDS, True, speed=0.02),
        Goal(TRACT_MOUTH + 0.03 * OUTWARDS, True),
        Goal(over, True),
        Goal(put, True),
        Goal(put, False, stay=0.5),
        Goal(over, False, stay=0.3),
    ]


def play(scene: palpate.Scene, goals: list[Goal]) -> Attempt:
    world, at = palpate.World(scene), goals[0].to
    for _ in range(1000):  # until the stone lies
        palpate.tick(scene, PARKED, TICK, world)
    attempt, ticks = Attempt(np.zeros(3), 0.0, 0.0, []), 0
    for goal in goals:
        left = goal.stay
        while left > 0.0:
            side = goal.to - at
            far = float(np.linalg.norm(side))
            step = goal.speed * TICK
            at, left = (goal.to, left - TICK) if far <= step else (at + step / far * side, left)
            sample = palpate.HapticSample(
                position=at, orientation=CROSSWISE,
                buttons=palpate.ATTACH_BUTTON if goal.closed else 0,
            )  # fmt: skip
            command = palpate.tick(scene, sample, TICK, world)
            assert not world.alarm, world.alarm
            stone = world.rigid[0]
            attempt.wall = max(attempt.wall, float(np.linalg.norm(stone.tissue_force)))
            attempt.felt = max(attempt.felt, float(np.linalg.norm(command.force)))
            ticks += 1
            if ticks % 100 == 0:
                attempt.hashes.append(palpate.compute_hash(world))
    attempt.stone = np.asarray(world.rigid[0].position)
    return attempt


def is_in_tray(stone: np.ndarray) -> bool:
    off = stone - np.array(TRAY)
    return bool((np.abs(off[:2]) < TRAY_HALF).all() and 0.0 < off[2] < TRAY_DEPTH)


def find_lying(scene: palpate.Scene) -> np.ndarray:
    world = palpate.World(scene)
    for _ in range(1000):
        palpate.tick(scene, PARKED, TICK, world)
    return np.asarray(world.rigid[0].position)


def require_close(made: object, kept: object) -> None:
    """The same but for the last digits of numbers, which are of the processor that summed them."""
    assert type(made) is type(kept), (made, kept)
    if isinstance(made, dict):
        assert made.keys() == kept.keys()
        for name, value in made.items():
            require_close(value, kept[name])
    elif isinstance(made, list):
        assert len(made) == len(kept)
        for one, other in zip(made, kept, strict=True):
            require_close(one, other)
    else:
        assert made == (pytest.approx(kept, rel=1e-12) if isinstance(made, float) else kept)


@pytest.mark.landing
def test_the_scene_is_what_its_layout_publishes(shipped):
    layout = read_layout(LAYOUT).now
    assembly = read_assembly(LAYOUT, layout)

    made = scenario.pack(make_scenario(layout, assembly, build(assembly)))

    kept = scenario.pack(shipped)
    for part in ("rigid", "instruments", "fluid", "gravity"):
        require_close(
            json.loads(made.content)["scene"][part], json.loads(kept.content)["scene"][part]
        )
    assert made.arrays.keys() == kept.arrays.keys()
    for name, rows in made.arrays.items():
        np.testing.assert_allclose(rows, kept.arrays[name], rtol=1e-9, atol=1e-12, err_msg=name)


def test_it_has_a_stone_of_8_to_9_mm_in_water_a_tray_and_a_grasper_through_a_port(shipped):
    scene = shipped.scene
    (stone,), (tray,), (grasper,) = scene.rigid, scene.scenery, scene.instruments

    size = np.ptp(np.asarray(stone.mesh.vertices), axis=0)
    assert 0.008 < size.max() < 0.009
    assert (scene.fluid.density, scene.fluid.viscosity) == (1000.0, 0.001)
    np.testing.assert_allclose(np.asarray(tray.mesh.vertices), make_tray()[0], atol=1e-9)
    assert palpate.compute_euler_number(tray.mesh.triangles) == 2
    assert (grasper.tool.radius, grasper.tool.jaws.grip) == (0.0012, 3.0)
    np.testing.assert_allclose(grasper.trocar, TRACT_MOUTH + PORT * OUTWARDS, atol=1e-6)
    assert shipped.title == "Kidney stone"


def test_its_kidney_is_weightless_and_the_stone_lies_from_the_first_tick_on(shipped):
    (kidney,) = shipped.scene.bodies
    assert kidney.weightless
    world = palpate.World(shipped.scene)
    start = np.asarray(world.rigid[0].position)
    for _ in range(100):
        palpate.tick(shipped.scene, PARKED, TICK, world)

    assert np.linalg.norm(np.asarray(world.rigid[0].position) - start) < 3e-5
    rest = np.asarray(palpate.surface_position(world.bodies[0]))
    sag = rest - np.asarray(palpate.compute_surface(kidney.tissue, kidney.tissue.rest_position))
    assert np.linalg.norm(sag, axis=1).max() < 3e-5


@pytest.mark.verify
def test_the_stone_lies_still_for_a_minute(shipped):
    world, places = palpate.World(shipped.scene), []
    for tick in range(60_000):
        palpate.tick(shipped.scene, PARKED, TICK, world)
        assert not world.alarm, world.alarm
        if tick % 1000 == 999:
            places.append(np.asarray(world.rigid[0].position))

    assert np.linalg.norm(places[0] - CALYX) < 0.008
    assert np.linalg.norm(np.array(places) - places[0], axis=1).max() < 2e-4


@pytest.mark.landing
def test_a_careful_hand_takes_the_stone_out_and_puts_it_into_the_tray(shipped):
    scene = shipped.scene

    attempt = play(scene, plan(find_lying(scene)))

    assert is_in_tray(attempt.stone), attempt.stone
    assert attempt.wall < 0.5
    assert attempt.felt < 1.0
    assert play(scene, plan(find_lying(scene))).hashes == attempt.hashes  # to the bit


@pytest.mark.landing
@pytest.mark.parametrize("wrong", ["opens in the tract", "never closes", "too short", "beside"])
def test_wrong_hands_leave_the_stone_elsewhere(shipped, wrong):
    scene = shipped.scene
    stone = find_lying(scene)
    goals = plan(stone)
    if wrong == "opens in the tract":
        goals[7] = Goal(CALYX + 0.025 * OUTWARDS, False, stay=0.3)
        goals[8:] = [Goal(TRACT_MOUTH + 0.03 * OUTWARDS, True)]
    elif wrong == "never closes":
        goals = [goals[0], *(Goal(g.to, False, g.speed, g.stay) for g in goals[4:])]
        goals[0:1] = plan(stone)[:4]
    elif wrong == "too short":
        goals = plan(stone, reach=-0.009)
    else:
        goals = plan(stone, put=np.array(TRAY) + (-0.03, 0.0, 0.009))

    attempt = play(scene, goals)

    assert not is_in_tray(attempt.stone)
    fell = attempt.stone[2] < TRAY[2] - 0.05  # past the tray, out of the kidney
    assert fell == (wrong == "beside"), attempt.stone
    assert fell or np.linalg.norm(attempt.stone - CALYX) < 0.05
