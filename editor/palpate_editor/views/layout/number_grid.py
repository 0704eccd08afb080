# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of numbers with their names and units."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QWidget

from palpate_editor.views.quantity_box import QuantityBox


class NumberGrid(QWidget):
    """One number to a row, each under its name in the commands."""

    entered = Signal(str, float)
    """Name, and the new value [SI]."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setColumnStretch(1, 1)
        self.boxes: dict[str, QuantityBox] = {}
        self.labels: dict[str, tuple[QLabel, QLabel]] = {}

    def add(self, name: str, words: str, unit: str, scale: float = 1.0) -> None:
        """`scale` is one `unit` in SI."""
        row = self.grid.rowCount()
        box = QuantityBox(unit, scale, self)
        box.setObjectName(name)
        box.setAccessibleName(words)
        box.entered.connect(self._tell)
        label, told = QLabel(words, self), QLabel(unit, self)
        label.setProperty("role", "name")
        told.setProperty("role", "name")
        told.setMinimumWidth(48)
        for column, widget in enumerate((label, box, told)):
            self.grid.addWidget(widget, row, column)
        self.boxes[name], self.labels[name] = box, (label, told)

    def show_value(self, name: str, value: float | None) -> None:
        """None hides the row."""
        for widget in (self.boxes[name], *self.labels[name]):
            widget.setVisible(value is not None)
        if value is not None:
            self.boxes[name].show_value(float(f"{value:.9g}"))

    def _tell(self, value: float) -> None:
        box = self.sender()
        self.entered.emit(box.objectName(), value)


class TickedNumbers(QWidget):
    """Several numbers in a row which are there or not, as a box is ticked."""

    entered = Signal(object)
    """[SI] All of them, (); a tuple without numbers where the box is not ticked."""

    def __init__(
        self,
        name: str,
        words: str,
        units: Sequence[tuple[str, float]],
        usual: tuple[float, ...],
        parent: QWidget | None = None,
    ):
        """`units` of the numbers, each with its size in SI; `usual` is what a tick begins with."""
        super().__init__(parent)
        self.values: tuple[float, ...] = ()
        self.usual = usual
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        self.tick = QCheckBox(words, self)
        self.tick.setObjectName(name)
        self.tick.clicked.connect(self._switch)
        grid.addWidget(self.tick, 0, 0, Qt.AlignmentFlag.AlignLeft)
        self.row = QWidget(self)
        cells = QGridLayout(self.row)
        cells.setContentsMargins(22, 0, 0, 0)
        self.boxes: list[QuantityBox] = []
        for place, (unit, scale) in enumerate(units):
            box = QuantityBox(unit, scale, self)
            box.setObjectName(f"{name} {place}")
            box.setAccessibleName(f"{words} {unit} {place + 1}")
            box.setMinimumWidth(58)
            box.entered.connect(self._enter)
            cells.addWidget(box, 0, 2 * place)
            label = QLabel(unit, self)
            label.setProperty("role", "name")
            cells.addWidget(label, 0, 2 * place + 1, Qt.AlignmentFlag.AlignLeft)
            same_follows = place + 1 < len(units) and units[place + 1][0] == unit
            label.setVisible(not same_follows)
            self.boxes.append(box)
        grid.addWidget(self.row, 1, 0)

    def show_values(self, values: Sequence[float]) -> None:
        self.values = tuple(values)
        with QSignalBlocker(self.tick):
            self.tick.setChecked(bool(values))
        self.row.setVisible(bool(values))
        for box, value in zip(self.boxes, values or self.usual, strict=True):
            box.show_value(float(f"{value:.9g}"))

    def _switch(self, on: bool) -> None:
        self.entered.emit(self.usual if on else ())

    def _enter(self, value: float) -> None:
        values = list(self.values or self.usual)
        values[self.boxes.index(self.sender())] = value
        self.entered.emit(tuple(values))
