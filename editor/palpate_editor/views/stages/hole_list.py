# SPDX-License-Identifier: GPL-3.0-or-later
"""The holes of a surface, by size: a click shows one in the view, a button fills what is chosen."""

from __future__ import annotations

from itertools import groupby
from math import asin, atan2

import numpy as np
import palpate
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from palpate_editor.document import Surface
from palpate_editor.edits import FillHoles
from palpate_editor.views.context import Context
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import count, quantity, tr

HOLES = Qt.ItemDataRole.UserRole
"""Of an item: the numbers of its holes."""
FEW = 8
"""Holes that are listed one by one."""
ROWS = 7
NEAR = 0.12
"""[-] of the organ's diagonal: the least that is shown around a hole."""
RING = 0.012
"""[-] of the organ's diagonal: the least radius of the ring around a hole."""


class HoleList(QWidget):
    """Lists, shows and fills holes."""

    def __init__(self, context: Context, tasks: Tasks, parent: QWidget | None = None):
        super().__init__(parent)
        self.context, self.tasks = context, tasks
        self.surface: Surface | None = None
        self.loops: list[np.ndarray] = []
        self.shown = False
        """Whether a hole is marked in the view."""
        self.tree = QTreeWidget(self)
        self.tree.setObjectName("holes")
        self.tree.setColumnCount(2)
        self.tree.setHeaderHidden(True)
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.tree.header().setStretchLastSection(True)
        self.tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.tree.itemSelectionChanged.connect(self.show_chosen)
        self.fill_button = QPushButton(tr("Fill these"), self)
        self.fill_button.setObjectName("fill_chosen")
        self.fill_button.clicked.connect(self.fill_chosen)
        self.all_button = QPushButton(tr("Fill all holes"), self)
        self.all_button.setObjectName("fill_holes")
        self.all_button.clicked.connect(self.fill_all)
        row = QHBoxLayout()
        row.addStretch(1)
        row.addWidget(self.fill_button)
        row.addWidget(self.all_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.tree)
        column.addLayout(row)
        context.stage_shown.connect(self.on_stage)

    # ------------------------------------------------------------ showing

    def show_surface(self, surface: Surface | None) -> None:
        """Lists the holes of a surface; nothing is done where it is the one that is listed."""
        if surface is self.surface:
            return
        self.unmark()
        self.surface = surface
        self.loops = [] if surface is None else palpate.find_border_loops(surface.triangles)
        self.tree.clear()
        order = sorted(range(len(self.loops)), key=lambda hole: -len(self.loops[hole]))
        for edges, group in groupby(order, key=lambda hole: len(self.loops[hole])):
            self.add_group(edges, list(group))
        rows = max(2, min(ROWS, self.tree.topLevelItemCount()))
        self.tree.setFixedHeight(rows * max(26, self.tree.sizeHintForRow(0)) + 6)
        self.show_chosen()

    def add_group(self, edges: int, holes: list[int]) -> None:
        if len(self.loops) <= FEW or len(holes) == 1:
            for hole in holes:
                self.tree.addTopLevelItem(self.build_item(hole))
            return
        text = tr("{count} holes of {edges} edges").format(count=count(len(holes)), edges=edges)
        group = QTreeWidgetItem([text, ""])
        group.setData(0, HOLES, tuple(holes))
        group.addChildren([self.build_item(hole) for hole in holes])
        self.tree.addTopLevelItem(group)

    def build_item(self, hole: int) -> QTreeWidgetItem:
        wide = quantity(1e3 * self.measure(hole), "mm", 3)
        item = QTreeWidgetItem(
            [
                tr("Hole of {edges} edges").format(edges=len(self.loops[hole])),
                tr("{size} wide").format(size=wide),
            ]
        )
        item.setData(0, HOLES, (hole,))
        return item

    def measure(self, hole: int) -> float:
        """[m] The diagonal of the box around a hole."""
        assert self.surface is not None
        return float(np.linalg.norm(np.ptp(self.surface.vertices[self.loops[hole]], axis=0)))

    def chosen(self) -> tuple[int, ...]:
        """Numbers of the holes that are selected, alone or with their group."""
        items = self.tree.selectedItems()
        return tuple(sorted({hole for item in items for hole in item.data(0, HOLES)}))

    # ------------------------------------------------------------ in the view

    def show_chosen(self) -> None:
        """Marks what is chosen and looks at it: at the first of several."""
        holes = self.chosen()
        self.fill_button.setEnabled(bool(holes))
        if self.surface is None or not holes:
            self.unmark()
            return
        weights = np.zeros(len(self.surface.vertices), np.float32)
        for hole in holes:
            weights[self.loops[hole]] = 1.0
        view, self.shown = self.context.view, True
        view.show_selection(weights)
        # the first of them that is largest
        hole = max(holes, key=lambda hole: (len(self.loops[hole]), -hole))
        middle, outward = self.find_place(hole)
        diagonal = float(palpate.compute_diagonal(self.surface.vertices))
        radius = max(0.6 * self.measure(hole), RING * diagonal)
        view.show_ring(middle, outward, radius)
        self.look_at(middle, outward, max(4.0 * radius, NEAR * diagonal))

    def find_place(self, hole: int) -> tuple[np.ndarray, np.ndarray]:
        """The middle of a hole [m] and the direction out of it, that of the surface around it."""
        assert self.surface is not None
        x, triangles = self.surface.vertices, self.surface.triangles
        normals = np.asarray(palpate.compute_vertex_normals(x, triangles))
        outward = normals[self.loops[hole]].sum(axis=0)
        size = np.linalg.norm(outward)
        up = np.array([0.0, 0.0, 1.0])
        return x[self.loops[hole]].mean(axis=0), outward / size if size > 1e-9 else up

    def look_at(self, middle: np.ndarray, outward: np.ndarray, size: float) -> None:
        """From outside, with `size` [m] of the surface around it in sight."""
        view = self.context.view
        view.orbit(0.0, 0.0)  # from here on the camera is where it is put
        x, y, z = (float(value) for value in outward)
        view.look_from(atan2(y, x), asin(max(-0.99, min(0.99, z))))
        view.camera.target = np.array(middle)
        view.camera.distance = size / view.camera.field_of_view
        view.update()

    def on_stage(self, stage: str) -> None:
        if stage != "repair":
            self.tree.clearSelection()

    def unmark(self) -> None:
        if self.shown:
            self.shown = False
            self.context.view.show_ring(None)
            self.context.view.show_selection(None)

    # ------------------------------------------------------------ doing

    def fill_chosen(self) -> None:
        holes = self.chosen()
        if len(holes) == len(self.loops):
            self.fill_all()
        elif holes:
            self.tasks.apply_slowly(FillHoles(holes, even=True, bent=True))

    def fill_all(self) -> None:
        self.tasks.apply_slowly(FillHoles(even=True, bent=True))
