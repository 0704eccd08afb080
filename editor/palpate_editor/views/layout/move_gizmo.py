# SPDX-License-Identifier: GPL-3.0-or-later
"""Three arrows and three rings at the chosen part: a drag moves or turns it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from palpate.layout.document import Placed
from palpate.render import Appearance, build_arrow
from palpate.viewport import View
from palpate.viewport.navigation import meet_plane
from palpate.viewport.ring import build_ring
from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

from palpate_editor.layout_shapes import PartShape, find_middle, move, turn
from palpate_editor.views.layout.scene_drawing import SceneDrawing

Floats = NDArray[np.float64]
AXES = np.eye(3)
COLOURS = ((0.85, 0.27, 0.24), (0.24, 0.62, 0.27), (0.20, 0.46, 0.88))
"""Of x, y and z, as the axes in the corner have them."""
HELD = (1.0, 0.85, 0.25)
ARM, RING = 1.45, 1.12
"""[-] of the part's radius: to the ends of the arrows, and of the rings."""
THIN, THICK = 0.008, 0.016
"""[-] Likewise: of rings and of shafts."""
THINNEST = 1.2
"""[px] of a ring's tube; of a shaft twice that."""
LEAST, KEPT = 45.0, 0.1
"""[px] of that radius, so that handles of a stone can be held.
[-] The relative error of their size above which they are drawn again."""
NEAR = 9.0
"""[px] from a handle that is meant."""
AROUND = 64
EDGE_ON = 0.2
"""[-] sine between the sight and a ring's plane below which it is dragged along its line."""


@dataclass(frozen=True)
class Handle:
    """An arrow that moves along an axis, or a ring that turns about it."""

    turns: bool
    axis: int


HANDLES = [Handle(turns, axis) for turns in (False, True) for axis in range(3)]


