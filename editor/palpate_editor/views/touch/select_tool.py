# SPDX-License-Identifier: GPL-3.0-or-later
"""Choosing vertices by click and rectangle, to fix them or make them stiffer all at once."""

from __future__ import annotations

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.viewport import View
from PySide6.QtCore import QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QRubberBand, QWidget

from palpate_editor.brush import select_linked
from palpate_editor.document import Organ, Surface
from palpate_editor.edits import FixVertices, PaintStiffness
from palpate_editor.views.context import Context
from palpate_editor.views.touch.colours import show_fixed, show_painted, show_stiffness
from palpate_editor.views.touch.painted_surface import PaintedSurface, Spot
from palpate_editor.views.touch.selection import find_in_rectangle
from palpate_editor.views.touch.surface_keeper import SeenWork, keeper_of
from palpate_editor.views.translations import tr

QUICK_TO_SEE = 3000
"""Vertices that are looked at between two pictures."""
CONTROL, ALT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.AltModifier


class SelectTool(QObject):
    """A click takes the nearest vertex, a drag all that are seen in a rectangle."""

    name, shortcut = "select", "V"
    stages: tuple[str, ...] = ("material",)
    left = Signal()
    selection_changed = Signal()

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent or context)
        self.context = context
        self.active = False
        self.selected: NDArray[np.bool_] = np.zeros(context.session.organ.vertex_count, bool)
        self._keeper = keeper_of(context)
        self._painted: PaintedSurface | None = None
        self._late: tuple[Surface, Qt.KeyboardModifier] | None = None
        """What waits for a thread to find what is seen: of which surface, with which keys."""
        self._start: QPoint | None = None
        self._band: QRubberBand | None = None
        self._options: QWidget | None = None
        self._actions = self._build_actions()
        context.session.changed.connect(self._take_organ)

    def title(self) -> str:
        return tr("Select")

    def hint(self) -> str:
        return tr(
            "Click or drag to select, Ctrl to add, Alt to remove, L takes what is linked, "
            "Ctrl+A all, Ctrl+I the others, Esc to leave"
        )

    # ------------------------------------------------------------ coming and going

    def activate(self) -> None:
        """Takes the mouse over the organ."""
        self.active = True
        self.context.view.tool = self
        self.context.set_hint(self.hint())
        self.show_organ(self.context.session.organ)

    def deactivate(self) -> None:
        """Gives the mouse back; the selection is kept for the next time."""
        self.active = False
        self._end_band()
        if self.context.view.tool is self:
            self.context.view.tool = None
        show_painted(self.context.view, self.context.session.organ)

    def options(self) -> QWidget:
        """What can be done with the selection, for the stage's panel."""
        if self._options is None:
            from palpate_editor.views.touch.select_options import SelectOptions

            self._options = SelectOptions(self)
        return self._options

    def actions(self) -> list[QAction]:
        """For menus and the command palette."""
        return self._actions

    def _build_actions(self) -> list[QAction]:
        table = (
            ("select_all", tr("Select all vertices"), "Ctrl+A", self.select_all),
            ("invert_selection", tr("Invert the selection"), "Ctrl+I", self.invert),
            ("select_linked", tr("Select what is linked"), "L", self.select_linked),
            ("select_none", tr("Select nothing"), "Ctrl+Shift+A", self.select_none),
            ("fix_selection", tr("Fix the selected vertices"), "Ctrl+Shift+F", self.fix),
            ("free_selection", tr("Free the selected vertices"), "Ctrl+Alt+F", self.free),
        )
        actions = []
        for name, title, shortcut, slot in table:
            action = QAction(title, self)
            action.setObjectName(name)
            if shortcut:
                action.setShortcut(shortcut)
            action.triggered.connect(slot)
            actions.append(action)
        return actions

    def _take_organ(self, before: Organ, after: Organ) -> None:
        if before.surface is not after.surface or len(self.selected) != after.vertex_count:
            self.selected = np.zeros(after.vertex_count, bool)
            self.selection_changed.emit()
        if self.active:
            self.show_organ(self.context.session.organ)

    def show_organ(self, organ: Organ) -> None:
        """Highlights the selection, and what is fixed beside it."""
        if organ.surface is not None:
            show_fixed(self.context.view, organ.fixed, self.selected)
            show_stiffness(self.context.view, organ.stiffness_scale)

    # ------------------------------------------------------------ the selection

    def select(
        self, ids: NDArray[np.intp], modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
    ) -> None:
        """Takes these vertices; with Ctrl beside those selected, with Alt out of them."""
        chosen = np.zeros(len(self.selected), bool)
        chosen[ids] = True
        if modifiers & CONTROL:
            chosen = self.selected | chosen
        elif modifiers & ALT:
            chosen = self.selected & ~chosen
        self._take(chosen)

    def select_all(self) -> None:
        self._take(np.ones(len(self.selected), bool))

    def select_none(self) -> None:
        self._take(np.zeros(len(self.selected), bool))

    def invert(self) -> None:
        self._take(~self.selected)

    def select_linked(self) -> None:
        """Grows the selection to all that hangs together with it."""
        painted = self._find_painted()
        if painted is None or not self.selected.any():
            self.context.tell(tr("Select a vertex first: then L takes all that is linked."), "info")
            return
        self.select(select_linked(np.flatnonzero(self.selected), painted.neighbours))

    def fix(self) -> None:
        """Holds the selected vertices at rest."""
        self._apply_fixed(True)

    def free(self) -> None:
        """Lets the selected vertices move."""
        self._apply_fixed(False)

    def stiffen(self, factor: float) -> None:
        """Gives the selected vertices a stiffness, [-] times the organ's own."""
        if self._has_selection():
            self.context.apply(PaintStiffness(np.flatnonzero(self.selected), factor))

    def _apply_fixed(self, fixed: bool) -> None:
        if self._has_selection():
            self.context.apply(FixVertices(np.flatnonzero(self.selected), fixed))

    def _has_selection(self) -> bool:
        if not self.selected.any():
            self.context.tell(tr("No vertices are selected: click or drag on the organ."), "info")
        return bool(self.selected.any())

    def _take(self, selected: NDArray[np.bool_]) -> None:
        self.selected = selected
        if self.active:
            self.show_organ(self.context.session.organ)
        self.selection_changed.emit()

    # ------------------------------------------------------------ events of the view

    def press(self, view: View, event: QMouseEvent) -> bool:
        """Begins a click or a rectangle."""
        if event.button() != Qt.MouseButton.LeftButton or self._find_painted() is None:
            return False
        self._start = event.position().toPoint()
        self._band = QRubberBand(QRubberBand.Shape.Rectangle, view)
        return True

    def move(self, view: View, event: QMouseEvent) -> bool:
        """Draws the rectangle."""
        del view
        if self._start is None:
            return False
        at = event.position().toPoint()
        if (at - self._start).manhattanLength() >= QApplication.startDragDistance():
            self._band.setGeometry(QRect(self._start, at).normalized())
            self._band.show()
        return True

    def release(self, view: View, event: QMouseEvent) -> bool:
        """Ends it: takes the vertices meant."""
        if event.button() != Qt.MouseButton.LeftButton or self._start is None:
            return False
        drawn = self._band.isVisible()
        start, end = self._start, event.position().toPoint()
        self._end_band()
        if drawn:
            self._select_seen(view, start, end, event.modifiers())
            return True
        found = view.pick(event.position())
        ids = np.array([] if found is None else [self._nearest(found)], dtype=np.intp)
        self.select(ids, event.modifiers())
        return True

    def wheel(self, view: View, event: QWheelEvent) -> bool:
        """The wheel is the camera's."""
        del view, event
        return False

    def leave(self, view: View) -> None:
        """Nothing to take away."""
        del view

    def key(self, view: View, event: QKeyEvent) -> bool:
        """Escape drops a rectangle, or leaves."""
        del view
        if event.key() != Qt.Key.Key_Escape:
            return False
        if self._start is not None:
            self._end_band()
        else:
            self.left.emit()
        return True

    def _end_band(self) -> None:
        if self._band is not None:
            self._band.hide()
            self._band.deleteLater()
        self._start = self._band = None

    def _find_painted(self) -> PaintedSurface | None:
        self._painted = self._keeper.find()
        return self._painted

    def _nearest(self, found: palpate.SurfacePoint) -> int:
        spot = Spot(found.triangle, np.array(found.weights), np.array(found.point), np.zeros(3))
        return self._painted.find_nearest(spot)

    def _select_seen(
        self, view: View, start: QPoint, end: QPoint, keys: Qt.KeyboardModifier
    ) -> None:
        """Takes what is seen in a rectangle; a little later where that is very much."""
        painted, camera = self._painted, view.camera
        pixels, depth = camera.project(painted.surface.vertices, (view.width(), view.height()))
        corners = [np.array([p.x(), p.y()], dtype=float) for p in (start, end)]
        ids = find_in_rectangle(np.where(depth[:, None] > 0.0, pixels, np.inf), *corners)
        work = SeenWork(painted, ids, np.asarray(camera.eye()))
        if len(ids) <= QUICK_TO_SEE:
            self.select(work(), keys)
            return
        self._late = painted.surface, keys
        self.context.jobs.start_unseen("selecting", work, self._take_late, self.context.refuse)

    def _take_late(self, ids: NDArray[np.intp]) -> None:
        late, self._late = self._late, None
        if late is not None and late[0] is self.context.session.organ.surface:
            self.select(ids, late[1])
