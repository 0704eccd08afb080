# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting on the organ with the mouse: one stroke, one edit, one step of undo."""

from __future__ import annotations

import math
from typing import Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray
from palpate.viewport import View
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import Edit
from palpate_editor.views.context import Context
from palpate_editor.views.touch.brush_keys import BrushKeys
from palpate_editor.views.touch.brush_options import BrushOptions
from palpate_editor.views.touch.colours import show_painted
from palpate_editor.views.touch.painted_surface import FIRST_RADIUS, PaintedSurface, Spot
from palpate_editor.views.touch.stroke import Brush, Stroke
from palpate_editor.views.touch.surface_keeper import keeper_of
from palpate_editor.views.translations import fill, tr

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

Keys = Qt.KeyboardModifier


Painted = TypeVar("Painted", bound=Stroke)


class Paint(Protocol[Painted]):
    """What a brush puts on the organ."""

    name: str
    shortcut: str
    has_factor: bool
    """Whether there is a stiffness to choose, or only yes and no."""

    def title(self) -> str: ...
    def hint(self) -> str: ...

    def begin(self, organ: Organ, surface: PaintedSurface, brush: Brush, keys: Keys) -> Painted:
        """A stroke with these keys held down."""

    def show_stroke(self, view: View, stroke: Painted) -> None: ...

    def show_organ(self, view: View, organ: Organ) -> None:
        """Colours the view with what the document says while the tool is in use."""

    def find_painted(self, organ: Organ) -> NDArray[np.bool_]:
        """(n,) the vertices that carry this paint."""

    def erase(self, ids: NDArray[np.intp]) -> Edit: ...


