# SPDX-License-Identifier: GPL-3.0-or-later
"""The long work of the window: importing and decimating, each in a thread of its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from palpate_editor import authoring
from palpate_editor.document import Organ
from palpate_editor.edits import Decimate, ImportMesh, decimate_organ, import_file
from palpate_editor.views.command_lines import decimate_words, import_words
from palpate_editor.views.desk import Desk
from palpate_editor.views.jobs import Progress
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.words import tr


@dataclass(frozen=True, eq=False)
class Reading:
    """A mesh file as it was read: enough to choose from, even where it cannot be used whole."""

    path: Path
    parts: tuple[tuple[str, int], ...]
    """Names and triangle counts of all parts."""
    chosen: tuple[str, ...]
    unit: str | None
    up: str | None
    """As asked for; None for a guess."""
    edit: ImportMesh | None = None
    problem: BaseException | None = None
    """Why it cannot be used like this."""


@dataclass(frozen=True)
class ImportWork:
    """Reads a mesh file and, where it can be used, makes the edit that imports it."""

    path: Path
    parts: tuple[str, ...] = ()
    unit: str | None = None
    up: str | None = None

    def __call__(self, progress: Progress) -> Reading:
        progress(tr("Reading {file}").format(file=self.path.name), 0.05)
        scene = authoring.read_mesh(self.path)
        counts = tuple((part.name, len(part.mesh.triangles)) for part in scene.parts)
        del scene
        progress(tr("Welding, repairing and inspecting {file}").format(file=self.path.name), 0.35)
        edit, problem = None, None
        try:
            edit = import_file(self.path, parts=self.parts, unit=self.unit, up=self.up)
        except (ValueError, OSError) as refusal:
            problem = refusal
        progress(tr("Done"), 1.0)
        return Reading(self.path, counts, self.parts, self.unit, self.up, edit, problem)


@dataclass(frozen=True, eq=False)
class DecimateWork:
    """Makes the edit that puts a coarser surface in place."""

    organ: Organ
    vertices: int

    def __call__(self, progress: Progress) -> Decimate:
        words = tr("Decimating to {count} vertices").format(count=self.vertices)
        progress(words, 0.15)
        edit = decimate_organ(self.organ, self.vertices)
        progress(words, 1.0)
        return edit


class Tasks(QObject):
    """Starts the work and puts what comes of it on the desk."""

    read = Signal(object)
    """A Reading, whether or not it could be imported."""
    imported = Signal(object)
    decimated = Signal()

    def __init__(self, desk: Desk, parent: QObject | None = None):
        super().__init__(parent)
        self.desk = desk
        self.wanted: ImportWork | DecimateWork | None = None

    def is_busy(self) -> bool:
        """Says so where other work is under way."""
        job = self.desk.jobs.current
        if job is not None:
            self.desk.tell(
                tr("{work} is still under way: wait for it, or cancel it below.").format(
                    work=job.title
                ),
                "warning",
            )
        return job is not None

    # ------------------------------------------------------------ import

    def import_mesh(
        self, path: Path, parts: Sequence[str] = (), unit: str | None = None, up: str | None = None
    ) -> None:
        if self.is_busy():
            return
        self.wanted = ImportWork(path, tuple(parts), unit, up)
        title = tr("Importing {file}").format(file=path.name)
        self.desk.jobs.start(title, self.wanted, self.on_read, self.desk.refuse)

    def on_read(self, reading: Reading) -> None:
        self.read.emit(reading)
        if reading.edit is None or reading.problem is not None:
            sentence = sentence_of(reading.problem) if reading.problem else ""
            if len(reading.parts) > 1:
                sentence = tr("{problem} Choose fewer of its parts at the right.").format(
                    problem=sentence.rstrip(".").replace("; fewer parts may do (--part)", "") + "."
                )
            self.desk.tell(sentence)
            self.desk.show_stage("import")
            return
        if not self.desk.apply(reading.edit):
            return
        self.desk.view.frame_all()
        words = import_words(
            reading.path, reading.chosen, reading.unit, reading.up, self.desk.stem()
        )
        self.desk.log_command(words)
        surface = reading.edit.surface
        self.desk.tell(
            tr("{file} imported: {vertices} vertices, {triangles} triangles.").format(
                file=reading.path.name,
                vertices=len(surface.vertices),
                triangles=len(surface.triangles),
            ),
            "info",
        )
        self.imported.emit(reading)

    # ------------------------------------------------------------ decimate

    def decimate(self, vertices: int) -> None:
        if self.is_busy():
            return
        self.wanted = DecimateWork(self.desk.session.organ, vertices)
        title = tr("Decimating")
        self.desk.jobs.start(title, self.wanted, self.on_decimated, self.desk.refuse)

    def on_decimated(self, edit: Decimate) -> None:
        if not self.desk.apply(edit):
            return
        self.desk.log_command(decimate_words(self.desk.stem(), edit.decimation.vertices))
        self.decimated.emit()
