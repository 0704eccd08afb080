# SPDX-License-Identifier: BSD-3-Clause
"""Dials, bars and the histogram: numbers that are read at a glance."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from palpate.device_window.sentences import number, translate
from palpate.device_window.style import Painted, applied_colour, pick

SWEEP = 240.0
"""[degree] of a dial from the lower to the upper end."""
NEAR = 5.0
"""[degree] from the end of a joint's range, where its dial warns."""
TRIP_BIN = 0.25
"""[ms] of the histogram's bins."""


class Dial(Painted):
    """One joint's angle between its stops."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.name, self.count = "", 0
        self.angle: float | None = None
        """[degree]; None where nothing is known of it."""
        self.range = (-60.0, 60.0)
        """[degree]"""
        self.setMinimumSize(96, 104)

    def show_angle(self, angle: float | None, count: int) -> None:
        if (angle, count) != (self.angle, self.count):
            self.angle, self.count = angle, count
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = self.begin()
        side = min(self.width(), self.height() - 22) - 12
        box = QRectF((self.width() - side) / 2, 8, side, side)
        start = 90.0 + SWEEP / 2
        self._arc(painter, box, start, -SWEEP, pick(self.theme, "track"))
        if self.angle is not None:
            low, high = self.range
            share = min(max((self.angle - low) / (high - low), 0.0), 1.0)
            zero = min(max(-low / (high - low), 0.0), 1.0)
            near = min(self.angle - low, high - self.angle) < NEAR
            colour = pick(self.theme, "warm" if near else "accent")
            self._arc(painter, box, start - SWEEP * zero, -SWEEP * (share - zero), colour)
            self._needle(painter, box, math.radians(start - SWEEP * share), colour)
        text = "\N{EN DASH}" if self.angle is None else f"{number(self.angle, 1)}°"
        painter.setFont(self.letters(15, bold=True))
        painter.setPen(pick(self.theme, "text"))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        painter.setFont(self.letters(10))
        painter.setPen(pick(self.theme, "faint"))
        lower = QRectF(box.left(), box.center().y() + 11, box.width(), 14)
        painter.drawText(lower, Qt.AlignmentFlag.AlignCenter, str(self.count))
        painter.setFont(self.letters(12))
        foot = QRectF(0, self.height() - 22, self.width(), 20)
        painter.drawText(foot, Qt.AlignmentFlag.AlignCenter, self.name)
        painter.end()

    def _arc(
        self, painter: QPainter, box: QRectF, start: float, sweep: float, colour: QColor
    ) -> None:
        pen = QPen(colour, 6.0)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        painter.drawArc(box, round(16 * start), round(16 * sweep))

    def _needle(self, painter: QPainter, box: QRectF, angle: float, colour: QColor) -> None:
        middle, radius = box.center(), box.width() / 2
        direction = QPointF(math.cos(angle), -math.sin(angle))
        painter.setPen(QPen(colour, 2.5))
        painter.drawLine(middle + direction * (radius - 9), middle + direction * (radius + 5))


class MotorBars(Painted):
    """What each motor is given, from the middle to either side, and how warm it is."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.duty: Sequence[int] = (0, 0, 0)
        """-255 to 255"""
        self.heat: Sequence[float] = (0.0, 0.0, 0.0)
        """Of what may be held for ever, 0 to 1."""
        self.names: Sequence[str] = ("", "", "")
        self.setMinimumHeight(66)

    def show_motors(self, duty: Sequence[int], heat: Sequence[float]) -> None:
        if (tuple(duty), tuple(heat)) != (tuple(self.duty), tuple(self.heat)):
            self.duty, self.heat = tuple(duty), tuple(heat)
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = self.begin()
        left, right, row = 74, 112, self.height() / 3
        width = self.width() - left - right
        for m, (name, duty, heat) in enumerate(zip(self.names, self.duty, self.heat, strict=True)):
            y = m * row + row / 2
            painter.setFont(self.letters(12))
            painter.setPen(pick(self.theme, "faint"))
            flags = Qt.AlignmentFlag.AlignVCenter
            painter.drawText(QRectF(0, m * row, left, row), flags, name)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(pick(self.theme, "track"))
            painter.drawRoundedRect(QRectF(left, y - 3, width, 6), 3, 3)
            middle, reach = left + width / 2, width / 2 * duty / 255
            painter.setBrush(applied_colour(self.theme))
            painter.drawRect(QRectF(min(middle, middle + reach), y - 3, abs(reach), 6))
            painter.setBrush(pick(self.theme, "faint"))
            painter.drawRect(QRectF(middle - 0.5, y - 6, 1, 12))
            hot = heat > 0.8
            painter.setPen(pick(self.theme, "hot" if hot else "text"))
            percent = number(100 * duty / 255, 0)
            text = translate("Device", "%1 %  heat %2 %").replace("%1", percent)
            text = text.replace("%2", number(100 * heat, 0))
            painter.drawText(
                QRectF(self.width() - right, m * row, right, row),
                flags | Qt.AlignmentFlag.AlignRight,
                text,
            )
        painter.end()


class Histogram(Painted):
    """How long commands took there and back."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.counts = np.zeros(40, dtype=float)
        self.setMinimumHeight(92)

    def show_counts(self, counts: Sequence[int]) -> None:
        new = np.asarray(counts, dtype=float)
        if not np.array_equal(new, self.counts):
            self.counts = new
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = self.begin()
        foot = 18.0
        floor, width = self.height() - foot, self.width() / len(self.counts)
        top = max(1.0, float(self.counts.max()))
        # a few late ones among thousands are what one looks for
        heights = np.log1p(self.counts) / np.log1p(top) * (floor - 6)
        painter.setPen(Qt.PenStyle.NoPen)
        for k, height in enumerate(heights):
            late = k == len(heights) - 1
            painter.setBrush(pick(self.theme, "hot" if late else "accent"))
            if height > 0.0:
                painter.drawRoundedRect(
                    QRectF(k * width + 0.5, floor - height, width - 1.0, height), 1.5, 1.5
                )
        painter.setPen(pick(self.theme, "line"))
        painter.drawLine(QPointF(0, floor), QPointF(self.width(), floor))
        painter.setFont(self.letters(10))
        painter.setPen(pick(self.theme, "faint"))
        letters = QFontMetricsF(painter.font())
        for bin_number in (0, 8, 16, 24, 32, 39):
            last = bin_number == 39
            text = f"{bin_number * TRIP_BIN:.0f}" if not last else "10+ ms"
            x = bin_number * width + (
                0 if bin_number == 0 else -letters.horizontalAdvance(text) / 2
            )
            x = min(x, self.width() - letters.horizontalAdvance(text))
            painter.drawText(QPointF(x, self.height() - 5), text)
        painter.end()
