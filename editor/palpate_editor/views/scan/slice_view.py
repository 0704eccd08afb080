# SPDX-License-Identifier: GPL-3.0-or-later
"""One of three planes through a scan, with the outline of what is chosen over it."""

from __future__ import annotations

import numpy as np
import pyqtgraph
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSlider, QVBoxLayout, QWidget

from palpate_editor.scan import Choice, Scan, find_chosen
from palpate_editor.views.scan.outlines import cut_surface, outline
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.theme import Colours
from palpate_editor.views.translations import tr

CHOSEN, SURFACE = 1.2, 2.0
"""[px] Width of the lines."""


class SliceView(QWidget):
    """Slices along one axis of the array; left on the screen is the patient's right."""

    moved = Signal()

    def __init__(self, axis: int, colours: Colours, parent: QWidget | None = None):
        super().__init__(parent)
        self.axis = axis
        self.scan: Scan | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        self.plot = pyqtgraph.PlotWidget(self, background="#000000")
        self.plot.setMenuEnabled(False)
        self.plot.hideButtons()
        self.plot.hideAxis("left")
        self.plot.hideAxis("bottom")
        self.plot.setAspectLocked(True)
        self.plot.setMouseEnabled(False, False)
        self.image = pyqtgraph.ImageItem()
        self.chosen = pyqtgraph.PlotCurveItem(
            pen=pyqtgraph.mkPen(colours.warning, width=CHOSEN), connect="pairs"
        )
        self.cut = pyqtgraph.PlotCurveItem(
            pen=pyqtgraph.mkPen(colours.curve, width=SURFACE), connect="pairs"
        )
        for item in (self.image, self.chosen, self.cut):
            self.plot.addItem(item)
        self.plot.getViewBox().sigResized.connect(self.fit)
        column.addWidget(self.plot, 1)
        row = QHBoxLayout()
        self.title: QLabel = write_label("", "note", self)
        self.title.setMinimumWidth(110)
        self.slider = QSlider(Qt.Orientation.Horizontal, self)
        self.slider.setObjectName(f"slice_{axis}")
        self.slider.valueChanged.connect(self.move)
        row.addWidget(self.title)
        row.addWidget(self.slider, 1)
        column.addLayout(row)

    def show_scan(self, scan: Scan) -> None:
        """Begins at the middle slice."""
        self.scan = scan
        assert scan.voxels is not None
        self.across, self.up = find_screen_axes(scan, self.axis)
        self.name = name_plane(scan, self.axis)
        self.slider.blockSignals(True)
        self.slider.setRange(0, scan.voxels.shape[self.axis] - 1)
        self.slider.setValue(scan.voxels.shape[self.axis] // 2)
        self.slider.blockSignals(False)
        self.slider.setAccessibleName(tr("Slice, {plane}").format(plane=self.name))
        box = self.plot.getViewBox()
        box.invertX(is_backwards(scan, self.across))
        # the patient's back is below, his head above
        vertical = main_axis(scan, self.up)
        box.invertY(is_backwards(scan, self.up) != (vertical == 1))
        self.show_slice()
        self.fit()

    def fit(self) -> None:
        """All of the slice, as large as there is room."""
        if self.scan is not None:
            self.plot.getViewBox().setRange(
                self.image.mapRectToParent(self.image.boundingRect()), padding=0.02
            )

    def spacing(self, axis: int) -> float:
        """[mm]"""
        assert self.scan is not None
        return float(1e3 * self.scan.spacing[2 - axis])

    def plane(self) -> np.ndarray:
        """(columns across, rows up) of this slice."""
        assert self.scan is not None and self.scan.voxels is not None
        taken = self.scan.voxels.take(self.slider.value(), self.axis)
        return taken if self.across < self.up else taken.T

    def show_slice(self) -> None:
        plane = self.plane()
        wide, high = self.spacing(self.across), self.spacing(self.up)
        self.image.setImage(plane.astype(np.float32), autoLevels=False)
        self.image.setRect(-0.5 * wide, -0.5 * high, wide * plane.shape[0], high * plane.shape[1])
        self.title.setText(f"{self.name} {self.slider.value() + 1}")

    def show_levels(self, low: float, high: float) -> None:
        self.image.setLevels((low, high))

    def show_choice(self, choice: Choice | None) -> None:
        lines = np.empty((0, 2))
        if choice is not None:
            lines = outline(find_chosen(self.plane(), choice))
        self.draw(self.chosen, lines)

    def show_surface(self, places: np.ndarray | None, triangles: np.ndarray | None) -> None:
        lines = np.empty((0, 2))
        if places is not None and triangles is not None:
            kept = (self.across, self.up)
            lines = cut_surface(places, triangles, self.axis, self.slider.value(), kept)
        self.draw(self.cut, lines)

    def draw(self, curve: pyqtgraph.PlotCurveItem, lines: np.ndarray) -> None:
        curve.setData(self.spacing(self.across) * lines[:, 0], self.spacing(self.up) * lines[:, 1])

    def move(self) -> None:
        if self.scan is not None:
            self.show_slice()
            self.moved.emit()

    def step(self, slices: int) -> None:
        self.slider.setValue(self.slider.value() + slices)


def main_axis(scan: Scan, axis: int) -> int:
    """0, 1 or 2: along x, y or z of the patient a step along an axis of the array goes."""
    return int(np.abs(scan.steps[:, 2 - axis]).argmax())


def is_backwards(scan: Scan, axis: int) -> bool:
    """Whether such a step goes to the right, the front or the feet."""
    return bool(scan.steps[main_axis(scan, axis), 2 - axis] < 0.0)


def find_screen_axes(scan: Scan, axis: int) -> tuple[int, int]:
    """Which of the two other axes runs across the screen, and which up: the more upright one."""
    one, other = (a for a in range(3) if a != axis)
    return (one, other) if main_axis(scan, one) < main_axis(scan, other) else (other, one)


def name_plane(scan: Scan, axis: int) -> str:
    return (tr("Sagittal"), tr("Coronal"), tr("Axial"))[main_axis(scan, axis)]
