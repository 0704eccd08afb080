# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of repair with their numbers: a click tries one, and a card tells what it does."""

from __future__ import annotations

from collections.abc import Callable

import palpate
from PySide6.QtWidgets import QComboBox, QGridLayout, QHBoxLayout, QPushButton, QSpinBox, QWidget

from palpate_editor.document import Organ
from palpate_editor.edits import (
    CleanUp,
    DropFins,
    DropPieces,
    Edit,
    KeepLargestShell,
    Remesh,
    RemoveCrossings,
    Smooth,
    StitchBorders,
    Wrap,
)
from palpate_editor.edits.wrap import FINENESS
from palpate_editor.views.quantity_box import QuantityBox
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import tr

MM = 1e-3
FEW_STEPS = 10
FINER = 0.5
"""[-] Of the edges elsewhere: those of a region, at first."""


class RepairSteps(QWidget):
    """`attempt` is told the edit that is wanted."""

    def __init__(self, attempt: Callable[[Edit], None], parent: QWidget | None = None):
        super().__init__(parent)
        self.attempt = attempt
        self.grid = QGridLayout(self)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setHorizontalSpacing(8)
        self.grid.setVerticalSpacing(5)
        self.grid.setColumnStretch(0, 1)
        self.add(tr("Clean up"), "clean_up", lambda: CleanUp())
        self.add(tr("Stitch borders"), "stitch", lambda: StitchBorders())
        self.add(tr("Drop fins"), "drop_fins", lambda: DropFins())
        self.add(tr("Drop small pieces"), "drop_pieces", lambda: DropPieces())
        self.largest = self.add(
            tr("Keep the largest piece"), "keep_largest", lambda: KeepLargestShell()
        )
        self.add(tr("Remove crossings"), "remove_crossings", lambda: RemoveCrossings())
        self.steps = QSpinBox(self)
        self.steps.setRange(1, 200)
        self.steps.setValue(FEW_STEPS)
        self.steps.lineEdit().setTextMargins(5, 0, 5, 0)
        self.add(tr("Smooth"), "smooth", lambda: Smooth(self.steps.value()), self.steps)
        self.edge = QuantityBox("mm", MM, self)
        self.edge.setObjectName("edge_length")
        self.add(tr("Remesh"), "remesh", self.build_remesh, self.edge, "mm")
        self.build_region_row()
        self.ball = QuantityBox("mm", MM, self)
        self.ball.setObjectName("wrap_ball")
        self.add(
            tr("Wrap, the last resort"),
            "wrap",
            lambda: Wrap(self.ball.shown, past_holes=True),
            self.ball,
            "mm",
        )
        self.size = 0.0
        self.ball.entered.connect(self.ball.show_value)
        self.edge.entered.connect(self.edge.show_value)
        self.fine.entered.connect(self.fine.show_value)

    def build_region_row(self) -> None:
        self.region = QComboBox(self)
        self.region.setObjectName("remesh_region")
        self.region.currentIndexChanged.connect(self.on_region)
        self.fine = QuantityBox("mm", MM, self)
        self.fine.setObjectName("region_edge_length")
        self.finer = QWidget(self)
        row = QHBoxLayout(self.finer)
        row.setContentsMargins(14, 0, 0, 0)
        row.addWidget(write_label(tr("finer in"), "name", self))
        row.addWidget(self.region, 1)
        self.grid.addWidget(self.finer, self.grid.rowCount(), 0)
        self.place(self.fine, "mm", self.grid.rowCount() - 1)

    def add(
        self,
        text: str,
        name: str,
        make: Callable[[], Edit],
        field: QWidget | None = None,
        unit: str = "",
    ) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(name)
        # a panel that is short of room must scroll, not press them flat
        button.setMinimumHeight(button.sizeHint().height())
        button.clicked.connect(lambda: self.attempt(make()))
        row = self.grid.rowCount()
        self.grid.addWidget(button, row, 0)
        if field is not None:
            self.place(field, unit, row)
        return button

    def place(self, field: QWidget, unit: str, row: int) -> None:
        field.setMinimumHeight(field.sizeHint().height())
        self.grid.addWidget(field, row, 1)
        if unit:
            self.grid.addWidget(write_label(unit, "name", self), row, 2)

    def show_organ(self, organ: Organ) -> None:
        surface = organ.surface
        self.setEnabled(surface is not None)
        if surface is None:
            return
        self.show_regions(tuple(organ.regions))
        size = float(palpate.compute_diagonal(surface.vertices))
        if size == self.size:
            return
        # numbers of the organ before mean nothing here
        self.size = size
        mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
        edge = (palpate.compute_area(mesh) / len(surface.triangles) / 0.433) ** 0.5
        self.edge.show_value(float(f"{edge:.2g}"))
        self.fine.show_value(float(f"{FINER * edge:.2g}"))
        self.ball.show_value(float(f"{FINENESS * size:.2g}"))

    def show_regions(self, names: tuple[str, ...]) -> None:
        self.finer.setVisible(bool(names))
        self.fine.setVisible(bool(names) and bool(self.region.currentData()))
        if names == tuple(self.region.itemData(i) for i in range(1, self.region.count())):
            return
        self.region.clear()
        self.region.addItem(tr("nowhere"), "")
        for name in names:
            self.region.addItem(name, name)

    def on_region(self, *_: object) -> None:
        self.fine.setVisible(bool(self.region.currentData()))

    def build_remesh(self) -> Edit:
        region = self.region.currentData() or ""
        fine = self.fine.shown if region else None
        return Remesh(self.edge.shown or 0.0, region, fine)
