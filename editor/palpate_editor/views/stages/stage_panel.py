# SPDX-License-Identifier: GPL-3.0-or-later
"""What all stage panels share: title, form, checks, and the way to the next stage."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from palpate_editor.document import Organ
from palpate_editor.document.problems import SEVERITIES, Problem
from palpate_editor.edits import Edit
from palpate_editor.far_field import SolveFarField
from palpate_editor.views.chart.advisor import Advisor
from palpate_editor.views.context import Context
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.stages.facts import CheckRow, Section, write_label
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.theme import title_font
from palpate_editor.views.translations import say, say_got, tr

TONES = {"error": "bad", "warning": "warning", "note": "faint"}


@dataclass(frozen=True)
class Workers:
    """What panels may need; most have enough with the context."""

    context: Context
    tasks: Tasks
    publishing: Publishing
    advisor: Advisor


class StagePanel(QWidget):
    """The panel of one stage. Subclasses name it, build the form and say what stands in it.

    The class is the `Stage` of its window: all that is said of a stage is asked of it.
    """

    stage = ""
    colouring = "plain"
    shows_fixed = False
    dock: str | None = None

    @classmethod
    def title(cls) -> str:
        """In stage bar, menu, palette, help and log; the name, where a panel has no better."""
        return cls.stage.capitalize()

    @staticmethod
    def lead() -> str:
        """The sentence under the title."""
        return ""

    @staticmethod
    def help() -> list[str]:
        """Paragraphs on the stage."""
        return []

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> StagePanel:
        return cls(workers.context, parent)

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("stage_page")
        self.context = context
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(16, 12, 16, 14)
        self.column.setSpacing(8)
        title = write_label(self.title(), "title", self)
        title.setFont(title_font(self.font(), 1.45))
        self.column.addWidget(title)
        lead = write_label(self.lead(), "lead", self)
        lead.setWordWrap(True)
        self.column.addWidget(lead)
        self.form = QVBoxLayout()
        self.form.setSpacing(8)
        self.column.addLayout(self.form)
        self.build()
        self.checks = Section(tr("Checks"), self)
        self.rows: list[CheckRow] = []
        self.column.addWidget(self.checks)
        self.column.addStretch(1)
        self.column.addLayout(self.build_next_stage_row())

    def build(self) -> None:
        """Fills the form; once."""

    def show_organ(self, organ: Organ) -> None:
        """Writes what the document says; after every change."""

    def show_assessment(self) -> None:
        """Writes what was found out about the document; a little later."""

    def good_news(self) -> list[str]:
        """What holds, in sentences; shown with a tick among the checks."""
        return []

    def is_known(self) -> bool:
        """Whether it is known how the stage stands, so that it may be ticked."""
        return True

    def problems(self) -> list[Problem]:
        """Those shown among the checks."""
        assessment = self.context.assessment
        return [] if assessment is None else assessment.of_stage(self.stage)

    def text_of(self, problem: Problem) -> str:
        """What was got, and what was expected instead."""
        return tr("{got}.\nExpected: {expected}.").format(
            got=say_got(problem), expected=say(problem.expected)
        )

    # ------------------------------------------------------------ shared parts

    def build_next_stage_row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setContentsMargins(0, 10, 0, 0)
        stages = self.context.stages
        self.following = stages.following(self.stage)
        self.next_button: QPushButton | None = None
        if self.following is not None:
            title = stages.title(self.following)
            self.next_button = QPushButton(
                tr("Next: {stage}").format(stage=title) + "  \N{RIGHTWARDS ARROW}"
            )
            self.next_button.setObjectName(f"next_{self.stage}")
            self.next_button.clicked.connect(self.go_on)
            row.addStretch(1)
            row.addWidget(self.next_button)
        return row

    def go_on(self) -> None:
        assert self.following is not None
        self.context.show_stage(self.following)

    def section(self, title: str) -> Section:
        made = Section(title, self)
        self.form.addWidget(made)
        return made

    def main_button(self, text: str, name: str) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(name)
        button.setProperty("main", True)
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        return button

    def fix(self, edit: Edit) -> None:
        """Does what a check offers: at once, or beside the window where it takes seconds."""
        if isinstance(edit, SolveFarField):
            self.context.long_edit_wanted.emit(edit)
        else:
            self.context.apply(edit)

    def show_checks(self) -> None:
        """All problems of the stage, the gravest first, then what is good."""
        colours = self.context.colours
        entries = [
            (TONES[p.severity], self.text_of(p), p.fix, tr("Fix it") if p.fix else "", place_of(p))
            for p in sorted(self.problems(), key=lambda p: SEVERITIES.index(p.severity))
        ]
        entries += [("good", sentence, None, "", None) for sentence in self.good_news()]
        while len(self.rows) < len(entries):
            row = CheckRow(self)
            row.fix_wanted.connect(self.fix)
            row.look_wanted.connect(self.context.look_wanted)
            self.rows.append(row)
            self.checks.add(row)
        for i, row in enumerate(self.rows):
            row.setVisible(i < len(entries))
            if i < len(entries):
                tone, text, fix, title, place = entries[i]
                row.show_check(tone, text, colours, fix, title, place)
        self.checks.setVisible(bool(entries))


def place_of(problem: Problem) -> Problem | None:
    """The problem, where it can be looked at."""
    return problem if problem.faces is not None and len(problem.faces) else None
