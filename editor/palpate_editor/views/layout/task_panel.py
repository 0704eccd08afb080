# SPDX-License-Identifier: GPL-3.0-or-later
"""What a trainee does in a scene, step by step: the Scenario stage of a layout."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from palpate import scenario
from palpate.assessment.selfplay import Attempt, attempt
from palpate.layout.check import Checked
from palpate.layout.document import Layout
from palpate.layout.publish import make_scenario
from palpate.layout.task import find_task, has_steps
from palpate.translation.refusals import say_refusal
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from palpate_editor.layout_shapes import Key, PartShape
from palpate_editor.views.jobs import Progress
from palpate_editor.views.layout.scene_draft import SceneDraft
from palpate_editor.views.layout.space_form import SpaceForm
from palpate_editor.views.layout.task_marks import TaskMarks
from palpate_editor.views.scenario.step_form import POINT
from palpate_editor.views.scenario.task_forms import TaskForms
from palpate_editor.views.stages.facts import CheckRow, Section, write_label
from palpate_editor.views.stages.stage_panel import TONES
from palpate_editor.views.theme import COLOURS
from palpate_editor.views.touch.place_tool import PlaceTool
from palpate_editor.views.translations import tr

TASK = "task: "
"""Where problems of the task are, among those of a scene."""
RING = 0.003
"""[m] of the ring that shows where a place would be."""


@dataclass(frozen=True, eq=False)
class CarefulWork:
    """One attempt of a careful hand at the task of a layout that was checked."""

    layout: Layout
    checked: Checked
    level: str
    seed: int

    def __call__(self, progress: Progress) -> Attempt:
        progress(tr("A careful hand plays"), 0.2)
        assert self.checked.scene is not None and self.checked.assembly is not None
        made = make_scenario(self.layout, self.checked.assembly, self.checked.scene)
        drawn = scenario.draw_task(made, self.level, self.seed)
        return attempt(scenario.draw_scene(made, drawn), drawn, "careful")


class TaskPanel(TaskForms, QWidget):
    """Writes the task into the layout of a window; every change is a step of its history."""

    def __init__(self, window: object, parent: QWidget | None = None):
        super().__init__(parent)
        self.window_of = window
        self.setObjectName("task_page")
        self.checked: Checked | None = None
        self.draft = SceneDraft(window.session, window.tell, window.log_command, self)
        self.marks = TaskMarks(self.draft, window.view, self)
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(16, 12, 16, 14)
        self.column.setSpacing(8)
        self.lead = write_label("", "lead", self)
        self.lead.setWordWrap(True)
        self.column.addWidget(self.lead)
        self.new_button = QPushButton(tr("New task"), self)
        self.new_button.setObjectName("new_task")
        self.new_button.setProperty("main", True)
        self.new_button.clicked.connect(self.draft.begin)
        self.column.addWidget(self.new_button)
        self._build_parts()
        self.column.addStretch(1)
        self.point_tool = PlaceTool(RING, self)
        self.point_tool.picked.connect(self._take_point)
        self.point_tool.left.connect(self.end_drawing)
        self.draft.shown.connect(self._show_draft)

    def _section(self, title: str) -> Section:
        made = Section(title, self)
        self.column.addWidget(made)
        return made

    def _build_parts(self) -> None:
        hands = self.build_forms(self, self._section)
        self.step_form.draw_wanted.connect(self._draw)
        self.space = self.step.add(SpaceForm(self.draft, self))
        self.add_played(hands, self)
        self.checks = self._section(tr("Checks"))
        self.rows: list[CheckRow] = []
        self.remove_button = QPushButton(tr("Remove the task"), self)
        self.remove_button.setObjectName("remove_task")
        self.remove_button.clicked.connect(self.draft.remove)
        self.column.addWidget(self.remove_button)
        self.parts += [self.checks, self.remove_button]

    # ------------------------------------------------------------ showing

    def show_layout(self, shapes: dict[Key, PartShape]) -> None:
        self.draft.show_layout(shapes)

    def _show_draft(self) -> None:
        layout = self.draft.layout
        self.lead.setText(
            tr("Say what a trainee does, step by step; it is judged in every tick.")
            if layout.bodies
            else tr("A task is of what is in the scene: add an organ first.")
        )
        self.new_button.setVisible(self.draft.assessment is None)
        self.new_button.setEnabled(bool(layout.bodies))
        self.show_forms()

    def show_checked(self, checked: Checked | None) -> None:
        """What is wrong with the task; None while nothing is known."""
        self.checked = checked
        colours = COLOURS[self.window_of.theme]
        found = [] if checked is None else checked.problems
        entries = [
            (TONES[p.severity], f"{p.where.removeprefix(TASK)}: {say_refusal(p.message)}")
            for p in found
            if p.where.startswith(TASK)
        ]
        if checked is None:
            entries = [("faint", tr("Being checked."))]
        elif not entries and checked.scene is None:
            entries = [("faint", tr("The scene itself is not right yet: see its checks."))]
        elif not entries and has_steps(find_task(self.draft.layout)):
            entries = [("good", tr("Nothing is wrong with the task in 20 attempts of each level."))]
        while len(self.rows) < len(entries):
            self.rows.append(self.checks.add(CheckRow(self)))
        for index, row in enumerate(self.rows):
            row.setVisible(index < len(entries))
            if index < len(entries):
                row.show_check(*entries[index], colours, None, "", None)

    # ------------------------------------------------------------ places

    def _draw(self, kind: str) -> None:
        self._give_back()
        if kind == POINT:
            self.point_tool.take(self.window_of.view)

    def end_drawing(self) -> None:
        """The mouse is the camera's again."""
        self._give_back()
        self.step_form.end_drawing()

    def _give_back(self) -> None:
        if self.window_of.view.tool is self.point_tool:
            self.point_tool.give_back(self.window_of.view)

    def _take_point(self, point: np.ndarray) -> None:
        self.end_drawing()
        body = self.window_of.drawing.find_body(point)
        if body is not None:
            self.draft.set_place("spot", self.draft.of_point(body, point))

    # ------------------------------------------------------------ hands

    def play(self) -> None:
        """A careful hand at the chosen level and seed."""
        window, checked = self.window_of, self.checked
        if checked is None or checked.scene is None or checked.has_errors:
            window.tell(tr("The task cannot be played yet: see the checks."), "info")
            return
        work = CarefulWork(self.draft.layout, checked, self.draft.level, self.draft.seed)
        window.jobs.start(tr("A careful hand plays"), work, self.show_played, window.refuse)
