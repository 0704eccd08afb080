# SPDX-License-Identifier: BSD-3-Clause
"""A kidney stone: a mulberry of calcium oxalate, about a centimetre large."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import Array, ball, bumps, ellipsoid_field, join
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 120
LEAST = 80
KNOBS = 11
GOLDEN = 0.6180339887498949
"""Knobs turn by this part of a circle from one to the next, so that none stand in a row."""


def kidney_stone(vertices: int = VERTICES, size: float = 1.0, seed: int = 0) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 80.
        size: [-] Times as large as the usual one, which is 11 mm long.
        seed: Another stone.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    shape = Shape(lambda p: stone_field(p, seed), (-8.5, -7.5, -6.5), (8.5, 7.5, 6.5), LEAST)
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def stone_field(p: Array, seed: int) -> Array:
    d = ellipsoid_field(p, (0.0, 0.0, 0.0), (4.6, 3.9, 3.2))
    random = np.random.default_rng(seed)
    for k in range(KNOBS):
        place = point_on_sphere(k) * np.array([4.0, 3.3, 2.6])
        d = join(d, ball(p, place, 1.35 + 0.55 * float(random.random())), 0.55)
    return d + bumps(p, 0.12, 2.3, seed)


def point_on_sphere(k: int) -> Array:
    """The k-th of the knobs' directions; a circle in rational steps, for the same bits anywhere."""
    height = 1.0 - 2.0 * (k + 0.5) / KNOBS
    turn = (k * GOLDEN) % 1.0
    # the circle's rational parametrisation, quarter by quarter
    quarter, part = int(4.0 * turn), (4.0 * turn) % 1.0
    c, s = (1.0 - part * part) / (1.0 + part * part), 2.0 * part / (1.0 + part * part)
    for _ in range(quarter):
        c, s = -s, c
    across = float(np.sqrt(1.0 - height * height))
    return np.array([across * c, across * s, height])


def kidney_stone_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    # nothing of a stone gives: it is held whole
    return {"crown": n[:, 2] > 0.5, "attachment": np.ones(len(p), bool)}
