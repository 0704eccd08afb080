# SPDX-License-Identifier: BSD-3-Clause
"""What a scene of several bodies costs in a tick while two of them are pressed together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import palpate
from palpate.layout.gaps import Gap, Surface, find_least
from palpate.runs.alarms import tell_alarm
from palpate.runs.press import Place, PressScript, find_place, has_jaws, write_script

PRESS = PressScript(depth=6e-3, speed=0.03, hold=0.2)
SEARCHED = 0.02
"""[m] From each other, farther than bodies are pushed."""


@dataclass(frozen=True)
class PairCosts:
    """Of a press of the second body of a pair against the first."""

    pair_median: float
    pair_p99: float
    """[s] of a tick, for the contact of the two bodies."""
    tick_median: float
    tick_p99: float
    """[s] whole."""
    most_touching: int
    """Vertices within the thickness, at most."""
    least_gap: float
    """[m] infinite where they never touched, below 0 where they went through each other."""
    alarm: str
    """What ended the press early; else empty."""


def press_pair(scene: palpate.Scene, index: int, surfaces: list[Surface]) -> PairCosts | None:
    """Presses the body from the side that is away from the other, as fast as the machine can; None
    for bodies too far apart to be pushed together, and for one that folds."""
    pair = scene.body_pairs[index]
    if pair.first == pair.second:
        return None
    nearest = find_least(surfaces[pair.first], surfaces[pair.second], SEARCHED, np.zeros(3))
    if nearest is None:
        return None
    samples = write_press(scene, pair.second, find_far_side(surfaces[pair.second], nearest))
    costs = palpate.measure_costs(scene, samples)
    touching, least, alarm = follow_pair(scene, index, samples)
    return PairCosts(
        costs.body_pairs[index].median,
        costs.body_pairs[index].p99,
        costs.tick.median,
        costs.tick.p99,
        touching,
        least,
        alarm,
    )


def find_far_side(surface: Surface, nearest: Gap) -> np.ndarray:
    """[m] Where a body is pressed so that it goes towards the other: across from where they are
    nearest, seen along the gap."""
    from_contact = surface.used - nearest.vertex
    along = from_contact @ nearest.normal
    across = np.linalg.norm(from_contact - along[:, None] * nearest.normal, axis=1)
    return np.asarray(surface.used[np.argmax(along - 2.0 * across)])


def write_press(scene: palpate.Scene, body: int, near: np.ndarray) -> list[palpate.HapticSample]:
    """Samples of all hands, tick by tick: the first presses, the others stay away."""
    place = find_place(scene, near, body)
    away = Place(place.point + 0.2 * place.outward, place.outward)
    hands = []
    for number, instrument in enumerate(scene.instruments):
        jaws = has_jaws(scene, number)
        at = place if number == 0 else away
        frames, times = write_script(at, instrument.tool.radius, PRESS, jaws)
        hands.append(palpate.ScriptedDevice(frames))
    ticks = round(times.end * scene.rate)
    return [hand.read(tick / scene.rate) for tick in range(ticks) for hand in hands]


def follow_pair(
    scene: palpate.Scene, index: int, samples: list[palpate.HapticSample]
) -> tuple[int, float, str]:
    """The most vertices that touch, the smallest gap [m], and what ended the press early."""
    world, most, least = palpate.World(scene), 0, np.inf
    count = len(scene.instruments)
    for tick in range(len(samples) // count):
        rows = samples[tick * count : (tick + 1) * count]
        palpate.tick(scene, rows, 1.0 / scene.rate, world)
        state = world.body_pairs[index]
        most, least = max(most, state.touching), min(least, state.least_gap)
        if world.alarm:
            return most, float(least), tell_alarm(world.alarm, scene, world.alarm_body)
    return most, float(least), ""
