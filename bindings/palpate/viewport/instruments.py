# SPDX-License-Identifier: BSD-3-Clause
"""The instruments of a view: what of them is drawn, and what they do to the look of the tissue.

How high a tip is over the tissue is seen by a ring on the surface around the point nearest to it,
which closes as the tip comes down and is gone where it touches; there the tissue glows. The shadow
of tip and shaft meets them in the same place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render import DrawnInstrument, build_instrument, build_trocar, place_instrument
from palpate.render.instrument import TROCAR, find_rotation, name_look
from palpate.render.instrument_shade import (
    InstrumentShade,
    build_shade,
    find_glow,
    place_axes,
)
from palpate.runs.live import Frame
from palpate.viewport.scenery import Scenery

Array = NDArray[np.float64]

RING_PIXELS = 6e3
"""[px/m] by which the ring grows with the height of the tip, at any zoom."""
HIGHEST = 0.025
"""[m] over the tissue: higher up there is no ring."""
LARGEST_RING = 0.6
"""[-] of the surface's radius."""


@dataclass(frozen=True)
class SeenInstrument:
    """An instrument as it is held."""

    tool: palpate.Tool
    position: ArrayLike
    """[m] (3,)"""
    orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0)
    """Unit quaternion (x, y, z, w)."""
    opening: float = 0.0
    """[rad] of each jaw."""
    touching: bool = False
    force: float = 0.0
    """[N] that the hand feels of it."""
    trocar: ArrayLike | None = None
    """[m] (3,) where its shaft passes the abdominal wall."""


def see_instruments(scene: palpate.Scene, frame: Frame) -> list[SeenInstrument]:
    """Those of a scene as a frame of a run has them."""
    return [
        SeenInstrument(
            instrument.tool,
            np.array(now.tool_position),
            np.array(now.tool_orientation),
            now.jaw_angle,
            bool(now.touching),
            float(np.linalg.norm(now.force)),
            instrument.trocar,
        )
        for instrument, now in zip(scene.instruments, frame.instruments, strict=True)
    ]


@dataclass(frozen=True)
class Drawn:
    """What an instrument looks like."""

    name: str
    look: tuple[object, ...]
    shape: DrawnInstrument | None
    """None for a ball."""


def describe_tool(tool: palpate.Tool) -> tuple[object, ...]:
    """All by which it is drawn."""
    return (name_look(tool), tool.radius, *((*part.from_, *part.to) for part in tool.capsules))


class Instruments:
    """Draws instruments into a scenery; one object for a view."""

    def __init__(self, scenery: Scenery) -> None:
        self._scenery = scenery
        self._drawn: list[Drawn] = []
        self._count = 0
        self._names: set[str] = set()
        self._seen: tuple[SeenInstrument, ...] = ()
        self._feet: list[tuple[Array, float] | None] = []
        self._is_stale = False
        self._pixel = 0.0

    def show(self, seen: Sequence[SeenInstrument]) -> None:
        """These and no others."""
        for index, instrument in enumerate(seen):
            self._build(index, instrument.tool)
        before, self._names = self._names, set()
        dented = False
        for index, instrument in enumerate(seen):
            if self._drawn[index].shape is None and not dented:
                self._scenery.show_tool(instrument.position, instrument.tool.radius)
                dented = True
            else:
                self._show(self._drawn[index], instrument)
        if not dented:
            self._scenery.show_tool(None, 0.0)
        for name in sorted(before - self._names):
            self._scenery.show_part(name, None)
        self._seen = tuple(seen)
        self._feet = [self._find_foot(instrument) for instrument in seen]
        self._is_stale = True

    def shade(self, pixel: float) -> None:
        """Shadow, ring and glow, where a pixel covers so much [m] of the surface's middle; at no
        cost where nothing has changed since."""
        if not self._is_stale and pixel == self._pixel:
            return
        self._is_stale, self._pixel = False, pixel
        pairs = zip(self._seen, self._feet, strict=True)
        self._scenery.shade([self._build_shade(seen, foot, pixel) for seen, foot in pairs])

    def _build(self, index: int, tool: palpate.Tool) -> None:
        """What an instrument looks like, where that has changed; its parts get new names then."""
        look = describe_tool(tool)
        if index < len(self._drawn) and self._drawn[index].look == look:
            return
        self._count += 1
        drawn = Drawn(f"instrument {self._count}", look, build_instrument(tool))
        self._drawn[index : index + 1] = [drawn]

    def _show(self, drawn: Drawn, seen: SeenInstrument) -> None:
        if drawn.shape is None:
            self._names.add(drawn.name)
            self._scenery.show_ball(drawn.name, seen.position, seen.tool.radius)
            return
        placed = place_instrument(drawn.shape, seen.position, seen.orientation, seen.opening)
        for number, part in enumerate(placed):
            name = f"{drawn.name} {number}"
            self._names.add(name)
            self._scenery.show_part(name, part.shape, part.appearance)
        if seen.trocar is not None:
            name = f"{drawn.name} trocar"
            self._names.add(name)
            port = build_trocar(seen.trocar, seen.position, seen.tool.radius)
            self._scenery.show_part(name, port, TROCAR)

    def _find_foot(self, seen: SeenInstrument) -> tuple[Array, float] | None:
        """[m] The point of the tissue nearest to what touches, and how far that is away."""
        if seen.touching:
            return None
        from_, to = place_axes(
            seen.tool, seen.position, find_rotation(seen.orientation), seen.opening
        )
        best: tuple[Array, float] | None = None
        for end in np.unique(np.vstack([from_, to]), axis=0):
            found = self._scenery.find_nearest(end)
            if found is None:
                return None
            foot = np.array(found.point)
            height = float(np.linalg.norm(end - foot)) - seen.tool.radius
            if best is None or height < best[1]:
                best = foot, height
        return best if best is not None and 0.0 < best[1] <= HIGHEST else None

    def _build_shade(
        self, seen: SeenInstrument, foot: tuple[Array, float] | None, pixel: float
    ) -> InstrumentShade:
        ring = None
        if foot is not None:
            grown = foot[1] * max(1.0, RING_PIXELS * pixel)
            most = LARGEST_RING * self._scenery.radius
            ring = foot[0], min(seen.tool.radius + grown, most)
        glow = find_glow(seen.touching, seen.force)
        rotation = find_rotation(seen.orientation)
        return build_shade(seen.tool, seen.position, rotation, glow, ring, seen.opening)
