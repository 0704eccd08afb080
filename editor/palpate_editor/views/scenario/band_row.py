# SPDX-License-Identifier: GPL-3.0-or-later
"""A band of a step: two sliders, the least and the most, in units of people's liking."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QSlider, QWidget

from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import number, tr

Band = list[float | None]


class Slider(QSlider):
    """A wheel that scrolls the form must not change it on the way."""

    def __init__(self, name: str, parent: QWidget):
        super().__init__(Qt.Orientation.Horizontal, parent)
        self.setObjectName(name)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


class SliderRow(QWidget):
    """A title over sliders with what each says beside it, in a unit of people's liking."""

    def __init__(self, text: str, unit: str, scale: float, step: float, parent: QWidget | None):
        """`step` is one tick of a slider in the shown unit."""
        super().__init__(parent)
        # a form that is scrolled takes from all that may be lower than it likes
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.unit, self.scale, self.step = unit, scale, step
        self._writing = False
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setVerticalSpacing(2)
        self.grid.setColumnStretch(0, 1)
        self.title = write_label(text, "name", self)
        self.grid.addWidget(self.title, 0, 0, 1, 2)

    def add_slider(self, name: str, said: str, count: int) -> tuple[Slider, QLabel]:
        slider = Slider(name, self)
        slider.setRange(0, count)
        slider.setAccessibleName(said)
        label = write_label("", "value", self)
        label.setMinimumWidth(104)
        row = self.grid.rowCount()
        self.grid.addWidget(slider, row, 0)
        self.grid.addWidget(label, row, 1)
        return slider, label


class BandRow(SliderRow):
    """From 0 for no least to its end for no most."""

    entered = Signal(list)
    """[SI] The new band, [least or None, most or None]; once a slider is let go."""

    def __init__(
        self, name: str, text: str, unit: str, scale: float, step: float, count: int,
        parent: QWidget | None = None,
    ):  # fmt: skip
        """Sliders of `count` steps each."""
        super().__init__(text, unit, scale, step, parent)
        self.count = count
        rows = [
            self.add_slider(f"{name}_{end}", f"{text}, {said}", count)
            for end, said in (("least", tr("least")), ("most", tr("most")))
        ]
        self.ends = [slider for slider, _ in rows]
        self.said = [label for _, label in rows]
        for slider in self.ends:
            slider.valueChanged.connect(self._moved)
            slider.sliderReleased.connect(self._enter)

    def show_band(self, band: object) -> None:
        """Shows a band of numbers [SI]; one of parameters is told and cannot be dragged."""
        numbers = isinstance(band, list) and all(not isinstance(end, str) for end in band)
        self._writing = True
        least, most = band if numbers else (None, None)  # type: ignore[misc]
        self.ends[0].setValue(0 if least is None else self._tick(least))
        self.ends[1].setValue(self.count if most is None else self._tick(most))
        self._writing = False
        for slider in self.ends:
            slider.setEnabled(numbers)
        self._tell()
        if not numbers and isinstance(band, list):
            for label, end in zip(self.said, band, strict=True):
                label.setText(str(end))

    def band(self) -> Band:
        """[SI]"""
        low, high = (slider.value() for slider in self.ends)
        least = None if low == 0 else round(low * self.step * self.scale, 9)
        most = None if high == self.count else round(high * self.step * self.scale, 9)
        if least is None and most is None:
            least = round(self.step * self.scale, 9)
        return [least, most]

    def _tick(self, value: float) -> int:
        return min(max(round(value / self.scale / self.step), 0), self.count)

    def _moved(self) -> None:
        if self._writing:
            return
        low, high = self.ends
        if low.value() > high.value():  # the other one is pushed along
            other = high if self.sender() is low else low
            self._writing = True
            other.setValue(self.sender().value())  # type: ignore[attr-defined]
            self._writing = False
        self._tell()
        if not any(slider.isSliderDown() for slider in self.ends):
            self._enter()

    def _enter(self) -> None:
        self.entered.emit(self.band())

    def _tell(self) -> None:
        low, high = (slider.value() for slider in self.ends)
        least, most = number(low * self.step, 3), number(high * self.step, 3)
        self.said[0].setText(tr("none") if low == 0 else f"{least} {self.unit}")
        self.said[1].setText(tr("none") if high == self.count else f"{most} {self.unit}")


class NumberRow(SliderRow):
    """One slider."""

    entered = Signal(float)
    """[SI] once it is let go"""

    def __init__(
        self, name: str, text: str, unit: str, scale: float, step: float, count: int,
        parent: QWidget | None = None,
    ):  # fmt: skip
        super().__init__(text, unit, scale, step, parent)
        self.slider, self.said = self.add_slider(name, text, count)
        self.slider.valueChanged.connect(self._moved)
        self.slider.sliderReleased.connect(self._enter)

    def show_value(self, value: object) -> None:
        """Shows a number [SI]; a parameter is told and cannot be dragged."""
        is_number = isinstance(value, int | float)
        self._writing = True
        if is_number:
            self.slider.setValue(round(float(value) / self.scale / self.step))  # type: ignore[arg-type]
        self._writing = False
        self.slider.setEnabled(is_number)
        self._tell()
        if not is_number:
            self.said.setText(str(value))

    def _moved(self) -> None:
        if self._writing:
            return
        self._tell()
        if not self.slider.isSliderDown():
            self._enter()

    def _enter(self) -> None:
        self.entered.emit(round(self.slider.value() * self.step * self.scale, 9))

    def _tell(self) -> None:
        self.said.setText(f"{number(self.slider.value() * self.step, 3)} {self.unit}")
