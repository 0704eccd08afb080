# SPDX-License-Identifier: BSD-3-Clause
"""No alarm where nothing is wrong: fast and deep presses, and steps just within the limit."""

from __future__ import annotations

import copy
import itertools

import numpy as np
import palpate
import pytest
from palpate.runs.press import CLEARANCE, Place, find_top
from palpate.runs.run import read_scene
from palpate_editor.shipped import list_organs
from scripted_hands import (
    SPRINGS,
    find_scattered_place,
    is_open,
    open_organ_scene,
    press,
    run_hand,
)
from tiers import keep_everyday

ORGANS = [entry.name for entry, _ in list_organs()]
OF_SPRINGS = sorted(path.stem for path in SPRINGS.glob("*.palpate"))
NONE = palpate.AlarmKind.none
DEEP, FAST = 10e-3, 0.1
"""[m], [m/s] as a hand explores that means it."""
COSTLY = ("liver", "spleen", "kidney")
"""Solids whose near field takes a second to build."""
LIMIT_SHARE = 0.9
"""[-] of the limit, that palpate.stable_step gives."""


def some(names: list[str]) -> list[object]:
    return keep_everyday(names, set(names) - set(COSTLY))


@pytest.mark.parametrize("name", some(ORGANS))
def test_a_hand_that_presses_10_mm_at_100_mm_s_ends_no_run(name):
    scene = open_organ_scene(name)
    for place in (find_top(scene), find_scattered_place(scene, 1)):
        assert press(scene, place, DEEP, FAST).alarm == NONE


OVER_BORDERS = [("simple_tissue", 26), ("simple_tissue", 32), ("gallbladder", 0)]
"""Organs and places of them where the ball rolls over an open border, and is drawn back from behind
it."""


@pytest.mark.parametrize(("name", "number"), OVER_BORDERS)
def test_a_hand_that_presses_on_an_open_border_ends_no_run(name, number):
    scene = open_organ_scene(name)

    assert press(scene, find_scattered_place(scene, number), DEEP, FAST).alarm == NONE


@pytest.mark.landing
@pytest.mark.parametrize("speed", [0.03, FAST])
def test_a_wall_that_folds_upon_its_fixed_edge_ends_no_run(speed):
    # half a millimetre from what is fixed: the ball slides off with all of the hand's 5 N, and the
    # wall snaps through; triangles that were pressed flat were drawn shut by their stretch-bend
    scene = open_organ_scene("stomach")

    assert press(scene, find_scattered_place(scene, 11), DEEP, speed).alarm == NONE


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_it_ends_none_at_forty_places_either(name):
    scene = open_organ_scene(name)
    places = {k: find_scattered_place(scene, k) for k in range(40)}
    reached = {k: place for k, place in places.items() if is_open(scene, place)}

    ends = {k: press(scene, place, DEEP, FAST).alarm for k, place in reached.items()}

    assert len(ends) >= 20
    assert {k: end.name for k, end in ends.items() if end != NONE} == {}


def step_at(scene: palpate.Scene, share: float) -> palpate.Scene:
    """A scene of which each substep in the air is that part of the longest that is stable."""
    limit = palpate.stable_step(scene.bodies[0].tissue) / LIMIT_SHARE
    if not np.isfinite(limit):  # a stone, which cannot swing
        return scene
    slower = copy.copy(scene)
    slower.rate = 1.0 / (scene.bodies[0].substeps * share * limit)
    return slower


ABOVE = 20e-3
"""[m] of the tip over the surface, between two pokes."""


def lift_off(scene: palpate.Scene, place: Place, height: float) -> np.ndarray:
    """[m] Of the tip's centre so high over a place."""
    return place.point + (scene.instruments[0].tool.radius + height) * np.asarray(place.outward)


def can_be_reached(scene: palpate.Scene, place: Place) -> bool:
    """Whether the tip, drawn straight out of a place, meets nothing: not out of a hollow."""
    x, triangles = take_rest_surface(scene)
    points = np.vstack([x, x[triangles].mean(axis=1)])
    heights = np.arange(CLEARANCE, 2.0 * np.ptp(x, axis=0).max(), CLEARANCE)
    way = np.array([lift_off(scene, place, height) for height in heights])
    nearest = min(float(np.linalg.norm(points - at, axis=1).min()) for at in way)
    return nearest > scene.instruments[0].tool.radius


def take_rest_surface(scene: palpate.Scene) -> tuple[np.ndarray, np.ndarray]:
    tissue = scene.bodies[0].tissue
    x = palpate.compute_surface(tissue, tissue.rest_position)
    return np.asarray(x), np.asarray(tissue.triangles)


