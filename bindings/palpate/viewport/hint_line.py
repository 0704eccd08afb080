# SPDX-License-Identifier: BSD-3-Clause
"""One line at the foot of the picture that says what the mouse does now, as a child widget."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from palpate.render.theme import DARK, Theme

PAD_X, PAD_Y, GAP, SPACE = 16, 8, 22, 8
"""[px] to the sides, between two pairs, and within one."""

Pairs = list[tuple[str, str]]

translate = QCoreApplication.translate


def say_hovering() -> Pairs:
    """Buttons and what they do, while the tip is over the organ."""
    return [
        (translate("Viewport", "Left button"), translate("Viewport", "press and stroke")),
        (translate("Viewport", "Right button"), translate("Viewport", "take hold and pull")),
        (translate("Viewport", "Wheel"), translate("Viewport", "deeper or higher")),
        (translate("Viewport", "Beside the organ"), translate("Viewport", "turn the view")),
    ]


def say_pressing() -> Pairs:
    """The same while the left button is down."""
    return [
        (translate("Viewport", "Move"), translate("Viewport", "stroke at this depth")),
        (translate("Viewport", "Wheel"), translate("Viewport", "deeper or higher")),
        (translate("Viewport", "Let go"), translate("Viewport", "lift off")),
    ]


def say_holding() -> Pairs:
    """The same while tissue is held."""
    return [
        (translate("Viewport", "Move"), translate("Viewport", "pull sideways")),
        (translate("Viewport", "Wheel"), translate("Viewport", "pull nearer or push away")),
        (translate("Viewport", "Let go"), translate("Viewport", "release the tissue")),
    ]


class HintLine(QWidget):
    """What buttons and wheel do; hidden where there is nothing to say, or no room for it."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("hint_line")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.theme: Theme = DARK
        self._words: Callable[[], Pairs] | None = None
        self._names = QFont(self.font())
        self._names.setWeight(QFont.Weight.DemiBold)
        self.pairs: Pairs = []
        """What is said now, in the language of the program."""
        self._room = QPointF(0.0, 0.0), 0.0
        self.hide()

    def say(self, words: Callable[[], Pairs] | None) -> None:
        """Asks a function, now and whenever the language changes; None says nothing."""
        if words is not self._words:
            self._words = words
            self._renew()

    def place(self, middle: float, bottom: float, room: float) -> None:
        """Its foot at (middle, bottom) [px]; not shown where it is wider than the room [px]."""
        self._room = QPointF(middle, bottom), room
        size = self.sizeHint()
        self.setGeometry(
            round(middle - size.width() / 2),
            round(bottom - size.height()),
            size.width(),
            size.height(),
        )
        self.setVisible(bool(self.pairs) and size.width() <= room)

    def use_theme(self, theme: Theme) -> None:
        self.theme = theme
        self.update()

    def sizeHint(self) -> QSize:
        names, words = QFontMetricsF(self._names), QFontMetricsF(self.font())
        wide = sum(
            names.horizontalAdvance(name) + SPACE + words.horizontalAdvance(meaning)
            for name, meaning in self.pairs
        )
        wide += GAP * max(0, len(self.pairs) - 1) + 2 * PAD_X
        return QSize(round(wide) + 1, round(names.height() + 2 * PAD_Y))

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.LanguageChange:
            self._renew()
        elif event.type() == QEvent.Type.FontChange:
            self._names = QFont(self.font())
            self._names.setWeight(QFont.Weight.DemiBold)
            self._renew()
        super().changeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor.fromRgbF(*self.theme.panel, 0.62))
        painter.drawRoundedRect(self.rect(), self.height() / 2, self.height() / 2)
        x, y = float(PAD_X), PAD_Y + QFontMetricsF(self._names).ascent()
        for name, meaning in self.pairs:
            for font, colour, text, gap in (
                (self._names, self.theme.text, name, SPACE),
                (self.font(), self.theme.faint, meaning, GAP),
            ):
                painter.setFont(font)
                painter.setPen(QColor.fromRgbF(*colour))
                painter.drawText(QPointF(x, y), text)
                x += QFontMetricsF(font).horizontalAdvance(text) + gap
        painter.end()

    def _renew(self) -> None:
        self.pairs = [] if self._words is None else self._words()
        at, room = self._room
        self.place(at.x(), at.y(), room)
        self.update()