class MoveGizmo(QObject):
    """A view's tool. A click beside its handles chooses the part under the pointer; what is no
    handle turns the camera as ever. Escape cancels a drag, and without one chooses nothing."""

    chosen = Signal(str)
    """A part, or nothing."""
    dragged = Signal(object)
    """Where the part would be."""
    dropped = Signal(object)
    """Where the part shall be."""

    def __init__(self, view: View, drawing: SceneDrawing):
        super().__init__(view)
        self._view, self._drawing = view, drawing
        self.part: Any = None
        self.middle, self.reach, self._radius = np.zeros(3), 1.0, 1.0
        self.held: Handle | None = None
        self._start: Any = None
        self._from = QPointF()
        self._moved: Any = None
        view.frame_drawn.connect(self.follow)

    def show(self, part: Placed | None, shape: PartShape | None) -> None:
        """At a part, or nowhere."""
        if self.held is None:
            self.part = part if shape is not None else None
            if part is not None and shape is not None:
                self.middle = find_middle(shape, part)
                self._radius = shape.radius
                self.reach = self._find_reach()
            self._draw()

    def follow(self) -> None:
        """As large as the camera needs it, which may have moved."""
        if self.part is None or self.held is not None:
            return
        reach = self._find_reach()
        if abs(reach / self.reach - 1.0) > KEPT:
            self.reach = reach
            self._draw()

    def _find_reach(self) -> float:
        """[m]"""
        return max(self._radius, LEAST * self._view.pixel_size_at(self.middle))

    # ------------------------------------------------------------ a view's tool

    def press(self, view: View, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton or event.modifiers():
            return False
        handle = self.find(event.position())
        if handle is None:
            name = self._drawing.pick(*view.ray_at(event.position()))
            if name:
                self.chosen.emit(name)
            return False
        self.held, self._start, self._from = handle, self.part, event.position()
        self._moved = None
        self._draw()
        return True

    def move(self, view: View, event: QMouseEvent) -> bool:
        if self.held is None:
            over = self.part is not None and self.find(event.position()) is not None
            shape = Qt.CursorShape.SizeAllCursor if over else Qt.CursorShape.ArrowCursor
            view.setCursor(shape)
            return False
        self._moved = self._drag(event.position())
        self.dragged.emit(self._moved)
        return True

    def release(self, view: View, event: QMouseEvent) -> bool:
        del view, event
        if self.held is None:
            return False
        self.held, moved = None, self._moved
        self._draw()
        if moved is not None:
            self.dropped.emit(moved)
        return True

    def wheel(self, view: View, event: QWheelEvent) -> bool:
        del view, event
        return False

    def leave(self, view: View) -> None:
        view.unsetCursor()

    def key(self, view: View, event: QKeyEvent) -> bool:
        del view
        if event.key() != Qt.Key.Key_Escape:
            return False
        if self.held is not None:
            self.held, self._moved = None, None
            self.dragged.emit(self._start)
            self._draw()
        elif self.part is not None:
            self.chosen.emit("")
        return True

    # ------------------------------------------------------------ inside

    def find(self, at: QPointF) -> Handle | None:
        """The handle that is nearest to a pixel."""
        if self.part is None:
            return None
        found = [(self._distance(handle, at), i) for i, handle in enumerate(HANDLES)]
        distance, index = min(found)
        return HANDLES[index] if distance <= NEAR else None

    def _points(self, handle: Handle) -> Floats:
        """[m] (n, 3) along a handle; of a ring those in front."""
        axis = AXES[handle.axis]
        if not handle.turns:
            lengths = np.linspace(0.35, 1.0, 24)[:, None]
            return self.middle + ARM * self.reach * lengths * axis
        first, second = AXES[handle.axis - 2], AXES[handle.axis - 1]
        angles = np.linspace(0.0, 2 * math.pi, AROUND)[:, None]
        around = np.cos(angles) * first + np.sin(angles) * second
        forward = self._view.camera.basis()[2]
        front = around[around @ forward <= 0.05]
        return self.middle + RING * self.reach * front

    def _distance(self, handle: Handle, at: QPointF) -> float:
        """[px] from a pixel."""
        pixels = [self._view.world_to_pixel(point) for point in self._points(handle)]
        x = np.array([(pixel.x(), pixel.y()) for pixel in pixels])
        return find_distance(x, np.array([at.x(), at.y()]))

    def _drag(self, at: QPointF) -> Any:
        handle, axis = self.held, AXES[self.held.axis]
        if handle.turns:
            return turn(self._start, axis, self._angle(axis, at), self.middle)
        before, now = self._along(axis, self._from), self._along(axis, at)
        return move(self._start, (now - before) * axis)

    def _along(self, axis: Floats, at: QPointF) -> float:
        """[m] along an axis through the middle, to where the pointer's ray is nearest to it."""
        origin, direction = (np.asarray(each) for each in self._view.ray_at(at))
        between, slant = self.middle - origin, float(axis @ direction)
        across = max(1.0 - slant * slant, 1e-4)
        return float(slant * (between @ direction) - between @ axis) / across

    def _angle(self, axis: Floats, at: QPointF) -> float:
        """[rad] about an axis between where the drag began and a pixel."""
        rays = [self._view.ray_at(each) for each in (self._from, at)]
        if min(abs(float(axis @ direction)) for _, direction in rays) > EDGE_ON:
            before, now = (meet_plane(*ray, self.middle, axis) - self.middle for ray in rays)
            return math.atan2(float(axis @ np.cross(before, now)), float(before @ now))
        # a ring that is seen from its side: a radius of the drag along it is a radian
        across = np.cross(axis, self._view.camera.basis()[2])
        across /= np.linalg.norm(across)
        forward = self._view.camera.basis()[2]
        before, now = (meet_plane(*ray, self.middle, forward) for ray in rays)
        return -float((now - before) @ across) / (RING * self.reach)

    def _draw(self) -> None:
        least = THINNEST * self._view.pixel_size_at(self.middle)
        for handle in HANDLES:
            name = f"gizmo {'turn' if handle.turns else 'move'} {handle.axis}"
            if self.part is None or self.held not in (None, handle):
                self._view.show_part(name, None, look((0.0, 0.0, 0.0)))
                continue
            colour = HELD if handle == self.held else COLOURS[handle.axis]
            axis, r = AXES[handle.axis], self.reach
            if handle.turns:
                shape = build_ring(self.middle, axis, RING * r, max(THIN * r, least))
            else:
                ends = (self.middle + share * ARM * r * axis for share in (0.35, 1.0))
                shape = build_arrow(*ends, max(THICK * r, 2.0 * least))
            self._view.show_part(name, shape, look(colour))


def look(colour: tuple[float, float, float]) -> Appearance:
    return Appearance(
        colour, gloss=0.0, subsurface=0.0, seen_through=True, ghost=0.55, casts_shadow=False
    )


def find_distance(line: Floats, at: Floats) -> float:
    """[px] of a pixel from a line of several (n, 2); infinite for one without a piece."""
    if len(line) < 2:
        return math.inf
    a, along = line[:-1], np.diff(line, axis=0)
    square = np.maximum((along**2).sum(axis=1), 1e-12)
    share = np.clip(((at - a) * along).sum(axis=1) / square, 0.0, 1.0)
    near = a + share[:, None] * along
    # the points of a ring that are in front may be two pieces: what lies between is none
    whole = np.sqrt(square) <= 4.0 * np.median(np.sqrt(square)) + 1.0
    away = np.linalg.norm(near - at, axis=1)[whole]
    return float(away.min()) if len(away) else math.inf