def go_around(scene: palpate.Scene, first: Place, last: Place) -> list[np.ndarray]:
    """[m] Corners of a way from above one place to above another that does not lead through the
    organ: straight out to a sphere around all of it, along that, and straight in."""
    x, _ = take_rest_surface(scene)
    centre = 0.5 * (x.min(axis=0) + x.max(axis=0))
    above = [lift_off(scene, place, ABOVE) for place in (first, last)]
    far = 1.5 * max(np.linalg.norm(p - centre) for p in (*above, *x))
    ends = []
    for at, place in zip(above, (first, last), strict=True):
        out = np.asarray(place.outward)
        along = float(out @ (at - centre))
        reach = np.sqrt(along**2 + far**2 - float((at - centre) @ (at - centre))) - along
        ends.append((at + reach * out - centre) / far)
    # slightly off, so that opposite places have a middle too
    middle = ends[0] + ends[1] + 0.1 * np.roll(ends[0], 1)
    return [centre + far * n / np.linalg.norm(n) for n in (ends[0], middle, ends[1])]


def list_reached(scene: palpate.Scene, count: int) -> list[Place]:
    places = (find_scattered_place(scene, k) for k in itertools.count())
    return list(itertools.islice((p for p in places if can_be_reached(scene, p)), count))


def poke(scene: palpate.Scene, seconds: float) -> palpate.AlarmKind:
    """3 mm into a place every second, at another each time; between them the tool goes around."""
    frames: list[palpate.KeyFrame] = []
    places = list_reached(scene, int(seconds))
    for k, place in enumerate(places):
        if frames:
            way = go_around(scene, places[k - 1], place)
            frames += [
                palpate.KeyFrame(k + time, at)
                for time, at in zip((0.02, 0.09, 0.16), way, strict=True)
            ]
        for time, height in ((0.22, ABOVE), (0.37, CLEARANCE), (0.5, -3e-3), (0.7, -3e-3),
                             (0.85, CLEARANCE), (0.95, ABOVE)):  # fmt: skip
            frames.append(palpate.KeyFrame(k + time, lift_off(scene, place, height)))
    return run_hand(scene, frames).alarm


@pytest.mark.parametrize("name", ["simple_tissue", "gallbladder"])
def test_at_098_of_its_limit_a_shipped_organ_that_is_poked_raises_no_alarm(name):
    assert poke(step_at(open_organ_scene(name), 0.98), 3.0) == NONE


@pytest.mark.parametrize("name", ["spleen"])
def test_at_098_of_its_limit_an_organ_of_springs_that_is_poked_raises_no_alarm(name):
    assert poke(step_at(read_scene(SPRINGS / f"{name}.palpate"), 0.98), 3.0) == NONE


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_for_a_minute_at_098_of_its_limit_no_shipped_organ_raises_an_alarm(name):
    assert poke(step_at(open_organ_scene(name), 0.98), 60.0) == NONE


@pytest.mark.verify
@pytest.mark.parametrize("name", OF_SPRINGS)
def test_for_a_minute_at_098_of_its_limit_no_organ_of_springs_raises_an_alarm(name):
    assert poke(step_at(read_scene(SPRINGS / f"{name}.palpate"), 0.98), 60.0) == NONE


JUMPS = (1.0e-3, 1.6e-3, 2.2e-3, 3.0e-3)
"""[m] in a tick, where some before it were missed; the tool is drawn along at 3 m/s at most."""


def jump(scene: palpate.Scene, seed: int, ticks: int) -> palpate.AlarmKind:
    """A hand that stands for 25 ticks, then is elsewhere at once: deeper, out or aside."""
    chance = np.random.default_rng(seed)
    place = find_scattered_place(scene, int(chance.integers(1000)))
    out = np.asarray(place.outward)
    aside = np.cross(out, np.roll(out, 1) + (0.3, 0.5, 0.8))
    axes = np.array([out, aside / np.linalg.norm(aside), np.cross(out, aside)])
    axes[2] /= np.linalg.norm(axes[2])
    low, high = np.array([-5e-3, -8e-3, -8e-3]), np.array([4e-3, 8e-3, 8e-3])
    world, sample, at = (
        palpate.World(scene, recovers=False),
        palpate.HapticSample(),
        np.array([3e-3, 0.0, 0.0]),
    )
    for tick in range(ticks):
        if tick % 25 == 0:
            moved = at.copy()
            moved[chance.integers(3)] += chance.choice(JUMPS) * chance.choice((-1.0, 1.0))
            at = np.clip(moved, low, high)
        sample.position = place.point + scene.instruments[0].tool.radius * out + at @ axes
        palpate.tick(scene, sample, 1.0 / scene.rate, world)
        if world.alarm.kind != NONE:
            break
    return world.alarm.kind


@pytest.mark.parametrize("name", ["simple_tissue", "gallbladder"])
def test_a_hand_that_jumps_by_up_to_3_mm_in_a_tick_ends_no_run(name):
    assert jump(open_organ_scene(name), 0, 400) == NONE


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_a_hand_that_jumps_ends_none_from_any_of_twenty_places_either(name):
    scene = open_organ_scene(name)

    ends = {seed: jump(scene, seed, 2000).name for seed in range(20)}

    assert {seed: end for seed, end in ends.items() if end != NONE.name} == {}
