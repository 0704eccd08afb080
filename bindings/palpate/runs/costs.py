# SPDX-License-Identifier: BSD-3-Clause
"""What a scene costs, part by part, found by pressing it."""

from __future__ import annotations

import numpy as np

import palpate
from palpate.runs.press import (
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


def press_costs(
    scene: palpate.Scene, script: PressScript | None = None, place: Place | None = None
) -> palpate.SceneCosts:
    """Presses a scene from rest, as fast as the machine can, and measures every tick.

    Every instrument presses the first body at once by PRESS or, with jaws, by GRASP: the first at
    `place`, at its top for None, the others beside it. Runs in the calling thread, which Python's
    lock does not hold up.
    Raises ValueError for a scene that is not from build_scene.
    """
    place = place or find_top(scene)
    hands = [write_hand(scene, place, i, script) for i in range(len(scene.instruments))]
    ticks = round(max(end for _, end in hands) * scene.rate)
    samples = [device.read(tick / scene.rate) for tick in range(ticks) for device, _ in hands]
    return palpate.measure_costs(scene, samples)


def write_hand(
    scene: palpate.Scene, place: Place, instrument: int, script: PressScript | None
) -> tuple[palpate.ScriptedDevice, float]:
    """The hand of one instrument, and when [s] it is done."""
    if instrument > 0:
        place = find_place(scene, place.point + instrument * BESIDE)
    jaws = has_jaws(scene, instrument)
    radius = scene.instruments[instrument].tool.radius
    frames, times = write_script(place, radius, script or (GRASP if jaws else PRESS), jaws)
    return palpate.ScriptedDevice(frames), times.end
