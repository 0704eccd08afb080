# SPDX-License-Identifier: GPL-3.0-or-later
"""Making the file a trainee gets, and playing it as the trainee will."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from palpate_editor.check import Assessment
from palpate_editor.document import Organ
from palpate_editor.publish import publish
from palpate_editor.views.command_lines import publish_words
from palpate_editor.views.companions import Companions
from palpate_editor.views.desk import Desk
from palpate_editor.views.files import Files
from palpate_editor.views.jobs import Progress
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.words import tr


@dataclass(frozen=True, eq=False)
class PublishWork:
    """Checks, compiles and writes a published file."""

    organ: Organ
    path: Path
    assessment: Assessment | None

    def __call__(self, progress: Progress) -> Any:
        progress(tr("Publishing {file}").format(file=self.path.name), 0.2)
        report = publish(self.organ, self.path, self.assessment)
        progress(tr("Done"), 1.0)
        return report


class Publishing(QObject):
    """Publishes and plays."""

    published = Signal(object)
    """The path."""

    def __init__(self, desk: Desk, files: Files, tasks: Tasks, parent: QObject | None = None):
        super().__init__(parent)
        self.desk, self.files, self.tasks = desk, files, tasks
        self.path: Path | None = None
        """The file published last from this window."""
        self.wanted = Path()
        self.companions = Companions(desk, self)

    def ask(self) -> None:
        """Asks for the file; refuses with the red checks where there are some."""
        assessment = self.desk.assessment
        if self.desk.session.organ.surface is None:
            self.desk.tell(tr("There is nothing to publish yet: import a mesh first."))
            return
        errors = [] if assessment is None else assessment.checked.errors
        if errors:
            self.desk.show_stage("publish")
            self.desk.tell(
                tr("Not published: red checks stand at the right ({count}).").format(
                    count=len(errors)
                )
            )
            return
        name = f"{self.desk.stem()}.palpate"
        filters = [tr("Published scenarios (*.palpate)")]
        self.files.ask(tr("Publish"), filters, self.publish_name, save=name)

    def publish_name(self, name: str) -> None:
        path = Path(name)
        self.publish(path if path.suffix == ".palpate" else path.with_name(path.name + ".palpate"))

    def publish(self, path: Path) -> None:
        if self.tasks.is_busy():
            return
        self.wanted = path
        title = tr("Publishing {file}").format(file=path.name)
        known = self.desk.assessment
        work = PublishWork(self.desk.session.organ, path, known.checked if known else None)
        self.desk.jobs.start(title, work, self.on_published, self.desk.refuse)

    def on_published(self, report: Any) -> None:
        del report
        self.path = self.wanted
        organ = self.desk.session.organ
        self.desk.log_command(publish_words(organ, self.desk.document(), self.path))
        self.desk.tell(tr("Published as {file}.").format(file=self.path.name), "info")
        self.published.emit(self.path)

    # ------------------------------------------------------------ playing

    def play(self) -> None:
        """Starts the player in a process of its own."""
        if self.path is None or not self.path.is_file():
            self.desk.tell(tr("Publish first: the player plays the published file."), "warning")
            return
        self.companions.start(["play", self.path])
