# SPDX-License-Identifier: BSD-3-Clause
"""One surface on the graphics card."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import moderngl
import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render.theme import TISSUE, Colour
from palpate.scene.scene_parts import AppearancePart, find_appearance_fault

WIDTHS = {"position": 3, "normal": 3, "value": 1, "selection": 1, "torn": 1, "openness": 1,
          "rest": 3, "tint": 3}  # fmt: skip
"""The streams of a part and how many float32 each vertex has in them."""


@dataclass(frozen=True)
class Pattern:
    """Spots and fine vessels all over a part; they stick to it where it is pressed."""

    colour: Colour
    """Of the spots."""
    size: float
    """[m] Of the spots."""
    strength: float = 0.5
    """[-] 0 none of the spots' colour, 1 all of it in their middle."""
    relief: float = 0.0
    """[-] How far the spots stand out, in parts of their size."""
    vein_colour: Colour = (0.45, 0.10, 0.10)
    vein_strength: float = 0.0
    """[-]"""


@dataclass(frozen=True)
class Appearance:
    """How a part takes the light."""

    colour: Colour = TISSUE
    """Where the colour map does not paint it."""
    tinted: bool = False
    """Whether its vertices have colours of their own, in place of that one and the pattern's."""
    mapped: bool = False
    """Whether the colour map paints its values."""
    wired: bool = False
    """Whether its edges are drawn."""
    gloss: float = 0.6
    """[-] 0 dull, 1 wet or polished."""
    subsurface: float = 0.3
    """[-] how far light creeps around into the shade, as in flesh."""
    roughness: float = 0.3
    """[-] 0 a mirror, 1 chalk: how wide a highlight is."""
    pattern: Pattern | None = None
    """Drawn where no colour map is."""
    casts_shadow: bool = True
    receives_instruments: bool = False
    """Whether instruments cast their shadow, their ring and their glow on it: tissue."""
    seen_through: bool = False
    """Whether it shines through what hides it, as a tool inside a dent must."""
    ghost: float = 0.3
    """[-] how strongly, from 0 to 1."""


def build_appearance(part: AppearancePart) -> Appearance:
    """What files say of a tissue's appearance, as the renderer takes it.

    Raises ValueError for colours or numbers out of their ranges.
    """
    fault = find_appearance_fault(part)
    if fault is not None:
        raise ValueError(f"appearance.{fault[0]}: got {fault[1]}, expected {fault[2]}")
    pattern = Pattern(
        colour=cast(Colour, part.pattern_colour),
        size=part.pattern_size,
        strength=part.pattern_strength,
        relief=part.relief,
        vein_colour=cast(Colour, part.vein_colour),
        vein_strength=part.vein_strength,
    )
    return Appearance(
        colour=cast(Colour, part.colour),
        gloss=part.gloss,
        roughness=part.roughness,
        subsurface=part.subsurface,
        pattern=pattern,
        receives_instruments=True,
    )


class Part:
    """A surface whose triangles stay and whose streams change from frame to frame.

    A stream is one float32 array per vertex: position [m] (n, 3), normal (n, 3), value (n,) for the
    colour map, selection (n,) from 0 to 1, torn (n,) from 0 to 1, openness (n,) from 0 to 1, the
    share of the sky seen, rest [m] (n, 3), to which patterns stick; where nobody gives it, the
    first position; tint (n, 3), the colour of each vertex in linear light.
    Arrays are handed to OpenGL as they lie in memory, so a view into the simulation's own array is
    copied nowhere else.
    """

    def __init__(
        self,
        context: moderngl.Context,
        surface: moderngl.Program,
        vertex_count: int,
        triangles: ArrayLike,
        appearance: Appearance,
    ):
        self.appearance = appearance
        self.vertex_count = vertex_count
        rows = self._check_triangles(triangles)
        self._triangle_count = len(rows)
        self._indices = context.buffer(rows, dynamic=True)
        self._streams = {
            name: context.buffer(reserve=4 * width * vertex_count, dynamic=True)
            for name, width in WIDTHS.items()
        }
        self._has_rest = True
        self.update(
            position=np.zeros((vertex_count, 3), np.float32),
            normal=np.zeros((vertex_count, 3), np.float32),
            value=np.zeros(vertex_count, np.float32),
            selection=np.zeros(vertex_count, np.float32),
            torn=np.zeros(vertex_count, np.float32),
            openness=np.ones(vertex_count, np.float32),
            tint=np.ones((vertex_count, 3), np.float32),
        )
        self._has_rest = False
        self._context = context
        self._arrays: dict[moderngl.Program, moderngl.VertexArray] = {}
        self._bind(surface)
        self._depth: moderngl.VertexArray | None = None

    def use_triangles(self, triangles: ArrayLike) -> None:
        """Others, as many as there are. The context must be current. Raises ValueError."""
        rows = self._check_triangles(triangles)
        if len(rows) != self._triangle_count:
            raise ValueError(f"triangles must be {self._triangle_count}, got {len(rows)}")
        self._indices.write(rows)

    def _check_triangles(self, triangles: ArrayLike) -> NDArray[np.uint32]:
        rows = np.ascontiguousarray(triangles, dtype=np.uint32)
        if rows.ndim != 2 or rows.shape[1] != 3 or rows.size == 0:
            raise ValueError(f"triangles must have shape (t, 3), t > 0, got {np.shape(triangles)}")
        low, high = int(np.min(triangles)), int(np.max(triangles))
        if low < 0 or high >= self.vertex_count:
            raise ValueError(
                f"triangles must name vertices 0 to {self.vertex_count - 1}, got {low} to {high}"
            )
        return rows

    def update(self, **streams: NDArray[np.float32]) -> None:
        """Writes streams by name. The context must be current.

        Raises ValueError, and writes nothing, for another name, shape or type than the stream's, or
        where the array is not contiguous: a silent copy each frame is not what the caller wants.
        """
        for name, array in streams.items():
            if name not in WIDTHS:
                raise ValueError(f"a part has streams {', '.join(WIDTHS)}, got {name!r}")
            n, width = self.vertex_count, WIDTHS[name]
            shape = (n, width) if width > 1 else (n,)
            if array.dtype != np.float32 or array.shape != shape or not array.flags.c_contiguous:
                raise ValueError(
                    f"{name} must be contiguous float32 of shape {shape}, "
                    f"got {array.dtype} of shape {array.shape}"
                )
        if not self._has_rest and "position" in streams:
            streams.setdefault("rest", streams["position"])
        self._has_rest |= "rest" in streams
        for name, array in streams.items():
            self._streams[name].write(array)

    def draw(self, surface: moderngl.Program) -> None:
        """Draws with a program that wants all streams."""
        if surface not in self._arrays:
            self._bind(surface)
        self._arrays[surface].render()

    def draw_depth(self, program: moderngl.Program) -> None:
        """Draws with a program that wants positions alone."""
        if self._depth is None or self._depth.program is not program:
            streams = [(self._streams["position"], "3f", "position")]
            self._depth = self._context.vertex_array(program, streams, self._indices)
        self._depth.render()

    def release(self) -> None:
        """Gives back the memory of the graphics card."""
        for thing in (*self._arrays.values(), self._depth, self._indices, *self._streams.values()):
            if thing is not None:
                thing.release()

    def _bind(self, surface: moderngl.Program) -> None:
        # a program without patterns has no use for where the part was at rest
        wanted = set(surface)
        streams = [
            (buffer, f"{WIDTHS[name]}f", name)
            for name, buffer in self._streams.items()
            if name in wanted
        ]
        self._arrays[surface] = self._context.vertex_array(surface, streams, self._indices)
