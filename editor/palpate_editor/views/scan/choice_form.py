# SPDX-License-Identifier: GPL-3.0-or-later
"""Which voxels are the organ: labels with their volumes, or a range of grey levels."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.scan import MOST_SMOOTHING, USUAL_SMOOTHING, Choice, Scan
from palpate_editor.views.number_box import NumberBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import quantity, tr

LABEL = Qt.ItemDataRole.UserRole


class ChoiceForm(QWidget):
    """Labels where the scan has some, else a range; smoothing and the largest piece."""

    changed = Signal()

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.list = QListWidget(self)
        self.list.setObjectName("scan_labels")
        self.list.setAccessibleName(tr("Labels of the organ"))
        self.list.itemChanged.connect(self.changed)
        column.addWidget(self.list, 1)
        self.range = QWidget(self)
        grid = QGridLayout(self.range)
        grid.setContentsMargins(0, 0, 0, 0)
        self.low = self.add_end(grid, tr("From grey level"), "scan_low", 0)
        self.high = self.add_end(grid, tr("To grey level"), "scan_high", 1)
        column.addWidget(self.range)
        self.largest = QCheckBox(tr("The largest piece alone"), self)
        self.largest.setObjectName("scan_largest")
        self.largest.setChecked(True)
        self.largest.toggled.connect(self.changed)
        column.addWidget(self.largest)
        row = QGridLayout()
        self.smooth = NumberBox(self)
        self.smooth.setObjectName("scan_smooth")
        self.smooth.setRange(0.0, MOST_SMOOTHING)
        self.smooth.setSingleStep(0.1)
        self.smooth.setSuffix(" " + tr("voxels"))
        self.smooth.valueChanged.connect(self.changed)
        row.addWidget(write_label(tr("Smoothing"), "name", self), 0, 0)
        row.addWidget(self.smooth, 0, 1)
        row.setColumnStretch(1, 1)
        column.addLayout(row)
        column.addStretch(0)

    def add_end(self, grid: QGridLayout, text: str, name: str, row: int) -> NumberBox:
        field = NumberBox(self)
        field.setObjectName(name)
        field.setDecimals(1)
        field.setKeyboardTracking(False)
        field.valueChanged.connect(self.changed)
        grid.addWidget(write_label(text, "name", self), row, 0)
        grid.addWidget(field, row, 1)
        grid.setColumnStretch(1, 1)
        return field

    def show_scan(self, scan: Scan) -> None:
        self.blockSignals(True)
        self.list.clear()
        for row in scan.labels or ():
            volume = quantity(1e6 * scan.voxel_volume * row.voxels, "ml", 3)
            name = row.name.replace("_", " ") or tr("label {number}").format(number=row.label)
            item = QListWidgetItem(f"{name}    {volume}", self.list)
            item.setData(LABEL, row.label)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Unchecked)
        has_labels = scan.labels is not None
        self.list.setVisible(has_labels)
        self.range.setVisible(not has_labels)
        size = max(scan.high - scan.low, 1e-6)
        for field, value in ((self.low, scan.low + 0.6 * size), (self.high, scan.high)):
            field.setRange(scan.low, scan.high)
            field.setSingleStep(max(0.005 * size, 0.1))
            field.setValue(value)
        self.smooth.setValue(USUAL_SMOOTHING if has_labels else 0.0)
        self.blockSignals(False)

    def choice(self) -> Choice | None:
        """None where nothing is chosen."""
        labels: tuple[int, ...] = ()
        low = high = None
        if self.list.isVisibleTo(self):
            items = [self.list.item(row) for row in range(self.list.count())]
            checked = [item for item in items if item.checkState() == Qt.CheckState.Checked]
            labels = tuple(int(item.data(LABEL)) for item in checked)
            if not labels:
                return None
        else:
            low, high = self.low.value(), self.high.value()
            if not low < high:
                return None
            # the ends of the scale leave nothing out
            low = None if low <= self.low.minimum() else low
            high = None if high >= self.high.maximum() else high
            if low is None and high is None:
                return None
        return Choice(labels, low, high, self.smooth.value(), self.largest.isChecked())
