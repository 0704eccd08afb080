# SPDX-License-Identifier: BSD-3-Clause
"""Where frames are drawn before they are shown: as fine or as coarse as there is time for."""

from __future__ import annotations

from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render import Camera, Renderer

COPY_VERTEX = """#version 330 core
out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}"""
COPY_FRAGMENT = """#version 330 core
in vec2 place;
uniform sampler2D frame;
out vec4 result;
void main() { result = vec4(texture(frame, place).rgb, 1.0); }"""


@dataclass(frozen=True)
class Quality:
    """How finely a frame is drawn."""

    samples: int
    """Per pixel, at edges."""
    shadow_softness: float
    """[-] as Renderer.shadow_softness."""
    most_pixels: float = float("inf")
    """Larger frames are drawn smaller and stretched."""


class Canvas:
    """A framebuffer of our own on a context, which must be current in every call."""

    def __init__(self, context: moderngl.Context):
        self._context = context
        self._program = context.program(vertex_shader=COPY_VERTEX, fragment_shader=COPY_FRAGMENT)
        self._copy = context.vertex_array(self._program, [])
        self._key: tuple[int, int, int] | None = None
        self._things: list = []
        self.size = (0, 0)
        """[px] of the frame last drawn."""

    def draw(
        self, renderer: Renderer, camera: Camera, size: tuple[int, int], quality: Quality
    ) -> None:
        """Draws a frame of `size` pixels or, where the quality says so, a smaller one."""
        shrink = min(1.0, (quality.most_pixels / (size[0] * size[1])) ** 0.5)
        self.size = (max(1, round(shrink * size[0])), max(1, round(shrink * size[1])))
        self._make(self.size, min(quality.samples, self._context.max_samples))
        self._drawn.use()
        renderer.draw(camera, self.size)
        if self._drawn is not self._frame:
            self._context.copy_framebuffer(self._frame, self._drawn)

    def paste(self, target: moderngl.Framebuffer, size: tuple[int, int]) -> None:
        """Shows the frame in a framebuffer of `size` pixels, stretched to fill it."""
        target.use()
        target.viewport = (0, 0, *size)
        self._context.enable_only(moderngl.NOTHING)
        self._texture.use(0)
        self._program["frame"].value = 0
        self._copy.render(moderngl.TRIANGLES, vertices=3)

    def read(self, pixels: NDArray[np.uint8]) -> None:
        """Copies the frame to (h, w, 4), the lowest row first."""
        self._frame.read_into(pixels, components=4, alignment=1)

    def release(self) -> None:
        for thing in (*self._things, self._copy, self._program):
            thing.release()
        self._things, self._key = [], None

    def _make(self, size: tuple[int, int], samples: int) -> None:
        if self._key == (*size, samples):
            return
        for thing in self._things:
            thing.release()
        context = self._context
        self._texture = context.texture(size, 4, alignment=1)
        self._texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        self._texture.repeat_x = self._texture.repeat_y = False
        depth = context.depth_renderbuffer(size, samples=samples)
        if samples:
            colour = context.renderbuffer(size, 4, samples=samples)
            self._drawn = context.framebuffer([colour], depth)
            self._frame = context.framebuffer([self._texture])
            self._things = [self._drawn, self._frame, colour, depth, self._texture]
        else:
            self._drawn = self._frame = context.framebuffer([self._texture], depth)
            self._things = [self._frame, depth, self._texture]
        self._key = (*size, samples)
