# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of several series in a folder of DICOM slices is shown."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from palpate_editor.scan import Series
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import count, tr

TOOLTIP = Qt.ItemDataRole.ToolTipRole


class SeriesRow(QWidget):
    """A list of series; hidden where there is one."""

    chosen = Signal(str)
    """The UID of the series that a person chose."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.list = QComboBox(self)
        self.list.setObjectName("scan_series")
        self.list.setAccessibleName(tr("Series of the folder"))
        self.list.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.list.setMinimumContentsLength(12)
        self.list.activated.connect(self.choose)
        row.addWidget(write_label(tr("Series"), "name", self))
        row.addWidget(self.list, 1)
        self.hide()

    def forget(self) -> None:
        self.list.clear()
        self.hide()

    def show_series(self, series: tuple[Series, ...]) -> None:
        """Lists them, and has the one of most slices chosen."""
        self.list.clear()
        for each in series:
            columns, rows = each.size[:2]
            text = tr("{title}: {slices} slices of {columns} × {rows}").format(
                title=each.title or tr("without a name"),
                slices=count(each.slices),
                columns=count(columns),
                rows=count(rows),
            )
            self.list.addItem(text, each.uid)
            self.list.setItemData(self.list.count() - 1, f"{text}\n{each.uid}", TOOLTIP)
        most = max(range(len(series)), key=lambda row: series[row].slices)
        self.list.setCurrentIndex(most)
        self.show()

    def uid(self) -> str | None:
        """None where there is one series."""
        return self.list.currentData() if self.list.count() else None

    def choose(self, row: int) -> None:
        self.chosen.emit(str(self.list.itemData(row)))
