# SPDX-License-Identifier: GPL-3.0-or-later
"""What every panel and tool of the window works with: one session, one view, one voice."""

from __future__ import annotations

import logging
import shlex
from collections.abc import Sequence
from pathlib import Path

from palpate.viewport import View
from PySide6.QtCore import QObject, Signal

from palpate_editor.app.session import Session
from palpate_editor.app.settings import Settings
from palpate_editor.edits import Edit, EditError
from palpate_editor.views.assessment import Assessment, Assessor
from palpate_editor.views.command_lines import find_arguments
from palpate_editor.views.jobs import Jobs
from palpate_editor.views.sentences import sentence_of
from palpate_editor.views.stage import Stages
from palpate_editor.views.theme import COLOURS, Colours
from palpate_editor.views.translations import say_title, tr

LOG = logging.getLogger(__name__)


class Context(QObject):
    """Shared by everything in one main window."""

    told = Signal(str, str)
    """A sentence and how grave it is: error, warning or info."""
    command_logged = Signal(str)
    remarked = Signal(str)
    """What no command line does, for those who read the log."""
    hinted = Signal(str)
    theme_changed = Signal(str)
    stage_shown = Signal(str)
    stage_wanted = Signal(str)
    import_wanted = Signal()
    """A mesh file is to be chosen."""
    mesh_wanted = Signal(object)
    """An ImportWork is to be done, after what could be lost was asked about."""
    scan_wanted = Signal(object)
    """An organ is to be cut out of a scan: its path, or None for one to be chosen."""
    preview_shown = Signal(bool)
    """The view shows something else than the open organ, or the organ again."""
    layout_wanted = Signal(object, bool)
    """A layout is to be opened in a window of its own: its path, and whether it is a new one."""
    distance_wanted = Signal(bool)
    long_edit_wanted = Signal(object)
    """An edit that takes seconds is to be done beside the window."""
    look_wanted = Signal(object)
    """A Problem is to be looked at, where it is on the surface."""
    dragged = Signal(object)
    """What the organ would be while a number of it is being dragged; it is no edit yet."""
    assessed = Signal()
    """`assessment` is that of the open organ."""

    def __init__(
        self,
        session: Session,
        view: View,
        settings: Settings,
        stages: Stages,
        parent: QObject | None = None,
    ):
        super().__init__(parent)
        self.session, self.view, self.settings = session, view, settings
        self.stages = stages
        self.jobs = Jobs(self)
        self.assessor = Assessor(session, self.jobs, self)
        self.assessor.assessed.connect(self.assessed)
        session.undone.connect(self.on_undone)
        session.redone.connect(self.on_redone)
        self.theme = "dark"
        self.stage = stages.names[0]
        self.previewing = False
        """Whether the view shows the parts of a file, not the organ."""

    @property
    def colours(self) -> Colours:
        return COLOURS[self.theme]

    @property
    def assessment(self) -> Assessment | None:
        """What is known of the open organ; None until it has been looked at."""
        return self.assessor.assessment

    def apply(self, edit: Edit) -> bool:
        """Applies an edit; a refusal becomes a sentence in the window, and False."""
        try:
            self.session.apply(edit)
        except EditError as refusal:
            self.refuse(refusal)
            return False
        arguments = find_arguments(edit, self.session.organ, self.document())
        if arguments is not None:
            self.log_command(arguments)
        else:
            self.remarked.emit(
                tr("{edit}: no command does this").format(edit=say_title(edit.title))
            )
        return True

    def on_undone(self, title: str) -> None:
        self.remarked.emit(tr("undone: {edit}").format(edit=title))

    def on_redone(self, title: str) -> None:
        self.remarked.emit(tr("done again: {edit}").format(edit=title))

    def tell(self, sentence: str, severity: str = "error") -> None:
        """Says a sentence in the message bar."""
        LOG.log(logging.WARNING if severity == "error" else logging.INFO, "%s", sentence)
        self.told.emit(sentence, severity)

    def refuse(self, problem: BaseException) -> None:
        """Says what went wrong, whatever it was."""
        if not isinstance(problem, EditError):
            LOG.info("refused", exc_info=problem)
        self.tell(sentence_of(problem), "error")

    def log_command(self, arguments: Sequence[object]) -> None:
        """The command line that does what was just done."""
        self.command_logged.emit(shlex.join(str(word) for word in arguments))

    def stem(self) -> str:
        """What files made from this organ are called."""
        session = self.session
        return session.path.stem if session.path else session.organ.name or "organ"

    def document(self) -> Path | str:
        """The file that command lines name: that of the session, or what it would be called."""
        path = self.session.path
        return path if path is not None and path.suffix == ".organ" else f"{self.stem()}.organ"

    def show_preview(self, shown: bool) -> None:
        """The view is taken for something else than the organ, or given back."""
        if shown != self.previewing:
            self.previewing = shown
            self.preview_shown.emit(shown)

    def show_distance(self, on: bool) -> None:
        self.distance_wanted.emit(on)

    def set_hint(self, text: str) -> None:
        self.hinted.emit(text)

    def use_theme(self, theme: str) -> None:
        self.theme = theme
        self.view.use_theme(theme)
        self.theme_changed.emit(theme)

    def show_stage(self, stage: str) -> None:
        """Asks the window for a stage."""
        self.stage_wanted.emit(stage)
