# SPDX-License-Identifier: GPL-3.0-or-later
"""The way from a scan to an organ: which file, its window, and what becomes of the document."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from palpate_editor.scan import SUFFIXES
from palpate_editor.views.context import Context
from palpate_editor.views.files import Files, is_replaceable
from palpate_editor.views.scan.scan_dialog import ScanDialog
from palpate_editor.views.scan.work import ImportScan
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import tr


class Scans(QObject):
    """Opens the window of scans, and imports what is chosen there."""

    def __init__(self, context: Context, files: Files, tasks: Tasks, window: QWidget):
        super().__init__(window)
        self.context, self.files, self.tasks, self.window = context, files, tasks, window
        self.dialog: ScanDialog | None = None
        self.work: ImportScan | None = None
        """What a new document is wanted of."""
        context.scan_wanted.connect(self.start)

    def start(self, path: Path | None) -> None:
        """With a file, or with one that is chosen now."""
        if path is not None:
            self.open(path)
            return
        names = " ".join(f"*{ending}" for ending in (*SUFFIXES, ".vtk"))
        filters = [tr("Scans ({names})").format(names=names), tr("All files (*)")]
        self.files.ask(tr("Import from a scan"), filters, self.open_name)

    def open_name(self, name: str) -> None:
        self.open(Path(name))

    def open(self, path: Path) -> None:
        """Shows a scan; of a DICOM slice all that lie beside it."""
        if self.tasks.is_busy():
            return
        if path.suffix.lower() in (".dcm", ""):
            path = path if path.is_dir() else path.parent
        if self.dialog is None:
            self.dialog = ScanDialog(self.context, self.window)
            self.dialog.wanted.connect(self.import_scan)
        self.dialog.open_scan(path)

    def import_scan(self, work: ImportScan) -> None:
        """Over an organ of another file it begins a document of its own."""
        organ = self.context.session.organ
        if is_replaceable(organ, work.path):
            self.tasks.import_scan(work, work.path.name)
            return
        self.work = work
        self.files.guard(self.import_over)

    def import_over(self) -> None:
        if self.work is not None:
            over = replace(self.work, over=self.context.session.organ)
            self.tasks.import_scan(over, over.path.name)
