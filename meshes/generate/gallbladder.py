# SPDX-License-Identifier: BSD-3-Clause
"""A gallbladder with its cystic duct cut: a pear, a pouch at its neck, a twisted duct."""

from __future__ import annotations

from palpate_meshes.generate.field import Array, ball, bumps, join, tube_field
from palpate_meshes.generate.opening import Opening
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 5400
LEAST = 1200
BORDER = 16
AXIS = (
    (0.0, -10.0, -42.0, 15.0),
    (0.0, -7.5, -34.0, 18.0),
    (0.0, -4.5, -23.0, 19.4),
    (0.0, -1.5, -10.0, 17.6),
    (0.5, 0.5, 2.0, 14.4),
    (1.5, 2.0, 13.0, 11.0),
    (3.5, 4.0, 24.0, 8.3),
    (8.0, 6.5, 31.5, 6.0),
    (13.5, 6.0, 34.0, 4.7),
    (17.0, 2.0, 36.0, 4.3),
    (18.5, -1.5, 40.0, 3.6),
    (20.5, -0.5, 44.5, 4.2),
    (19.0, 2.5, 48.5, 3.5),
    (20.0, 2.0, 53.5, 4.1),
    (22.0, 0.0, 58.0, 3.5),
    (21.5, 0.5, 64.0, 3.7),
    (20.5, 1.5, 70.0, 3.6),
    (19.5, 2.5, 76.0, 3.6),
    (18.5, 3.5, 82.0, 3.6),
)
"""[mm] From fundus to duct: x, y, z, radius. The valves of Heister make the duct wind and swell."""


def gallbladder(
    vertices: int = VERTICES, border: int = BORDER, size: float = 1.0, seed: int = 0
) -> tuple[Array, Array]:
    """An open surface of exactly `vertices` vertices, `border` of them around the cut duct.

    It has 2 vertices - 2 - border triangles.

    Args:
        vertices: At least 1200: the duct is thin.
        border: Vertices of the one border loop, at least 5.
        size: [-] Times as large as the usual one, whose sac is 8 cm long.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    rim = Opening((19.0, 3.0, 79.0), (-1.0, 1.0, 6.0), 8.0, border)
    shape = Shape(
        lambda p: gallbladder_field(p, seed), (-26.0, -32.0, -66.0), (34.0, 28.0, 92.0), LEAST, rim
    )
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def pouch(p: Array) -> Array:
    """Hartmann's, which hangs beside the neck."""
    return ball(p, (5.5, 9.5, 22.0), 7.4)


def gallbladder_field(p: Array, seed: int) -> Array:
    d = join(tube_field(p, AXIS[:8], 8), tube_field(p, AXIS[6:], 8), 2.0)
    d = join(d, pouch(p), 4.0)
    return d + bumps(p, 0.5, 16.0, seed)


def gallbladder_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    z = p[:, 2]
    duct = (tube_field(p, AXIS[9:], 8) < 1.0) & (z > 34.0)
    neck = (z > 16.0) & ~duct
    end = duct & (z > 74.0)
    return {
        "fundus": z < -34.0,
        "body": (z >= -34.0) & (z <= 16.0),
        "neck": neck,
        "Hartmann's pouch": neck & (pouch(p) < 1.0),
        "cystic duct": duct,
        "cut end": end,
        # the side that grows to the liver, and the duct that goes on to the bile duct
        "attachment": ((z >= -34.0) & (z <= 16.0) & (n[:, 1] > 0.75)) | end,
    }
