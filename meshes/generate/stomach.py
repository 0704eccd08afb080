# SPDX-License-Identifier: BSD-3-Clause
"""A stomach: a J from the oesophagus to the pylorus, its fundus under the diaphragm."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import (
    Array,
    bumps,
    cut,
    ellipsoid_field,
    join,
    rod,
    tube_field,
    turn_about,
)
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 3000
LEAST = 700
FLAT = 1.14
"""[-] By which it is thinner from front to back than from side to side."""
BODY = (
    (31.0, 2.0, 50.0, 31.0),
    (39.0, -1.0, 33.0, 33.0),
    (41.0, -5.0, 10.0, 31.5),
    (36.0, -10.0, -13.0, 28.5),
    (23.0, -15.0, -33.0, 25.5),
    (3.0, -17.0, -44.0, 22.0),
    (-16.0, -14.0, -43.0, 18.5),
    (-31.0, -9.0, -35.0, 14.0),
    (-39.5, -5.0, -27.0, 9.8),
    (-43.0, -2.5, -22.5, 8.0),
)
"""[mm] Body and antrum as far as the pylorus: x, y, z, radius."""
BULB = (
    (-43.0, -2.5, -22.5, 8.4),
    (-47.0, 0.0, -17.0, 11.0),
    (-54.0, 4.0, -10.0, 12.0),
    (-62.0, 9.0, -5.0, 10.5),
)
"""[mm] The beginning of the duodenum."""
OESOPHAGUS = (
    (-3.0, 12.0, 96.0, 8.6),
    (0.0, 10.0, 84.0, 8.4),
    (4.0, 8.0, 72.0, 8.6),
    (11.0, 5.0, 60.0, 10.0),
    (21.0, 3.0, 48.0, 13.0),
)


def stomach(vertices: int = VERTICES, size: float = 1.0, seed: int = 0) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 700.
        size: [-] Times as large as the usual one, which is 19 cm high and half filled.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    shape = Shape(
        lambda p: stomach_field(p, seed), (-85.0, -60.0, -85.0), (90.0, 55.0, 120.0), LEAST
    )
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def stomach_field(p: Array, seed: int) -> Array:
    q = p * np.array([1.0, FLAT, 1.0])
    d = tube_field(q, BODY, 8)
    # the fundus rises to the left of the oesophagus: between them is the cardiac notch
    d = join(d, ellipsoid_field(q, (39, 4, 68), (36, 32, 29), turn_about((0, 1, 0), 24)), 16.0)
    d = join(d, tube_field(q, OESOPHAGUS, 6), 4.0)
    # the angular notch of the lesser curvature
    d = cut(d, rod(q, (-1.0, -60.0, -12.0), (-1.0, 40.0, -12.0), 5.5), 10.0)
    d = join(d, tube_field(q, BULB, 6), 1.2)
    return d + bumps(p, 1.3, 30.0, seed)


def stomach_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    q = p * np.array([1.0, FLAT, 1.0])
    x, _, z = p.T
    gullet = (tube_field(q, OESOPHAGUS[:3], 6) < 2.0) & (z > 66.0) & (x < 12.0)
    bulb = tube_field(q, BULB[1:], 6) < 1.5
    antrum = (tube_field(q, BODY[6:], 8) < 1.5) & ~bulb
    pylorus = tube_field(q, (BODY[-2], BODY[-1]), 6) < 1.5
    fundus = (z > 62.0) & ~gullet
    side = np.stack([q[:, 0] - 4.0, q[:, 2] - 8.0], axis=1)
    away = n[:, 0] * side[:, 0] + n[:, 2] * side[:, 1]
    stretch = np.sqrt(side[:, 0] * side[:, 0] + side[:, 1] * side[:, 1])
    trunk = ~gullet & ~bulb
    return {
        "oesophagus": gullet,
        "cardia": (tube_field(q, OESOPHAGUS[2:4], 6) < 2.5) & ~gullet,
        "fundus": fundus,
        "body": trunk & ~fundus & ~antrum & ~pylorus,
        "antrum": antrum & ~pylorus,
        "pylorus": pylorus & ~bulb,
        "duodenal bulb": bulb,
        "greater curvature": trunk & (away > 0.85 * stretch),
        "lesser curvature": trunk & (away < -0.6 * stretch),
        # it hangs between the oesophagus and the duodenum, which lies on the back wall
        "attachment": (gullet & (z > 78.0)) | (bulb & (x < -50.0)),
    }
