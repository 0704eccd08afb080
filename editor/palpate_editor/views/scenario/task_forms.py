# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists and forms of a task, section by section: of an organ's stage and of a scene's page."""

from __future__ import annotations

from collections.abc import Callable

from palpate.assessment import author_values
from palpate.assessment.selfplay import Attempt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSpinBox, QWidget

from palpate_editor.views.scenario.band_row import NumberRow
from palpate_editor.views.scenario.limit_list import LimitList
from palpate_editor.views.scenario.parameter_table import ParameterTable
from palpate_editor.views.scenario.step_form import Choice, StepForm
from palpate_editor.views.scenario.step_list import StepList
from palpate_editor.views.scenario.task_draft import TaskDraft
from palpate_editor.views.scenario.text_table import TextTable
from palpate_editor.views.scenario.tool_list import ToolList
from palpate_editor.views.stages.facts import Section, write_label
from palpate_editor.views.translations import number, tr

MOST_SEED = 9999


class TaskForms:
    """Mixed into the widget that has them, which says where a section goes, what is drawn on, and
    how a hand plays."""

    draft: TaskDraft

    def play(self) -> None:
        """A careful hand at the chosen level and seed."""
        raise TypeError("TaskForms: got no way to play, expected that of a subclass")

    def build_forms(self, widget: QWidget, section: Callable[[str], Section]) -> Section:
        """All but what is under the buttons of self-play, whose section comes back."""
        steps = section(tr("Steps"))
        self.list = steps.add(StepList(self.draft, widget))
        self.step = section(tr("The chosen step"))
        self.step_form = self.step.add(StepForm(self.draft, widget))
        tools = section(tr("Instruments"))
        self.tools = tools.add(ToolList(self.draft, widget))
        limits = section(tr("Limits"))
        self.limits = limits.add(LimitList(self.draft, widget))
        self.time = limits.add(
            NumberRow("time_limit", tr("Time limit"), "s", 1.0, 10.0, 60, widget)
        )
        self.time.entered.connect(self._set_time)
        values = section(tr("Levels and parameters"))
        self.values = values.add(ParameterTable(self.draft, widget))
        texts = section(tr("Texts"))
        self.texts = texts.add(TextTable(self.draft, widget))
        hands = section(tr("Self-play"))
        self.play_row = self._build_play(widget)
        hands.body.addLayout(self.play_row)
        self.parts: list[QWidget] = [steps, tools, limits, values, texts, hands]
        return hands

    def _build_play(self, widget: QWidget) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(6)
        self.level = Choice(widget)
        self.level.setObjectName("level")
        self.level.setAccessibleName(tr("Level"))
        self.level.activated.connect(self._set_level)
        self.seed = QSpinBox(widget)
        self.seed.setObjectName("seed")
        self.seed.setAccessibleName(tr("Seed"))
        self.seed.setPrefix(tr("seed") + " ")
        self.seed.setRange(0, MOST_SEED)
        self.seed.valueChanged.connect(self._set_seed)
        self.play_button = QPushButton(tr("Careful hand"), widget)
        self.play_button.setObjectName("play_careful")
        self.play_button.clicked.connect(self.play)
        for each in (self.level, self.seed, self.play_button):
            row.addWidget(each, 1)
        return row

    def add_played(self, hands: Section, widget: QWidget) -> None:
        """Where it stands how a hand has fared."""
        self.played: QLabel = hands.add(write_label("", "note", widget))
        self.played.setWordWrap(True)

    def show_forms(self) -> bool:
        """What the draft has; False where no task has been begun."""
        task = self.draft.assessment
        for part in self.parts:
            part.setVisible(task is not None)
        self.step.setVisible(task is not None and self.draft.step is not None)
        if task is None:
            return False
        self.time.show_value(task["finish"].get("time_limit_s", 0.0))
        self.level.setVisible(bool(self.draft.levels))
        self.level.clear()
        for level in self.draft.levels:
            self.level.addItem(level, level)
        self.level.setCurrentIndex(max(self.level.findData(self.draft.level), 0))
        self.play_button.setEnabled(bool(self.draft.steps))
        return True

    def show_played(self, played: Attempt) -> None:
        told = played.describe()
        done = tr("done") if told["outcome"] == "done" else tr("not done")
        text = tr("A careful hand: {outcome} in {time} s, {errors} errors, peak {peak} N.")
        self.played.setText(
            text.format(outcome=done, time=number(told["time_s"], 3), errors=told["errors"],
                        peak=number(told["peak_force_N"], 3))
        )  # fmt: skip

    def _set_time(self, seconds: float) -> None:
        if self.draft.assessment is not None and seconds > 0.0:
            self.draft.change("finish", author_values.set_time, seconds)

    def _set_level(self) -> None:
        self.draft.level = str(self.level.currentData() or "")

    def _set_seed(self, seed: int) -> None:
        self.draft.seed = seed
