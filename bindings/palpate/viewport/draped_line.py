# SPDX-License-Identifier: BSD-3-Clause
"""A line that lies on a surface and goes where the tissue goes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render import Shape
from palpate.viewport.ring import AROUND, build_tube

Array = NDArray[np.float64]

TURNS = 4
"""of the search for a point of the surface at a given distance from another one"""
SPACING = 0.001
"""[m] between the points of a path's line, at most"""


@dataclass(frozen=True)
class DrapedLine:
    """Points of triangles."""

    corners: NDArray[np.int32]
    """(n, 3) Vertices of the surface around each point."""
    weights: Array
    """[-] (n, 3) Barycentric."""
    closed: bool

    def find_points(self, positions: ArrayLike) -> tuple[Array, Array]:
        """[m] (n, 3) Where it is while the surface's vertices are at `positions` [m], and the
        surface's normals there, not of unit length."""
        corners = np.asarray(positions)[self.corners]
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        return np.einsum("nk,nkd->nd", self.weights, corners), np.cross(b - a, c - a)

    def build(self, positions: ArrayLike, thickness: float) -> Shape:
        """Its tube, `thickness` [m] in radius."""
        points, outward = self.find_points(positions)
        return build_tube(points, outward, self.closed, thickness)


class Drape:
    """Lays lines on a surface at rest."""

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike):
        self._vertices = np.array(vertices, dtype=np.float64, order="C")
        self._triangles = np.array(triangles, dtype=np.int32, order="C")
        self._tree = palpate.AabbTree(self._vertices, self._triangles)

    def lay_ring(self, point: ArrayLike, radius: float) -> DrapedLine:
        """Around the place nearest to a point [m], all of it `radius` [m] away from there where
        the surface goes so far."""
        nearest = self._find_nearest(np.asarray(point, dtype=float))
        middle = np.array(nearest.point)
        a, b, c = self._vertices[self._triangles[nearest.triangle]]
        axis = np.cross(b - a, c - a)
        axis /= max(float(np.linalg.norm(axis)), 1e-30)
        first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
        first /= np.linalg.norm(first)
        second = np.cross(axis, first)
        found = []
        for angle in np.arange(AROUND) * 2 * math.pi / AROUND:
            away = math.cos(angle) * first + math.sin(angle) * second
            for _ in range(TURNS):
                there = self._find_nearest(middle + radius * away)
                away = np.asarray(there.point) - middle
                away = away / max(float(np.linalg.norm(away)), 1e-9)
            found.append(there)
        return self._take(found, closed=True)

    def lay_path(self, points: ArrayLike) -> DrapedLine:
        """Along points [m] (n, 3), two or more of them."""
        x = np.asarray(points, dtype=float)
        arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(x, axis=0), axis=1)))
        count = max(2, math.ceil(arc[-1] / SPACING) + 1)
        at = np.linspace(0.0, arc[-1], count)
        fine = np.stack([np.interp(at, arc, x[:, axis]) for axis in range(3)], axis=1)
        return self._take([self._find_nearest(point) for point in fine], closed=False)

    def _find_nearest(self, point: Array) -> palpate.SurfacePoint:
        return palpate.find_closest_point(self._tree, self._vertices, point)

    def _take(self, found: list[palpate.SurfacePoint], closed: bool) -> DrapedLine:
        rows = self._triangles[[point.triangle for point in found]]
        return DrapedLine(rows, np.array([point.weights for point in found]), closed)
