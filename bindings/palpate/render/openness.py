# SPDX-License-Identifier: BSD-3-Clause
"""How much of the sky each point of a surface sees: what makes dents and folds look deep."""

from __future__ import annotations

import math
from collections.abc import Sequence

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render.part import Part
from palpate.render.shadow import Array, DepthMap, look_along

MAP_PIXELS = 512
DIRECTIONS = 128
LIFT = 0.006
"""[-] of the radius: points are lifted off their surface by this, lest it hides itself."""


def spread_directions(count: int) -> Array:
    """Unit vectors (count, 3) spread evenly over the sphere by the golden angle."""
    k = np.arange(count) + 0.5
    z = 1.0 - 2.0 * k / count
    angle = math.pi * (3.0 - math.sqrt(5.0)) * k
    flat = np.sqrt(1.0 - z * z)
    return np.stack([flat * np.cos(angle), flat * np.sin(angle), z], axis=1)


class Sky:
    """Lamps all around a ball, each with the depth map of what stands in its light."""

    def __init__(
        self, context: moderngl.Context, parts: Sequence[Part], centre: Array, radius: float
    ):
        """Draws all the maps, after which no framebuffer is in use."""
        self._radius = radius
        self._directions = spread_directions(DIRECTIONS)
        self._views = [look_along(centre, radius, lamp) for lamp in self._directions]
        depths = DepthMap(context, MAP_PIXELS)
        self._maps = []
        for view in self._views:
            depths.draw(parts, view)
            self._maps.append(depths.read())
        depths.release()

    def measure(self, points: Array, normals: Array, focus: float = 1.0) -> NDArray[np.float64]:
        """Share of the sky over each point, (n,): the mean over all lamps of whether its light
        arrives, weighted by the cosine to the normal, to the power of `focus`.
        """
        lifted = points + LIFT * self._radius * normals
        seen, most = np.zeros(len(points)), np.zeros(len(points))
        for lamp, view, depths in zip(self._directions, self._views, self._maps, strict=True):
            weight = np.maximum(normals @ lamp, 0.0) ** focus
            seen += weight * find_lit(lifted, view, depths)
            most += weight
        return np.divide(seen, most, out=np.ones(len(points)), where=most > 0.0)


def find_lit(points: Array, view: Array, depths: NDArray[np.float32]) -> NDArray[np.float64]:
    """Whether the light of a lamp arrives at points, 0 to 1: the mean of the four nearest pixels of
    its depth map (p, p), which `view`, world to clip space, was drawn with.
    """
    pixels = len(depths)
    clip = points @ view[:3, :3].T + view[:3, 3]
    x, y = ((0.5 + 0.5 * clip[:, axis]) * pixels - 0.5 for axis in (0, 1))
    # nothing stands before a place whose depth is 1: so too where the floor lies deeper yet
    depth = np.minimum(0.5 + 0.5 * clip[:, 2], 1.0)
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    lit = np.zeros(len(points))
    for dj in (0, 1):
        for di in (0, 1):
            row = np.clip(j + dj, 0, pixels - 1)
            column = np.clip(i + di, 0, pixels - 1)
            share = np.abs(1 - di - (x - i)) * np.abs(1 - dj - (y - j))
            # what lies beyond the map is in nobody's shadow: the ball holds all that casts one
            inside = (row == j + dj) & (column == i + di)
            lit += share * ((depth <= depths[row, column]) | ~inside)
    return lit
