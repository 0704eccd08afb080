# SPDX-License-Identifier: BSD-3-Clause
"""A scene with a stone that falls on a table beside an organ."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
from palpate import scenario
from surfaces import ellipsoid, organ_scene

TABLE = -0.06
"""[m] The top of the table."""
RADIUS = 0.005
"""[m] Of the stone, a ball."""
START = (0.05, 0.0, 0.0)
"""[m] Where it begins."""
HALF = np.array([5.5, 4.5, 4.0])
"""[mm] Half axes of the stone of a mesh."""


def make_table(half: float = 0.1) -> palpate.SurfaceMesh:
    """A slab 10 mm thick."""
    corners = [
        (x, y, z) for x in (-half, half) for y in (-half, half) for z in (TABLE - 0.01, TABLE)
    ]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]
    return palpate.SurfaceMesh(corners, triangles)


def make_stone_mesh(scale: float = 1.0, fine: int = 2) -> palpate.SurfaceMesh:
    """An ellipsoid of these half axes times `scale`."""
    ball = ellipsoid((1.0, 1.0, 1.0), fine)
    x = np.asarray(ball.vertices)
    return palpate.SurfaceMesh(scale * HALF * x / np.abs(x).max(axis=0), ball.triangles)


def make_stone() -> palpate.RigidBody:
    mass = 2000.0 * 4.0 / 3.0 * np.pi * RADIUS**3
    inertia = 0.4 * mass * RADIUS**2
    return palpate.RigidBody(
        [(0, 0, 0)], [RADIUS], mass=mass, inertia=[inertia] * 3, position=START
    )


def make_stone_scene() -> palpate.Scene:
    tissue = organ_scene(1).bodies[0].tissue
    return palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue)],
            rigid=[make_stone()],
            scenery=[palpate.Scenery(make_table(), [0])],
            gravity=(0.0, 0.0, -9.81),
        )
    )


def write_stone(folder: Path) -> Path:
    path = folder / "stone.palpate"
    scenario.write(path, scenario.Scenario(scene=make_stone_scene(), title="A stone"))
    return path
