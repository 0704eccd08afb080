# SPDX-License-Identifier: GPL-3.0-or-later
"""A scan in three planes: what of it is the organ, and the surface that comes of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from palpate.viewport.screen import fit_to_screen
from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QDialog, QGridLayout, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.scan import Choice, Scan, ScanSurface, SeveralSeries
from palpate_editor.views.context import Context
from palpate_editor.views.scan.choice_form import ChoiceForm
from palpate_editor.views.scan.level_form import LevelForm
from palpate_editor.views.scan.outlines import find_voxel_places
from palpate_editor.views.scan.series_row import SeriesRow
from palpate_editor.views.scan.slice_view import SliceView
from palpate_editor.views.scan.surface_preview import SurfacePreview
from palpate_editor.views.scan.work import CutScan, ImportScan, ReadScan
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import count, number, quantity, tr

SIZE = QSize(1180, 760)
FORM = 310
"""[px]"""


class ScanDialog(QDialog):
    """Stays open beside the window, so that another choice can be tried."""

    wanted = Signal(object)
    """An ImportScan."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("scan_dialog")
        self.setWindowTitle(tr("From a scan"))
        self.context = context
        self.scan: Scan | None = None
        self.path: Path | None = None
        """Of the scan that is shown, or was wanted last."""
        self.found: ScanSurface | None = None
        self.places: np.ndarray | None = None
        row = QHBoxLayout(self)
        row.setSpacing(12)
        row.addLayout(self.build_views(), 1)
        row.addWidget(self.build_form())

    def build_views(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(6)
        self.views = [SliceView(axis, self.context.colours, self) for axis in range(3)]
        self.preview = SurfacePreview(self)
        for place, widget in enumerate((*self.views, self.preview)):
            grid.addWidget(widget, place // 2, place % 2)
        for line in range(2):
            grid.setRowStretch(line, 1)
            grid.setColumnStretch(line, 1)
        for view in self.views:
            view.moved.connect(self.show_lines)
        return grid

    def build_form(self) -> QWidget:
        form = QWidget(self)
        form.setFixedWidth(FORM)
        column = QVBoxLayout(form)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(8)
        self.about = write_label("", "note", form)
        self.about.setObjectName("scan_about")
        self.about.setWordWrap(True)
        column.addWidget(self.about)
        self.series = SeriesRow(form)
        self.series.chosen.connect(self.open_series)
        column.addWidget(self.series)
        self.levels = LevelForm(form)
        self.levels.changed.connect(self.show_levels)
        column.addWidget(self.levels)
        self.chooser = ChoiceForm(form)
        self.chooser.changed.connect(self.change_choice)
        column.addWidget(self.chooser, 1)
        self.facts = write_label("", "note", form)
        self.facts.setObjectName("scan_facts")
        self.facts.setWordWrap(True)
        column.addWidget(self.facts)
        row = QHBoxLayout()
        self.cut_button = QPushButton(tr("Preview"), form)
        self.cut_button.setObjectName("preview_scan")
        self.cut_button.clicked.connect(self.cut)
        self.import_button = QPushButton(tr("Import"), form)
        self.import_button.setObjectName("import_scan")
        self.import_button.setProperty("main", True)
        self.import_button.clicked.connect(self.import_scan)
        self.cancel_button = QPushButton(tr("Cancel"), form)
        self.cancel_button.setObjectName("cancel_scan")
        self.cancel_button.clicked.connect(self.context.jobs.cancel)
        for button in (self.cancel_button, self.cut_button, self.import_button):
            button.setAutoDefault(False)
            row.addWidget(button)
        column.addLayout(row)
        self.context.jobs.started.connect(self.show_use)
        self.context.jobs.stopped.connect(self.show_use)
        return form

    # ------------------------------------------------------------ a scan

    def open_scan(self, path: Path) -> None:
        """Reads it beside the window, and shows it then."""
        self.path = path
        self.series.forget()
        self.read(None)

    def open_series(self, uid: str) -> None:
        """One of several in the folder."""
        if self.context.jobs.current is None:
            self.read(uid)

    def read(self, series: str | None) -> None:
        assert self.path is not None
        title = tr("Reading {file}").format(file=self.path.name)
        work = ReadScan(self.path, series)
        self.context.jobs.start(title, work, self.show_scan, self.refuse_scan)

    def refuse_scan(self, problem: BaseException) -> None:
        """Of several series the one of most slices is read; another can be chosen then."""
        if isinstance(problem, SeveralSeries):
            self.series.show_series(problem.series)
            self.read(self.series.uid())
            return
        self.scan = None
        self.show_use()
        self.refuse(problem)
        if self.series.uid() is not None:
            self.show()

    def show_scan(self, scan: Scan) -> None:
        self.scan, self.found, self.places = scan, None, None
        self.preview.clear()
        self.facts.clear()
        size = " × ".join(map(count, scan.size))
        spacing = " × ".join(number(1e3 * length, 3) for length in scan.spacing)
        lines = [f"{scan.path.name}: {scan.format}", f"{size}, {spacing} mm"]
        if scan.tilt > 0.1:
            lines.append(tr("The gantry was tilted by {angle}.").format(
                angle=quantity(scan.tilt, "°", 3)))  # fmt: skip
        self.about.setText("\n".join(lines))
        for view in self.views:
            view.show_scan(scan)
        self.levels.show_scan(scan)
        self.chooser.show_scan(scan)
        self.show_levels()
        self.change_choice()
        fit_to_screen(self, SIZE)
        self.show()
        self.raise_()

    def show_levels(self) -> None:
        low, high = self.levels.ends()
        for view in self.views:
            view.show_levels(low, high)

    def choice(self) -> Choice | None:
        return self.chooser.choice()

    def change_choice(self) -> None:
        """The surface is no longer that of the choice."""
        self.found, self.places = None, None
        self.preview.clear()
        self.facts.clear()
        self.show_lines()
        self.show_use()

    def show_lines(self) -> None:
        choice = self.choice()
        triangles = None if self.found is None else self.found.triangles
        for view in self.views:
            if view.scan is not None:
                view.show_choice(choice)
                view.show_surface(self.places, triangles)

    def show_use(self, job: object = None) -> None:
        del job
        idle = self.context.jobs.current is None
        can = idle and self.scan is not None and self.choice() is not None
        self.cut_button.setEnabled(can)
        self.import_button.setEnabled(can)
        self.cancel_button.setEnabled(not idle)

    # ------------------------------------------------------------ doing

    def cut(self) -> None:
        choice = self.choice()
        if self.scan is None or choice is None:
            return
        title = tr("Cutting the surface out of {file}").format(file=self.scan.path.name)
        work = CutScan(self.scan.path, choice, self.series.uid())
        self.context.jobs.start(title, work, self.show_found, self.refuse)

    def refuse(self, problem: BaseException) -> None:
        self.facts.setText(sentence_of(problem))
        self.context.refuse(problem)

    def show_found(self, found: ScanSurface) -> None:
        if self.scan is None or found.choice != self.choice():
            return
        self.found = found
        self.places = find_voxel_places(self.scan, found.vertices)
        self.preview.show_surface(found.vertices, found.triangles)
        lines = [
            tr("{vertices} vertices, {triangles} triangles, {volume}").format(
                vertices=count(len(found.vertices)), triangles=count(len(found.triangles)),
                volume=quantity(1e6 * found.volume, "ml", 4)),
        ]  # fmt: skip
        if found.choice.smoothing:
            share = quantity(100.0 * found.change, "%", 2)
            lines.append(tr("Smoothing changes the volume by {share}.").format(share=share))
        if found.pieces_dropped or found.shells_dropped:
            dropped = count(found.pieces_dropped + found.shells_dropped)
            lines.append(tr("{count} smaller pieces are left out.").format(count=dropped))
        if found.cut_sides:
            lines.append(tr("It ends where the scan does, and is closed there flat."))
        self.facts.setText("\n".join(lines))
        self.show_lines()

    def import_scan(self) -> None:
        choice = self.choice()
        if self.scan is not None and choice is not None:
            uid = self.series.uid()
            self.wanted.emit(ImportScan(self.scan.path, choice, self.found, series=uid))
