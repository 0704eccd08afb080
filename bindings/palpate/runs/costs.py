# SPDX-License-Identifier: BSD-3-Clause
"""What a scene costs, part by part, found by pressing it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

import palpate
from palpate.runs.press import (
    CLOSE,
    RAMP,
    Place,
    PressScript,
    find_place,
    find_top,
    has_jaws,
    write_script,
)

PRESS = PressScript(depth=3e-3, speed=0.03, hold=0.2)
"""A press as a hand makes it: in the air, in contact and away again."""
BESIDE = np.array([0.015, 0.0, 0.0])
"""[m] Where an instrument presses, seen from where the one before it does."""
GRASP = PressScript(depth=6e-3, pull=3e-3, speed=0.03, hold=0.2, clearance=0.02)
"""The same with jaws, which close at the depth and pull; open they reach 11 mm to either side."""
HELD = 2.5
"""[-] By which a hand that holds takes longer than one that presses: it holds for more than half of
that."""


def press_costs(
    scene: palpate.Scene, script: PressScript | None = None, place: Place | None = None
) -> palpate.SceneCosts:
    """Presses a scene from rest, as fast as the machine can, and measures every tick.

    Every instrument presses the first body at once by PRESS or, with jaws, by GRASP: the first at
    `place`, at its top for None, the others beside it. Runs in the calling thread, which Python's
    lock does not hold up.
    Raises ValueError for a scene that is not from build_scene.
    """
    return measure_hands(scene, write_hands(scene, script, place))


def hold_costs(scene: palpate.Scene) -> palpate.SceneCosts:
    """As press_costs, but instruments stay at what they press, jaws at what they hold, for most of
    the time: medians are of that. Raises ValueError for a scene that is not from build_scene."""
    return measure_hands(scene, write_holding_hands(scene))


def run_until_held(scene: palpate.Scene) -> palpate.World:
    """The world under the hands of hold_costs, once all of them stand still."""
    hands, world, dt = write_holding_hands(scene), palpate.World(scene), 1.0 / scene.rate
    devices = [palpate.ScriptedDevice(hand.frames) for hand in hands]
    for tick in range(round(max(hand.held for hand in hands) * scene.rate)):
        palpate.tick(scene, [device.read(tick * dt) for device in devices], dt, world)
    return world


@dataclass(frozen=True)
class PressHand:
    """The hand of one instrument."""

    frames: list[palpate.KeyFrame]
    held: float
    """[s] When it has stood still at the depth, closed where it has jaws."""
    end: float
    """[s]"""


def write_hands(
    scene: palpate.Scene, script: PressScript | None = None, place: Place | None = None
) -> list[PressHand]:
    place = place or find_top(scene)
    return [write_hand(scene, place, i, script) for i in range(len(scene.instruments))]


def write_holding_hands(scene: palpate.Scene) -> list[PressHand]:
    """All of them for as long, and away again."""
    hands = write_hands(scene)
    whole = HELD * max(hand.end for hand in hands)
    for hand in hands:
        later = whole - hand.end
        for frame in hand.frames:
            frame.time += later if frame.time >= hand.held else 0.0
    return [replace(hand, end=whole) for hand in hands]


def write_hand(
    scene: palpate.Scene, place: Place, instrument: int, script: PressScript | None
) -> PressHand:
    if instrument > 0:
        place = find_place(scene, place.point + instrument * BESIDE)
    jaws = has_jaws(scene, instrument)
    radius = scene.instruments[instrument].tool.radius
    script = script or (GRASP if jaws else PRESS)
    frames, times = write_script(place, radius, script, jaws)
    closed = 0.0 if times.pulled is None else RAMP + CLOSE
    return PressHand(frames, times.held + closed, times.end)


def measure_hands(scene: palpate.Scene, hands: list[PressHand]) -> palpate.SceneCosts:
    ticks = round(max(hand.end for hand in hands) * scene.rate)
    devices = [palpate.ScriptedDevice(hand.frames) for hand in hands]
    samples = [device.read(tick / scene.rate) for tick in range(ticks) for device in devices]
    return palpate.measure_costs(scene, samples)
