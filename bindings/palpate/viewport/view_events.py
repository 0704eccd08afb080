# SPDX-License-Identifier: BSD-3-Clause
"""How mouse and keys reach a view's tool or its camera."""

from __future__ import annotations

from typing import Self

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

from palpate.viewport.navigation import ZOOM
from palpate.viewport.view_tool import ViewTool


class ViewEvents:
    """The part of a view that Qt calls.

    What the tool does not take moves the camera: left and right button turn it, the middle one, or
    Shift with any, moves it, the wheel comes nearer to what lies under the pointer.
    """

    tool: ViewTool[Self] | None
    """Gets mouse and keys before the camera does."""

    def change_scope(self) -> bool:
        """What V does, where there is a laparoscope; False where there is none."""
        return False

    def listen(self) -> None:
        """From now on events come in."""
        self.tool = None
        self._dragged_from: QPointF | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self.tool is None or not self.tool.press(self, event):
            self._dragged_from = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._dragged_from is not None and event.buttons() != Qt.MouseButton.NoButton:
            moved = at - self._dragged_from
            self._dragged_from = at
            shifted = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
            if event.buttons() & Qt.MouseButton.MiddleButton or shifted:
                self.pan(moved.x(), moved.y())
            else:
                self.orbit(moved.x(), moved.y())
        elif self.tool is None or not self.tool.move(self, event):
            self._dragged_from = None
        if event.buttons() == Qt.MouseButton.NoButton:
            self.hover.emit(at)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        dragged, self._dragged_from = self._dragged_from is not None, None
        if not dragged and self.tool is not None:
            self.tool.release(self, event)
        self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.tool is None or not self.tool.wheel(self, event):
            notches = event.angleDelta().y() / 120
            self.zoom(ZOOM**notches, event.position())
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        if self.tool is not None:
            self.tool.leave(self)
        super().leaveEvent(event)  # type: ignore[misc]

    def focusNextPrevChild(self, next: bool) -> bool:
        """Tab is a key of a tool that says so, and else goes to the next widget."""
        if getattr(self.tool, "takes_tab", False):
            return False
        return bool(super().focusNextPrevChild(next))  # type: ignore[misc]

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.tool is not None and self.tool.key(self, event):
            return
        plain = event.key() == Qt.Key.Key_V and not event.modifiers() and not event.isAutoRepeat()
        if not (plain and self.change_scope()):
            super().keyPressEvent(event)  # type: ignore[misc]
