# SPDX-License-Identifier: BSD-3-Clause
"""How far two surfaces at rest are from each other, or in each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
CORNER = 1e-9
"""[-] A weight below this is none: the nearest point is on a side or a corner."""


@dataclass(frozen=True)
class Gap:
    """The way from the nearest point of a surface to a vertex beside it."""

    size: float
    """[m] below 0 inside of the surface."""
    normal: Floats
    """[-] (3,), unit, the direction in which the gap grows."""
    vertex: Floats
    """[m] (3,)"""


class Surface:
    """A body's surface at rest, asked how far points are."""

    def __init__(self, x: Floats, triangles: Ints):
        self.x, self.triangles = x, triangles
        self.tree = palpate.AabbTree(x, triangles)
        self.used = x[np.unique(triangles)]
        self.low, self.high = self.used.min(axis=0), self.used.max(axis=0)
        cross = np.cross(x[triangles[:, 1]] - x[triangles[:, 0]],
                         x[triangles[:, 2]] - x[triangles[:, 0]])  # fmt: skip
        self.normals = cross / np.linalg.norm(cross, axis=1)[:, None]
        self.border = {int(v) for loop in palpate.find_border_loops(triangles) for v in loop}
        self.around: dict[int, list[int]] = {}
        for t, row in enumerate(triangles):
            for v in row:
                self.around.setdefault(int(v), []).append(t)

    def find_near(self, p: Floats, reach: float, shift: Floats) -> Gap | None:
        """The gap of a point [m] to the surface moved by `shift`, None beyond `reach` [m].

        Beside an open border there is no inside, and gaps are above 0.
        """
        at = p - shift
        inside = not self.border and bool((at > self.low).all() and (at < self.high).all())
        found = palpate.find_closest_point(self.tree, self.x, at, np.inf if inside else reach)
        if found is None:
            return None
        offset = at - np.asarray(found.point)
        side = self.find_side(found, offset)
        if side >= 0.0 and found.distance > reach:
            return None
        normal = self.normals[found.triangle]
        if found.distance > 1e-9:
            normal = offset / found.distance * (1.0 if side >= 0.0 else -1.0)
        return Gap(found.distance if side >= 0.0 else -found.distance, normal, p)

    def find_side(self, found: palpate.SurfacePoint, offset: Floats) -> float:
        """[m] Above or, below 0, under the steepest of the triangles that meet in a point."""
        corners = self.triangles[found.triangle][np.asarray(found.weights) > CORNER]
        if len(corners) == 3:
            return float(self.normals[found.triangle] @ offset)
        if any(int(v) in self.border for v in corners):
            return found.distance
        meet = set.intersection(*(set(self.around[int(v)]) for v in corners))
        heights = self.normals[sorted(meet)] @ offset
        return float(heights[np.argmax(np.abs(heights))])


def find_gaps(still: Surface, moved: Surface, reach: float, shift: Floats) -> list[Gap]:
    """Gaps up to `reach` [m] of either surface's vertices to the other, `moved` moved by `shift`
    [m]; each normal is the way in which moving it further makes the gap wider."""
    low = np.maximum(still.low, moved.low + shift) - reach
    high = np.minimum(still.high, moved.high + shift) + reach
    if (low > high).any():
        return []
    gaps = []
    for p in moved.used + shift:
        if (p >= low).all() and (p <= high).all():
            gap = still.find_near(p, reach, np.zeros(3))
            if gap is not None:
                gaps.append(gap)
    for p in still.used:
        if (p >= low).all() and (p <= high).all():
            gap = moved.find_near(p, reach, shift)
            if gap is not None:
                gaps.append(Gap(gap.size, -gap.normal, p))
    return gaps


def find_least(still: Surface, moved: Surface, reach: float, shift: Floats) -> Gap | None:
    """The smallest gap; None where all are beyond `reach` [m]."""
    return min(find_gaps(still, moved, reach, shift), key=lambda gap: gap.size, default=None)
