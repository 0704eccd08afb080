# SPDX-License-Identifier: BSD-3-Clause
"""Panels over the picture: texts that say themselves again when the language changes."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices, QMouseEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from palpate.player.sentences import format_clock, say_notice, translate

LONG_WORD = re.compile(r"(?=[^\s/]*(?:[_\d-]|\.\w))[^\s/]{17,}|[^\s/]{32,}")
"""The name of a file rather than a word, or no word of any language."""
BREAK = "\N{ZERO WIDTH SPACE}"


def build_label(name: str, parent: QWidget, wrap: bool = False) -> QLabel:
    """A label that the style sheet knows by name; text is never taken for HTML."""
    label = QLabel(parent)
    label.setObjectName(name)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(wrap)
    return label


def allow_breaks(text: str) -> str:
    """The text with zero-width spaces where long words, such as names of files, may be broken: a
    label breaks lines at spaces and slashes alone, and cuts off what is still too long.
    """
    return LONG_WORD.sub(lambda word: BREAK.join(word[0]), text)


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


class Page(QScrollArea):
    """A rounded panel whose rows are scrolled where there is no room for all of them."""

    def __init__(self, parent: QWidget, name: str):
        super().__init__(parent)
        self.setObjectName(name)
        self.setWidgetResizable(True)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.page = QWidget()
        self.page.setObjectName("page")
        self.rows = QVBoxLayout(self.page)
        self.setWidget(self.page)
        self.page.setAutoFillBackground(False)
        self.viewport().setAutoFillBackground(False)

    def add(self, name: str) -> QLabel:
        label = build_label(name, self.page, wrap=True)
        self.rows.addWidget(label)
        return label

    def fit(self, width: int, room: int) -> int:
        """[px] the height to take of the room, scrolled only where that is less than is needed.

        Left to itself, Qt keeps a bar that was needed once: beside it the text is higher.
        """
        needed = self.find_height(width)
        policy = Qt.ScrollBarPolicy
        fits = needed <= room
        self.setVerticalScrollBarPolicy(
            policy.ScrollBarAlwaysOff if fits else policy.ScrollBarAsNeeded
        )
        return needed if fits else room

    def find_height(self, width: int) -> int:
        """[px] that all rows need in this width."""
        for part in (self, self.page, *self.page.findChildren(QWidget)):
            part.ensurePolished()
        self.rows.invalidate()
        frame = 2 * self.frameWidth()
        wanted = self.rows.totalHeightForWidth(width - frame)
        return frame + (wanted if wanted > 0 else self.rows.totalSizeHint().height())


class TaskCard(Page):
    """What the scenario is called and what is to be done. A click folds it up to its title."""

    folded = Signal(bool)

    def __init__(self, parent: QWidget):
        super().__init__(parent, "card")
        self.rows.setContentsMargins(20, 16, 20, 16)
        self.rows.setSpacing(6)
        self.title, self.body = self.add("title"), self.add("body")
        self.hint = self.add("caption")
        self.is_folded = False
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def tell(self, title: str, task: str) -> None:
        self.title.setText(title)
        self.body.setText(task)
        self.fold(self.is_folded)

    def fold(self, folded: bool) -> None:
        """Shows the title alone, or the task too."""
        self.is_folded = folded
        there = bool(self.body.text())
        self.body.setVisible(there and not folded)
        text = translate("Player", "T shows the task") if folded else ""
        self.hint.setText(text)
        self.hint.setVisible(there and folded)
        self.folded.emit(folded)

    def toggle(self) -> None:
        self.fold(not self.is_folded)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.toggle()
        event.accept()


class FolderLine(QWidget):
    """Where something is kept, and a button that shows it in the system's own file manager."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.folder = Path()
        self.label = build_label("caption", self, wrap=True)
        self.button = QPushButton(self)
        self.button.setObjectName("small")
        self.button.setCursor(Qt.CursorShape.PointingHandCursor)
        self.button.clicked.connect(self.open)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(12)
        row.addWidget(self.label, 1)
        row.addWidget(self.button)

    def tell(self, text: str, folder: Path) -> None:
        """`text` names what lies in the folder."""
        self.folder = folder
        self.label.setText(allow_breaks(text))
        self.button.setText(translate("Player", "Open the folder"))

    def open(self) -> None:
        """Makes the folder where there is none yet."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            opened = QDesktopServices.openUrl(QUrl.fromLocalFile(str(self.folder)))
        except OSError:
            opened = False
        if not opened:
            text = translate("Player", "This system does not open folders. It is %1")
            self.label.setText(allow_breaks(text.replace("%1", str(self.folder))))


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
        self.label.ensurePolished()  # a layout may have known it in other letters
        self.label.setMinimumWidth(self.label.sizeHint().width())
        self.setMinimumWidth(self.layout().totalMinimumSize().width())


class Banner(QFrame):
    """A sentence of what went wrong ("alarm") or runs badly ("warning")."""

    def __init__(self, parent: QWidget, name: str):
        super().__init__(parent)
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.sentence = ""
        self.label = build_label(f"{name}_text", self, wrap=True)
        self.label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        row = QHBoxLayout(self)
        row.setContentsMargins(22, 13, 22, 13)
        row.addWidget(self.label)
        self.hide()

    def tell(self, sentence: str) -> None:
        """Shows a sentence; an empty one takes the banner away."""
        self.sentence = sentence
        self.label.setText(allow_breaks(sentence))
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
        self._tell(self._rows())

    def fit(self, room: int) -> bool:
        """As many of them as there is room for [px], and the last, of the menu that has them all;
        False where not even that has room."""
        rows = self._rows()
        for count in range(len(rows) - 1, -1, -1):
            self._tell([*rows[:count], rows[-1]])
            self.ensurePolished()
            self.adjustSize()
            if self.width() <= room:
                return True
        return False

    def _tell(self, rows: list[tuple[str, str]]) -> None:
        pairs = (f"{name}  {meaning}" for name, meaning in rows)
        self.label.setText("      ".join(pairs))
