# SPDX-License-Identifier: GPL-3.0-or-later
"""The two brushes: one holds vertices at rest, one makes them stiffer or softer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import FixVertices, PaintStiffness
from palpate_editor.views.touch.brush_options import BrushOptions
from palpate_editor.views.touch.brush_tool import BrushTool
from palpate_editor.views.touch.colours import show_fixed, show_stiffness
from palpate_editor.views.touch.painted_surface import PaintedSurface
from palpate_editor.views.touch.stroke import FixStroke, SmoothStroke, StiffnessStroke
from palpate_editor.views.words import tr


class BrushKeys(QObject):
    """Two actions that size whichever brush has the mouse, wherever the keyboard's focus is."""

    def __init__(self, tools: Sequence[BrushTool], parent: QObject | None = None):
        super().__init__(parent)
        self.tools = tools
        self.actions = [
            self._add("brush_smaller", tr("Smaller brush"), "[", self.shrink),
            self._add("brush_larger", tr("Larger brush"), "]", self.grow),
        ]
        for tool in tools:
            tool.activated.connect(self._take_active)
        self._take_active(False)

    def _add(self, name: str, title: str, key: str, slot: Callable[[], None]) -> QAction:
        action = QAction(title, self)
        action.setObjectName(name)
        action.setShortcut(key)
        action.triggered.connect(slot)
        return action

    def grow(self) -> None:
        self._size(1.0)

    def shrink(self) -> None:
        self._size(-1.0)

    def _size(self, notches: float) -> None:
        for tool in self.tools:
            if tool.active:
                tool.grow(notches)

    def _take_active(self, on: bool) -> None:
        for action in self.actions:
            action.setEnabled(on)


class FixTool(BrushTool):
    """Paints vertices that must not move; Ctrl frees them."""

    name, shortcut = "fix", "X"

    def title(self) -> str:
        return tr("Fix")

    def hint(self) -> str:
        return tr("Drag to fix, Ctrl to free, [ ] or Ctrl+wheel for the size, Esc to leave")

    def begin_stroke(self, organ: Organ, painted: PaintedSurface, event: QMouseEvent) -> FixStroke:
        del painted
        free = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        return FixStroke(organ.fixed, not free)

    def show_stroke(self, stroke: FixStroke) -> None:
        show_fixed(self.desk.view, stroke.values, None)

    def build_options(self) -> QWidget:
        return BrushOptions(self, has_factor=False)

    def count_painted(self) -> tuple[int, int]:
        fixed = self.desk.session.organ.fixed
        return int(fixed.sum()), len(fixed)

    def erase_all(self) -> None:
        """Frees every vertex."""
        self.desk.apply(FixVertices(np.flatnonzero(self.desk.session.organ.fixed), False))


class StiffnessTool(BrushTool):
    """Paints local stiffness; Ctrl gives back the organ's own, Shift evens out."""

    name, shortcut = "stiffness", "B"
    keys: BrushKeys | None = None
    """Those of all brushes, where there is a menu for them."""

    def title(self) -> str:
        return tr("Stiffness")

    def hint(self) -> str:
        return tr(
            "Drag to paint, Ctrl to erase, Shift to smooth, [ ] or Ctrl+wheel for the size, "
            "Esc to leave"
        )

    def begin_stroke(self, organ: Organ, painted: PaintedSurface, event: QMouseEvent) -> Any:
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            return SmoothStroke(organ.stiffness_scale, painted.neighbours)
        erase = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        factor = 1.0 if erase else self.brush.factor
        return StiffnessStroke(organ.stiffness_scale, factor, self.brush.strength)

    def show_stroke(self, stroke: Any) -> None:
        show_stiffness(self.desk.view, stroke.values, always=True)

    def show_organ(self, organ: Organ) -> None:
        super().show_organ(organ)
        if self._stroke is None:
            show_stiffness(self.desk.view, organ.stiffness_scale, always=True)

    def actions(self) -> list[QAction]:
        return self.keys.actions if self.keys is not None else []

    def build_options(self) -> QWidget:
        return BrushOptions(self, has_factor=True)

    def count_painted(self) -> tuple[int, int]:
        scale = self.desk.session.organ.stiffness_scale
        return int((scale != 1.0).sum()), len(scale)

    def erase_all(self) -> None:
        """Gives every vertex the stiffness of the organ."""
        painted = np.flatnonzero(self.desk.session.organ.stiffness_scale != 1.0)
        self.desk.apply(PaintStiffness(painted, 1.0))
