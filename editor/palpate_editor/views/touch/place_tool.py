# SPDX-License-Identifier: GPL-3.0-or-later
"""Pointing once at the organ, to say where a script shall press."""

from __future__ import annotations

import numpy as np
from palpate.viewport import FboView, GLView, View, ViewTool
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent


class PlaceTool(QObject):
    """A view tool: the next click on the surface is the place."""

    picked = Signal(object)
    """[m] (3,)"""
    left = Signal()

    def __init__(self, radius: float, parent: QObject | None = None):
        super().__init__(parent)
        self.radius = radius
        """[m] of the ring that shows where it would be."""
        self.before: ViewTool[GLView] | ViewTool[FboView] | None = None

    def take(self, view: View) -> None:
        """Has the mouse from now on, and the Escape key before any menu."""
        self.before = view.tool
        view.tool = self
        view.installEventFilter(self)
        view.setFocus()

    def give_back(self, view: View) -> None:
        """The tool that had the mouse before has it again."""
        view.removeEventFilter(self)
        view.show_ring(None)
        if view.tool is self:
            view.tool = self.before
        self.before = None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and event.key() == Qt.Key.Key_Escape:
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def press(self, view: View, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton:
            return False
        found = view.pick(event.position())
        if found is None:
            return False
        self.picked.emit(np.array(found.point))
        return True

    def move(self, view: View, event: QMouseEvent) -> bool:
        self._show_ring(view, event.position())
        return False

    def release(self, view: View, event: QMouseEvent) -> bool:
        del view, event
        return False

    def wheel(self, view: View, event: QWheelEvent) -> bool:
        del view, event
        return False

    def leave(self, view: View) -> None:
        view.show_ring(None)

    def key(self, view: View, event: QKeyEvent) -> bool:
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
            return True
        return False

    def _show_ring(self, view: View, at: QPointF) -> None:
        found = view.pick(at)
        if found is None:
            view.show_ring(None)
            return
        _, direction = view.ray_at(at)
        view.show_ring(np.array(found.point), -np.asarray(direction), self.radius)
