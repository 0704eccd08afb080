# SPDX-License-Identifier: BSD-3-Clause
"""Two organs that touch: a tip presses the upper one onto the lower one, in a scene from code and
in the same scene from a .palpate file."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import palpate
from palpate import scenario

TICK, RADIUS, GAP = 1e-3, 0.02, 4e-4


def make_sphere(height: float, around: int = 24, rings: int = 11) -> palpate.SurfaceMesh:
    """A sphere of `rings` circles of latitude and two poles, its centre at a height [m]."""
    polar = np.pi * np.arange(1, rings + 1) / (rings + 1)
    turn = 2.0 * np.pi * np.arange(around) / around
    x = np.stack(
        [
            np.outer(np.sin(polar), np.cos(turn)),
            np.outer(np.sin(polar), np.sin(turn)),
            np.outer(np.cos(polar), np.ones(around)),
        ],
        axis=2,
    ).reshape(-1, 3)
    vertices = np.concatenate([x, [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    north, south, triangles = len(x), len(x) + 1, []
    for j in range(around):
        k = (j + 1) % around
        triangles.append((north, j, k))
        triangles.append((south, (rings - 1) * around + k, (rings - 1) * around + j))
        for i in range(rings - 1):
            a, b = i * around + j, i * around + k
            triangles += [(a, a + around, b + around), (a, b + around, b)]
    return palpate.SurfaceMesh(RADIUS * vertices + (0.0, 0.0, height), triangles)


def make_organ(height: float, home: float) -> palpate.SoftBody:
    """`home` [N/m³] is how firmly it is held where it is."""
    wall = palpate.Material(density=1000.0, wall_thickness=0.003)
    options = palpate.SurfaceOptions(home_stiffness=home, drag=30.0)
    return palpate.SoftBody(
        tissue=palpate.build_mass_spring(make_sphere(height), wall, 2000.0, options)
    )


def make_scene(touches: bool) -> palpate.Scene:
    pairs = [palpate.BodyPair(0, 1)] if touches else []
    bodies = [make_organ(2.0 * RADIUS + GAP, 5e3), make_organ(0.0, 3e5)]
    return palpate.build_scene(palpate.Scene(bodies=bodies, body_pairs=pairs))


def press(scene: palpate.Scene) -> tuple[float, float, float]:
    """[N] of the hand and [N] downwards on the lower organ at the deepest, and least gap [m]."""
    world, lower, least = palpate.World(scene), 0.0, np.inf
    top = 3.0 * RADIUS + GAP + scene.instruments[0].tool.radius
    for i in range(600):
        height = top + 1e-3 - 9e-3 * min(1.0, i / 400)
        sample = palpate.HapticSample(position=(0.0, 0.0, height), time=i * TICK)
        command = palpate.tick(scene, sample, TICK, world)
        assert not world.alarm, world.alarm
        if world.body_pairs:
            lower = -world.body_pairs[0].force[2]
            least = min(least, world.body_pairs[0].least_gap)
    return float(command.force[2]), float(lower), float(least)


def main() -> int:
    scene = make_scene(True)
    touching, through = press(scene), press(make_scene(False))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "two_organs.palpate"
        scenario.write(file, scenario.Scenario(scene=scene, title="Two organs"))
        from_file = press(scenario.read(file).scene)
    hand, lower, least = touching
    print(
        f"the hand feels {hand:.3f} N, the lower organ {lower:.3f} N, gap {1e3 * least:.3f} mm at "
        f"least; alone {through[0]:.3f} N"
    )
    same = from_file == touching
    print("from a file:", "the same bits" if same else "something else")
    return 0 if same and least > 0.0 and lower > 1e-3 and hand > through[0] else 1


if __name__ == "__main__":
    sys.exit(main())
