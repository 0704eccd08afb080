# SPDX-License-Identifier: GPL-3.0-or-later
"""Every sentence of the scenario in every language; those that are missing are red."""

from __future__ import annotations

from palpate.assessment import author
from palpate.translation import LANGUAGES
from PySide6.QtCore import Qt
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.translations import tr

ROW, MOST = 26, 8
RED = QColor(190, 40, 40, 110)
CODE = Qt.ItemDataRole.UserRole


class TextTable(QTableWidget):
    """A cell is an edit once it has been left."""

    def __init__(self, draft: TaskDraft, parent: QWidget | None = None):
        super().__init__(parent)
        self.draft = draft
        self._writing = False
        self.setObjectName("texts")
        self.setAccessibleName(tr("Texts"))
        self.verticalHeader().hide()
        self.setWordWrap(False)
        self.cellChanged.connect(self._enter)
        draft.shown.connect(self.show_draft)

    def show_draft(self) -> None:
        if self.draft.assessment is None:
            self.setRowCount(0)
            return
        texts = self.draft.assessment["texts"]
        codes = ["en", *(code for code in LANGUAGES if code != "en"),
                 *(code for code in texts if code not in LANGUAGES)]  # fmt: skip
        keys = list(texts.get("en", {}))
        self._writing = True
        self.setColumnCount(len(codes))
        self.setHorizontalHeaderLabels([LANGUAGES.get(code, code) for code in codes])
        self.setRowCount(len(keys))
        for row, key in enumerate(keys):
            for column, code in enumerate(codes):
                text = texts.get(code, {}).get(key, "")
                item = QTableWidgetItem(text)
                item.setData(CODE, (key, code))
                item.setToolTip(
                    f"{key}: {text}" if text else tr("{key} is missing").format(key=key)
                )
                if not text:
                    item.setBackground(QBrush(RED))
                self.setItem(row, column, item)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.setFixedHeight(ROW * (min(max(len(keys), 1), MOST) + 1) + 12)
        self._writing = False

    def count_missing(self) -> int:
        items = [self.item(r, c) for r in range(self.rowCount()) for c in range(self.columnCount())]
        return sum(item is not None and not item.text() for item in items)

    def _enter(self, row: int, column: int) -> None:
        if not self._writing:
            key, code = self.item(row, column).data(CODE)
            text = self.item(row, column).text().strip()
            self.draft.change("text", author.set_text, key, code, text)
