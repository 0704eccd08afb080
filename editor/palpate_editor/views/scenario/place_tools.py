# SPDX-License-Identifier: GPL-3.0-or-later
"""A line drawn along the organ: a click for each corner."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from palpate.viewport import View
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent

from palpate_editor.views.touch.place_tool import PlaceTool

ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)

Points = NDArray[np.float64]


class PathTool(PlaceTool):
    """A view tool: every click is a corner; Enter or a double click ends the line."""

    drawn = Signal(object)
    """[m] (n, 3) the corners, two or more."""

    def __init__(self, radius: float, parent: QObject | None = None):
        super().__init__(radius, parent)
        self.corners: list[Points] = []
        self.picked.connect(self._take)

    def take(self, view: View) -> None:
        self.corners = []
        super().take(view)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.MouseButtonDblClick and self.corners:
            self._finish()
            return True
        return super().eventFilter(watched, event)

    def press(self, view: View, event: QMouseEvent) -> bool:
        if event.button() == Qt.MouseButton.RightButton and len(self.corners) > 1:
            self._finish()
            return True
        return super().press(view, event)

    def key(self, view: View, event: QKeyEvent) -> bool:
        if event.key() in ENTER:
            self._finish()
            return True
        return super().key(view, event)

    def _take(self, point: Points) -> None:
        self.corners.append(np.asarray(point))

    def _finish(self) -> None:
        if len(self.corners) < 2:
            return
        corners, self.corners = self.corners, []
        self.drawn.emit(np.array(corners))
