# SPDX-License-Identifier: BSD-3-Clause
"""A few numbers over the picture, as a child widget."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QPoint, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from palpate.render.theme import DARK, Theme

PAD, GAP = 14, 22
"""[px]"""
LINE = 1.35
"""[-] from a row to the next, in heights of a letter."""


class Hud(QWidget):
    """Rows of a name and a number, such as force, time and cost; hidden when there are none."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("hud")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.theme: Theme = DARK
        self.rows: tuple[tuple[str, str], ...] = ()
        self.wrong: frozenset[str] = frozenset()
        """Names of the rows whose number is beyond what it may be."""
        self._numbers = QFont(self.font())
        self._numbers.setWeight(QFont.Weight.DemiBold)
        self._widest = (0.0, 0.0)
        self._corner = QPoint(0, 0)
        self.hide()

    def place(self, corner: QPoint) -> None:
        """Its upper right corner [px], where it stays however wide its rows are."""
        self._corner = corner
        self.move(corner.x() - self.width(), corner.y())

    def show_rows(self, rows: Sequence[tuple[str, str]], wrong: Iterable[str] = ()) -> None:
        """Names and what stands beside them, unit included; none hides the widget. Those named in
        `wrong` are marked."""
        rows, wrong = tuple(rows), frozenset(wrong)
        if (rows, wrong) == (self.rows, self.wrong):
            return
        self.wrong = wrong
        names = tuple(name for name, _ in rows)
        if names != tuple(name for name, _ in self.rows):
            self._widest = (0.0, 0.0)
        self.rows = rows
        self.setVisible(bool(rows))
        self._fit()

    def _fit(self) -> None:
        """As large as its rows need."""
        if self.rows:
            self.resize(self.sizeHint())
            self.place(self._corner)
            self.update()

    def use_letter(self, height: float) -> None:
        """Of its text [px]; as the window has it where nothing is said."""
        font = QFont(self.font())
        font.setPixelSize(max(9, round(height)))
        self.setFont(font)
        self._numbers = QFont(font)
        self._numbers.setWeight(QFont.Weight.DemiBold)
        self._widest = (0.0, 0.0)
        self._fit()

    def use_theme(self, theme: Theme) -> None:
        self.theme = theme
        self.update()

    def sizeHint(self) -> QSize:
        names, numbers = QFontMetricsF(self.font()), QFontMetricsF(self._numbers)
        left = max((names.horizontalAdvance(name) for name, _ in self.rows), default=0.0)
        right = max((numbers.horizontalAdvance(number) for _, number in self.rows), default=0.0)
        # only ever wider, or the panel would tremble with its digits
        self._widest = (max(left, self._widest[0]), max(right, self._widest[1]))
        width = sum(self._widest) + GAP + 2 * PAD
        lines = LINE * (len(self.rows) - 1) + 1.0
        return QSize(round(width), round(lines * numbers.height() + 2 * PAD))

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor.fromRgbF(*self.theme.panel, 0.62))
        painter.drawRoundedRect(self.rect(), 8, 8)
        letters = QFontMetricsF(self._numbers)
        y = PAD + letters.ascent()
        for name, number in self.rows:
            painter.setFont(self.font())
            painter.setPen(QColor.fromRgbF(*self.theme.faint))
            painter.drawText(QPointF(PAD, y), name)
            painter.setFont(self._numbers)
            colour = self.theme.alarm if name in self.wrong else self.theme.text
            painter.setPen(QColor.fromRgbF(*colour))
            painter.drawText(
                QPointF(self.width() - PAD - letters.horizontalAdvance(number), y), number
            )
            y += LINE * letters.height()
        painter.end()
