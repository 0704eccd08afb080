# SPDX-License-Identifier: GPL-3.0-or-later
"""The brush's size, value and manner, for the panel of a stage."""

from __future__ import annotations

import math
from collections.abc import Callable

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSlider,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.edits.paint import LEAST, MOST
from palpate_editor.views.quantity_box import QuantityBox, QuantityRow
from palpate_editor.views.touch.tools import PaintTool
from palpate_editor.views.translations import count, tr

STEPS = 200
"""of a slider from end to end."""
SMALLEST, LARGEST = 5e-4, 0.1
"""[m] at the ends of the radius slider."""


def to_step(value: float, low: float, high: float) -> int:
    """Where a value stands on a slider of even ratios."""
    return round(STEPS * math.log(value / low) / math.log(high / low))


def from_step(step: int, low: float, high: float) -> float:
    return low * (high / low) ** (step / STEPS)


class RatioSlider(QWidget):
    """A slider of even ratios, and the number to type beside it."""

    def __init__(
        self,
        row: QuantityRow,
        low: float,
        high: float,
        take: Callable[[float], None],
        parent: QWidget | None = None,
    ):
        super().__init__(parent)
        self.low, self.high, self.take = low, high, take
        """`take` is a bound method that is told the new value [SI]."""
        self.row = row
        self.slider = QSlider(Qt.Orientation.Horizontal, self)
        self.slider.setRange(0, STEPS)
        self.slider.setMinimumWidth(70)
        self.slider.valueChanged.connect(self._take_step)
        row.entered.connect(self._take_number)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addWidget(row)
        layout.addWidget(self.slider)

    def name(self, text: str) -> None:
        """For those who have the screen read to them."""
        self.slider.setAccessibleName(text)
        self.row.box.setAccessibleName(text)

    def show_value(self, value: float) -> None:
        self.row.show_value(value)
        self.slider.blockSignals(True)
        self.slider.setValue(to_step(value, self.low, self.high))
        self.slider.blockSignals(False)

    def _take_step(self, step: int) -> None:
        self.take(float(f"{from_step(step, self.low, self.high):.3g}"))

    def _take_number(self, value: object) -> None:
        self.take(min(max(float(value), self.low), self.high))


class BrushOptions(QWidget):
    """What a brush tool shows on top of its stage."""

    def __init__(self, tool: PaintTool, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName(f"{tool.name}_options")
        self.tool, has_factor = tool, tool.has_factor
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setHorizontalSpacing(12)
        form.setVerticalSpacing(8)
        self.radius = RatioSlider(
            QuantityRow(QuantityBox("mm", 1e-3)), SMALLEST, LARGEST, tool.set_radius
        )
        self.radius.name(tr("Brush radius"))
        form.addRow(self._name(tr("Brush radius")), self.radius)
        self.factor = self.strength = None
        if has_factor:
            self.factor = RatioSlider(
                QuantityRow(QuantityBox("\N{MULTIPLICATION SIGN}")), LEAST, MOST, self._take_factor
            )
            self.factor.setToolTip(tr("Stiffness in the middle of the brush, times the organ's"))
            self.factor.name(tr("Stiffness"))
            form.addRow(self._name(tr("Stiffness")), self.factor)
            self.strength = QSlider(Qt.Orientation.Horizontal)
            self.strength.setAccessibleName(tr("Strength"))
            self.strength.setRange(5, 100)
            self.strength.setToolTip(tr("How much of the way to that stiffness one stroke goes"))
            self.strength.valueChanged.connect(self._take_strength)
            form.addRow(self._name(tr("Strength")), self.strength)
        self._ticks: dict[str, QCheckBox] = {}
        if has_factor:
            self._add_tick(form, "soft", tr("Soft edge"), tr("Fade towards the rim"))
        self._add_tick(
            form, "front_only", tr("Front side only"), tr("Leave alone what faces away from you")
        )
        self._add_tick(
            form, "connected", tr("Connected only"), tr("Never reach through a wall or a gap")
        )
        form.addRow(self._build_foot(has_factor))
        tool.brush_changed.connect(self.show_brush)
        tool.context.session.changed.connect(self._show_count)
        self.show_brush()
        self._show_count()

    def _name(self, text: str) -> QLabel:
        label = QLabel(text)
        label.setProperty("role", "name")
        return label

    def _add_tick(self, form: QFormLayout, field: str, title: str, tip: str) -> None:
        tick = QCheckBox(title)
        tick.setObjectName(field)
        tick.setToolTip(tip)
        tick.toggled.connect(self._take_ticks)
        form.addRow(tick)
        self._ticks[field] = tick

    def _build_foot(self, has_factor: bool) -> QWidget:
        foot = QWidget(self)
        row = QHBoxLayout(foot)
        row.setContentsMargins(0, 0, 0, 0)
        self.count = QLabel(foot)
        self.count.setProperty("role", "name")
        self.erase = QPushButton(tr("Even out") if has_factor else tr("Free all"), foot)
        self.erase.setProperty("small", True)
        self.erase.setToolTip(
            tr("Give every vertex the organ's own stiffness")
            if has_factor
            else tr("Let every vertex move")
        )
        self.erase.clicked.connect(self._erase_all)
        row.addWidget(self.count, 1)
        row.addWidget(self.erase)
        return foot

    # ------------------------------------------------------------ both ways

    def show_brush(self) -> None:
        """Shows what the brush is now."""
        brush = self.tool.brush
        self.radius.show_value(brush.radius)
        if self.factor is not None:
            self.factor.show_value(brush.factor)
            self.strength.blockSignals(True)
            self.strength.setValue(round(100 * brush.strength))
            self.strength.blockSignals(False)
        for field, tick in self._ticks.items():
            tick.blockSignals(True)
            tick.setChecked(getattr(brush, field))
            tick.blockSignals(False)

    def showEvent(self, event: QEvent) -> None:
        super().showEvent(event)
        self.show_brush()

    def _take_factor(self, factor: float) -> None:
        self.tool.brush.factor = factor
        self.show_brush()

    def _take_strength(self, percent: int) -> None:
        self.tool.brush.strength = percent / 100

    def _take_ticks(self, on: bool) -> None:
        del on
        for field, tick in self._ticks.items():
            setattr(self.tool.brush, field, tick.isChecked())

    def _erase_all(self) -> None:
        self.tool.erase_all()

    def _show_count(self, *organs: object) -> None:
        del organs
        some, every = self.tool.count_painted()
        text = (
            tr("{some} of {all} vertices painted")
            if self.factor is not None
            else tr("{some} of {all} vertices fixed")
        )
        self.count.setText(text.format(some=count(some), all=count(every)))
        self.erase.setEnabled(some > 0)
