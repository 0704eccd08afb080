# SPDX-License-Identifier: BSD-3-Clause
"""A left kidney that can be entered: its collecting system is hollow, dilated as behind a stone,
and a percutaneous access tract leads through the lower pole into it.
"""

from __future__ import annotations

from palpate_meshes.generate.field import Array, bumps, cut, ellipsoid_field, join, rod, tube_field
from palpate_meshes.generate.kidney import bean_field, sinus, to_own_axes
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 2800
LEAST = 2000
PELVIS = (
    (-2.0, 0.0, 4.0, 12.0),
    (-12.0, 0.0, 2.0, 12.5),
    (-23.0, 0.0, 0.0, 11.5),
    (-31.0, 0.5, -6.0, 8.5),
    (-35.0, 1.5, -14.0, 5.4),
    (-37.5, 2.5, -23.0, 4.2),
    (-38.5, 3.0, -33.0, 3.6),
    (-38.0, 3.0, -46.0, 3.5),
    (-39.0, 2.5, -59.0, 3.5),
)
"""[mm] The outside of the pelvis and of the ureter it narrows into: x, y, z, radius. The ureter is
not hollow: the stone blocks it."""
LUMEN = (
    (-11.0, 0.0, 3.0, 7.0),
    (-18.0, 0.0, 1.5, 8.5),
    (-24.0, 0.0, -0.5, 8.0),
    (-29.5, 0.3, -4.5, 5.0),
)
"""[mm] The inside of the pelvis."""
LOWER = ((-20.0, -1.0, -1.0, 6.0), (-13.0, 1.5, -11.0, 6.0), (-6.0, 3.5, -21.0, 7.8))
"""[mm] The lower infundibulum, its neck 12 mm wide, and the calyx at its end."""
MIDDLE = ((-14.0, 0.0, 3.0, 5.0), (-6.0, 1.5, 3.5, 4.5), (1.0, 2.5, 4.0, 6.0))
"""[mm] The middle ones."""
UPPER = ((-17.0, 0.0, 4.0, 5.5), (-12.0, 0.5, 14.0, 4.8), (-8.0, 1.5, 25.0, 7.0))
"""[mm] The upper ones."""
FAT = ((-17.0, 0.0, 1.0), (13.5, 14.0, 25.0))
"""[mm] What fills the sinus around pelvis and infundibula: centre and radii of an ellipsoid."""
ENTRY, MOUTH = (-6.0, 3.5, -21.0), (20.0, 8.5, -58.0)
"""[mm] The axis of the tract, from the calyx to beyond the capsule."""
TRACT = 5.0
"""[mm] Radius of a sheath of 30 French."""


def collecting_system(
    vertices: int = VERTICES, size: float = 1.0, seed: int = 0
) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles: capsule and
    lining, joined at the rim of the tract.

    Args:
        vertices: At least 2000: the ureter is thin, and the neck must stay open.
        size: [-] Times as large as the usual one, which is 11 cm long.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside, so
        that those of the lining face the lumen.
    """
    low, high = (-54.0, -32.0, -72.0), (45.0, 34.0, 70.0)
    shape = Shape(lambda p: collecting_system_field(p, seed), low, high, LEAST)
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def lumen(p: Array) -> Array:
    """What urine fills: pelvis, infundibula and calyces."""
    d = tube_field(p, LUMEN, 6)
    for calyx in (LOWER, MIDDLE, UPPER):
        d = join(d, tube_field(p, calyx, 6), 3.0)
    return d


def tract(p: Array) -> Array:
    return rod(p, ENTRY, MOUTH, TRACT)


def collecting_system_field(p: Array, seed: int) -> Array:
    d = bean_field(p)
    d = join(d, ellipsoid_field(p, *FAT), 8.0)
    d = join(d, tube_field(p, PELVIS, 6), 8.0)
    d = d + bumps(p, 1.0, 22.0, seed)
    d = cut(d, tract(p), 4.0)
    return cut(d, lumen(p), 1.5)


def collecting_system_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    q = to_own_axes(p)
    in_tract = tract(p) < 1.0
    lining = (lumen(p) < 1.0) & ~in_tract
    outside = ~lining & ~in_tract
    hanging = (tube_field(p, PELVIS, 6) < 1.5) & outside
    pelvis = hanging & (tube_field(p, PELVIS[:5], 6) < 1.5)
    ureter = hanging & ~pelvis
    inside = (sinus(p) < 1.5) & outside & ~hanging
    capsule = outside & ~hanging & ~inside
    return {
        "renal pelvis": pelvis,
        "ureter": ureter,
        "renal sinus": inside,
        "capsule": capsule,
        "upper pole": (q[:, 2] > 38.0) & capsule,
        "lower pole": (q[:, 2] < -38.0) & capsule,
        "lining of the pelvis": lining & (tube_field(p, LUMEN, 6) < 1.5),
        "lower calyx": lining & (tube_field(p, LOWER, 6) < 1.5),
        "middle calyx": lining & (tube_field(p, MIDDLE, 6) < 1.5),
        "upper calyx": lining & (tube_field(p, UPPER, 6) < 1.5),
        "access tract": in_tract,
        # it lies on the muscles of the back, and the ureter goes on to the bladder
        "attachment": ((n[:, 1] > 0.8) & capsule) | (ureter & (p[:, 2] < -54.0)),
    }
