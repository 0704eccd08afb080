# SPDX-License-Identifier: GPL-3.0-or-later
"""The long work of the window: importing and decimating, each in a thread of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from palpate_editor import authoring
from palpate_editor.document import Organ
from palpate_editor.edits import (
    Decimate,
    Edit,
    ImportMesh,
    Prepared,
    decimate_organ,
    decimate_within,
    import_read,
    prepare,
)
from palpate_editor.edits.import_mesh import BESIDE, Assembling
from palpate_editor.edits.part_list import Part, list_parts
from palpate_editor.felt_change import FeltChange, measure_felt_change
from palpate_editor.guarded import stopping
from palpate_editor.views.context import Context
from palpate_editor.views.jobs import Progress
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.translations import quantity, say_title, tr


@dataclass(frozen=True, eq=False)
class Reading:
    """A mesh file as it was read: enough to choose from, even where it cannot be used whole."""

    path: Path
    parts: tuple[Part, ...]
    """All of them."""
    chosen: tuple[str, ...]
    unit: str | None
    up: str | None
    """As asked for; None for a guess."""
    edit: ImportMesh | None = None
    problem: BaseException | None = None
    """Why it cannot be used like this."""
    over: Organ | None = None
    """The organ whose place a new document takes; None where the mesh comes into its own."""


@dataclass(frozen=True, eq=False)
class ImportWork:
    """Reads a mesh file and, where it can be used, makes the edit that imports it."""

    path: Path
    parts: tuple[str, ...] = ()
    unit: str | None = None
    up: str | None = None
    over: Organ | None = None
    assembling: Assembling = BESIDE

    def __call__(self, progress: Progress) -> Reading:
        progress(tr("Reading {file}").format(file=self.path.name), 0.05)
        scene = authoring.read_mesh(self.path)
        progress(tr("Welding, repairing and inspecting {file}").format(file=self.path.name), 0.35)
        edit, problem = None, None
        try:
            edit = import_read(
                self.path,
                scene,
                parts=self.parts,
                unit=self.unit,
                up=self.up,
                assembling=self.assembling,
            )
        except (ValueError, OSError) as refusal:
            problem = refusal
        progress(tr("Looking at its parts"), 0.8)
        parts = list_parts(scene, *self.find_meaning(scene, edit))
        progress(tr("Done"), 1.0)
        return Reading(self.path, parts, self.parts, self.unit, self.up, edit, problem, self.over)

    def find_meaning(
        self, scene: authoring.ImportedScene, edit: ImportMesh | None
    ) -> tuple[str, str]:
        """Unit and axis up, as the import took them or would have."""
        if edit is not None:
            return edit.source.unit, edit.source.up
        try:
            joined = authoring.join_parts(scene, parts=self.parts, unit=self.unit, up=self.up)
        except (ValueError, OSError):  # no triangle in it: anything will do
            return self.unit or "mm", self.up or "z"
        return joined.unit, joined.up


@dataclass(frozen=True, eq=False)
class DecimateWork:
    """Makes the edit that puts a coarser surface in place, and does its work."""

    organ: Organ
    vertices: int | None = None
    error: float | None = None
    """[m] One of the two."""

    def __call__(self, progress: Progress) -> tuple[Prepared, FeltChange]:
        prepared = prepare(self.decimate(progress), self.organ)
        progress(tr("Pressing it before and after"), 0.6)
        return prepared, measure_felt_change(self.organ, prepared.after)

    def decimate(self, progress: Progress) -> Decimate:
        """With what a designer wants kept: ridges, thin parts, borders of what is painted."""
        if self.error is not None:
            text = quantity(1e3 * self.error, "mm", 3)
            progress(tr("Decimating within {distance}").format(distance=text), 0.15)
            return decimate_within(self.organ, self.error, True)
        assert self.vertices is not None
        progress(tr("Decimating to {count} vertices").format(count=self.vertices), 0.15)
        return decimate_organ(self.organ, self.vertices, True)


@dataclass(frozen=True, eq=False)
class EditWork:
    """Does the work of an edit that goes through a whole surface."""

    organ: Organ
    edit: Edit

    def __call__(self, progress: Progress) -> Prepared:
        progress(say_title(self.edit.title), 0.3)
        with stopping(progress.stop.is_set):
            return prepare(self.edit, self.organ)


class Tasks(QObject):
    """Starts the work and applies what comes of it."""

    read = Signal(object)
    """A Reading, whether or not it could be imported."""
    felt = Signal(object, object)
    """The organ that was decimated, and the FeltChange of that."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        context.long_edit_wanted.connect(self.apply_slowly)

    def is_busy(self) -> bool:
        """Says so where other work is under way."""
        job = self.context.jobs.current
        if job is not None:
            self.context.tell(
                tr("{work} is still under way: wait for it, or cancel it below.").format(
                    work=job.title
                ),
                "warning",
            )
        return job is not None

    def is_overtaken(self, over: Organ | None, file: str) -> bool:
        """Whether the organ was changed while another was read: then it stays, and is told."""
        session = self.context.session
        if session.saved or session.organ is over:
            return False
        self.context.tell(
            tr("The organ was changed while {file} was read, so it stays: open that again.").format(
                file=file
            ),
            "warning",
        )
        return True

    # ------------------------------------------------------------ import

    def import_mesh(
        self,
        path: Path,
        parts: Sequence[str] = (),
        unit: str | None = None,
        up: str | None = None,
        *,
        over: Organ | None = None,
        assembling: Assembling = BESIDE,
    ) -> None:
        """Imports into the open document or, where `over` is its organ, into a new one."""
        self.start_import(ImportWork(path, tuple(parts), unit, up, over, assembling))

    def start_import(self, work: ImportWork) -> None:
        if not self.is_busy():
            title = tr("Importing {file}").format(file=work.path.name)
            self.context.jobs.start(title, work, self.on_read, self.context.refuse)

    def import_scan(self, work: Callable[[Progress], Reading], file: str) -> None:
        """Imports what was cut out of a scan; the work says over which organ."""
        if not self.is_busy():
            title = tr("Importing {file}").format(file=file)
            self.context.jobs.start(title, work, self.on_read, self.context.refuse)

    def show_view(self) -> None:
        """Lets the view draw again."""
        self.context.view.setUpdatesEnabled(True)

    def on_read(self, reading: Reading) -> None:
        self.read.emit(reading)
        if reading.edit is None or reading.problem is not None:
            sentence = sentence_of(reading.problem) if reading.problem else ""
            if len(reading.parts) > 1:
                sentence = tr("{problem} Choose fewer of its parts at the right.").format(
                    problem=sentence.rstrip(".").replace("; fewer parts may do (--part)", "") + "."
                )
            self.context.tell(sentence)
            self.context.show_stage("import")
            return
        if reading.over is not None:
            if self.is_overtaken(reading.over, reading.path.name):
                return
            self.context.session.clear()
        # the panels first, the picture at the next look at the events: both at once take too long
        self.context.view.setUpdatesEnabled(False)
        QTimer.singleShot(0, self.show_view)
        if not self.context.apply(reading.edit):
            return
        self.context.view.frame_all()
        surface = reading.edit.surface
        self.context.tell(
            tr("{file} imported: {vertices} vertices, {triangles} triangles.").format(
                file=reading.path.name,
                vertices=len(surface.vertices),
                triangles=len(surface.triangles),
            ),
            "info",
        )

    # ------------------------------------------------------------ decimate

    def decimate(self, vertices: int) -> None:
        self.start_decimating(DecimateWork(self.context.session.organ, vertices))

    def decimate_within(self, error: float) -> None:
        """`error` [m]: to the fewest vertices that keep every point within it of the source."""
        self.start_decimating(DecimateWork(self.context.session.organ, error=error))

    def start_decimating(self, work: DecimateWork) -> None:
        if not self.is_busy():
            self.context.jobs.start(tr("Decimating"), work, self.on_decimated, self.context.refuse)

    def on_decimated(self, found: tuple[Prepared, FeltChange]) -> None:
        prepared, change = found
        if self.context.apply(prepared):
            self.felt.emit(self.context.session.organ, change)

    def apply_slowly(self, edit: Edit) -> None:
        """Applies an edit whose work takes long for a large organ."""
        if self.is_busy():
            return
        work = EditWork(self.context.session.organ, edit)
        self.context.jobs.start(
            say_title(edit.title), work, self.context.apply, self.context.refuse
        )
