# SPDX-License-Identifier: GPL-3.0-or-later
"""The Scenario stage: steps, limits and texts of a task, places on the organ, hands that try it."""

from __future__ import annotations

import numpy as np
from palpate.assessment.check_problem import Problem as TaskProblem
from palpate.assessment.selfplay import Attempt
from palpate.command.verb import Report
from palpate.runs.hand_record import find_bands
from PySide6.QtWidgets import QPushButton, QWidget

from palpate_editor.document import Organ, phrase
from palpate_editor.document.problems import Problem
from palpate_editor.surface_path import follow_surface
from palpate_editor.views.context import Context
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.scenario.draft import Draft
from palpate_editor.views.scenario.place_marks import PlaceMarks
from palpate_editor.views.scenario.place_tools import PathTool
from palpate_editor.views.scenario.play_work import CarefulWork, CheckWork, EveryHandWork
from palpate_editor.views.scenario.step_form import PATH, POINT
from palpate_editor.views.scenario.task_draft import round_point
from palpate_editor.views.scenario.task_forms import TaskForms
from palpate_editor.views.scenario.time_line import TimeLine
from palpate_editor.views.stages.stage_panel import StagePanel, Workers
from palpate_editor.views.touch.force_plot import ForcePlot
from palpate_editor.views.touch.live_costs import LiveCosts
from palpate_editor.views.touch.place_tool import PlaceTool
from palpate_editor.views.touch.results import Outcome
from palpate_editor.views.touch.runner import HandRequest, Runner
from palpate_editor.views.translations import tr


