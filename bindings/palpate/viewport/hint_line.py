# SPDX-License-Identifier: BSD-3-Clause
"""One line at the foot of the picture that says what the mouse does now, as a child widget."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from palpate.render.theme import DARK, Theme

PAD_X, PAD_Y, GAP, SPACE = 16, 8, 22, 8
"""[px] to the sides, between two pairs, and within one."""

Pairs = list[tuple[str, str]]

translate = QCoreApplication.translate


@dataclass(frozen=True)
class Means:
    """What a mouse can do with an instrument, beside pressing and taking hold."""

    turns: bool = False
    """About its shaft."""
    leans: bool = False
    """To and from the viewer: no trocar holds its shaft."""
    jaws: bool = False
    next_hand: int = 0
    """The number of the instrument that Tab changes to; 0 for the only one."""


PLAIN = Means()
"""A ball's."""


def say_hovering(means: Means = PLAIN) -> Pairs:
    """Buttons and what they do, while the tip is over the organ."""
    return [
        (translate("Viewport", "Left button"), translate("Viewport", "press and stroke")),
        (translate("Viewport", "Right button"), say_taking(means)),
        (translate("Viewport", "Wheel"), translate("Viewport", "deeper or higher")),
        *say_jaws(means),
        *say_hands(means),
        *say_turns(means),
        (translate("Viewport", "Beside the organ"), translate("Viewport", "turn the view")),
    ]


def say_taking(means: Means) -> str:
    """How tissue is held: by jaws, or fastened to a ball by click and hold."""
    if means.jaws:
        return translate("Viewport", "close the jaws and pull")
    return translate("Viewport", "click and hold to pull")


def say_jaws(means: Means) -> Pairs:
    """How jaws are closed and stay so."""
    if not means.jaws:
        return []
    return [("A", translate("Viewport", "close the jaws, or open them"))]


def say_turns(means: Means) -> Pairs:
    """How a shaft is turned."""
    pairs = []
    if means.turns:
        turns = translate("Viewport", "turn the instrument")
        pairs.append((translate("Viewport", "Shift + wheel"), turns))
    if means.leans:
        pairs.append((translate("Viewport", "Alt + wheel"), translate("Viewport", "lean it")))
    return pairs


def say_hands(means: Means) -> Pairs:
    """How the other instrument is reached."""
    if not means.next_hand:
        return []
    other = translate("Viewport", "instrument %1").replace("%1", str(means.next_hand))
    return [(translate("Viewport", "Tab"), other)]


def say_pressing(means: Means = PLAIN) -> Pairs:
    """The same while the left button is down."""
    del means
    return [
        (translate("Viewport", "Move"), translate("Viewport", "stroke at this depth")),
        (translate("Viewport", "Wheel"), translate("Viewport", "deeper or higher")),
        (translate("Viewport", "Let go"), translate("Viewport", "lift off")),
    ]


def say_holding(means: Means = PLAIN) -> Pairs:
    """The same while tissue is held."""
    opens = translate("Viewport", "open the jaws")
    return [
        (translate("Viewport", "Move"), translate("Viewport", "pull sideways")),
        (translate("Viewport", "Wheel"), translate("Viewport", "pull nearer or push away")),
        *say_turns(means),
        *say_hands(means),
        (
            translate("Viewport", "Let go"),
            opens if means.jaws else translate("Viewport", "release the tissue"),
        ),
    ]


MOST_LINES = 3


class HintLine(QWidget):
    """What buttons and wheel do, the first of it where there is no room for all; hidden where there
    is nothing to say, or no room for any of it."""

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
        self._lines: list[Pairs] = []
        self._room = QPointF(0.0, 0.0), 0.0
        self.hide()

    def say(self, words: Callable[[], Pairs] | None) -> None:
        """Asks a function, now and whenever the language changes; None says nothing."""
        if words is not self._words:
            self._words = words
            self._renew()

    def place(self, middle: float, bottom: float, room: float) -> None:
        """Its foot at (middle, bottom) [px]; as many pairs as have room [px], from the first on."""
        self._room = QPointF(middle, bottom), room
        self._lines = self._choose(room)
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
        wide = max((self._measure(line) for line in self._lines), default=0.0) + 2 * PAD_X
        high = QFontMetricsF(self._names).height() * max(1, len(self._lines))
        return QSize(round(wide) + 1, round(high + 2 * PAD_Y))

    def _measure(self, pairs: Pairs) -> float:
        """[px]"""
        names, words = QFontMetricsF(self._names), QFontMetricsF(self.font())
        wide = sum(
            names.horizontalAdvance(name) + SPACE + words.horizontalAdvance(meaning)
            for name, meaning in pairs
        )
        return wide + GAP * max(0, len(pairs) - 1)

    @property
    def shown(self) -> Pairs:
        """Of what is said, that for which there is room."""
        return [pair for line in self._lines for pair in line]

    def _choose(self, room: float) -> list[Pairs]:
        """Lines of as many pairs as there is room [px] for."""
        for count in range(len(self.pairs), 1, -1):
            lines = self._break(self.pairs[:count], room)
            if len(lines) <= MOST_LINES:
                return lines
        return [self.pairs[:1]]

    def _break(self, pairs: Pairs, room: float) -> list[Pairs]:
        """Pairs in lines of about the same width, as few as there is room [px] for."""
        count = max(1, math.ceil((self._measure(pairs) + 1) / max(1.0, room - 2 * PAD_X)))
        least = self._measure(pairs) / count
        lines: list[Pairs] = [[]]
        for pair in pairs:
            full = lines[-1] and self._measure([*lines[-1], pair]) > room - 2 * PAD_X
            if full or (len(lines) < count and self._measure(lines[-1]) >= least):
                lines.append([])
            lines[-1].append(pair)
        return lines

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
        letters = QFontMetricsF(self._names)
        round_ = letters.height() / 2 + PAD_Y
        painter.drawRoundedRect(self.rect(), round_, round_)
        for number, line in enumerate(self._lines):
            x = (self.width() - self._measure(line)) / 2
            self._paint_line(painter, line, x, PAD_Y + letters.ascent() + number * letters.height())
        painter.end()

    def _paint_line(self, painter: QPainter, line: Pairs, x: float, y: float) -> None:
        for name, meaning in line:
            for font, colour, text, gap in (
                (self._names, self.theme.text, name, SPACE),
                (self.font(), self.theme.faint, meaning, GAP),
            ):
                painter.setFont(font)
                painter.setPen(QColor.fromRgbF(*colour))
                painter.drawText(QPointF(x, y), text)
                x += QFontMetricsF(font).horizontalAdvance(text) + gap

    def _renew(self) -> None:
        self.pairs = [] if self._words is None else self._words()
        at, room = self._room
        self.place(at.x(), at.y(), room)
        self.update()
