# SPDX-License-Identifier: BSD-3-Clause
"""What makes folds look deep and a thing stand on the floor, gathered while a window is idle."""

from __future__ import annotations

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render import Part
from palpate.render.ground import FOCUS, Ground, lay_floor, shade_floor
from palpate.render.openness import LIFT, find_lit, spread_directions
from palpate.render.shadow import DepthMap, look_along

Array = NDArray[np.float64]

DIRECTIONS, MAP_PIXELS = 96, 256
"""Fewer and smaller than for a picture that is drawn once: half a second on a processor."""


class SkyLight:
    """How much of the sky the points of a surface, and of the floor under it, see.

    The context must be current in every call but result().
    """

    def __init__(
        self,
        context: moderngl.Context,
        part: Part,
        surface: tuple[Array, Array],
        ball: tuple[Array, float],
    ):
        """`part` shows the surface, given as vertices [m] and normals; `ball` holds it, [m]."""
        self._context, self._part = context, part
        self._centre, self._radius = ball
        vertices, normals = surface
        self.vertices = vertices
        self._floor = float(vertices[:, 2].min())
        points, up = lay_floor(self._centre, self._radius, self._floor)
        self._points = np.concatenate([vertices + LIFT * self._radius * normals, points])
        self._normals = np.concatenate([normals, up])
        self._focus = np.where(np.arange(len(self._points)) < len(vertices), 1.0, FOCUS)
        self._seen, self._most = np.zeros(len(self._points)), np.zeros(len(self._points))
        self._left = list(spread_directions(DIRECTIONS))
        self._depths = DepthMap(context, MAP_PIXELS)

    def step(self) -> bool:
        """Looks at the sky in one more direction; False once that was all."""
        lamp = self._left.pop()
        view = look_along(self._centre, self._radius, lamp)
        self._depths.draw([self._part], view)
        weight = np.maximum(self._normals @ lamp, 0.0) ** self._focus
        self._seen += weight * find_lit(self._points, view, self._depths.read())
        self._most += weight
        return bool(self._left)

    def result(self) -> NDArray[np.float64]:
        """Share of the sky that each vertex sees, (n,)."""
        return self._share()[: len(self.vertices)]

    def build_ground(self) -> Ground:
        share = self._share()[len(self.vertices) :]
        return shade_floor(self._context, self._centre, self._radius, self._floor, share)

    def release(self) -> None:
        self._depths.release()

    def _share(self) -> NDArray[np.float64]:
        whole = np.ones(len(self._seen))
        return np.divide(self._seen, self._most, out=whole, where=self._most > 0.0)
