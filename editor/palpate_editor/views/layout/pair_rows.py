# SPDX-License-Identifier: GPL-3.0-or-later
"""Which two may touch, as rows that are ticked, and the constants of those that do."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

from palpate.layout.document import Layout, TouchingPair, is_of
from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QWidget

from palpate_editor.views.quantity_box import QuantityBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr


@dataclass(frozen=True)
class Row:
    """Two that may touch or may not."""

    first: str
    second: str
    pair: TouchingPair | None
    """Of two bodies that may."""
    ticked: bool
    is_bodies: bool


def list_rows(layout: Layout) -> list[Row]:
    rows = []
    for one, other in combinations([body.name for body in layout.bodies], 2):
        pair = next((each for each in layout.pairs if is_of(each, one, other)), None)
        rows.append(Row(one, other, pair, pair is not None, True))
    for scenery in layout.scenery:
        for body in layout.bodies:
            ticked = body.name in scenery.stops
            rows.append(Row(scenery.name, body.name, None, ticked, False))
    return rows


class PairRow(QWidget):
    """A box to tick, thickness, stiffness and friction."""

    wanted = Signal(object)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.row: Row | None = None
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 2)
        self.tick = QCheckBox(self)
        self.tick.clicked.connect(self._switch)
        grid.addWidget(self.tick, 0, 0, 1, 4)
        self.thickness, self.stiffness = QuantityBox("mm", 1e-3, self), QuantityBox("", 1e9, self)
        self.friction = QuantityBox("", 1.0, self)
        self.boxes = (self.thickness, self.stiffness, self.friction)
        self.labels = [
            QLabel(words, self) for words in (tr("thick (mm)"), tr("stiff (N/mm³)"), tr("Friction"))
        ]
        for place, (label, box) in enumerate(zip(self.labels, self.boxes, strict=True)):
            label.setProperty("role", "name")
            box.setMinimumWidth(58)
            box.setToolTip(tr("0: chosen from the two organs"))
            box.entered.connect(self._enter)
            line, column = divmod(place, 2)
            grid.addWidget(label, 1 + line, 2 * column)
            grid.addWidget(box, 1 + line, 2 * column + 1)
        self.friction.setToolTip(
            tr("Coulomb's coefficient: some hundredths of wet serosa; 0: they slide.")
        )

    def show_row(self, row: Row) -> None:
        self.row = row
        words = tr("{one} and {other}") if row.is_bodies else tr("{one} stops {other}")
        self.tick.setText(words.format(one=row.first, other=row.second))
        self.tick.setObjectName(f"pair {row.first} {row.second}")
        with QSignalBlocker(self.tick):
            self.tick.setChecked(row.ticked)
        for widget in (*self.labels, *self.boxes):
            widget.setVisible(row.pair is not None)
        if row.pair is not None:
            self.thickness.show_value(row.pair.thickness)
            self.stiffness.show_value(row.pair.stiffness)
            self.friction.show_value(row.pair.friction)

    def _switch(self, on: bool) -> None:
        if self.row is not None:
            words = ("pair", self.row.first, self.row.second)
            self.wanted.emit(words if on else (*words, "--remove"))

    def _enter(self, value: float) -> None:
        pair = None if self.row is None else self.row.pair
        if pair is None:
            return
        thick = value if self.sender() is self.thickness else pair.thickness
        stiff = value if self.sender() is self.stiffness else pair.stiffness
        friction = value if self.sender() is self.friction else pair.friction
        words = ["pair", pair.first, pair.second]
        if thick:
            words.append(f"--thickness={1e3 * thick:.9g}mm")
        if stiff:
            words.append(f"--stiffness={stiff:.9g}N/m3")
        if pair.damping != TouchingPair("", "").damping:
            words.append(f"--damping={pair.damping:.9g}")
        if friction:
            words.append(f"--friction={friction:.9g}")
        self.wanted.emit(tuple(words))


class PairRows(QWidget):
    """All rows of a layout."""

    wanted = Signal(object)
    """The words of a change."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.none = write_label(
            tr("With two organs you say here whether they touch."), "name", self
        )
        self.none.setWordWrap(True)
        self.grid.addWidget(self.none, 0, 0)
        self.rows: list[PairRow] = []

    def show_layout(self, layout: Layout) -> None:
        rows = list_rows(layout)
        self.none.setVisible(not rows)
        while len(self.rows) < len(rows):
            made = PairRow(self)
            made.wanted.connect(self.wanted)
            self.rows.append(made)
            self.grid.addWidget(made, len(self.rows), 0)
        for place, widget in enumerate(self.rows):
            widget.setVisible(place < len(rows))
            if place < len(rows):
                widget.show_row(rows[place])
