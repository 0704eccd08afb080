# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting on the organ with the mouse: one stroke, one edit, one step of undo."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from palpate_editor.document import Organ
from palpate_editor.views.touch.colours import show_painted
from palpate_editor.views.touch.painted_surface import FIRST_RADIUS, PaintedSurface, Spot
from palpate_editor.views.touch.stroke import Brush
from palpate_editor.views.words import tr

GROWTH = 1.15
"""[-] of the radius for one key or one notch of the wheel."""
SMALLEST, LARGEST = 1e-4, 0.3
"""[m] radius of a brush."""
STAMP_GAP = 0.35
"""[-] of the radius between two stamps of a quick stroke."""
MOST_STAMPS = 64
"""between two events of the mouse."""
NOTCH = 120.0
"""of QWheelEvent.angleDelta."""


class BrushTool(QObject):
    """What painting tools share: the ring, the stroke, its size. Subclasses say what is painted."""

    name = ""
    shortcut = ""
    stages: tuple[str, ...] = ("material",)
    left = Signal()
    """The person wants to go back to looking around."""
    brush_changed = Signal()
    activated = Signal(bool)
    """It has the mouse now, or no longer."""

    def __init__(self, desk: Any, brush: Brush, parent: QObject | None = None):
        super().__init__(parent or desk)
        self.desk, self.brush = desk, brush
        self.active = False
        self._painted: PaintedSurface | None = None
        self._stroke: Any | None = None
        self._last: QPointF | None = None
        self._options: QWidget | None = None
        desk.session.changed.connect(self._take_organ)

    # ------------------------------------------------------------ what subclasses say

    def title(self) -> str:
        raise NotImplementedError

    def hint(self) -> str:
        raise NotImplementedError

    def begin_stroke(self, organ: Organ, painted: PaintedSurface, event: QMouseEvent) -> Any:
        raise NotImplementedError

    def show_stroke(self, stroke: Any) -> None:
        raise NotImplementedError

    def build_options(self) -> QWidget:
        raise NotImplementedError

    def count_painted(self) -> tuple[int, int]:
        """How many vertices carry this paint, and how many there are."""
        raise NotImplementedError

    def erase_all(self) -> None:
        raise NotImplementedError

    # ------------------------------------------------------------ coming and going

    def activate(self) -> None:
        """Takes the mouse over the organ."""
        self.active = True
        self.desk.view.tool = self
        self.show_organ(self.desk.session.organ)
        self.activated.emit(True)

    def deactivate(self) -> None:
        """Gives the mouse back; a stroke under way is dropped."""
        self._stroke = None
        self.active = False
        self.desk.view.show_ring(None)
        if self.desk.view.tool is self:
            self.desk.view.tool = None
        show_painted(self.desk.view, self.desk.session.organ)
        self.activated.emit(False)

    def actions(self) -> list[QAction]:
        """For menus and the command palette."""
        return []

    def options(self) -> QWidget:
        """Size, value and manner of the brush, for the stage's panel."""
        if self._options is None:
            self._options = self.build_options()
        return self._options

    def show_organ(self, organ: Organ) -> None:
        """Colours the view with what the document says, or a stroke under way will say."""
        show_painted(self.desk.view, organ)
        if self._stroke is not None:
            self.show_stroke(self._stroke)

    def find_painted(self) -> PaintedSurface | None:
        """The surface to paint on; None while there is no organ."""
        surface = self.desk.session.organ.surface
        if surface is None:
            self._painted = None
        elif self._painted is None or self._painted.surface is not surface:
            self._painted = PaintedSurface(surface)
            low, high = FIRST_RADIUS / 8 * self._painted.diagonal, self._painted.diagonal / 2
            if not low < self.brush.radius < high:
                self.set_radius(FIRST_RADIUS * self._painted.diagonal)
        return self._painted

    def _take_organ(self, before: Organ, after: Organ) -> None:
        del before
        if self._stroke is not None:
            self._stroke = None
        if self.active:
            self.show_organ(after)

    # ------------------------------------------------------------ the brush

    def set_radius(self, radius: float) -> None:
        """[m], kept within what can be seen and held."""
        self.brush.radius = float(np.clip(radius, SMALLEST, LARGEST))
        self.brush_changed.emit()

    def grow(self, notches: float = 1.0) -> None:
        """One notch larger; a negative count makes it smaller."""
        self.set_radius(self.brush.radius * GROWTH**notches)

    def find_spot(self, at: QPointF) -> Spot | None:
        """What the mouse points at; None beside the organ."""
        view = self.desk.view
        found = view.pick(at)
        if found is None or self.find_painted() is None:
            return None
        _, direction = view.ray_at(at)
        return Spot(
            found.triangle,
            np.array(found.weights),
            np.array(found.point),
            np.asarray(direction, dtype=float),
        )

    def pixels(self, spot: Spot) -> float:
        """[px] of the screen that the radius is at a spot."""
        return self.brush.radius / max(self.desk.view.pixel_size_at(spot.point), 1e-12)

    def _show_ring(self, at: QPointF) -> Spot | None:
        spot = self.find_spot(at)
        if spot is None:
            self.desk.view.show_ring(None)
            self.desk.set_hint(self.hint())
            return None
        self.desk.view.show_ring(spot.point, self._painted.normal_at(spot), self.brush.radius)
        size = tr("brush {mm:.1f} mm ({px:.0f} px)").format(
            mm=1e3 * self.brush.radius, px=self.pixels(spot)
        )
        self.desk.set_hint(f"{size}   {self.hint()}")
        return spot

    # ------------------------------------------------------------ events of the view

    def press(self, view: Any, event: QMouseEvent) -> bool:
        """Begins a stroke on the organ; beside it the view turns as ever."""
        del view
        if event.button() != Qt.MouseButton.LeftButton or self._stroke is not None:
            return False
        spot = self._show_ring(event.position())
        if spot is None:
            return False
        self._stroke = self.begin_stroke(self.desk.session.organ, self._painted, event)
        self._last = event.position()
        self._stamp(spot)
        self.show_stroke(self._stroke)
        return True

    def move(self, view: Any, event: QMouseEvent) -> bool:
        """Moves the ring, and paints along the way while a stroke lasts."""
        del view
        spot = self._show_ring(event.position())
        if self._stroke is None:
            return False
        self._paint_way(event.position(), spot)
        self.show_stroke(self._stroke)
        return True

    def release(self, view: Any, event: QMouseEvent) -> bool:
        """Ends the stroke: all of it is one edit."""
        del view
        if event.button() != Qt.MouseButton.LeftButton or self._stroke is None:
            return False
        stroke, self._stroke = self._stroke, None
        edit = stroke.edit()
        if edit is None or not self.desk.apply(edit):
            self.show_organ(self.desk.session.organ)
        return True

    def wheel(self, view: Any, event: QWheelEvent) -> bool:
        """Ctrl and the wheel: the size of the brush."""
        del view
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            return False
        self.grow(event.angleDelta().y() / NOTCH)
        self._show_ring(event.position())
        return True

    def key(self, view: Any, event: QKeyEvent) -> bool:
        """[ and ] for the size, Escape to drop a stroke or to leave."""
        del view
        if event.type() != QEvent.Type.KeyPress:
            return False
        if event.text() in ("[", "]"):
            self.grow(1.0 if event.text() == "]" else -1.0)
            return True
        if event.key() == Qt.Key.Key_Escape:
            if self._stroke is not None:
                self._stroke = None
                self.show_organ(self.desk.session.organ)
            else:
                self.left.emit()
            return True
        return False

    def leave(self, view: Any) -> None:
        """The mouse has left the view."""
        view.show_ring(None)

    def _paint_way(self, to: QPointF, spot: Spot | None) -> None:
        """Stamps between the last place of the mouse and this one, close enough to join."""
        start, self._last = self._last, to
        way = to - start
        length = math.hypot(way.x(), way.y())
        gap = STAMP_GAP * (self.pixels(spot) if spot is not None else math.inf)
        count = min(MOST_STAMPS, max(1, math.ceil(length / max(gap, 1.0))))
        for k in range(1, count):
            between = self.find_spot(start + way * (k / count))
            if between is not None:
                self._stamp(between)
        if spot is not None:
            self._stamp(spot)

    def _stamp(self, spot: Spot) -> None:
        self._stroke.add(*self._painted.reach(spot, self.brush))
