# SPDX-License-Identifier: BSD-3-Clause
"""A hand that presses deeper than tissue bears is limited by it, and ends no run."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import read_scene

PUBLISHED = Path(palpate_meshes.__file__).parent / "published"
HOLD = 0.3
"""[s]"""


@dataclass
class Pressed:
    """What a hand did, and felt."""

    world: palpate.World
    frames: list[palpate.HapticSample] = field(default_factory=list)
    felt: list[palpate.Felt] = field(default_factory=list)
    hashes: list[palpate.StateHash] = field(default_factory=list)
    force: list[float] = field(default_factory=list)
    """[N] of every tick."""
    held: slice = field(default_factory=lambda: slice(0))
    """The ticks of the last two thirds of the hold."""


def press(scene: palpate.Scene, depth: float) -> Pressed:
    """At 0.1 m/s down, held, and up again."""
    script = PressScript(depth=depth, speed=0.1, hold=HOLD)
    radius = scene.instruments[0].tool.radius
    frames, times = write_script(find_top(scene), radius, script, False)
    device, pressed = palpate.ScriptedDevice(frames), Pressed(palpate.World(scene))
    held = round(times.held * scene.rate)
    pressed.held = slice(held - round(2 / 3 * HOLD * scene.rate), held)
    for tick in range(round(times.end * scene.rate)):
        sample = device.read(tick / scene.rate)
        command = palpate.tick(scene, sample, 1.0 / scene.rate, pressed.world)
        pressed.frames.append(sample)
        pressed.felt.append(palpate.compute_felt(command, pressed.world))
        pressed.force.append(float(np.linalg.norm(command.force)))
        if tick % 50 == 0:
            state = palpate.compute_hash(pressed.world)
            pressed.hashes.append(palpate.StateHash(tick=tick, hash=state))
        if pressed.world.alarm:
            break
    return pressed


@pytest.mark.landing
@pytest.mark.parametrize("organ", ["kidney", "collecting_system"])
def test_a_stab_of_30_mm_is_held_off_by_the_tissue_and_replays_to_the_bit(organ):
    """Once a tetrahedron was inverted by 0.9 to 1.3 N, which ended the run."""
    scene = read_scene(PUBLISHED / f"{organ}.palpate")

    pressed = press(scene, 0.03)

    assert not pressed.world.alarm
    force = np.array(pressed.force)
    held = force[pressed.held]
    assert held.min() > 0.3
    assert held.max() < 0.3 * scene.instruments[0].coupling.force_max
    assert np.abs(np.diff(held)).max() < 0.05 * held.max()  # it does not buzz
    assert force[-1] == 0.0
    record = palpate.Record(hand=pressed.frames, felt=pressed.felt, hashes=pressed.hashes)
    assert palpate.replay(scene, record).equal
