# SPDX-License-Identifier: BSD-3-Clause
"""What a scene of several bodies costs in a tick while two of them are pressed together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import palpate
from palpate.layout.gaps import Gap, Surface, find_least
from palpate.runs.alarms import describe_alarm
from palpate.runs.press import Place, PressScript, find_place, has_jaws, write_script

PRESS = PressScript(depth=6e-3, speed=0.03, hold=0.2)
SEARCHED = 0.02
"""[m] From each other, farther than bodies are pushed."""


@dataclass(frozen=True)
class Pressed:
    """How a press of the second body of a pair against the first went."""

    end: palpate.Alarm
    """What ended it early, or none."""
    end_body: int
    """Whose that is; -1 for none."""
    most_touching: int
    """Vertices within the thickness, at most."""
    least_gap: float
    """[m] infinite where they never touched, below 0 where they went through each other."""
    substeps: float
    """Of the body that took most, on the mean."""

    @property
    def alarm(self) -> str:
        """What ended it early, in English; else empty."""
        return str(describe_alarm(self.end)) if self.end else ""


@dataclass(frozen=True)
class PairCosts(Pressed):
    """And what it took."""

    pair_median: float
    pair_p99: float
    """[s] of a tick, for the contact of the two bodies."""
    tick_median: float
    tick_p99: float
    """[s] whole."""


def press_pair(scene: palpate.Scene, index: int, surfaces: list[Surface]) -> PairCosts | None:
    """Presses the body from the side that is away from the other, as fast as the machine can; None
    for bodies too far apart to be pushed together, and for one that folds."""
    pair = scene.body_pairs[index]
    if pair.first == pair.second:
        return None
    samples = write_press_of(scene, index, surfaces)
    if not samples:
        return None
    costs = palpate.measure_costs(scene, samples)
    return PairCosts(
        **vars(follow_press(scene, index, samples)),
        pair_median=costs.body_pairs[index].median,
        pair_p99=costs.body_pairs[index].p99,
        tick_median=costs.tick.median,
        tick_p99=costs.tick.p99,
    )


def write_press_of(
    scene: palpate.Scene, index: int, surfaces: list[Surface]
) -> list[palpate.HapticSample]:
    """Of the second body of a pair against the first; none where they are too far apart."""
    pair = scene.body_pairs[index]
    nearest = find_least(surfaces[pair.first], surfaces[pair.second], SEARCHED, np.zeros(3))
    if nearest is None:
        return []
    return write_press(scene, pair.second, find_far_side(surfaces[pair.second], nearest))


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


def follow_press(scene: palpate.Scene, index: int, samples: list[palpate.HapticSample]) -> Pressed:
    """Ticks the scene through a press, up to its end or an alarm."""
    world, most, least, substeps, ticks = palpate.World(scene), 0, np.inf, 0, 0
    count = len(scene.instruments)
    for tick in range(len(samples) // count):
        rows = samples[tick * count : (tick + 1) * count]
        palpate.tick(scene, rows, 1.0 / scene.rate, world)
        state = world.body_pairs[index]
        most, least = max(most, state.touching), min(least, state.least_gap)
        substeps += max(body.substeps for body in world.bodies)
        ticks += 1
        if world.alarm:
            break
    return Pressed(world.alarm, world.alarm_body, most, float(least), substeps / max(1, ticks))
