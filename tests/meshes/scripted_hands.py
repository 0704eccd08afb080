# SPDX-License-Identifier: BSD-3-Clause
"""Hands that press, flick and pull the shipped organs, one tick after the other without a clock."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import palpate
from palpate.runs.press import CLEARANCE, RAMP, Place, PressScript, find_place, write_script
from palpate.runs.run import read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
PUBLISHED, SPRINGS = CHECKOUT / "meshes" / "published", CHECKOUT / "tests" / "scenes" / "springs"


@dataclass
class Felt:
    """What a hand felt, tick by tick, and how it ended."""

    world: palpate.World
    force: list[float] = field(default_factory=list)
    """[N]"""
    held: list[bool] = field(default_factory=list)
    """The tool is fastened to the tissue."""

    @property
    def alarm(self) -> palpate.AlarmKind:
        return self.world.alarm.kind


def open_organ_scene(name: str) -> palpate.Scene:
    return read_scene(PUBLISHED / f"{name}.palpate")


def find_scattered_place(scene: palpate.Scene, number: int) -> Place:
    """One of many places all over an organ, always the same."""
    x = palpate.compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)
    return find_place(scene, x[number * 7919 % len(x)])


def is_open(scene: palpate.Scene, place: Place) -> bool:
    """Whether a hand comes there straight from outside; within a hollow organ it would come out of
    the wall behind it."""
    tissue, n = scene.bodies[0].tissue, np.asarray(place.outward)
    x = palpate.compute_surface(tissue, tissue.rest_position)
    tree = palpate.AabbTree(x, tissue.triangles)
    return palpate.find_ray_hit(tree, x, place.point + 1e-4 * n, n) is None


def run_hand(scene: palpate.Scene, frames: list[palpate.KeyFrame]) -> Felt:
    """Up to the end of the script or the first alarm."""
    device, felt, dt = (
        palpate.ScriptedDevice(frames),
        Felt(palpate.World(scene, recovers=False)),
        1 / scene.rate,
    )
    for tick in range(round(frames[-1].time * scene.rate)):
        command = palpate.tick(scene, device.read(tick * dt), dt, felt.world)
        felt.force.append(float(np.linalg.norm(command.force)))
        felt.held.append(felt.world.instruments[0].tool.hold_count > 0)
        if felt.alarm != palpate.AlarmKind.none:
            break
    return felt


def press(scene: palpate.Scene, place: Place, depth: float, speed: float = 0.03) -> Felt:
    script = PressScript(depth, speed=speed, hold=0.1)
    return run_hand(scene, write_script(place, scene.instruments[0].tool.radius, script)[0])


def pull(
    scene: palpate.Scene,
    place: Place,
    height: float,
    hold: float,
    depth: float = 4e-3,
    speed: float = 0.05,
) -> Felt:
    """Takes hold 4 mm deep, pulls at a speed [m/s] to a height [m] above the surface at rest,
    holds [s], lets go there and waits."""
    frames: list[palpate.KeyFrame] = []

    def go(above: float, duration: float, attached: bool = False) -> None:
        frame = palpate.KeyFrame()
        frame.time = frames[-1].time + duration if frames else 0.0
        frame.position = place.point + (scene.instruments[0].tool.radius + above) * place.outward
        frame.buttons = int(attached)
        frames.append(frame)

    go(CLEARANCE, 0.0)
    go(-depth, (CLEARANCE + depth) / 0.03)
    go(-depth, 0.2)
    go(-depth, RAMP, attached=True)
    go(height, (depth + height) / speed, attached=True)
    go(height, hold, attached=True)
    go(height, 1e-3)
    go(height, 0.5)
    return run_hand(scene, frames)