class BrushTool(QObject, Generic[Painted]):
    """A view's tool that paints: the ring, the stroke, its size."""

    stages: tuple[str, ...] = ("material",)
    left = Signal()
    """The person wants to go back to looking around."""
    brush_changed = Signal()
    activated = Signal(bool)
    """It has the mouse now, or no longer."""

    def __init__(
        self, context: Context, brush: Brush, paint: Paint[Painted], parent: QObject | None = None
    ):
        super().__init__(parent or context)
        self.context, self.brush, self.paint = context, brush, paint
        self.name, self.shortcut = paint.name, paint.shortcut
        self.has_factor = paint.has_factor
        self.keys: BrushKeys | None = None
        """Those of all brushes, where there is a menu for them."""
        self.active = False
        self._keeper = keeper_of(context)
        self._painted: PaintedSurface | None = None
        self._stroke: Painted | None = None
        self._last: QPointF | None = None
        self._options: QWidget | None = None
        context.session.changed.connect(self._take_organ)

    def title(self) -> str:
        return self.paint.title()

    def hint(self) -> str:
        return self.paint.hint()

    # ------------------------------------------------------------ coming and going

    def activate(self) -> None:
        """Takes the mouse over the organ."""
        self.active = True
        self.context.view.tool = self
        self.find_painted()
        self.show_organ(self.context.session.organ)
        self.activated.emit(True)

    def deactivate(self) -> None:
        """Gives the mouse back; a stroke under way is dropped."""
        self._stroke = None
        self.active = False
        self.context.view.show_ring(None)
        if self.context.view.tool is self:
            self.context.view.tool = None
        show_painted(self.context.view, self.context.session.organ)
        self.activated.emit(False)

    def actions(self) -> list[QAction]:
        """For menus and the command palette."""
        return self.keys.actions if self.keys is not None else []

    def options(self) -> QWidget:
        """Size, value and manner of the brush, for the stage's panel."""
        if self._options is None:
            self._options = BrushOptions(self)
        return self._options

    def show_organ(self, organ: Organ) -> None:
        """Colours the view with what the document says, or a stroke under way will say."""
        if organ.surface is None:
            return
        self.paint.show_organ(self.context.view, organ)
        if self._stroke is not None:
            self.paint.show_stroke(self.context.view, self._stroke)

    def count_painted(self) -> tuple[int, int]:
        """How many vertices carry this paint, and how many there are."""
        painted = self.paint.find_painted(self.context.session.organ)
        return int(painted.sum()), len(painted)

    def erase_all(self) -> None:
        """Takes this paint off the whole organ."""
        ids = np.flatnonzero(self.paint.find_painted(self.context.session.organ))
        self.context.apply(self.paint.erase(ids))

    def find_painted(self) -> PaintedSurface | None:
        """The surface to paint on; None while there is none that is ready."""
        painted = self._keeper.find()
        if painted is not None and painted is not self._painted:
            low, high = FIRST_RADIUS / 8 * painted.diagonal, painted.diagonal / 2
            if not low < self.brush.radius < high:
                self.set_radius(FIRST_RADIUS * painted.diagonal)
        self._painted = painted
        return painted

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
        view = self.context.view
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
        return self.brush.radius / max(self.context.view.pixel_size_at(spot.point), 1e-12)

    def _show_ring(self, at: QPointF) -> Spot | None:
        spot = self.find_spot(at)
        if spot is None:
            self.context.view.show_ring(None)
            self.context.set_hint(self.hint())
            return None
        self.context.view.show_ring(spot.point, self._painted.normal_at(spot), self.brush.radius)
        size = fill(
            tr("brush {mm:.1f} mm ({px:.0f} px)"), mm=1e3 * self.brush.radius, px=self.pixels(spot)
        )
        self.context.set_hint(f"{size}   {self.hint()}")
        return spot

    # ------------------------------------------------------------ events of the view

    def press(self, view: View, event: QMouseEvent) -> bool:
        """Begins a stroke on the organ; beside it the view turns as ever."""
        del view
        if event.button() != Qt.MouseButton.LeftButton or self._stroke is not None:
            return False
        spot = self._show_ring(event.position())
        if spot is None:
            return False
        organ, keys = self.context.session.organ, event.modifiers()
        self._stroke = self.paint.begin(organ, self._painted, self.brush, keys)
        self._last = event.position()
        self._stamp(spot)
        self.paint.show_stroke(self.context.view, self._stroke)
        return True

    def move(self, view: View, event: QMouseEvent) -> bool:
        """Moves the ring, and paints along its path while a stroke lasts."""
        del view
        spot = self._show_ring(event.position())
        if self._stroke is None:
            return False
        self._paint_path(event.position(), spot)
        self.paint.show_stroke(self.context.view, self._stroke)
        return True

    def release(self, view: View, event: QMouseEvent) -> bool:
        """Ends the stroke: all of it is one edit."""
        del view
        if event.button() != Qt.MouseButton.LeftButton or self._stroke is None:
            return False
        stroke, self._stroke = self._stroke, None
        edit = stroke.edit()
        if edit is None or not self.context.apply(edit):
            self.show_organ(self.context.session.organ)
        return True

    def wheel(self, view: View, event: QWheelEvent) -> bool:
        """Ctrl and the wheel: the size of the brush."""
        del view
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            return False
        self.grow(event.angleDelta().y() / NOTCH)
        self._show_ring(event.position())
        return True

    def key(self, view: View, event: QKeyEvent) -> bool:
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
                self.show_organ(self.context.session.organ)
            else:
                self.left.emit()
            return True
        return False

    def leave(self, view: View) -> None:
        """The mouse has left the view."""
        view.show_ring(None)

    def _paint_path(self, to: QPointF, spot: Spot | None) -> None:
        """Stamps between the last place of the mouse and this one, close enough to join."""
        start, self._last = self._last, to
        shift = to - start
        length = math.hypot(shift.x(), shift.y())
        gap = STAMP_GAP * (self.pixels(spot) if spot is not None else math.inf)
        count = min(MOST_STAMPS, max(1, math.ceil(length / max(gap, 1.0))))
        for k in range(1, count):
            between = self.find_spot(start + shift * (k / count))
            if between is not None:
                self._stamp(between)
        if spot is not None:
            self._stamp(spot)

    def _stamp(self, spot: Spot) -> None:
        self._stroke.add(*self._painted.reach(spot, self.brush))
