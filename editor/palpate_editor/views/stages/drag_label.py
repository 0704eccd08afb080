# SPDX-License-Identifier: GPL-3.0-or-later
"""The name of a number, which is dragged to the right for more and to the left for less."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QLabel, QWidget

PER_DECADE = 160.0
"""[px] of a drag that makes a number ten times as large."""
LEAST = 3.0
"""[px] that the hand may tremble."""


class DragLabel(QLabel):
    """Tells by what factor it is dragged, and by which it was let go."""

    dragged = Signal(float)
    """[-] While the button is held."""
    dropped = Signal(float)
    """[-] Once, where it was dragged at all."""

    def __init__(self, text: str, role: str, parent: QWidget | None = None):
        super().__init__(text, parent)
        self.setProperty("role", role)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.start: float | None = None
        self.factor: float | None = None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.start, self.factor = event.globalPosition().x(), None
            event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.start is None:
            return
        moved = event.globalPosition().x() - self.start
        if self.factor is None and abs(moved) < LEAST:
            return
        self.factor = float(10.0 ** (moved / PER_DECADE))
        self.dragged.emit(self.factor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        factor, self.start, self.factor = self.factor, None, None
        event.accept()
        if factor is not None:
            self.dropped.emit(factor)
