# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and numbers in two columns, sections over them, and the checks of a stage."""

from __future__ import annotations

from collections.abc import Sequence

from palpate.viewport.tone import set_tone
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.views.icons import draw_icon
from palpate_editor.views.theme import Colours
from palpate_editor.views.translations import tr

SIGNS = {"good": "tick", "warning": "warning", "bad": "cross", "faint": "info"}

Fact = tuple[str, str] | tuple[str, str, str]
"""Name, value, and the tone where it has one: good, warning or bad."""


def write_label(text: str, role: str, parent: QWidget | None = None) -> QLabel:
    label = QLabel(text, parent)
    label.setProperty("role", role)
    label.setTextFormat(Qt.TextFormat.PlainText)
    return label


class Facts(QWidget):
    """Rows of a name and its value; rows are made once and written again after that."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setHorizontalSpacing(14)
        self.grid.setVerticalSpacing(5)
        self.grid.setColumnStretch(1, 1)
        self.rows: list[tuple[QLabel, QLabel]] = []
        self.keep_height = False
        """Whether the widget never gets lower, so that what stands below it stays where it is."""

    def forget_height(self) -> None:
        """It may get lower once."""
        self.setMinimumHeight(0)

    def show_facts(self, facts: Sequence[Fact]) -> None:
        while len(self.rows) < len(facts):
            self.add_row()
        for i, (name, value) in enumerate(self.rows):
            shown = i < len(facts)
            name.setVisible(shown)
            value.setVisible(shown)
            if shown:
                name.setText(facts[i][0])
                value.setText(facts[i][1])
                set_tone(value, facts[i][2] if len(facts[i]) > 2 else "")
        if self.keep_height:
            self.grid.activate()
            wanted = self.grid.totalHeightForWidth(self.width())
            self.setMinimumHeight(max(self.minimumHeight(), wanted))

    def add_row(self) -> None:
        name, value = write_label("", "name", self), write_label("", "value", self)
        value.setWordWrap(True)
        value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        value.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row = len(self.rows)
        self.grid.addWidget(name, row, 0, Qt.AlignmentFlag.AlignTop)
        self.grid.addWidget(value, row, 1)
        self.rows.append((name, value))

    def texts(self) -> dict[str, str]:
        """What is shown, by name."""
        return {n.text(): v.text() for n, v in self.rows if not n.isHidden()}


class Section(QWidget):
    """A heading with a line under it, and what belongs to it."""

    def __init__(self, title: str, parent: QWidget | None = None):
        super().__init__(parent)
        self.body = QVBoxLayout(self)
        self.body.setContentsMargins(0, 8, 0, 0)
        self.body.setSpacing(7)
        self.heading = write_label(title, "section", self)
        rule = QFrame(self)
        rule.setProperty("role", "rule")
        rule.setFixedHeight(1)
        row = QHBoxLayout()
        row.setSpacing(9)
        row.addWidget(self.heading)
        row.addWidget(rule, 1)
        self.body.addLayout(row)

    def add(self, widget: QWidget) -> QWidget:
        self.body.addWidget(widget)
        return widget


class CheckRow(QWidget):
    """One check: its sign, a sentence, and a button where a fix is known."""

    fix_wanted = Signal(object)
    look_wanted = Signal(object)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 1, 0, 1)
        row.setSpacing(9)
        self.sign, self.label = QLabel(self), write_label("", "value", self)
        self.sign.setFixedSize(18, 18)
        self.label.setWordWrap(True)
        self.button = QPushButton(self)
        self.button.setProperty("small", True)
        self.button.clicked.connect(self.tell)
        self.fix: object = None
        self.look = QPushButton(tr("Show"), self)
        self.look.setProperty("small", True)
        self.look.clicked.connect(self.tell_place)
        self.look.hide()
        self.place: object = None
        row.addWidget(self.sign, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self.label, 1)
        row.addWidget(self.look, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self.button, 0, Qt.AlignmentFlag.AlignTop)

    def show_check(
        self,
        tone: str,
        text: str,
        colours: Colours,
        fix: object = None,
        fix_text: str = "",
        place: object = None,
    ) -> None:
        """`place` is what can be looked at, None where it is nowhere in particular."""
        self.tone, self.fix, self.place = tone, fix, place
        self.look.setVisible(place is not None)
        colour = getattr(colours, tone)
        self.sign.setPixmap(draw_icon(SIGNS[tone], colour, 16, 2.2))
        self.label.setText(text)
        self.button.setText(fix_text)
        self.button.setVisible(fix is not None)

    def tell(self) -> None:
        self.fix_wanted.emit(self.fix)

    def tell_place(self) -> None:
        self.look_wanted.emit(self.place)
