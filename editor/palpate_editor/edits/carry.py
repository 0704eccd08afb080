# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking what was painted on one surface over to another of the same organ."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface
from palpate_editor.edits.wall import settle_wall


def carry_paint(organ: Organ, surface: Surface) -> Organ:
    """`organ` on `surface`, each vertex painted as the old surface is at the point closest to it.

    A factor of stiffness is interpolated; a vertex is fixed, or in a region, where most of its
    point is. A region that nothing is left of goes. A
    surface that is open now has a wall.
    """
    old = organ.surface
    fresh = settle_wall(organ.with_surface(surface), organ)
    painted = organ.fixed.any() or (organ.stiffness_scale != 1.0).any() or organ.regions
    if old is None or not painted:
        return fresh
    corners, weights = find_closest(old, surface.vertices)

    def spread(values: np.ndarray) -> np.ndarray:
        return (values[corners] * weights).sum(axis=1)

    regions = {}
    for name, ids in organ.regions.items():
        inside = np.zeros(len(old.vertices))
        inside[ids] = 1.0
        kept = np.flatnonzero(spread(inside) >= 0.5)
        if kept.size:
            regions[name] = kept
    return replace(
        fresh,
        fixed=spread(organ.fixed.astype(float)) >= 0.5,
        stiffness_scale=spread(organ.stiffness_scale),
        regions=regions,
    )


def find_closest(surface: Surface, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3) and weights (n, 3) of the surface's points closest to `points` [m] (n, 3)."""
    tree = palpate.AabbTree(surface.vertices, surface.triangles)
    found = [palpate.find_closest_point(tree, surface.vertices, point) for point in points]
    corners = surface.triangles[[near.triangle for near in found]]
    return corners, np.array([near.weights for near in found])
