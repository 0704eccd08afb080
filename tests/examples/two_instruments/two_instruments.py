# SPDX-License-Identifier: BSD-3-Clause
"""Two instruments on one organ: one steadies it, the other is drawn over it and rubs."""

from __future__ import annotations

import sys

import numpy as np
import palpate

TICK, RADIUS, FRICTION = 1e-3, 0.03, 0.2


def make_sphere(around: int = 32, rings: int = 15) -> palpate.SurfaceMesh:
    """A sphere of `rings` circles of latitude and two poles."""
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
    return palpate.SurfaceMesh(RADIUS * vertices, triangles)


def make_probe(trocar: tuple[float, float, float], friction: float) -> palpate.Instrument:
    """5 mm thick and 20 mm of it touch; its shaft goes to the trocar."""
    shaft = palpate.Capsule(to=(0.0, 0.0, 0.02))
    tool = palpate.Tool(radius=2.5e-3, friction=friction, capsules=[shaft])
    return palpate.Instrument(tool=tool, trocar=trocar)


def make_scene(friction: float) -> palpate.Scene:
    wall = palpate.Material(density=1000.0, wall_thickness=0.003)
    options = palpate.SurfaceOptions(home_stiffness=3e5, drag=30.0)
    tissue = palpate.build_mass_spring(make_sphere(), wall, 60.0, options)
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue)],
            instruments=[
                make_probe((-0.15, 0.0, 0.10), friction),
                make_probe((0.05, 0.0, 0.20), friction),
            ],
        )
    )


def find_hands(time: float) -> list[palpate.HapticSample]:
    """The left one goes 4 mm in from the side; the right one 3 mm down on the top, and along it."""
    into, along = min(1.0, time / 0.2), max(0.0, time - 0.3)
    left = (-RADIUS - 0.0035 + 0.005 * into, 0.0, 0.0)
    right = (0.02 * along, 0.0, RADIUS + 0.0035 - 0.004 * into)
    return [palpate.HapticSample(time=time, position=place) for place in (left, right)]


def play(friction: float) -> np.ndarray:
    """[N] (2, 3) what the hands feel at the end."""
    scene = make_scene(friction)
    world = palpate.World(scene)
    for k in range(700):
        commands = palpate.tick(scene, find_hands(k * TICK), TICK, world)
    assert not world.alarm
    return np.array([command.force for command in commands])


def main() -> int:
    felt, again, smooth = play(FRICTION), play(FRICTION), play(0.0)
    for hand, force in enumerate(felt):
        print(f"hand {hand} feels", " ".join(f"{f:.3f}" for f in force), "N")
    rubs = (smooth[1, 0] - felt[1, 0]) / (FRICTION * np.linalg.norm(felt[1]))
    print(f"dragged back by {rubs:.2f} of mu N")
    holds = felt[0, 0] < -0.05 and 0.7 < rubs < 1.3 and np.array_equal(felt, again)
    print("one steadies, the other rubs, and again to the bit" if holds else "this is not so")
    return 0 if holds else 1


if __name__ == "__main__":
    sys.exit(main())
