# SPDX-License-Identifier: BSD-3-Clause
"""A grasper takes, holds, pulls and lets go of every organ that ships, all over, for a minute."""

from __future__ import annotations

from collections.abc import Iterator
from copy import copy

import numpy as np
import palpate
import pytest
from palpate.assessment.instruments import shape_tool
from palpate.runs.press import Place, find_top
from palpate.scene.instrument_kinds import KINDS
from scipy.spatial.transform import Rotation
from scripted_hands import PUBLISHED, find_scattered_place, is_open, open_organ_scene

ORGANS = sorted({path.stem for path in PUBLISHED.glob("*.palpate")} - {"kidney_stone"})
"""A stone that is fixed is no tissue: jaws are left behind it."""
SAMPLE = ("gallbladder", "simple_tissue", "spleen")
CYCLE = 3.0
"""[s]"""
FRAMES = (
    *((0.2, 0.015, 0), (0.5, None, 0), (0.55, None, 1), (0.9, None, 1)),
    *((1.3, 0.0, 1), (2.1, 0.0, 1), (2.15, 0.0, 0), (2.4, 0.0, 0), (2.6, 0.015, 0)),
)
"""[s] in a cycle, [m] over the surface at rest, None at the depth, and the button."""
DEPTH = 0.008
"""[m] To which open jaws are pressed down, their hinge away from the organ, before they close."""
WIDE = 0.014
"""[m] The tips of open jaws are as far from their middle, and some more."""
FAR, ARC = 0.03, 5
"""[m] outside of all of the organ, and by how many pieces an instrument goes around it there."""
HELD, AWAY = slice(1800, 2100), slice(2750, 2800)
"""Ticks of a cycle in which the hand holds still, and in which it is off the organ."""
LET_GO, STEP = slice(2149, 2205), 0.2
"""Ticks in which jaws let go before they open, and the largest step of the force from one to the
next over what was held [-]. Jaws that open in a dent push, which is no step of a load."""
OPENED, FLOOR = slice(2149, 2400), 0.0105
"""Ticks from the one before jaws let go to where they are drawn out, and a step [N] that jaws which
open in a dent may always have."""
CLOSES, PUSHED = slice(520, 900), 0.5
"""Ticks in which jaws close, and the largest step of the force [N] from one to the next."""


def take(name: str) -> palpate.Scene:
    """The organ with a grasper that the hand turns, as `palpate tool ORGAN grasper` has it."""
    kind = KINDS["grasper"]
    said = {
        **{"kind": "grasper", "radius_m": kind.radius, "length_m": kind.length},
        **{"friction": kind.friction, "jaw_opening_rad": kind.jaw_opening},
    }
    scene = shape_tool(said, 0, open_organ_scene(name))
    changed = copy(scene)
    changed.instruments[0].trocar = None
    return palpate.build_scene(changed)


def is_wide(scene: palpate.Scene, place: Place) -> bool:
    """Whether open jaws come there straight from outside."""
    tissue, n = scene.bodies[0].tissue, np.asarray(place.outward)
    x = palpate.compute_surface(tissue, tissue.rest_position)
    tree = palpate.AabbTree(x, tissue.triangles)
    across = np.linalg.svd(n[None])[2][1:]
    for angle in np.arange(8) * np.pi / 4:
        start = place.point + 0.012 * n + WIDE * (np.array([np.cos(angle), np.sin(angle)]) @ across)
        if palpate.find_ray_hit(tree, x, start, n) is not None:
            return False
    return is_open(scene, place)


def list_places(scene: palpate.Scene) -> Iterator[Place]:
    """The top, then others all over it."""
    yield find_top(scene)
    for number in range(1, 1000):
        place = find_scattered_place(scene, number)
        if is_wide(scene, place):
            yield place


def turn_to(outward: np.ndarray) -> np.ndarray:
    """The least turn (4,) of an instrument's z, which goes from its tip to the hand: x, y, z, w."""
    w = 1.0 + outward[2]
    if w < 1e-6:
        return np.array([1.0, 0.0, 0.0, 0.0])
    q = np.array([-outward[1], outward[0], 0.0, w])
    return q / np.linalg.norm(q)


def leave(centre: np.ndarray, radius: float, place: Place) -> np.ndarray:
    """[m] (3,) Where the straight way out from a place passes the ball about all of the organ."""
    d, n = np.asarray(place.point) - centre, np.asarray(place.outward)
    return place.point + (np.sqrt((d @ n) ** 2 - d @ d + radius**2) - d @ n) * n


