# SPDX-License-Identifier: BSD-3-Clause
"""A left kidney: a bean around its sinus, from which pelvis and ureter hang."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import (
    Array,
    bumps,
    cut,
    ellipsoid_field,
    join,
    tube_field,
)
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 2000
LEAST = 900
PELVIS = (
    (-2.0, 0.0, 5.0, 9.0),
    (-10.0, 0.0, 3.5, 8.8),
    (-19.0, 0.0, 0.5, 8.4),
    (-27.5, 0.5, -4.5, 6.8),
    (-34.0, 1.5, -12.0, 5.0),
    (-37.5, 2.5, -22.0, 3.9),
    (-38.5, 3.0, -33.0, 3.6),
    (-38.0, 3.0, -46.0, 3.5),
    (-39.0, 2.5, -59.0, 3.5),
)
"""[mm] The renal pelvis and the ureter it narrows into: x, y, z, radius."""


def kidney(vertices: int = VERTICES, size: float = 1.0, seed: int = 0) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 900: the ureter is thin.
        size: [-] Times as large as the usual one, which is 11 cm long.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    shape = Shape(lambda p: kidney_field(p, seed), (-52.0, -32.0, -72.0), (45.0, 32.0, 70.0), LEAST)
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def to_own_axes(p: Array) -> Array:
    """Straightened: the bean's axis bends round the hilum, which lies towards -x."""
    x, y, z = p.T
    return np.stack([x + 0.0034 * z * z - 2.0, y, z], axis=1)


def sinus(p: Array) -> Array:
    return ellipsoid_field(p, (-25, 0, 0), (25, 13.5, 22))


def bean_field(p: Array) -> Array:
    """The kidney itself, without pelvis and ureter."""
    q = to_own_axes(p)
    # the upper pole is broader than the lower
    broad = 1.0 + 0.0018 * q[:, 2]
    q = np.stack([q[:, 0] / broad, q[:, 1] / broad, q[:, 2]], axis=1)
    d = ellipsoid_field(q, (0.0, 0.0, 0.0), (29.5, 22.5, 56.0), square=0.25)
    # a shallow bay, and in it the sinus between two lips
    d = cut(d, ellipsoid_field(p, (-37, 0, -1), (17, 32, 22)), 14.0)
    return cut(d, sinus(p), 5.0)


def kidney_field(p: Array, seed: int) -> Array:
    d = join(bean_field(p), tube_field(p, PELVIS, 6), 3.0)
    return d + bumps(p, 1.0, 22.0, seed)


def kidney_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    q = to_own_axes(p)
    hanging = tube_field(p, PELVIS, 6) < 1.2
    pelvis = hanging & (tube_field(p, PELVIS[:5], 6) < 1.2)
    ureter = hanging & ~pelvis
    inside = (sinus(p) < 1.5) & ~hanging
    return {
        "renal pelvis": pelvis,
        "ureter": ureter,
        "renal sinus": inside,
        "hilum": (np.abs(sinus(p)) < 6.0) & (p[:, 0] < -8.0) & ~hanging,
        "capsule": ~hanging & ~inside,
        "upper pole": (q[:, 2] > 38.0) & ~hanging,
        "lower pole": (q[:, 2] < -38.0) & ~hanging,
        "lateral border": (n[:, 0] > 0.75) & ~hanging & ~inside,
        # it lies on the muscles of the back, and the ureter goes on to the bladder
        "attachment": ((n[:, 1] > 0.8) & ~hanging & ~inside) | (ureter & (p[:, 2] < -54.0)),
    }
