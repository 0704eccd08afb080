# SPDX-License-Identifier: GPL-3.0-or-later
"""Which grey levels are black and which white: window and level, as radiologists set them."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QGridLayout, QSlider, QWidget

from palpate_editor.scan import Scan
from palpate_editor.views.number_box import NumberBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

STEPS = 1000
"""Of a slider."""
LEAST_WIDTH = 1e-3
"""[-] Of the whole range."""


def list_presets() -> dict[str, tuple[float, float] | None]:
    """Level and width in Hounsfield units; None for all grey levels."""
    return {
        tr("All grey levels"): None,
        tr("Soft tissue"): (40.0, 400.0),
        tr("Bone"): (500.0, 2000.0),
        tr("Lung"): (-600.0, 1500.0),
    }


class LevelForm(QWidget):
    """A choice of usual ones, and both by hand."""

    changed = Signal()

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(1, 1)
        self.low, self.high = 0.0, 1.0
        self.presets = list_presets()
        self.box = QComboBox(self)
        self.box.setObjectName("level_preset")
        self.box.setAccessibleName(tr("Grey levels that are shown"))
        self.box.addItems(list(self.presets))
        self.box.activated.connect(self.use_preset)
        grid.addWidget(self.box, 0, 0, 1, 3)
        self.sliders, self.fields = [], []
        for row, (text, name) in enumerate(((tr("Level"), "level"), (tr("Window"), "window"))):
            slider, field = QSlider(Qt.Orientation.Horizontal, self), NumberBox(self)
            slider.setRange(0, STEPS)
            slider.setObjectName(f"{name}_slider")
            slider.setAccessibleName(text)
            slider.valueChanged.connect(self.slide)
            field.setObjectName(name)
            field.setDecimals(1)
            field.setKeyboardTracking(False)
            field.valueChanged.connect(self.enter)
            self.sliders.append(slider)
            self.fields.append(field)
            grid.addWidget(write_label(text, "name", self), row + 1, 0)
            grid.addWidget(slider, row + 1, 1)
            grid.addWidget(field, row + 1, 2)

    def show_scan(self, scan: Scan) -> None:
        self.low, self.high = scan.low, max(scan.high, scan.low + 1e-6)
        size = self.high - self.low
        for field, ends in zip(self.fields, ((self.low, self.high), (LEAST_WIDTH * size, size)),
                               strict=True):  # fmt: skip
            field.blockSignals(True)
            field.setRange(*ends)
            field.setSingleStep(0.01 * size)
            field.blockSignals(False)
        grey = scan.labels is None and scan.low < -500.0 < 300.0 < scan.high
        self.box.setCurrentIndex(1 if grey else 0)
        self.use_preset()

    def use_preset(self) -> None:
        chosen = self.presets[self.box.currentText()]
        whole = (0.5 * (self.low + self.high), self.high - self.low)
        self.show_numbers(*(chosen or whole))

    def show_numbers(self, level: float, width: float) -> None:
        for field, value in zip(self.fields, (level, width), strict=True):
            field.blockSignals(True)
            field.setValue(value)
            field.blockSignals(False)
        self.enter()

    def enter(self) -> None:
        for field, slider in zip(self.fields, self.sliders, strict=True):
            low, high = field.minimum(), field.maximum()
            slider.blockSignals(True)
            slider.setValue(round(STEPS * (field.value() - low) / max(high - low, 1e-30)))
            slider.blockSignals(False)
        self.changed.emit()

    def slide(self) -> None:
        for field, slider in zip(self.fields, self.sliders, strict=True):
            low, high = field.minimum(), field.maximum()
            field.blockSignals(True)
            field.setValue(low + (high - low) * slider.value() / STEPS)
            field.blockSignals(False)
        self.changed.emit()

    def ends(self) -> tuple[float, float]:
        """The grey levels that are black and white."""
        level, width = (field.value() for field in self.fields)
        return level - 0.5 * width, level + 0.5 * width
