# SPDX-License-Identifier: BSD-3-Clause
"""Things turned on a lathe: shafts, barrels, needles."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

DECIMALS = 8


def lathe(profile: Sequence[tuple[float, float]], sides: int = 32) -> tuple[np.ndarray, np.ndarray]:
    """A closed surface of revolution about z.

    Args:
        profile: (radius, z) [m] from one end to the other, z falling in all; both ends are closed.
        sides: Vertices around.

    Returns:
        Vertices [m] and triangles, counter-clockwise from outside.
    """
    turn = [2.0 * math.pi * k / sides for k in range(sides)]
    rings = [[(r * math.cos(a), r * math.sin(a), z) for a in turn] for r, z in profile]
    points = [(0.0, 0.0, profile[0][1])]
    for ring in rings:
        points += ring
    points.append((0.0, 0.0, profile[-1][1]))
    triangles = []
    for k in range(sides):
        n = (k + 1) % sides
        triangles.append((0, 1 + k, 1 + n))
        for ring in range(len(rings) - 1):
            a, b = 1 + ring * sides, 1 + (ring + 1) * sides
            triangles += [(a + k, b + k, b + n), (a + k, b + n, a + n)]
        last = 1 + (len(rings) - 1) * sides
        triangles.append((len(points) - 1, last + n, last + k))
    return np.round(np.array(points), DECIMALS), np.array(triangles)
