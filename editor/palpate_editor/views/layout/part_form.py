# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the chosen part stands, in numbers, and what else may be done with it."""

from __future__ import annotations

from typing import Any

from palpate.layout.document import Layout, Placed, PlacedBody
from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.layout_changes import Words, write_three
from palpate_editor.layout_shapes import Key, PartShape, find_degrees, key_of
from palpate_editor.views.layout.number_grid import NumberGrid, TickedNumbers
from palpate_editor.views.quantity_box import QuantityBox
from palpate_editor.views.translations import tr

GAP = 5e-4
"""[m] between two regions that are laid on each other, unless another is asked for."""


class PartForm(QWidget):
    """Position and angles, laying a region on another, folding, what a stone is of, removing."""

    wanted = Signal(object)
    """The words of a change."""
    heavy_wanted = Signal(object)
    """Of one that reads files."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.part: Placed | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.title, self.hint = QLabel(self), QLabel(self)
        self.title.setObjectName("part_name")
        self.hint.setText(tr("Click a part in the view or in the tree to choose it."))
        self.hint.setWordWrap(True)
        column.addWidget(self.hint)
        column.addWidget(self.title)
        self.rest = QWidget(self)
        column.addWidget(self.rest)
        inner = QVBoxLayout(self.rest)
        inner.setContentsMargins(0, 0, 0, 0)
        grid = QGridLayout()
        self.at = [self._box(f"at_{axis}", "mm", 1e-3) for axis in "xyz"]
        self.turned = [self._box(f"turn_{axis}", "°", 1.0) for axis in "xyz"]
        for row, (words, boxes, unit) in enumerate(
            ((tr("Stands at"), self.at, "mm"), (tr("Turned"), self.turned, "°"))
        ):
            grid.addWidget(QLabel(words, self), row, 0)
            for place, box in enumerate(boxes):
                grid.addWidget(box, row, 1 + place)
            grid.addWidget(QLabel(unit, self), row, 4)
        inner.addLayout(grid)
        self.folds = QCheckBox(tr("Parts of it may touch each other"), self)
        self.folds.setObjectName("folds")
        self.folds.clicked.connect(self._fold)
        inner.addWidget(self.folds)
        self.weightless = QCheckBox(tr("Scanned as it lies: gravity leaves it as it is"), self)
        self.weightless.setObjectName("weightless")
        self.weightless.clicked.connect(self._weigh)
        inner.addWidget(self.weightless)
        self.numbers = NumberGrid(self)
        self.numbers.add("density", tr("Density"), "kg/m³")
        self.numbers.add("spheres", tr("Spheres of its hull"), "")
        self.numbers.add("friction", tr("Friction"), "")
        self.numbers.entered.connect(self._number)
        inner.addWidget(self.numbers)
        self.tool_friction = TickedNumbers(
            "tool_friction", tr("Instruments rub on it otherwise"), [("", 1.0)], (0.1,), self
        )
        self.tool_friction.setToolTip(
            tr("Coulomb's coefficient. Otherwise that of the instrument, as on all else.")
        )
        self.tool_friction.entered.connect(self._rub)
        inner.addWidget(self.tool_friction)
        self._build_snap(inner)
        self.remove = QPushButton(tr("Remove from the scene"), self)
        self.remove.setObjectName("remove_part")
        self.remove.clicked.connect(self._remove)
        inner.addWidget(self.remove)

    def _box(self, name: str, unit: str, scale: float) -> QuantityBox:
        box = QuantityBox(unit, scale, self)
        box.setObjectName(name)
        box.setMinimumWidth(62)
        box.entered.connect(self._place)
        return box

    def _build_snap(self, column: QVBoxLayout) -> None:
        self.snap_form = QWidget(self)
        rows = QGridLayout(self.snap_form)
        rows.setContentsMargins(0, 0, 0, 0)
        self.region, self.onto = QComboBox(self), QComboBox(self)
        self.region.setObjectName("snap_region")
        self.onto.setObjectName("snap_onto")
        for box in (self.region, self.onto):
            box.setMinimumContentsLength(10)
            box.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
        self.gap = QuantityBox("mm", 1e-3, self)
        self.gap.setObjectName("snap_gap")
        self.gap.show_value(GAP)
        self.gap.entered.connect(self.gap.show_value)
        self.snap = QPushButton(tr("Lay it on"), self)
        self.snap.setObjectName("snap")
        self.snap.clicked.connect(self._snap)
        rows.addWidget(QLabel(tr("Its region"), self), 0, 0)
        rows.addWidget(self.region, 0, 1)
        rows.addWidget(QLabel(tr("onto"), self), 1, 0)
        rows.addWidget(self.onto, 1, 1)
        rows.addWidget(QLabel(tr("Gap (mm)"), self), 2, 0)
        last = QHBoxLayout()
        last.addWidget(self.gap)
        last.addWidget(self.snap)
        rows.addLayout(last, 2, 1)
        rows.setColumnStretch(1, 1)
        column.addWidget(self.snap_form)

    # ------------------------------------------------------------ showing

    def show_part(self, layout: Layout, shapes: dict[Key, PartShape], part: Placed | None) -> None:
        self.part = part
        for widget in (self.title, self.rest):
            widget.setVisible(part is not None)
        self.hint.setVisible(part is None)
        if part is None:
            return
        self.title.setText(part.name)
        self.show_place(part)
        is_body = isinstance(part, PlacedBody)
        self.folds.setVisible(is_body)
        self.folds.setChecked(bool(getattr(part, "may_fold", False)))
        self.weightless.setVisible(is_body)
        self.weightless.setChecked(bool(getattr(part, "weightless", False)))
        self.numbers.setVisible(not is_body)
        for name in self.numbers.boxes:
            self.numbers.show_value(name, getattr(part, name, None))
        self.tool_friction.show_values(part.tool_friction)
        regions = regions_of(shapes, part)
        others = [
            f"{body.name}/{region}"
            for body in layout.bodies
            if body.name != part.name
            for region in regions_of(shapes, body)
        ]
        self.snap_form.setVisible(is_body and bool(regions) and bool(others))
        for box, names in ((self.region, list(regions)), (self.onto, others)):
            if [box.itemText(i) for i in range(box.count())] != names:
                with QSignalBlocker(box):
                    box.clear()
                    box.addItems(names)

        self._measure()

    def _measure(self) -> None:
        """What was hidden was measured before it was dressed."""
        for widget in self.findChildren(QWidget):
            widget.ensurePolished()
        for each in (self.snap_form, self.rest, self):
            layout = each.layout()
            if layout is not None:
                layout.invalidate()
            each.updateGeometry()

    def show_place(self, part: Placed) -> None:
        """Where a part is, or would be while it is dragged."""
        for box, value in zip(self.at, part.position, strict=True):
            box.show_value(float(f"{value:.9g}"))
        for box, value in zip(self.turned, find_degrees(part), strict=True):
            box.show_value(float(f"{value:.9g}"))

    # ------------------------------------------------------------ inside

    def _place(self, value: float) -> None:
        box, part = self.sender(), self.part
        if part is None:
            return
        if box in self.at:
            at = list(part.position)
            at[self.at.index(box)] = value
            self.wanted.emit(("place", part.name, f"--at={write_three(at, 1e3)}"))
        else:
            angles = list(find_degrees(part))
            angles[self.turned.index(box)] = value
            self.wanted.emit(("place", part.name, f"--turn={write_three(angles)}"))

    def _fold(self, on: bool) -> None:
        if self.part is not None:
            self.wanted.emit(("place", self.part.name, "--fold" if on else "--no-fold"))

    def _weigh(self, on: bool) -> None:
        if self.part is not None:
            words = "--weightless" if on else "--no-weightless"
            self.wanted.emit(("place", self.part.name, words))

    def _number(self, name: str, value: float) -> None:
        if self.part is not None:
            if name == "spheres":
                value = round(value)
            unit = "kg/m3" if name == "density" else ""
            self.wanted.emit(("place", self.part.name, f"--{name}={value:.9g}{unit}"))

    def _rub(self, values: tuple[float, ...]) -> None:
        if self.part is not None:
            mu = f"{values[0]:.9g}" if values else "own"
            self.wanted.emit(("place", self.part.name, f"--tool-friction={mu}"))

    def _snap(self) -> None:
        if self.part is not None and self.gap.shown is not None:
            words: Words = (
                "place", self.part.name, f"--snap={self.region.currentText()}",
                f"--onto={self.onto.currentText()}", f"--gap={1e3 * self.gap.shown:.6g}mm",
            )  # fmt: skip
            self.heavy_wanted.emit(words)

    def _remove(self) -> None:
        if self.part is not None:
            self.wanted.emit(("place", self.part.name, "--remove"))


def regions_of(shapes: dict[Key, PartShape], part: Any) -> tuple[str, ...]:
    shape = shapes.get(key_of(part))
    return () if shape is None else shape.regions
