# SPDX-License-Identifier: BSD-3-Clause
"""A spleen: a fist under the ribs, hollowed by its neighbours, notched in front."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import (
    Array,
    apply_turn,
    ball,
    bumps,
    cut,
    ellipsoid_field,
    invert_turn,
    join,
    rod,
    turn_about,
)
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 600
LEAST = 200
LIE = turn_about((1.0, 0.0, 0.0), -28.0)
"""Along the tenth rib: the upper pole lies behind, the lower in front."""


def spleen(vertices: int = VERTICES, size: float = 1.0, seed: int = 0) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 200.
        size: [-] Times as large as the usual one, which is 12 cm long.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    shape = Shape(lambda p: spleen_field(p, seed), (-60.0, -75.0, -85.0), (60.0, 75.0, 85.0), LEAST)
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def to_own_axes(p: Array) -> Array:
    """Long axis along z, upper pole up; convex side +x, notched border -y; straightened."""
    q = apply_turn(invert_turn(LIE), p)
    x, y, z = q.T
    return np.stack([x + 0.0040 * z * z - 5.0, y + 0.0022 * z * z - 3.0, z], axis=1)


def stomach_bed(q: Array) -> Array:
    turn = turn_about((0, 0, 1), -16)
    return ellipsoid_field(q, (-38, -29, 10), (37, 32, 56), turn)


def kidney_bed(q: Array) -> Array:
    turn = turn_about((0, 0, 1), 18)
    return ellipsoid_field(q, (-37, 37, -6), (32, 26, 46), turn)


def colon_bed(q: Array) -> Array:
    return ball(q, (-28, -14, -66), 27.0)


def notches(q: Array) -> Array:
    """Two of the front border, and a shallow third."""
    d = np.full(len(q), np.inf)
    for z, depth, radius in ((32.0, 1.0, 8.0), (3.0, 2.0, 8.5), (-24.0, -2.5, 7.0)):
        y = -46.0 + 0.008 * z * z + depth
        d = np.minimum(d, rod(q, (-30, y, z - 4), (34, y - 2.0, z + 9), radius))
    return d


def vessels(q: Array) -> Array:
    """Where they enter: on the ridge between stomach and kidney."""
    return rod(q, (-27, 2, -22), (-26, 0, 24), 6.0)


def spleen_field(p: Array, seed: int) -> Array:
    q = to_own_axes(p)
    d = ellipsoid_field(q, (0.0, 0.0, 0.0), (26.0, 40.0, 61.0), turn_about((1, 0, 0), 8), 0.25)
    # between the beds of stomach and kidney a ridge is left
    d = join(d, rod(q, (-16, 9, -30), (-16, 7, 28), 12.0), 14.0)
    d = cut(d, stomach_bed(q), 4.0)
    d = cut(d, kidney_bed(q), 4.0)
    d = cut(d, colon_bed(q), 7.0)
    d = cut(d, notches(q), 5.0)
    d = cut(d, vessels(q), 5.0)
    return 0.85 * d + bumps(p, 0.8, 17.0, seed)


def spleen_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    q, m = to_own_axes(p), apply_turn(invert_turn(LIE), n)
    hollow = m[:, 0] < 0.1
    return {
        "hilum": (vessels(q) < 5.0) & hollow,
        "gastric impression": (stomach_bed(q) < 2.5) & hollow,
        "renal impression": (kidney_bed(q) < 2.5) & hollow,
        "colic impression": (colon_bed(q) < 2.5) & (m[:, 0] < 0.4),
        "diaphragmatic surface": m[:, 0] > 0.25,
        "notched border": notches(q) < 4.0,
        "upper pole": q[:, 2] > 44.0,
        "lower pole": q[:, 2] < -44.0,
        # the ligaments to stomach and kidney end around the vessels
        "attachment": (vessels(q) < 9.0) & hollow,
    }
