# SPDX-License-Identifier: BSD-3-Clause
"""Force against time, as it is asked for and as the motors give it."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from palpate.device_window.sentences import number, say_axes, translate
from palpate.device_window.style import Painted, applied_colour, commanded_colour, pick

SPAN = 8.0
"""[s] that are shown."""
CAPACITY = 1000
"""Rows that are kept: those of a status every 8 ms."""
LEAST = 0.25
"""[N] that a plot reaches up and down at least."""


class Strip(Painted):
    """Three plots beside each other: right, away and up."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self._rows: deque[tuple[float, ...]] = deque(maxlen=CAPACITY)
        self._reach = LEAST
        self.setMinimumHeight(150)

    def add(self, time: float, commanded: ArrayLike, applied: ArrayLike) -> None:
        """Forces [N] at a time [s]."""
        if self._rows and time <= self._rows[-1][0]:
            if time < self._rows[-1][0]:
                self._rows.clear()
            else:
                return
        self._rows.append((time, *np.asarray(commanded, float), *np.asarray(applied, float)))

    def clear(self) -> None:
        self._rows.clear()
        self._reach = LEAST
        self.update()

    def rows(self) -> NDArray[np.float64]:
        """(n, 7) time [s], commanded and applied [N]."""
        return np.array(self._rows, dtype=float).reshape(-1, 7)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = self.begin()
        rows = self.rows()
        now = rows[-1, 0] if len(rows) else 0.0
        rows = rows[rows[:, 0] > now - SPAN] if len(rows) else rows
        if len(rows):
            most = float(np.abs(rows[:, 1:]).max())
            self._reach = max(LEAST, most * 1.15, self._reach * 0.98)
        names = say_axes()
        gap, head = 14.0, 24.0
        width = (self.width() - 2 * gap) / 3
        for axis, name in enumerate(names):
            box = QRectF(axis * (width + gap), head, width, self.height() - head - 4)
            self._draw_frame(painter, box)
            if len(rows):
                x = box.left() + box.width() * (1.0 - (now - rows[:, 0]) / SPAN)
                self._draw_line(painter, box, x, rows[:, 1 + axis], commanded_colour(self.theme), 3)
                self._draw_line(painter, box, x, rows[:, 4 + axis], applied_colour(self.theme), 1.3)
            self._write_scale(painter, box, name)
        self._draw_key(painter)
        painter.end()

    def _draw_frame(self, painter: QPainter, box: QRectF) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(pick(self.theme, "track", 0.55))
        painter.drawRoundedRect(box, 6, 6)
        painter.setPen(QPen(pick(self.theme, "line"), 1.0))
        middle = box.center().y()
        painter.drawLine(QPointF(box.left(), middle), QPointF(box.right(), middle))

    def _write_scale(self, painter: QPainter, box: QRectF, name: str) -> None:
        """Over the lines, each text on a ground of its own, so that no line hides it."""
        inside = box.adjusted(6, 3, -6, -3)
        reach = number(self._reach, 2)
        top, left = Qt.AlignmentFlag.AlignTop, Qt.AlignmentFlag.AlignLeft
        painter.setFont(self.letters(10))
        faint = pick(self.theme, "faint")
        self._write(painter, inside, top | left, f"{reach} N", faint)
        low = Qt.AlignmentFlag.AlignBottom | left
        self._write(painter, inside, low, f"\N{MINUS SIGN}{reach} N", faint)
        painter.setFont(self.letters(12, bold=True))
        right = top | Qt.AlignmentFlag.AlignRight
        self._write(painter, inside, right, name, pick(self.theme, "text"))

    def _write(
        self, painter: QPainter, box: QRectF, place: Qt.AlignmentFlag, text: str, colour: QColor
    ) -> None:
        ground = painter.boundingRect(box, place, text).adjusted(-3, 0, 3, 0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(pick(self.theme, "card", 0.8))
        painter.drawRoundedRect(ground, 3, 3)
        painter.setPen(colour)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawText(box, place, text)

    def _draw_line(
        self,
        painter: QPainter,
        box: QRectF,
        x: NDArray[np.float64],
        force: NDArray[np.float64],
        colour: QColor,
        width: float,
    ) -> None:
        y = box.center().y() - force / self._reach * (box.height() / 2 - 3)
        # a point for each pixel is enough
        step = max(1, len(x) // max(1, round(box.width())))
        line = QPolygonF([QPointF(a, b) for a, b in zip(x[::step], y[::step], strict=True)])
        painter.setPen(QPen(colour, width))
        painter.drawPolyline(line)

    def _draw_key(self, painter: QPainter) -> None:
        painter.setFont(self.letters(12))
        x = 2.0
        for name, colour in (
            (translate("Device", "Force asked for"), commanded_colour(self.theme)),
            (translate("Device", "Force the motors give"), applied_colour(self.theme)),
        ):
            painter.setPen(QPen(colour, 3))
            painter.drawLine(QPointF(x, 11), QPointF(x + 18, 11))
            painter.setPen(pick(self.theme, "faint"))
            painter.drawText(QPointF(x + 24, 15), name)
            x += 44 + painter.fontMetrics().horizontalAdvance(name)
        span = translate("Device", "last %1 s").replace("%1", number(SPAN, 0))
        right = QRectF(0, 0, self.width(), 22)
        flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(right, flags, span)
