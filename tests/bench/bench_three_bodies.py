# SPDX-License-Identifier: BSD-3-Clause
"""What a tick of three bodies of 1962 vertices in a row costs under a ball or jaws, with pairs and
without: each tick the least of three runs of a script, processor time of the thread.

.venv/bin/python tests/bench/bench_three_bodies.py
"""

from __future__ import annotations

import numpy as np
import palpate
from palpate.runs.costs import write_hand
from palpate.runs.press import find_place
from palpate_meshes.generate import ellipsoid
from tick_times import time_least

HALF, GAP, RUNS = (0.03, 0.025, 0.02), 7e-4, 3
NEAR_GAP = np.array([0.027, 0.0, 0.008])
"""[m] Where the first body is pressed: 3 mm from the next one."""


def make_organ(x: float) -> palpate.SoftBody:
    """An ellipsoid that lies on a foot, moved by x [m]."""
    vertices, triangles = ellipsoid(1962, HALF, bow=0, hollow=0, notches=0)
    vertices = np.asarray(vertices) + (x, 0.0, 0.0)
    options = palpate.SurfaceOptions(fixed=(vertices[:, 2] < -0.012).tolist(), home_stiffness=4e5)
    wall = palpate.Material(damping_ratio=0.2, wall_thickness=3e-3)
    mesh = palpate.SurfaceMesh(vertices, triangles)
    tissue = palpate.build_mass_spring(mesh, wall, 100.0, options)
    return palpate.make_scene(tissue).bodies[0]


def make_scene(jaws: bool, paired: bool) -> palpate.Scene:
    instrument = palpate.Instrument(tool=palpate.Tool(radius=0.0015 if jaws else 0.003))
    if jaws:
        sides = [(0.0, y, 0.0) for y in (0.0015, -0.0015)]
        instrument.tool.capsules = [palpate.Capsule(at, (0.0, at[1], 0.01)) for at in sides]
        instrument.tool.jaws = palpate.Jaws(
            hinge=(0.0, 0.0, 0.015), axis=(1.0, 0.0, 0.0), open=0.4, grip=3.0
        )
    return palpate.build_scene(
        palpate.Scene(
            bodies=[make_organ(k * (2.0 * HALF[0] + GAP)) for k in range(3)],
            instruments=[instrument],
            body_pairs=[palpate.BodyPair(0, 1), palpate.BodyPair(1, 2)] if paired else [],
        )
    )


def measure(scene: palpate.Scene) -> np.ndarray:
    """[s] of every tick."""
    hand = write_hand(scene, find_place(scene, NEAR_GAP), 0, None)
    device = palpate.ScriptedDevice(hand.frames)
    samples = [device.read(tick / scene.rate) for tick in range(round(hand.end * scene.rate))]
    return time_least(RUNS, scene, samples)


def main() -> None:
    for jaws in (False, True):
        for paired in (False, True):
            times = 1e6 * measure(make_scene(jaws, paired))
            print(
                f"{'jaws' if jaws else 'ball'}, {'with' if paired else 'without'} pairs: "
                f"median {np.median(times):.0f} us, p99 {np.percentile(times, 99):.0f} us"
            )


if __name__ == "__main__":
    main()
