# SPDX-License-Identifier: BSD-3-Clause
"""What pages are put together from."""

from __future__ import annotations

from PySide6.QtCore import Qt
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

from palpate.player.cards import build_label


class Card(QFrame):
    """A rounded panel with a small title."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("card")
        self.rows = QVBoxLayout(self)
        self.rows.setContentsMargins(14, 10, 14, 12)
        self.rows.setSpacing(6)
        self.title = build_label("section", self)
        self.rows.addWidget(self.title)

    def add(self, name: str, wrap: bool = False) -> QLabel:
        label = build_label(name, self, wrap)
        self.rows.addWidget(label)
        return label

    def add_row(self, *widgets: QWidget) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(8)
        for widget in widgets:
            row.addWidget(widget)
        self.rows.addLayout(row)
        return row


class Facts(QWidget):
    """Names and numbers in two columns of pairs."""

    def __init__(self, parent: QWidget, count: int, columns: int = 2):
        super().__init__(parent)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(4)
        self.names, self.values = [], []
        for k in range(count):
            row, column = divmod(k, columns)
            name, value = build_label("faint", self), build_label("number", self)
            value.setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(name, row, 3 * column)
            grid.addWidget(value, row, 3 * column + 1)
            self.names.append(name)
            self.values.append(value)
        for column in range(columns):
            grid.setColumnStretch(3 * column + 1, 1)
            if column + 1 < columns:
                grid.setColumnMinimumWidth(3 * column + 2, 10)

    def call(self, *names: str) -> None:
        for label, name in zip(self.names, names, strict=True):
            label.setText(name)

    def show_values(self, *values: str) -> None:
        for label, value in zip(self.values, values, strict=True):
            if label.text() != value:
                label.setText(value)


class Page(QScrollArea):
    """Cards one below the other."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        inside = QWidget()
        inside.setObjectName("page")
        self.column = QVBoxLayout(inside)
        self.column.setContentsMargins(0, 0, 6, 0)
        self.column.setSpacing(10)
        self.setWidget(inside)

    def add_card(self) -> Card:
        card = Card(self)
        self.column.addWidget(card)
        return card


def build_button(parent: QWidget, main: bool = False, checkable: bool = False) -> QPushButton:
    button = QPushButton(parent)
    button.setCheckable(checkable)
    if main:
        button.setObjectName("main")
    button.setCursor(Qt.CursorShape.PointingHandCursor)
    return button
