# SPDX-License-Identifier: BSD-3-Clause
"""A liver: a wedge under the diaphragm, its lower edge sharp, its underside moulded."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import (
    Array,
    ball,
    bumps,
    cut,
    ellipsoid_field,
    join,
    keep,
    ramp,
    rod,
    smooth_min,
    turn_about,
)
from palpate_meshes.generate.settle import Shape, build_mesh

VERTICES = 6214
LEAST = 800
FURROW_DEPTH, FURROW_WIDTH = 2.0, 5.0
"""[mm] Of the falciform line; the width to either side."""


def liver(vertices: int = VERTICES, size: float = 1.0, seed: int = 0) -> tuple[Array, Array]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 800.
        size: [-] Times as large as the usual one, which is 22 cm wide.
        seed: Another mesh, with other small bumps.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    shape = Shape(
        lambda p: liver_field(p, seed), (-125.0, -85.0, -105.0), (140.0, 95.0, 90.0), LEAST
    )
    points, triangles = build_mesh(shape, vertices, seed)
    return size * points, triangles


def liver_field(p: Array, seed: int) -> Array:
    # x: the patient's left, -y: the front, z: up
    right = ellipsoid_field(p, (-40, 6, -12), (74, 68, 88), turn_about((0, 1, 0), 8), 0.30)
    left = ellipsoid_field(p, (41, -22, 6), (79, 42, 50), turn_about((0, 1, 0), -6), 0.30)
    d = keep(join(right, left, 40.0), diaphragm(p), 22.0)
    d = cut(d, spine(p), 26.0)
    # the rim of the underside is sharp in front, blunt behind
    d = mould(p, keep(d, underside(p), 8.0 + 16.0 * ramp(p[:, 1], -15.0, 45.0)))
    return d + FURROW_DEPTH * falciform_line(p) + bumps(p, 0.9, 42.0, seed)


def diaphragm(p: Array) -> Array:
    """Two domes, the right one higher; the heart lies in the saddle between them."""
    x, y, z = p.T
    right = 0.0040 * (x + 48.0) * (x + 48.0) + 0.0030 * (y - 6.0) * (y - 6.0) - 66.0
    left = 0.0024 * (x - 62.0) * (x - 62.0) + 0.0030 * (y + 10.0) * (y + 10.0) - 42.0
    return z + smooth_min(right, left, 14.0)


def spine(p: Array) -> Array:
    """It and the muscles beside it hollow the back, to the left of the right lobe."""
    return rod(p, (40, 92, -120), (40, 92, 120), 54.0)


def underside(p: Array) -> Array:
    """It faces down, back and to the left, and is a little hollow, which makes its rim sharp."""
    return -ball(p, (155, 205, -329), 400.0)


def stomach_bed(p: Array) -> Array:
    return ellipsoid_field(p, (66, 26, -20), (66, 44, 36), turn_about((0, 1, 0), -12))


def kidney_bed(p: Array) -> Array:
    return ellipsoid_field(p, (-44, 60, -58), (32, 34, 44))


def gallbladder_bed(p: Array) -> Array:
    """From the lower edge up to the porta hepatis."""
    return rod(p, (-44, -58, -97), (-14, 6, -26), 13.0, 7.5)


def porta(p: Array) -> Array:
    return rod(p, (-16, 10, -26), (24, 0, -13), 5.5)


def caudate(p: Array) -> Array:
    return ellipsoid_field(p, (8, 36, 4), (16, 14, 24), turn_about((0, 1, 0), 10))


def vena_cava(p: Array) -> Array:
    return rod(p, (17, 47, -60), (12, 50, 62), 12.5)


def round_ligament(p: Array) -> Array:
    """Its notch in the lower edge."""
    return rod(p, (29, -62, -53), (24, 0, -13), 7.5, 5.0)


def mould(p: Array, d: Array) -> Array:
    """The marks that neighbours and vessels leave on the underside and behind."""
    d = cut(d, stomach_bed(p), 10.0)
    d = cut(d, kidney_bed(p), 10.0)
    d = cut(d, gallbladder_bed(p), 9.0)
    d = cut(d, porta(p), 9.0)
    d = join(d, caudate(p), 12.0)
    d = cut(d, vena_cava(p), 7.0)
    return cut(d, round_ligament(p), 7.0)


def falciform_line(p: Array) -> Array:
    """[-] 1 in the middle of a furrow over the front and the top, where the lobes meet."""
    y = p[:, 1]
    aside = to_the_left(p) / FURROW_WIDTH
    across = np.maximum(1.0 - aside * aside, 0.0)
    front = ramp(-underside(p), 6.0, 16.0) * (1.0 - ramp(y, 10.0, 30.0))
    return across * across * front


def to_the_left(p: Array) -> Array:
    """[mm] Of the falciform line."""
    return p[:, 0] - 25.0 + 0.2 * (p[:, 2] + 14.0)


def liver_regions(p: Array, n: Array) -> dict[str, Array]:
    """Masks of the vertices at p [mm] with normals n."""
    y, z = p[:, 1], p[:, 2]
    below = (underside(p) > -14.0) & (n[:, 2] < 0.25)
    tail = (caudate(p) < 2.0) & (n[:, 2] < 0.7)
    bed = (gallbladder_bed(p) < 2.5) & (n[:, 2] < 0.3)
    square = below & (p[:, 0] > -14.0 + 0.342 * (y - 6.0)) & (to_the_left(p) < 0.0) & (y < 0.0)
    behind = (n[:, 1] > 0.6) & (z > 5.0)
    cava = vena_cava(p) < 2.5
    line = falciform_line(p) > 0.2
    return {
        "right lobe": to_the_left(p) < 0.0,
        "left lobe": to_the_left(p) >= 0.0,
        "quadrate lobe": square & (gallbladder_bed(p) > 2.0) & (round_ligament(p) > 0.0),
        "caudate lobe": tail,
        "gallbladder fossa": bed,
        "porta hepatis": porta(p) < 2.5,
        "falciform line": line,
        "round ligament notch": round_ligament(p) < 2.5,
        "vena cava groove": cava,
        "bare area": behind & (p[:, 0] > -95.0) & (p[:, 0] < 12.0) & ~cava & ~tail,
        "gastric impression": (stomach_bed(p) < 2.5) & below,
        "renal impression": (kidney_bed(p) < 2.5) & (n[:, 2] < 0.3),
        "lower edge": (np.abs(underside(p)) < 8.0) & (y < -20.0) & (n[:, 1] < -0.2),
        # it is grown to the diaphragm and the great vein, and hangs on the falciform ligament
        "attachment": (behind & (p[:, 0] > -95.0) & (p[:, 0] < 12.0)) | cava | line,
    }
