# SPDX-License-Identifier: BSD-3-Clause
"""What a scene costs, part by part, found by pressing it."""

from __future__ import annotations

import palpate
from palpate.runs.press import Place, PressScript, find_top, has_jaws, write_script

PRESS = PressScript(depth=3e-3, speed=0.03, hold=0.2)
"""A press as a hand makes it: in the air, in contact and away again."""
GRASP = PressScript(depth=6e-3, pull=3e-3, speed=0.03, hold=0.2)
"""The same with jaws, which close at the depth and pull."""


def press_costs(
    scene: palpate.Scene, script: PressScript | None = None, place: Place | None = None
) -> palpate.SceneCosts:
    """Presses a scene from rest, as fast as the machine can, and measures every tick.

    The first instrument presses the first body at `place`, at its top for None, by PRESS or, with
    jaws, by GRASP; all others stay where the first begins. Runs in the calling thread, which
    Python's lock does not hold up.
    Raises ValueError for a scene that is not from build_scene.
    """
    place = place or find_top(scene)
    script = script or (GRASP if has_jaws(scene) else PRESS)
    frames, times = write_script(place, scene.instruments[0].tool.radius, script, has_jaws(scene))
    hand = palpate.ScriptedDevice(frames)
    still = hand.read(0.0)
    others = [still] * (len(scene.instruments) - 1)
    ticks = round(times.end * scene.rate)
    samples = [
        sample for tick in range(ticks) for sample in (hand.read(tick / scene.rate), *others)
    ]
    return palpate.measure_costs(scene, samples)
