# SPDX-License-Identifier: GPL-3.0-or-later
"""What a trainee does in a scene, step by step: the Scenario stage of a layout."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from palpate import scenario
from palpate.assessment import author_values
from palpate.assessment.selfplay import Attempt, attempt
from palpate.layout.check import Checked
from palpate.layout.document import Layout
from palpate.layout.publish import make_scenario
from palpate.layout.task import find_task, has_steps
from palpate.translation.refusals import say_refusal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QSpinBox, QVBoxLayout, QWidget

from palpate_editor.layout_shapes import Key, PartShape
from palpate_editor.views.jobs import Progress
from palpate_editor.views.layout.scene_draft import SceneDraft
from palpate_editor.views.layout.space_form import SpaceForm
from palpate_editor.views.layout.task_marks import TaskMarks
from palpate_editor.views.scenario.band_row import NumberRow
from palpate_editor.views.scenario.limit_list import LimitList
from palpate_editor.views.scenario.parameter_table import ParameterTable
from palpate_editor.views.scenario.step_form import POINT, Choice, StepForm
from palpate_editor.views.scenario.step_list import StepList
from palpate_editor.views.scenario.text_table import TextTable
from palpate_editor.views.scenario.tool_list import ToolList
from palpate_editor.views.stages.facts import CheckRow, Section, write_label
from palpate_editor.views.stages.stage_panel import TONES
from palpate_editor.views.theme import COLOURS
from palpate_editor.views.touch.place_tool import PlaceTool
from palpate_editor.views.translations import number, tr

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


class TaskPanel(QWidget):
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
        steps = self._section(tr("Steps"))
        self.list = steps.add(StepList(self.draft, self))
        self.step = self._section(tr("The chosen step"))
        self.step_form = self.step.add(StepForm(self.draft, self))
        self.step_form.draw_wanted.connect(self._draw)
        self.space = self.step.add(SpaceForm(self.draft, self))
        tools = self._section(tr("Instruments"))
        self.tools = tools.add(ToolList(self.draft, self))
        limits = self._section(tr("Limits"))
        self.limits = limits.add(LimitList(self.draft, self))
        self.time = limits.add(NumberRow("time_limit", tr("Time limit"), "s", 1.0, 10.0, 60, self))
        self.time.entered.connect(self._set_time)
        values = self._section(tr("Levels and parameters"))
        self.values = values.add(ParameterTable(self.draft, self))
        texts = self._section(tr("Texts"))
        self.texts = texts.add(TextTable(self.draft, self))
        hands = self._section(tr("Self-play"))
        hands.body.addLayout(self._build_play())
        self.played = hands.add(write_label("", "note", self))
        self.played.setWordWrap(True)
        self.checks = self._section(tr("Checks"))
        self.rows: list[CheckRow] = []
        self.remove_button = QPushButton(tr("Remove the task"), self)
        self.remove_button.setObjectName("remove_task")
        self.remove_button.clicked.connect(self.draft.remove)
        self.column.addWidget(self.remove_button)
        self.parts = [steps, tools, limits, values, texts, hands, self.checks, self.remove_button]

    def _build_play(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.level = Choice(self)
        self.level.setObjectName("level")
        self.level.setAccessibleName(tr("Level"))
        self.level.activated.connect(self._set_level)
        self.seed = QSpinBox(self)
        self.seed.setObjectName("seed")
        self.seed.setAccessibleName(tr("Seed"))
        self.seed.setPrefix(tr("seed") + " ")
        self.seed.setRange(0, 9999)
        self.play_button = QPushButton(tr("Careful hand"), self)
        self.play_button.setObjectName("play_careful")
        self.play_button.clicked.connect(self.play)
        for widget in (self.level, self.seed, self.play_button):
            row.addWidget(widget, 1)
        return row

    # ------------------------------------------------------------ showing

    def show_layout(self, shapes: dict[Key, PartShape]) -> None:
        self.draft.show_layout(shapes)

    def _show_draft(self) -> None:
        task, layout = self.draft.assessment, self.draft.layout
        begun = task is not None
        self.lead.setText(
            tr("Say what a trainee does, step by step; it is judged in every tick.")
            if layout.bodies
            else tr("A task is of what is in the scene: add an organ first.")
        )
        self.new_button.setVisible(not begun)
        self.new_button.setEnabled(bool(layout.bodies))
        for part in self.parts:
            part.setVisible(begun)
        self.step.setVisible(begun and self.draft.step is not None)
        if task is None:
            return
        self.time.show_value(task["finish"].get("time_limit_s", 0.0))
        self.level.setVisible(bool(self.draft.levels))
        self.level.clear()
        for level in self.draft.levels:
            self.level.addItem(level, level)
        self.level.setCurrentIndex(max(self.level.findData(self.draft.level), 0))
        self.play_button.setEnabled(bool(self.draft.steps))

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

    # ------------------------------------------------------------ numbers, hands

    def _set_time(self, seconds: float) -> None:
        if self.draft.assessment is not None and seconds > 0.0:
            self.draft.change("finish", author_values.set_time, seconds)

    def _set_level(self) -> None:
        self.draft.level = str(self.level.currentData() or "")

    def play(self) -> None:
        """A careful hand at the chosen level and seed."""
        window, checked = self.window_of, self.checked
        if checked is None or checked.scene is None or checked.has_errors:
            window.tell(tr("The task cannot be played yet: see the checks."), "info")
            return
        work = CarefulWork(self.draft.layout, checked, self.draft.level, self.seed.value())
        window.jobs.start(tr("A careful hand plays"), work, self._take_attempt, window.refuse)

    def _take_attempt(self, played: Attempt) -> None:
        told = played.describe()
        done = tr("done") if told["outcome"] == "done" else tr("not done")
        text = tr("A careful hand: {outcome} in {time} s, {errors} errors, peak {peak} N.")
        self.played.setText(
            text.format(outcome=done, time=number(told["time_s"], 3), errors=told["errors"],
                        peak=number(told["peak_force_N"], 3))
        )  # fmt: skip
