# SPDX-License-Identifier: BSD-3-Clause
"""Where one stands in what is done step by step."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from palpate.device_window.style import Painted, pick

DOT = 6.0
"""[px] radius."""


class Steps(Painted):
    """Dots on a line, those that are done filled, with their names below."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.names: Sequence[str] = ()
        self.step = 0
        self.setFixedHeight(44)

    def show_step(self, names: Sequence[str], step: int) -> None:
        self.names, self.step = tuple(names), step
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = self.begin()
        width = self.width() / max(1, len(self.names))
        places = [QPointF((k + 0.5) * width, 12.0) for k in range(len(self.names))]
        for k in range(len(places) - 1):
            painter.setPen(QPen(pick(self.theme, "accent" if k < self.step else "line"), 2))
            gap = QPointF(DOT + 4, 0)
            painter.drawLine(places[k] + gap, places[k + 1] - gap)
        painter.setFont(self.letters(11))
        for k, (place, name) in enumerate(zip(places, self.names, strict=True)):
            done, here = k < self.step, k == self.step
            painter.setPen(QPen(pick(self.theme, "accent" if done or here else "line"), 2))
            painter.setBrush(pick(self.theme, "accent") if done else Qt.BrushStyle.NoBrush)
            painter.drawEllipse(place, DOT, DOT)
            painter.setPen(pick(self.theme, "text" if here else "faint"))
            painter.drawText(QRectF(k * width, 24, width, 18), Qt.AlignmentFlag.AlignCenter, name)
        painter.end()
