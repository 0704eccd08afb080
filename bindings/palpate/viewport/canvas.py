# SPDX-License-Identifier: BSD-3-Clause
"""Where frames are drawn before they are shown: at once, and then as finely as there is time for.

A graphics card draws every frame in full. A processor that stands in for one would need most of a
second for it, so it draws a smaller frame without shadows while things move, and once they rest
the fine one, tile by tile, each short enough not to be noticed.
"""

from __future__ import annotations

import math
import time
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render import Camera, Tile
from palpate.render.studio import cut_tiles
from palpate.viewport.scenery import Scenery

SOFTWARE = ("llvmpipe", "softpipe", "swrast")
QUICK_SIZES = (1 / 3, 1 / 2.5, 1 / 2, 2 / 3, 1.0)
"""[-] of the view's width and height that a processor draws while things move; the frame is
stretched to the view. With less than a third nobody sees a dent: then there are fewer frames."""
QUICK_TIME = 0.040
"""[s] that this may take; the size follows."""
MOST_PAUSE = 0.25
"""[s] without a frame after one that took too long."""
LIGHT_SURFACE = 5_000
"""Triangles of a surface whose first frame may be as large as the ones before it."""
TILES = (64, 96, 128, 192, 256)
"""[px] Sides of what is drawn between two events of the window."""
TILE_TIME = 0.030
"""[s] that this may take; the size of the tiles follows."""
SAMPLES = 4
SHADOW_SOFTNESS = 0.035
WIRE_WIDTH = 1.05
"""[px]"""
COPY_VERTEX = """#version 330 core
uniform bool upside_down;
out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
  if (upside_down) place.y = 1.0 - place.y;
}"""
COPY_FRAGMENT = """#version 330 core
in vec2 place;
uniform sampler2D frame;
out vec4 result;
void main() { result = vec4(texture(frame, place).rgb, 1.0); }"""

Size = tuple[int, int]


class Target:
    """A framebuffer of some size; drawn in with several samples and looked at with one."""

    def __init__(self, context: moderngl.Context, size: Size, samples: int):
        self._context, self.size = context, size
        samples = min(samples, context.max_samples)
        self.texture = context.texture(size, 4, alignment=1)
        self.texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        self.texture.repeat_x = self.texture.repeat_y = False
        depth = context.depth_renderbuffer(size, samples=samples)
        self._things: list[Any] = [depth, self.texture]
        if samples:
            colour = context.renderbuffer(size, 4, samples=samples)
            self.drawn = context.framebuffer([colour], depth)
            self.frame = context.framebuffer([self.texture])
            self._things += [colour, self.drawn]
        else:
            self.drawn = self.frame = context.framebuffer([self.texture], depth)
        self._things.append(self.frame)

    def resolve(self) -> None:
        if self.drawn is not self.frame:
            self._context.copy_framebuffer(self.frame, self.drawn)

    def release(self) -> None:
        for thing in self._things:
            thing.release()


