# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be done with selected vertices, for the panel of a stage."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QWidget

from palpate_editor.views.quantity_box import QuantityBox, QuantityRow
from palpate_editor.views.touch.region_row import RegionRow
from palpate_editor.views.touch.tools import SelectionTool
from palpate_editor.views.translations import count, tr

FIRST_FACTOR = 3.0


class SelectOptions(QWidget):
    """How many are selected, and buttons to fix, free and stiffen them."""

    def __init__(self, tool: SelectionTool, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("select_options")
        self.tool, self.value = tool, FIRST_FACTOR
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(8)
        self.count = QLabel(self)
        self.count.setProperty("role", "name")
        grid.addWidget(self.count, 0, 0, 1, 2)
        self.fix = self._button(tr("Fix"), tr("Hold the selected vertices at rest"), tool.fix)
        self.free = self._button(tr("Free"), tr("Let the selected vertices move"), tool.free)
        grid.addWidget(self.fix, 1, 0)
        grid.addWidget(self.free, 1, 1)
        self.factor = QuantityRow(QuantityBox("\N{MULTIPLICATION SIGN}"), parent=self)
        self.factor.show_value(self.value)
        self.factor.entered.connect(self._take_factor)
        self.stiffen = self._button(
            tr("Set stiffness"),
            tr("Give the selected vertices this stiffness, times the organ's own"),
            self._stiffen,
        )
        grid.addWidget(self.factor, 2, 0)
        grid.addWidget(self.stiffen, 2, 1)
        self.regions = RegionRow(tool, self)
        grid.addWidget(self.regions, 3, 0, 1, 2)
        tool.selection_changed.connect(self.show_count)
        self.show_count()

    def _button(self, title: str, tip: str, slot: Callable[[], None]) -> QPushButton:
        button = QPushButton(title, self)
        button.setToolTip(tip)
        button.clicked.connect(slot)
        return button

    def show_count(self) -> None:
        """Says how many are selected, and locks what would do nothing."""
        selected = self.tool.selected
        some = int(selected.sum())
        self.count.setText(
            tr("{some} of {all} vertices selected").format(
                some=count(some), all=count(len(selected))
            )
        )
        for button in (self.fix, self.free, self.stiffen):
            button.setEnabled(some > 0)

    def _take_factor(self, value: object) -> None:
        self.value = float(value)
        self.factor.show_value(self.value)

    def _stiffen(self) -> None:
        self.tool.stiffen(self.value)
