# SPDX-License-Identifier: BSD-3-Clause
"""How deep things lie as seen from far away: the shadows of a lamp, and how open a place is."""

from __future__ import annotations

from collections.abc import Iterable

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render.part import Part
from palpate.render.program import build_program, write_matrix

Array = NDArray[np.float64]

SHADOW_PIXELS = 2048
"""Sides of the map of a lamp: a two-hundredth of an organ is ten of them."""


def look_along(centre: Array, radius: float, to_lamp: Array) -> Array:
    """World to clip space, (4, 4), of a ball seen from infinitely far along `to_lamp`, unit."""
    helper = np.eye(3)[np.abs(to_lamp).argmin()]
    right = np.cross(helper, to_lamp)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(to_lamp, right), -to_lamp])
    matrix = np.eye(4)
    matrix[:3, :3] = axes / radius
    matrix[:3, 3] = -matrix[:3, :3] @ centre
    return matrix


class DepthMap:
    """A square picture of depths, 0 near to 1 far, of what parts cast a shadow."""

    def __init__(self, context: moderngl.Context, pixels: int):
        self.pixels = pixels
        self.texture = context.depth_texture((pixels, pixels))
        self._context = context
        self._target = context.framebuffer(depth_attachment=self.texture)
        self._program = build_program(context, "depth")

    def draw(self, parts: Iterable[Part], world_to_clip: Array) -> None:
        self._target.use()
        self._target.clear(depth=1.0)
        self._context.enable_only(moderngl.DEPTH_TEST)
        write_matrix(self._program, "world_to_clip", world_to_clip)
        for part in parts:
            if part.appearance.casts_shadow:
                part.draw_depth(self._program)

    def read(self) -> NDArray[np.float32]:
        """(pixels, pixels), the lowest row first."""
        data = np.frombuffer(self.texture.read(), np.float32)
        return data.reshape(self.pixels, self.pixels)

    def release(self) -> None:
        for thing in (self._target, self.texture, self._program):
            thing.release()


class ShadowMap:
    """The depth map of one lamp, which shaders compare with."""

    def __init__(self, context: moderngl.Context):
        self._map = DepthMap(context, SHADOW_PIXELS)
        self._map.texture.compare_func = "<="
        self._map.texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        self._map.texture.repeat_x = self._map.texture.repeat_y = False
        self.texture = self._map.texture
        self.world_to_texture = np.eye(4)

    def draw(self, parts: Iterable[Part], centre: Array, radius: float, to_lamp: Array) -> None:
        """Leaves its own framebuffer in use."""
        world_to_clip = look_along(centre, radius, to_lamp)
        self._map.draw(parts, world_to_clip)
        clip_to_texture = np.diag([0.5, 0.5, 0.5, 1.0])
        clip_to_texture[:3, 3] = 0.5
        self.world_to_texture = clip_to_texture @ world_to_clip

    def release(self) -> None:
        self._map.release()