class ScenarioPanel(TaskForms, StagePanel):
    """Writes the task of the open organ; every change is an edit."""

    stage = "scenario"
    shows_fixed = True

    @staticmethod
    def title() -> str:
        return tr("Scenario")

    @staticmethod
    def lead() -> str:
        return tr("Say what a trainee does, step by step; it is judged in every tick.")

    @staticmethod
    def help() -> list[str]:
        return [
            tr("A step is a verb, a place and a band of force or depth. It is done once all has "
               "been so for as long as you say, and the next one begins."),
            tr("A limit is a warning, an error, or the end of the task. An organ without steps is "
               "published as one to feel."),
            tr("A parameter is a number by name: levels give it other values, or the seed draws "
               "it. It can stand for a bound of a step or a limit."),
            tr("Instruments are those of the Test stage too, where Tab gives the mouse to the next "
               "one. What each costs of a tick stands in the budget bar."),
            tr("Simulated hands try the task out. They test its numbers, not what it teaches."),
        ]  # fmt: skip

    @classmethod
    def make(cls, workers: Workers, parent: QWidget) -> ScenarioPanel:
        panel = cls(workers.context, parent)
        panel.publishing = workers.publishing
        return panel

    def __init__(self, context: Context, parent: QWidget | None = None):
        self.publishing: Publishing | None = None
        """Which is told how hands have fared."""
        self.draft = Draft(context)
        self.found: tuple[Organ | None, list[TaskProblem]] = (None, [])
        self._checking: Organ | None = None
        super().__init__(context, parent)
        self.draft.setParent(self)
        self.marks = PlaceMarks(self.draft, self.stage, self)
        radius = context.session.organ.tool.radius
        self.point_tool, self.path_tool = PlaceTool(radius, self), PathTool(radius, self)
        self.point_tool.picked.connect(self._take_point)
        self.path_tool.drawn.connect(self._take_path)
        for tool in (self.point_tool, self.path_tool):
            tool.left.connect(self.end_drawing)
        self.runner = Runner(context, ForcePlot(self), LiveCosts(self), self)
        self.runner.plot.hide()
        self.runner.costs.hide()
        self.runner.changed.connect(self._show_run)
        self.runner.ended.connect(self._take_outcome)
        context.theme_changed.connect(self.line.use_theme)
        context.stage_shown.connect(self._on_stage)
        context.assessed.connect(self._check)
        self.line.use_theme(context.theme)

    # ------------------------------------------------------------ looks

    def build(self) -> None:
        self.new_button = self.main_button(tr("New scenario"), "new_scenario")
        self.new_button.clicked.connect(self.draft.begin)
        self.form.addWidget(self.new_button)
        hands = self.build_forms(self, self.section)
        self.step_form.draw_wanted.connect(self._draw)
        self.step_form.record_wanted.connect(self._record)
        self.every_button = QPushButton(tr("Every hand"), self)
        self.every_button.setObjectName("play_every")
        self.every_button.setToolTip(tr("Careful, idle, violent and clumsy hands, every level"))
        self.every_button.clicked.connect(self.play_every)
        self.play_row.addWidget(self.every_button, 1)
        self.line = hands.add(TimeLine(self))
        self.add_played(hands, self)
        self.draft.shown.connect(self._show_draft)

    def show_organ(self, organ: Organ) -> None:
        self.draft.show_organ(organ)

    def _show_draft(self) -> None:
        self.new_button.setVisible(self.draft.assessment is None)
        self.new_button.setEnabled(self.context.session.organ.surface is not None)
        if not self.show_forms():
            self.line.show_attempt(None)
            return
        self.every_button.setEnabled(bool(self.draft.steps))

    def _on_stage(self, stage: str) -> None:
        if stage != self.stage:
            self.end_drawing()
            self.runner.stop()
        else:
            self._check()

    # ------------------------------------------------------------ checks

    def _check(self) -> None:
        """Asks once the organ is compiled, where a person sees what comes of it."""
        known, organ = self.context.assessment, self.context.session.organ
        if self.context.stage != self.stage or known is None or known.scene is None:
            return
        if known.organ is not organ or organ in (self.found[0], self._checking):
            return
        self._checking = organ
        work = CheckWork(organ, known.scene)
        self.context.jobs.start_unseen("task", work, self._take_check, self.context.refuse)

    def _take_check(self, found: tuple[Organ, list[TaskProblem]]) -> None:
        self.found = found
        self._checking = None
        if found[0] is self.context.session.organ:
            self.show_checks()
        else:
            self._check()

    def is_known(self) -> bool:
        """Where a task has been begun, once it has been checked."""
        organ = self.context.session.organ
        return not organ.assessment or self.found[0] is organ

    def problems(self) -> list[Problem]:
        found = self.found[1] if self.found[0] is self.context.session.organ else []
        return super().problems() + [
            Problem("task", each.severity, self.stage, each.where,
                    phrase("{where}: {text}", where=each.where, text=each.message),
                    phrase("a task that can be done and judged"))
            for each in found
        ]  # fmt: skip

    def good_news(self) -> list[str]:
        organ = self.context.session.organ
        if not organ.assessment:
            return [tr("Without a task the organ is published as one to feel.")]
        if self.found[0] is organ and not self.found[1] and self.draft.steps:
            return [tr("Nothing is wrong with the task in 20 attempts of each level.")]
        return []

    # ------------------------------------------------------------ places

    def _draw(self, kind: str) -> None:
        self._give_back()
        if kind == POINT:
            self.point_tool.take(self.context.view)
            self.context.set_hint(tr("Click on the organ where the step shall be, Esc to leave"))
        elif kind == PATH:
            self.path_tool.take(self.context.view)
            self.context.set_hint(
                tr("Click along the organ; Enter or the right button ends the line, Esc leaves")
            )

    def end_drawing(self) -> None:
        """The mouse is the camera's again."""
        self._give_back()
        self.step_form.end_drawing()
        if self.context.stage == self.stage:
            self.context.set_hint("")

    def _give_back(self) -> None:
        for tool in (self.point_tool, self.path_tool):
            if self.context.view.tool is tool:
                tool.give_back(self.context.view)

    def _take_point(self, point: np.ndarray) -> None:
        self.end_drawing()
        self.draft.set_place("spot", self.draft.of_ball(np.asarray(point)))

    def _take_path(self, corners: np.ndarray) -> None:
        self.end_drawing()
        surface = self.context.session.organ.surface
        if surface is None or self.draft.assessment is None:
            return
        points = [round_point(point) for point in follow_surface(surface, corners)]
        self.draft.set_place("line", {"organ": self.draft.organ_id, "path": points})

    # ------------------------------------------------------------ a hand that is recorded

    def _record(self) -> None:
        if self.runner.running or self.runner.waiting:
            self.runner.stop()
        else:
            self.end_drawing()
            self.runner.start(HandRequest())

    def _show_run(self) -> None:
        busy = self.runner.running or self.runner.waiting
        self.step_form.record.setChecked(busy)
        self.step_form.record.setText(
            tr("Stop: take the band") if busy else tr("Record from my hand")
        )
        if self.context.stage == self.stage:
            self.context.set_hint(tr("Do the step once with the mouse, then stop") if busy else "")

    def _take_outcome(self, outcome: Outcome) -> None:
        step = self.draft.step
        if step is None:
            return
        tool = self.draft.tools.get(str(step.get("tool")), {})
        row = int(tool.get("instrument", 0))
        values = find_bands(outcome.scene, outcome.record, str(step["do"]), row)
        if values is None:
            self.context.tell(tr("Nothing was pressed, so the band stays as it was."), "info")
        else:
            self.draft.set_step(values, "record")

    # ------------------------------------------------------------ numbers, hands

    def play(self) -> None:
        """A careful hand at the chosen level and seed."""
        known = self.context.assessment
        if known is None or known.scene is None:
            self.context.tell(tr("The organ is not compiled yet."), "info")
            return
        organ = self.context.session.organ
        work = CarefulWork(organ, known.scene, self.draft.level, self.draft.seed)
        title = tr("A careful hand plays")
        self.context.jobs.start(title, work, self._take_attempt, self.context.refuse)

    def _take_attempt(self, played: Attempt) -> None:
        self.line.show_attempt(played)
        self.show_played(played)

    def play_every(self) -> None:
        """All hands: some minutes."""
        known = self.context.assessment
        if known is None or known.scene is None:
            return
        work = EveryHandWork(self.context.session.organ, known.scene)
        title = tr("Hands play every level")
        self.context.jobs.start(title, work, self._take_every, self.context.refuse)

    def _take_every(self, tried: Report) -> None:
        if self.publishing is not None:
            self.publishing.tried = tried
        problems = tried["problems"]
        lines = [f"{problem['where']}: {problem['message']}" for problem in problems]
        good = tr("Careful hands finish, idle and violent ones do not.")
        self.played.setText("\n".join(lines) or good)
