# SPDX-License-Identifier: GPL-3.0-or-later
"""One row of a chart in words, with the button that gives the organ its configuration."""

from __future__ import annotations

from palpate.study.scene_chart import Chart, Row
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QPushButton, QScrollArea, QSizePolicy, QVBoxLayout, QWidget

from palpate_editor.chart_fit import find_present
from palpate_editor.chart_words import describe_row
from palpate_editor.configuration import describe_provenance, name_configuration
from palpate_editor.document import Organ, Phrase
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import say, tr

WIDTH = 330
"""[px]"""


class RowCard(QWidget):
    """A name, sentences under it, and the button."""

    wanted = Signal(int)
    """The number of the row that the organ is to have."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("chart_row")
        self.row: Row | None = None
        self.setFixedWidth(WIDTH)
        column = QVBoxLayout(self)
        column.setContentsMargins(10, 6, 8, 6)
        column.setSpacing(6)
        self.name = write_label("", "value", self)
        self.name.setObjectName("chart_row_name")
        self.name.setWordWrap(True)
        font = self.name.font()
        font.setBold(True)
        self.name.setFont(font)
        self.words = write_label("", "note", self)
        self.words.setObjectName("chart_row_words")
        self.words.setWordWrap(True)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        area = QScrollArea(self)
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(self.words)
        self.button = QPushButton(tr("Simulate it so"), self)
        self.button.setObjectName("apply_row")
        self.button.clicked.connect(self.ask)
        column.addWidget(self.name)
        column.addWidget(area, 1)
        column.addWidget(self.button, 0, Qt.AlignmentFlag.AlignLeft)
        self.show_nothing()

    def show_nothing(self) -> None:
        self.row = None
        self.name.setText("")
        self.words.setText(tr("Click on a point to read what it is, and to simulate the organ so."))
        self.button.setVisible(False)

    def show_row(self, row: Row, chart: Chart, organ: Organ, more: list[Phrase]) -> None:
        """`more` is said before all else."""
        self.row = row
        self.name.setText(str(say(name_configuration(row.configuration, organ))))
        lines = [*more, *describe_row(row, chart), describe_provenance(row.configuration, organ)]
        present = find_present(chart.rows, organ)
        if present is not None and present.number == row.number:
            lines.insert(0, tr("So it is simulated now."))
            self.button.setEnabled(False)
        else:
            self.button.setEnabled(row.total is not None)
        self.words.setText("\n\n".join(capitalize(str(say(line))) for line in lines))
        self.button.setVisible(True)

    def ask(self) -> None:
        if self.row is not None:
            self.wanted.emit(self.row.number)


def capitalize(text: str) -> str:
    return text[:1].upper() + text[1:]
