# SPDX-License-Identifier: BSD-3-Clause
"""A stone on a table: jaws take it, lift it and press it onto an organ that lies on another one, in
a scene from code and in the same scene from a .palpate file."""

from __future__ import annotations

import sys
import tempfile
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np
import palpate
from palpate import scenario

TICK, RADIUS, GAP = 1e-3, 0.02, 4e-4
HALF = np.array([0.0055, 0.0045, 0.004])
"""[m] Half axes of the stone, an ellipsoid."""
ASIDE = -0.05
"""[m] In y: where the stone lies."""


def make_sphere(around: int = 24, rings: int = 11) -> palpate.SurfaceMesh:
    """Of radius 1: `rings` circles of latitude and two poles."""
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
    return palpate.SurfaceMesh(vertices, triangles)


def make_organ(height: float, home: float) -> palpate.SoftBody:
    """A hollow ball whose centre is at a height [m]; `home` [N/m³] is how firmly it is held."""
    sphere = make_sphere()
    mesh = palpate.SurfaceMesh(
        RADIUS * np.asarray(sphere.vertices) + (0.0, 0.0, height), sphere.triangles
    )
    wall = palpate.Material(density=1000.0, wall_thickness=0.003)
    options = palpate.SurfaceOptions(home_stiffness=home, drag=30.0)
    return palpate.SoftBody(tissue=palpate.build_mass_spring(mesh, wall, 2000.0, options))


def make_table() -> palpate.Scenery:
    """A slab 10 mm thick with its top at z = 0; the lower organ stops at it."""
    corners = list(product((-0.1, 0.1), (-0.1, 0.1), (-0.01, 0.0)))
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]
    return palpate.Scenery(palpate.SurfaceMesh(corners, triangles), [1], friction=0.2)


def make_stone() -> palpate.RigidBody:
    """An ellipsoid of 2000 kg/m³ as a mesh, and fourteen spheres in it that touch its surface."""
    ways = [np.array(d) for d in product((-1, 0, 1), repeat=3) if abs(np.array(d)).sum() in (1, 3)]
    r = 0.45 * HALF.min()
    sphere = make_sphere(32, 15)
    mass = 2000.0 * 4.0 / 3.0 * np.pi * HALF.prod()
    square = HALF**2
    return palpate.RigidBody(
        [(HALF - r) * way / np.linalg.norm(way) for way in ways],
        [r] * len(ways),
        mass=mass,
        inertia=mass / 5.0 * (square.sum() - square),
        position=(0.0, ASIDE, HALF[2]),
        mesh=palpate.SurfaceMesh(HALF * np.asarray(sphere.vertices), sphere.triangles),
    )


def make_jaws() -> palpate.Instrument:
    """Two jaws of 10 mm, which close with 2 N, and no trocar: the hand turns them."""
    r = 0.0012
    capsules = [palpate.Capsule((0, y, 0), (0, y, 0.01)) for y in (r, -r)]
    jaws = palpate.Jaws(hinge=(0, 0, 0.02), axis=(1, 0, 0), open=0.5, grip=2.0)
    tool = palpate.Tool(radius=r, friction=0.5, capsules=capsules, jaws=jaws)
    return palpate.Instrument(tool=tool)


def make_scene() -> palpate.Scene:
    return palpate.build_scene(
        palpate.Scene(
            bodies=[make_organ(3.0 * RADIUS + GAP + 1e-4, 3e3), make_organ(RADIUS + 1e-4, 1e4)],
            body_pairs=[palpate.BodyPair(0, 1)],
            rigid=[make_stone()],
            scenery=[make_table()],
            instruments=[make_jaws()],
            gravity=(0.0, 0.0, -9.81),
        )
    )


PATH = [
    (0.0, (ASIDE, 0.04), False),
    (0.15, (ASIDE, 0.0018), False),
    (0.4, (ASIDE, 0.0018), True),
    (0.9, (ASIDE, 0.1), True),
    (1.3, (0.0, 0.1), True),
    (1.7, (0.0, 4.0 * RADIUS - 0.012), True),
]
"""[s], [m] in y and z, and whether the jaws are closed."""


def find_hand(time: float) -> palpate.HapticSample:
    times = [row[0] for row in PATH]
    y, z = (np.interp(time, times, [row[1][axis] for row in PATH]) for axis in (0, 1))
    closed = any(row[2] for row in PATH if row[0] - 0.2 <= time)
    return palpate.HapticSample(
        position=(0.0, y, z), time=time, buttons=palpate.ATTACH_BUTTON if closed else 0
    )


@dataclass(frozen=True)
class Felt:
    """At the end, but for the first."""

    lifted: float
    """[m] over the table, of the stone at its highest."""
    hand: float
    on_stone: float
    on_lower: float
    on_table: float
    """[N] upwards of the hand and of the tissue on the stone, downwards on the lower organ and on
    the table."""


def carry(scene: palpate.Scene) -> Felt:
    world, lifted = palpate.World(scene), 0.0
    for i in range(1800):
        command = palpate.tick(scene, find_hand(i * TICK), TICK, world)
        assert not world.alarm, world.alarm
        lifted = max(lifted, float(world.rigid[0].position[2]))
    return Felt(
        lifted,
        float(command.force[2]),
        float(world.rigid[0].tissue_force[2]),
        -float(world.body_pairs[0].force[2]),
        float(world.scenery_contacts[0].force[2]),
    )


def main() -> int:
    scene = make_scene()
    felt = carry(scene)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "stone.palpate"
        scenario.write(file, scenario.Scenario(scene=scene, title="A stone and two organs"))
        from_file = carry(scenario.read(file).scene)
    print(
        f"the stone was {1e3 * felt.lifted:.0f} mm up; pressed down, it feels {felt.on_stone:.3f}"
        f" N, the hand {felt.hand:.3f} N, the lower organ {felt.on_lower:.3f} N and the table "
        f"{felt.on_table:.3f} N"
    )
    same = from_file == felt
    print("from a file:", "the same bits" if same else "something else")
    carried = felt.lifted > 0.09 and felt.on_stone > 0.01
    return 0 if same and carried and felt.on_lower > 0.01 and felt.on_table > 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
