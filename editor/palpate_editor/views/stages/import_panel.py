# SPDX-License-Identifier: GPL-3.0-or-later
"""Stage 1: which file, which parts of it, how long its unit is and where it is up."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from palpate.translation.refusals import say_note, say_refusal
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
)

from palpate_editor.document import Organ, Source
from palpate_editor.document.organ_sizes import find_range
from palpate_editor.document.rules import find_organ_word
from palpate_editor.edits import SetName, SetUnit, SetUp
from palpate_editor.edits.orient import METRES
from palpate_editor.edits.part_list import Part
from palpate_editor.views.stages.appearance_row import AppearanceRow
from palpate_editor.views.stages.facts import Facts, write_label
from palpate_editor.views.stages.histogram import Histograms
from palpate_editor.views.stages.parts_chooser import PartsChooser
from palpate_editor.views.stages.stage_panel import StagePanel
from palpate_editor.views.tasks import ImportWork, Reading
from palpate_editor.views.translations import count, number, quantity, tr

UNITS = ("m", "cm", "mm", "um", "in", "ft")
UPS = ("z", "y", "x", "-z", "-y", "-x")


class ImportPanel(StagePanel):
    """Chooses and understands a mesh file."""

    stage = "import"

    @staticmethod
    def title() -> str:
        return tr("Import")

    @staticmethod
    def lead() -> str:
        return tr("Import a surface, and confirm its unit and its axis.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("Drop a mesh file on the window, or choose one. Files with several parts, such as a "
               "whole heart, can be used in part: tick what you need and import again."),
            tr("A file rarely says how long its unit is. The editor guesses by the size of the "
               "organ and says why; correct it where it is wrong, and everything follows."),
            tr("Importing again keeps your constants but forgets what was painted."),
        ]  # fmt: skip

    def build(self) -> None:
        self.reading: Reading | None = None
        """The file read last in this window; it may not be the one in the editor."""
        self.shown_source: Source | None = None
        self.build_file()
        self.build_parts()
        self.build_meaning()
        found = self.section(tr("What was found"))
        self.facts = found.add(Facts(self))
        self.histograms = found.add(Histograms(self.context, self))
        self.notes = found.add(write_label("", "note", self))
        self.notes.setWordWrap(True)

    def build_file(self) -> None:
        section = self.section(tr("File"))
        row = QHBoxLayout()
        self.file = write_label("", "value", self)
        self.file.setWordWrap(True)
        self.choose_button = QPushButton(tr("Choose…"), self)
        self.choose_button.setObjectName("choose_file")
        self.choose_button.clicked.connect(self.choose)
        self.scan_button = QPushButton(tr("From a scan…"), self)
        self.scan_button.setObjectName("choose_scan")
        self.scan_button.clicked.connect(self.choose_scan)
        row.addWidget(self.file, 1)
        row.addWidget(self.scan_button)
        row.addWidget(self.choose_button)
        section.body.addLayout(row)
        name_row = QGridLayout()
        name_row.setHorizontalSpacing(14)
        name_row.addWidget(write_label(tr("Name of the organ"), "name", self), 0, 0)
        self.name = QLineEdit(self)
        self.name.setObjectName("organ_name")
        self.name.editingFinished.connect(self.set_name)
        name_row.addWidget(self.name, 0, 1)
        self.appearance = AppearanceRow(self.context, self)
        name_row.addWidget(write_label(tr("Appearance"), "name", self), 1, 0)
        name_row.addWidget(self.appearance, 1, 1)
        section.body.addLayout(name_row)

    def build_parts(self) -> None:
        self.parts_section = self.section(tr("Parts to use"))
        self.chooser = PartsChooser(self.context, self)
        self.parts = self.chooser.tree
        self.all_button, self.none_button = self.chooser.all_button, self.chooser.none_button
        self.chooser.changed.connect(self.on_part)
        self.parts_section.add(self.chooser)
        row = QHBoxLayout()
        row.addStretch(1)
        self.import_button = self.main_button(tr("Import these parts"), "import_parts")
        self.import_button.clicked.connect(self.import_parts)
        row.addWidget(self.import_button)
        self.parts_section.body.addLayout(row)

    def build_meaning(self) -> None:
        section = self.section(tr("Meaning of the file"))
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(1, 1)
        self.unit, self.up = QComboBox(self), QComboBox(self)
        self.unit_reason, self.up_reason = write_label("", "note"), write_label("", "note")
        self.unit.addItems([self.unit_name(unit) for unit in UNITS])
        self.up.addItems(list(UPS))
        self.unit.activated.connect(self.set_unit)
        self.up.activated.connect(self.set_up)
        rows = (
            (tr("Unit"), self.unit, self.unit_reason),
            (tr("Axis up"), self.up, self.up_reason),
        )
        for i, (name, box, reason) in enumerate(rows):
            grid.addWidget(write_label(name, "name", self), 2 * i, 0)
            grid.addWidget(box, 2 * i, 1)
            reason.setWordWrap(True)
            grid.addWidget(reason, 2 * i + 1, 1)
        self.unit.setObjectName("unit")
        self.up.setObjectName("up")
        section.body.addLayout(grid)
        self.meaning = section

    @staticmethod
    def unit_name(unit: str) -> str:
        return {
            "m": tr("metre (m)"),
            "cm": tr("centimetre (cm)"),
            "mm": tr("millimetre (mm)"),
            "um": tr("micrometre (µm)"),
            "in": tr("inch (in)"),
            "ft": tr("foot (ft)"),
        }.get(unit, unit)

    # ------------------------------------------------------------ showing

    def show_reading(self, reading: Reading) -> None:
        """A file was read: its parts can be chosen, whether or not it was imported."""
        self.reading = reading
        self.fill_parts({part.name: part for part in reading.parts}, reading.chosen)
        self.file.setText(reading.path.name)
        self.file.setToolTip(str(reading.path))
        if reading.edit is None and len(reading.parts) > 1:
            self.chooser.begin_preview()

    def show_organ(self, organ: Organ) -> None:
        source = organ.source
        if not self.name.hasFocus():
            self.name.setText(organ.name)
        self.name.setEnabled(organ.surface is not None)
        self.appearance.show_organ(organ)
        self.meaning.setVisible(source is not None)
        self.facts.parentWidget().setVisible(organ.surface is not None)
        if source is not self.shown_source:
            self.show_source(source)
        if source is not None:
            self.show_units(organ)
            self.unit.setCurrentIndex(UNITS.index(source.unit) if source.unit in UNITS else -1)
            self.up.setCurrentText(source.up)
            self.unit_reason.setText(self.reason(source.unit_guessed, source.unit_reason))
            self.up_reason.setText(self.reason(source.up_guessed, source.up_reason))
            self.notes.setText("\n".join(map(say_note, source.notes)))
            self.notes.setVisible(bool(source.notes))
        elif self.reading is None:
            self.file.setText(tr("No file yet: choose one, or drop it anywhere on this window."))
            self.parts_section.hide()

    def show_units(self, organ: Organ) -> None:
        """Each unit with how long the organ would be in it; those that make no organ are faint."""
        if organ.source is None or organ.imported is None or organ.source.unit not in METRES:
            return
        least, most = find_range(find_organ_word(organ))
        x = organ.imported.vertices
        size = float(np.linalg.norm(np.ptp(x, axis=0))) / METRES[organ.source.unit]
        for row, unit in enumerate(UNITS):
            length = size * METRES[unit]
            fits = least <= length <= most
            faint = None if fits else QColor(self.context.colours.faint)
            self.unit.setItemText(row, f"{self.unit_name(unit)}: {say_length(length)}")
            self.unit.setItemData(row, faint, Qt.ItemDataRole.ForegroundRole)

    def show_source(self, source: Source | None) -> None:
        self.shown_source = source
        if source is None:
            self.reading = None
            return
        self.file.setText(source.file)
        self.file.setToolTip(str(Path(source.folder) / source.file))
        known = self.reading is not None and self.reading.path.name == source.file
        if self.context.session.organ.segmentation is not None:
            self.reading = None
            self.fill_parts({}, ())
            return
        parts = {p.name: p for p in self.reading.parts} if known and self.reading else {}
        self.fill_parts(
            {name: parts.get(name) for name in source.parts_available},
            source.parts,
            self.context.session.organ,
        )

    @staticmethod
    def reason(guessed: bool, reason: str) -> str:
        said = say_refusal(reason)
        return tr("Guessed: {reason}").format(reason=said) if guessed else said

    def fill_parts(
        self,
        parts: Mapping[str, Part | None],
        chosen: tuple[str, ...],
        organ: Organ | None = None,
    ) -> None:
        self.chooser.show_parts(parts, chosen, organ)
        self.parts_section.setVisible(len(parts) > 1)

    def show_assessment(self) -> None:
        assessment = self.context.assessment
        report = assessment.report if assessment else None
        self.histograms.show_report(report)
        if report is None:
            self.facts.show_facts([])
            return
        tissue = assessment.tissue if assessment else None
        step = None if tissue is None or tissue.stable_step is None else 1e6 * tissue.stable_step
        size = " × ".join(number(length, 3) for length in report.size_mm)
        self.facts.show_facts(
            [
                (tr("Vertices"), count(report.vertices)),
                (tr("Triangles"), count(report.triangles)),
                (tr("Size"), f"{size} mm"),
                (tr("Volume"), quantity(report.volume_ml, "ml", 4)),
                (tr("Pieces"), count(report.shells)),
                (tr("Thinnest"), quantity(report.thinnest_mm, "mm", 3)),
                (tr("Smallest angle"), quantity(report.smallest_angle_deg, "°", 3)),
                (tr("Longest stable step"), quantity(step, "µs", 3)),
            ]
        )

    def good_news(self) -> list[str]:
        source = self.context.session.organ.source
        if source is None:
            return []
        used = tr("{used} of {all} parts are in use.").format(
            used=len(source.parts), all=len(source.parts_available)
        )
        return [used]

    # ------------------------------------------------------------ doing

    def chosen_parts(self) -> list[str]:
        return self.chooser.chosen()

    def on_part(self) -> None:
        self.import_button.setEnabled(bool(self.chosen_parts()))

    def tick_none(self) -> None:
        self.chooser.tick_none()

    def choose(self) -> None:
        self.context.import_wanted.emit()

    def choose_scan(self) -> None:
        self.context.scan_wanted.emit(None)

    def path(self) -> Path | None:
        """The file the shown parts are in."""
        if self.reading is not None and self.reading.path.name == self.file.text():
            return self.reading.path
        source = self.context.session.organ.source
        return Path(source.folder) / source.file if source is not None else None

    def import_parts(self) -> None:
        path, parts = self.path(), self.chosen_parts()
        if path is None:
            return
        if self.context.session.organ.segmentation is not None and self.reading is None:
            self.context.scan_wanted.emit(path)
            return
        if not path.is_file():
            self.context.tell(
                tr("{file} is no longer where it was: choose it again.").format(file=path.name)
            )
            return
        whole = len(parts) == self.parts.count()
        source = self.context.session.organ.source
        same = source is not None and source.file == path.name
        unit = source.unit if same and source and not source.unit_guessed else None
        up = source.up if same and source and not source.up_guessed else None
        chosen = () if whole else tuple(parts)
        assembling = self.chooser.assembling()
        if assembling.subtract:
            chosen = tuple(parts)  # all means all of the others
        self.context.mesh_wanted.emit(ImportWork(path, chosen, unit, up, assembling=assembling))

    def set_unit(self, row: int) -> None:
        source = self.context.session.organ.source
        if source is None or (source.unit == UNITS[row] and not source.unit_guessed):
            return
        if not self.context.apply(SetUnit(UNITS[row])):
            self.show_organ(self.context.session.organ)
            return
        self.context.view.frame_all()

    def set_up(self, row: int) -> None:
        source = self.context.session.organ.source
        if source is None or (source.up == UPS[row] and not source.up_guessed):
            return
        if not self.context.apply(SetUp(UPS[row])):
            self.show_organ(self.context.session.organ)
            return
        self.context.view.frame_all()

    def set_name(self) -> None:
        name = self.name.text().strip()
        if (
            name != self.context.session.organ.name
            and self.context.session.organ.surface is not None
        ):
            self.context.apply(SetName(name))


def say_length(length: float) -> str:
    """[m] Of an organ in a unit, which may be any."""
    if length >= 1.0:
        return tr("{length} long").format(length=quantity(length, "m", 3))
    return tr("{length} long").format(length=quantity(1e3 * length, "mm", 3))
