# SPDX-License-Identifier: BSD-3-Clause
"""Panels over the picture: texts that say themselves anew when the language changes."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from palpate.player.words import format_clock, say_notice, translate


def build_label(name: str, parent: QWidget, wrap: bool = False) -> QLabel:
    """A label whose look the style sheet knows by name; text is never taken for HTML."""
    label = QLabel(parent)
    label.setObjectName(name)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(wrap)
    return label


class Card(QFrame):
    """A rounded panel with labels one below the other."""

    def __init__(self, parent: QWidget, name: str = "card"):
        super().__init__(parent)
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.rows = QVBoxLayout(self)
        self.rows.setContentsMargins(20, 16, 20, 16)
        self.rows.setSpacing(6)

    def add(self, name: str, wrap: bool = False) -> QLabel:
        label = build_label(name, self, wrap)
        self.rows.addWidget(label)
        return label


class TaskCard(Card):
    """What the scenario is called and what is to be done; its own words, in its own language."""

    def __init__(self, parent: QWidget, title: str, task: str):
        super().__init__(parent)
        self.add("title", wrap=True).setText(title)
        body = self.add("body", wrap=True)
        body.setText(task)
        body.setVisible(bool(task))


class ClockCard(Card):
    """The time of the run."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.caption, self.clock = self.add("caption"), self.add("clock")
        self.rows.setSpacing(0)
        self.time = 0.0
        """[s]"""
        self.say()

    def show_time(self, time: float) -> None:
        """[s] of the run."""
        self.time = time
        self.clock.setText(format_clock(time))

    def say(self) -> None:
        self.caption.setText(translate("Player", "Time"))
        self.show_time(self.time)


class Notice(QFrame):
    """That this is no medical device. Nothing takes it off the screen."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("notice")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.label = build_label("notice_text", self)
        row = QHBoxLayout(self)
        row.setContentsMargins(14, 7, 14, 7)
        row.addWidget(self.label)
        self.say()

    def say(self) -> None:
        self.label.setText(say_notice())


class Banner(QFrame):
    """A sentence of what went wrong ("alarm") or runs badly ("warning")."""

    def __init__(self, parent: QWidget, name: str):
        super().__init__(parent)
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.label = build_label(f"{name}_text", self, wrap=True)
        self.label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        row = QHBoxLayout(self)
        row.setContentsMargins(22, 13, 22, 13)
        row.addWidget(self.label)
        self.hide()

    def tell(self, sentence: str) -> None:
        """Shows a sentence; an empty one takes the banner away."""
        self.label.setText(sentence)
        self.setVisible(bool(sentence))


class Table(QWidget):
    """Names and what they do, in two columns."""

    def __init__(self, parent: QWidget, rows: Callable[[], list[tuple[str, str]]]):
        super().__init__(parent)
        self._rows = rows
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(22)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(1, 1)
        self._labels = []
        for k in range(len(rows())):
            left, right = build_label("body", self), build_label("keys", self)
            self._grid.addWidget(left, k, 0)
            self._grid.addWidget(right, k, 1)
            self._labels.append((left, right))
        self.say()

    def say(self) -> None:
        for (left, right), (name, meaning) in zip(self._labels, self._rows(), strict=True):
            left.setText(name)
            right.setText(meaning)


class KeyLine(QFrame):
    """The keys, in one line at the foot of the window."""

    def __init__(self, parent: QWidget, rows: Callable[[], list[tuple[str, str]]]):
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._rows = rows
        self.label = build_label("keys", self)
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self.label)
        self.say()

    def say(self) -> None:
        pairs = (f"{name}  {meaning}" for name, meaning in self._rows())
        self.label.setText("      ".join(pairs))
