# SPDX-License-Identifier: BSD-3-Clause
"""Things whose sections are known: turned on a lathe, or filed to any outline."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from palpate_meshes.generate.field import Array

DECIMALS = 8
"""Of vertices in metres, as the organs'."""


def loft(rings: Sequence[Array], ends: tuple[Array, Array]) -> tuple[Array, Array]:
    """A closed surface through rings of points, each of as many.

    Args:
        rings: (k, 3) [m] each, counter-clockwise seen from the first end, one behind the other.
        ends: (3,) [m] The middles of the first and of the last ring, where fans close them.

    Returns:
        Vertices [m] and triangles, counter-clockwise from outside.
    """
    sides = len(rings[0])
    points = np.concatenate([ends[0][None], *rings, ends[1][None]])
    triangles = []
    for k in range(sides):
        n = (k + 1) % sides
        triangles.append((0, 1 + k, 1 + n))
        for ring in range(len(rings) - 1):
            a, b = 1 + ring * sides, 1 + (ring + 1) * sides
            triangles += [(a + k, b + k, b + n), (a + k, b + n, a + n)]
        last = 1 + (len(rings) - 1) * sides
        triangles.append((len(points) - 1, last + n, last + k))
    return np.round(points, DECIMALS), np.array(triangles)


def lathe(profile: Sequence[tuple[float, float]], sides: int = 32) -> tuple[Array, Array]:
    """A closed surface of revolution about z.

    Args:
        profile: (radius, z) [m] from one end to the other, z falling in all; both ends are closed.
        sides: Vertices around.
    """
    turn = [2.0 * math.pi * k / sides for k in range(sides)]
    rings = [np.array([(r * math.cos(a), r * math.sin(a), z) for a in turn]) for r, z in profile]
    first, last = (np.array([0.0, 0.0, profile[i][1]]) for i in (0, -1))
    return loft(rings, (first, last))
