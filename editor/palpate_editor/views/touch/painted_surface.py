# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface under a brush, with what painting asks of it again and again. Knows no Qt."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import palpate
from numpy.typing import NDArray

from palpate_editor.brush import build_neighbours, compute_falloff, stamp
from palpate_editor.document import Surface
from palpate_editor.views.touch.stroke import Brush

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

FIRST_RADIUS = 0.07
"""[-] of the diagonal of an organ that a brush has when it first meets it."""


@dataclass(frozen=True)
class Spot:
    """Where the mouse points at the surface, and from where."""

    triangle: int
    weights: Array
    """(3,) barycentric"""
    point: Array
    """[m] (3,)"""
    direction: Array
    """(3,) unit, from the eye"""


class PaintedSurface:
    """One surface; made again when the organ gets another."""

    def __init__(self, surface: Surface):
        self.surface = surface
        self.normals = np.asarray(
            palpate.compute_vertex_normals(surface.vertices, surface.triangles)
        )
        self.neighbours = build_neighbours(surface.triangles, len(surface.vertices))
        self.diagonal = float(palpate.compute_diagonal(surface.vertices))

    def normal_at(self, spot: Spot) -> Array:
        """The smooth outward normal, unit (3,)."""
        normal = spot.weights @ self.normals[self.surface.triangles[spot.triangle]]
        return normal / max(float(np.linalg.norm(normal)), 1e-12)

    def find_nearest(self, spot: Spot) -> int:
        """The corner of the triangle that is nearest to the spot."""
        corners = self.surface.triangles[spot.triangle]
        away = np.linalg.norm(self.surface.vertices[corners] - spot.point, axis=1)
        return int(corners[away.argmin()])

    def reach(self, spot: Spot, brush: Brush) -> tuple[Indices, Array]:
        """The vertices a brush means at a spot, and their weights [-]."""
        vertices = self.surface.vertices
        ids = stamp(
            vertices,
            self.normals,
            self.surface.triangles,
            self.neighbours,
            spot.triangle,
            spot.point,
            brush.radius,
            spot.direction,
            front_only=brush.front_only,
            connected=brush.connected,
        )
        falloff = 1.0 if brush.soft else 0.0
        weights = compute_falloff(vertices, ids, spot.point, brush.radius, falloff)
        # a brush smaller than a triangle means its nearest corner, which lies beyond the rim
        beyond = np.linalg.norm(vertices[ids] - spot.point, axis=1) >= brush.radius
        return ids, np.where(beyond, 1.0, weights)
