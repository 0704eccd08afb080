# SPDX-License-Identifier: BSD-3-Clause
"""A small table of what was measured."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QWidget

from palpate.player.cards import build_label


class Results(QWidget):
    """Rows of equal length; the first one is the head."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.rows: Sequence[Sequence[str]] = ()
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setHorizontalSpacing(10)
        self.grid.setVerticalSpacing(4)
        self.grid.setColumnStretch(0, 1)

    def show_rows(self, rows: Sequence[Sequence[str]]) -> None:
        if rows == self.rows:
            return
        self.rows = rows
        while self.grid.count():
            item = self.grid.takeAt(0)
            if item is not None and item.widget() is not None:
                item.widget().deleteLater()
        for y, row in enumerate(rows):
            for x, text in enumerate(row):
                label = build_label("faint" if y == 0 or x == 0 else "number", self)
                label.setText(text)
                if x:
                    label.setAlignment(Qt.AlignmentFlag.AlignRight)
                self.grid.addWidget(label, y, x)