def write_hand(scene: palpate.Scene, places: list[Place]) -> palpate.ScriptedDevice:
    """One place after the other, a cycle each, by ways that lead around the organ."""
    x = palpate.compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)
    centre = x.mean(axis=0)
    radius = np.linalg.norm(x - centre, axis=1).max() + FAR
    ends = [leave(centre, radius, place) for place in places]
    frames = []
    for number, (place, end) in enumerate(zip(places, ends, strict=True)):
        start, outward = number * CYCLE, np.asarray(place.outward)
        frames.append(palpate.KeyFrame(start, end))
        frames += [
            palpate.KeyFrame(
                start + time,
                place.point + (-DEPTH if height is None else height) * outward,
                buttons=button,
            )
            for time, height, button in FRAMES
        ]
        frames.append(palpate.KeyFrame(start + 2.8, end))
        following = ends[min(number + 1, len(ends) - 1)]
        for piece in range(1, ARC):
            way = (1.0 - piece / ARC) * (end - centre) + piece / ARC * (following - centre)
            around = centre + radius * way / np.linalg.norm(way)
            frames.append(palpate.KeyFrame(start + 2.8 + 0.2 * piece / ARC, around))
    frames.append(palpate.KeyFrame(len(places) * CYCLE, ends[-1]))
    return palpate.ScriptedDevice(frames)


def grasp(scene: palpate.Scene, count: int) -> tuple[np.ndarray, np.ndarray, palpate.World]:
    """[N] (count, ticks of a cycle, 3) of as many places, and (count,) which of them were held."""
    places = [place for _, place in zip(range(count), list_places(scene), strict=False)]
    hand, world, felt, held = write_hand(scene, places), palpate.World(scene), [], []
    ticks = round(CYCLE * scene.rate)
    for tick in range(count * ticks):
        number, within = divmod(tick, ticks)
        sample = hand.read(tick / scene.rate)
        sample.orientation = turn_to(np.asarray(places[number].outward))
        felt.append(palpate.tick(scene, sample, 1.0 / scene.rate, world).force)
        assert not world.alarm, (tick, places[number], world.alarm)
        if within == HELD.start:
            held.append(world.instruments[0].tool.pinches)
    return np.array(felt).reshape(count, -1, 3), np.array(held), world


def check(felt: np.ndarray) -> None:
    assert np.isfinite(felt).all()
    assert np.abs(felt[:, AWAY]).max() == 0.0, "something is held on"


@pytest.mark.parametrize("outward", [(0, 0, 1), (0, 0, -1), (0.36, 0.48, 0.8), (-1, 0, 0)])
def test_an_instrument_comes_with_its_hinge_away_from_the_organ(outward):
    turn = Rotation.from_quat(turn_to(np.array(outward, float)))
    assert turn.apply([0.0, 0.0, 1.0]) == pytest.approx(outward, abs=1e-12)


@pytest.mark.landing
@pytest.mark.parametrize("name", SAMPLE)
def test_an_organ_is_grasped_at_its_top_with_the_same_bits_each_time(name):
    scene = take(name)
    felt, _, world = grasp(scene, 1)
    check(felt)
    load = np.linalg.norm(felt[:, HELD], axis=2)
    assert (np.ptp(load, axis=1) < 0.01 * load.mean(axis=1)).all(), np.ptp(load, axis=1)
    steps = np.linalg.norm(np.diff(felt[:, LET_GO], axis=1), axis=2).max(axis=1)
    assert (steps < STEP * load.mean(axis=1)).all(), (steps, load.mean(axis=1))

    again, _, other = grasp(scene, 1)

    assert (again == felt).all()
    assert palpate.compute_hash(other) == palpate.compute_hash(world)


@pytest.mark.landing
def test_jaws_that_close_on_a_liver_are_not_thrown_about():
    """They stepped by 4.3 N, out of balance by as much, where one jaw touched alone."""
    felt, _, _ = grasp(take("liver"), 4)
    check(felt)
    steps = np.linalg.norm(np.diff(felt[:, CLOSES], axis=1), axis=2).max(axis=1)
    assert (steps < PUSHED).all(), steps


@pytest.mark.landing
def test_what_a_crease_bears_no_more_is_held_still():
    """What its hand may push with came back and was taken away again, by 0.4 N in a quarter of a
    second."""
    felt, _, _ = grasp(take("collecting_system"), 1)
    check(felt)
    load = np.linalg.norm(felt[0, HELD], axis=1)
    assert np.ptp(load) < 0.1 * load.mean(), (np.ptp(load), load.mean())


@pytest.mark.landing
def test_jaws_that_open_in_a_crease_do_not_kick():
    """Once the hand had opened as far as it would, they stepped by 0.45 N."""
    felt, _, _ = grasp(take("kidney"), 2)
    check(felt)
    load = np.linalg.norm(felt[:, HELD], axis=2).mean(axis=1)
    steps = np.linalg.norm(np.diff(felt[:, OPENED], axis=1), axis=2).max(axis=1)
    assert (steps < np.maximum(STEP * load, FLOOR)).all(), (steps, load)


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_a_minute_of_grasps_all_over_an_organ_has_no_alarm_and_keeps_nothing(name):
    felt, held, world = grasp(take(name), round(60.0 / CYCLE))

    check(felt)
    assert held.any()
    assert world.tick_count == felt.shape[0] * felt.shape[1]
