# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading scans and cutting surfaces out of them beside the window, until it is cancelled."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from palpate_editor.document import Organ
from palpate_editor.from_scan import build_import
from palpate_editor.scan import Cancelled, Choice, Scan, ScanSurface, read_scan, segment_scan
from palpate_editor.views import jobs
from palpate_editor.views.jobs import Progress
from palpate_editor.views.tasks import Reading
from palpate_editor.views.translations import tr


@dataclass(frozen=True)
class ReadScan:
    """The volume with its voxels, to be looked at."""

    path: Path
    series: str | None = None
    """The UID of one of several in a folder."""

    def __call__(self, progress: Progress) -> Scan:
        progress(tr("Reading {file}").format(file=self.path.name), 0.2)
        try:
            return read_scan(
                self.path, series=self.series, voxels=True, stopped=progress.stop.is_set
            )
        except Cancelled:
            raise jobs.Cancelled from None


@dataclass(frozen=True)
class CutScan:
    """A surface, to be looked at."""

    path: Path
    choice: Choice
    series: str | None = None

    def __call__(self, progress: Progress) -> ScanSurface:
        progress(tr("Cutting the surface out of {file}").format(file=self.path.name), 0.3)
        try:
            return segment_scan(
                self.path, self.choice, series=self.series, stopped=progress.stop.is_set
            )
        except Cancelled:
            raise jobs.Cancelled from None


@dataclass(frozen=True, eq=False)
class ImportScan:
    """The edit that imports a surface; cuts it where that has not been done."""

    path: Path
    choice: Choice
    found: ScanSurface | None = None
    over: Organ | None = None
    series: str | None = None

    def __call__(self, progress: Progress) -> Reading:
        found = self.found or CutScan(self.path, self.choice, self.series)(progress)
        progress(tr("Repairing the surface"), 0.8)
        edit = build_import(self.path, found, series=self.series)
        return Reading(self.path, (), (), None, None, edit, None, self.over)
