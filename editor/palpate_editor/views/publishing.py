# SPDX-License-Identifier: GPL-3.0-or-later
"""Making the file a trainee gets, and playing it as the trainee will."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from palpate.assessment.selfplay import Attempt
from PySide6.QtCore import QObject, Signal

from palpate_editor.check import Assessment
from palpate_editor.document import Organ
from palpate_editor.document.problems import Problem
from palpate_editor.publish import find_errors, publish
from palpate_editor.views.child_processes import ChildProcesses
from palpate_editor.views.command_lines import publish_arguments
from palpate_editor.views.context import Context
from palpate_editor.views.files import Files
from palpate_editor.views.jobs import Progress
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import say_problems, tr


@dataclass(frozen=True, eq=False)
class PublishWork:
    """Checks, compiles and writes a published file."""

    organ: Organ
    path: Path
    assessment: Assessment | None
    slow: bool = False
    tried: Any = None
    """What hands have done in the Scenario stage, of describe_selfplay."""

    def __call__(self, progress: Progress) -> Any:
        title = tr("Publishing {file}").format(file=self.path.name)
        progress(title, 0.2)

        def tell(played: Attempt) -> None:
            told = played.describe()
            hand = f"{told['hand']} {told['level']} {told['seed']}"
            progress(tr("{title}: hands try the task, {hand}").format(title=title, hand=hand), 0.5)

        report = publish(self.organ, self.path, self.assessment, self.slow, self.tried, tell)
        progress(tr("Done"), 1.0)
        return report


class Publishing(QObject):
    """Publishes and plays."""

    published = Signal(object)
    """The path."""

    def __init__(self, context: Context, files: Files, tasks: Tasks, parent: QObject | None = None):
        super().__init__(parent)
        self.context, self.files, self.tasks = context, files, tasks
        self.path: Path | None = None
        """The file published last from this window."""
        self.wanted = Path()
        self.slow = False
        """Whether an organ may be published that is late on the reference machine."""
        self.tried: Any = None
        """The last report of every hand, of describe_selfplay; None before they have played."""
        self.child_processes = ChildProcesses(context, self)

    def ask(self) -> None:
        """Asks for the file; refuses where there are errors."""
        if self.context.session.organ.surface is None:
            self.context.tell(tr("There is nothing to publish yet: import a mesh first."))
            return
        errors = self.refuses()
        if errors:
            self.context.show_stage("publish")
            self.context.tell(
                tr("Not published: {problems}. See the checks on the right.").format(
                    problems=say_problems(len(errors), 0)
                )
            )
            return
        name = f"{self.context.stem()}.palpate"
        filters = [tr("Published scenarios (*.palpate)")]
        self.files.ask(tr("Publish"), filters, self.publish_name, save=name)

    def refuses(self) -> tuple[Problem, ...]:
        """What prevents publishing, as far as it is known."""
        assessment = self.context.assessment
        return () if assessment is None else find_errors(assessment.checked, self.slow)

    def publish_name(self, name: str) -> None:
        path = Path(name)
        self.publish(path if path.suffix == ".palpate" else path.with_name(path.name + ".palpate"))

    def publish(self, path: Path) -> None:
        if self.tasks.is_busy():
            return
        self.wanted = path
        title = tr("Publishing {file}").format(file=path.name)
        known = self.context.assessment
        work = PublishWork(
            self.context.session.organ, path, known.checked if known else None, self.slow,
            self.tried,
        )  # fmt: skip
        self.context.jobs.start(title, work, self.on_published, self.context.refuse)

    def on_published(self, report: Any) -> None:
        del report
        self.path = self.wanted
        organ = self.context.session.organ
        self.context.log_command(
            publish_arguments(organ, self.context.document(), self.path, self.slow)
        )
        self.context.tell(tr("Published as {file}.").format(file=self.path.name), "info")
        self.published.emit(self.path)

    # ------------------------------------------------------------ playing

    def play(self) -> None:
        """Starts the player in a process of its own."""
        if self.path is None or not self.path.is_file():
            self.context.tell(tr("Publish first: the player plays the published file."), "warning")
            return
        self.child_processes.start(["play", self.path])