class Canvas:
    """The frames of one view on a context, which must be current in every call."""

    def __init__(self, context: moderngl.Context):
        self._context = context
        self._program = context.program(vertex_shader=COPY_VERTEX, fragment_shader=COPY_FRAGMENT)
        self._copy = context.vertex_array(self._program, [])
        name = context.info["GL_RENDERER"].lower()
        self.is_software = any(word in name for word in SOFTWARE)
        self._targets: dict[str, Target] = {}
        self._key: object = None
        self._inset_key: object = None
        self._tiles: list[Tile] | None = None
        self._is_fine = False
        self._tile_size, self._slowest = 1, 0.0
        self._quick_size, self._surface_version = 2, -1
        self.pause = 0.0
        """[s] that whatever else the processor does should have before it draws the next frame."""

    def draw(self, scenery: Scenery, camera: Camera, size: Size, ratio: float) -> bool:
        """Draws a frame of `size` pixels, `ratio` of them for each of the window's.

        False, at no cost, where nothing has changed since the last one.
        """
        key = (scenery.version, camera.describe(), size)
        if key == self._key:
            return False
        self._key, self._tiles, self._is_fine = key, None, not self.is_software
        shrink, begun = 1.0, time.perf_counter()
        if self.is_software:
            self._expect(scenery)
            shrink = QUICK_SIZES[self._quick_size]
        small = (max(1, math.ceil(shrink * size[0])), max(1, math.ceil(shrink * size[1])))
        target = self._use("whole", small, SAMPLES if self._is_fine else 0)
        renderer = scenery.prepare(
            SHADOW_SOFTNESS if self._is_fine else 0.0, WIRE_WIDTH * ratio * shrink
        )
        target.drawn.use()
        renderer.draw(camera, small)
        target.resolve()
        if self.is_software:
            self._context.finish()
            self._choose_quick_size(time.perf_counter() - begun)
        return True

    def refine(self, scenery: Scenery, camera: Camera, size: Size, ratio: float) -> bool:
        """Draws the next tile of the fine frame of what was drawn last; False once it is whole."""
        if self._is_fine or self._key != (scenery.version, camera.describe(), size):
            return False
        begun = time.perf_counter()
        renderer = scenery.prepare(SHADOW_SOFTNESS, WIRE_WIDTH * ratio)
        side = TILES[self._tile_size]
        if self._tiles is None:
            self._tiles = list(cut_tiles(size, side))
            renderer.cast_shadows(camera)
            self._context.finish()
            return True
        tile = self._tiles.pop()
        small = self._use("tile", (side, side), SAMPLES)
        small.drawn.use()
        renderer.draw(camera, size, tile, new_shadows=False)
        small.resolve()
        fine = self._use("fine", size, 0)
        self._stretch(small.texture, fine.frame, (tile.left, tile.bottom, side, side))
        # drivers put work off, and then it would count as the cost of another part
        self._context.finish()
        self._slowest = max(self._slowest, time.perf_counter() - begun)
        self._is_fine = not self._tiles
        if self._is_fine:
            self._choose_tile_size()
        return not self._is_fine

    def draw_inset(
        self, scenery: Scenery, camera: Camera, size: Size, ratio: float
    ) -> NDArray[np.uint8] | None:
        """A second, small picture of what draw() drew, without shadows: (h, w, 4), the top row
        first. None, at no cost, where nothing has changed since the last one."""
        key = (scenery.version, camera.describe(), size)
        if key == self._inset_key:
            return None
        self._inset_key = key
        target = self._use("inset", size, SAMPLES)
        renderer = scenery.prepare(0.0, WIRE_WIDTH * ratio)
        target.drawn.use()
        renderer.draw(camera, size)
        target.resolve()
        pixels = np.empty((size[1], size[0], 4), np.uint8)
        self._copy_out(target, "inset screen", pixels)
        return pixels

    def paste(self, target: moderngl.Framebuffer, size: Size) -> None:
        """Shows the best frame there is in a framebuffer of `size` pixels."""
        self._stretch(self._best().texture, target, (0, 0, *size))

    def read(self, pixels: NDArray[np.uint8]) -> None:
        """Copies the best frame there is to (h, w, 4), stretched, the top row first."""
        self._copy_out(self._best(), "screen", pixels)

    def _copy_out(self, target: Target, through: str, pixels: NDArray[np.uint8]) -> None:
        """To (h, w, 4), stretched, by way of a target of that size."""
        size = (pixels.shape[1], pixels.shape[0])
        screen = self._use(through, size, 0)
        self._stretch(target.texture, screen.frame, (0, 0, *size), upside_down=True)
        screen.frame.read_into(pixels, components=4, alignment=1)

    def release(self) -> None:
        for thing in (*self._targets.values(), self._copy, self._program):
            thing.release()
        self._targets.clear()
        self._key = self._inset_key = None

    def _expect(self, scenery: Scenery) -> None:
        """A new surface of many triangles may take long, so its first frame is drawn small."""
        if scenery.surface_version != self._surface_version:
            self._surface_version = scenery.surface_version
            if len(scenery.triangles) > LIGHT_SURFACE:
                self._quick_size, self._tile_size = 0, 0

    def _choose_quick_size(self, taken: float) -> None:
        """For the next quick frame, by what this one took [s]."""
        self.pause = min(taken, MOST_PAUSE) if taken > QUICK_TIME else 0.0
        if taken > QUICK_TIME:
            self._quick_size = max(0, self._quick_size - 1)
        elif taken < QUICK_TIME / 2.2:
            self._quick_size = min(len(QUICK_SIZES) - 1, self._quick_size + 1)

    def _choose_tile_size(self) -> None:
        """For the next fine frame, by what the tiles of this one took."""
        if self._slowest > TILE_TIME:
            self._tile_size = max(0, self._tile_size - 1)
        elif self._slowest < TILE_TIME / 3:
            self._tile_size = min(len(TILES) - 1, self._tile_size + 1)
        self._slowest = 0.0

    def _best(self) -> Target:
        return self._targets["fine" if self._is_fine and self.is_software else "whole"]

    def _use(self, name: str, size: Size, samples: int) -> Target:
        old = self._targets.get(name)
        if old is None or old.size != size:
            if old is not None:
                old.release()
            self._targets[name] = Target(self._context, size, samples)
        return self._targets[name]

    def _stretch(
        self,
        texture: moderngl.Texture,
        target: moderngl.Framebuffer,
        place: tuple[int, int, int, int],
        upside_down: bool = False,
    ) -> None:
        target.use()
        target.viewport = place
        self._context.enable_only(moderngl.NOTHING)
        texture.use(0)
        self._program["frame"].value = 0
        self._program["upside_down"].value = upside_down
        self._copy.render(moderngl.TRIANGLES, vertices=3)
