# SPDX-License-Identifier: GPL-3.0-or-later
"""Begins and ends live runs of the open organ, and keeps what the last one felt."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
from numpy.typing import NDArray
from palpate.runs.cause import Cause
from palpate.runs.element import Element
from palpate.runs.live import Frame
from palpate.runs.other_hands import park
from palpate.runs.press import (
    Place,
    PressScript,
    PressTimes,
    find_place,
    find_top,
    has_jaws,
    write_script,
)
from palpate.viewport import FboView, GLView, PointerHands, ViewTool
from PySide6.QtCore import QObject, Signal

from palpate_editor.compile import is_built_alike
from palpate_editor.document import Organ
from palpate_editor.document.problems import Problem
from palpate_editor.views.budget_bar import find_budget
from palpate_editor.views.context import Context
from palpate_editor.views.touch.alarm_work import make_problem, plan_cause_work
from palpate_editor.views.touch.force_plot import ForcePlot
from palpate_editor.views.touch.live_costs import LiveCosts
from palpate_editor.views.touch.results import Outcome, read_felt
from palpate_editor.views.touch.trial import Trial, advise, describe_averted, describe_end
from palpate_editor.views.translations import say, tr

MEASURED = 30
"""Frames from one showing of what the parts of a run cost to the next, half a second."""


@dataclass(frozen=True)
class HandRequest:
    """A run with the mouse as the hand."""


@dataclass(frozen=True)
class PressRequest:
    """A run of a script."""

    script: PressScript
    place: NDArray[np.float64] | None
    """[m] (3,) near which the surface is pressed; None for the top."""


class Runner(QObject):
    """One run at a time. Whatever ends it, the view shows the organ at rest again."""

    changed = Signal()
    """It waits, runs, is paused or has ended."""
    ended = Signal(object)
    """An Outcome."""
    measured = Signal(object)
    """A Budget: what the parts of the run have cost so far."""

    def __init__(
        self, context: Context, plot: ForcePlot, costs: LiveCosts, parent: QObject | None = None
    ):
        super().__init__(parent)
        self.context, self.plot, self.costs = context, plot, costs
        self.request: HandRequest | PressRequest | None = None
        """What waits for the organ to be compiled, or runs."""
        self.trial: Trial | None = None
        self._organ: Organ | None = None
        self._script: tuple[Place, PressTimes] | None = None
        self._tool_before: ViewTool[GLView] | ViewTool[FboView] | None = None
        self._name, self._count, self._frames = "", 0, 0
        self._folder = tempfile.TemporaryDirectory(prefix="palpate-test-")
        context.session.changed.connect(self._on_changed)
        context.assessed.connect(self._on_assessed)

    @property
    def running(self) -> bool:
        """Also while it is paused."""
        return self.trial is not None

    @property
    def waiting(self) -> bool:
        """Started, and the organ is still being compiled."""
        return self.request is not None and self.trial is None

    @property
    def paused(self) -> bool:
        return self.trial is not None and self.trial.paused

    # ------------------------------------------------------------ what a person asks for

    def start(self, request: HandRequest | PressRequest) -> None:
        """Begins as soon as the organ is compiled; another run is ended first."""
        self.stop()
        if self.context.session.organ.surface is None:
            self.context.tell(tr("There is no organ to test yet: import a mesh file first."))
            return
        self.request = request
        self.changed.emit()
        self._on_assessed()

    def toggle_pause(self) -> None:
        """Pauses a run, or goes on."""
        if self.trial is None:
            return
        if self.trial.paused:
            self.trial.resume()
        else:
            self.trial.pause()
        self.changed.emit()

    def stop(self) -> None:
        """Ends the run, or the wait for it."""
        if self.trial is not None:
            self._end(self.trial.finish())
        elif self.request is not None:
            self.request = None
            self.changed.emit()

    def reset(self) -> None:
        """The same run from the beginning, from rest."""
        request = self.request
        if request is not None:
            self.start(request)

    # ------------------------------------------------------------ beginning

    def _on_assessed(self) -> None:
        found, organ = self.context.assessment, self.context.session.organ
        if self.request is None or self.trial is not None or found is None:
            return
        if found.organ is not organ:
            return
        if found.scene is None:
            self.request = None
            self.context.tell(describe_refusal(found.problems))
            self.changed.emit()
            return
        self._begin(organ, found.scene, self.request)

    def _begin(
        self, organ: Organ, scene: palpate.Scene, request: HandRequest | PressRequest
    ) -> None:
        self._count += 1
        duration, self._script = 0.0, None
        count = len(scene.instruments)
        if isinstance(request, HandRequest):
            devices = [palpate.SurfacePointer(scene, 0, i) for i in range(count)]
            self._name = tr("Hand {count}").format(count=self._count)
        else:
            place = find_target(scene, request.place)
            frames, times = write_script(
                place, scene.instruments[0].tool.radius, request.script, has_jaws(scene)
            )
            waiting = [palpate.KeyFrame(0.0, park(scene, i)) for i in range(1, count)]
            devices = [palpate.ScriptedDevice(each) for each in (frames, *([w] for w in waiting))]
            duration = times.end
            self._script = place, times
            self._name = tr("Press {count}").format(count=self._count)
        record = Path(self._folder.name) / f"run{self._count}.prec"
        view = self.context.view
        try:
            self.trial = Trial(view, scene, devices, record, duration, self)
        except OSError as problem:
            self.request = None
            self.context.refuse(problem)
            self.changed.emit()
            return
        self._organ = organ
        self.trial.framed.connect(self._take_frame)
        self.trial.ended.connect(self._end)
        self._tool_before = view.tool
        if isinstance(request, HandRequest):
            view.tool = PointerHands(view, list(enumerate(devices)), scene)
        self._frames = 0
        self.plot.begin(self._name)
        self.costs.clear()
        facts = self.context.assessment.tissue
        if facts is not None and facts.margin:
            self.costs.show_margin(1.0 / scene.rate / scene.bodies[0].substeps, facts.margin)
        self.trial.start()
        self.changed.emit()

    def _take_frame(self, frame: Frame) -> None:
        self.plot.add(frame.time, frame.force)
        self.costs.show_frame(frame, self.trial.scene.rate)
        self._frames += 1
        if self._frames % MEASURED == 0:
            self._tell_costs(self.trial.run.report(), self.trial.scene.rate)

    def _tell_costs(self, report: palpate.LoopReport, rate: float) -> None:
        budget = find_budget(report.part_costs, rate, self._organ)
        if budget is not None:
            self.measured.emit(budget)

    # ------------------------------------------------------------ ending

    def _end(self, report: palpate.LoopReport) -> None:
        trial, self.trial, self.request = self.trial, None, None
        view = self.context.view
        if isinstance(view.tool, PointerHands):
            view.tool = self._tool_before
            view.hint.say(None)
        trial.clear_view()
        trial.deleteLater()
        self.costs.show_report(report, trial.scene.rate)
        self._tell_costs(report, trial.scene.rate)
        outcome = self._read_outcome(trial, report)
        if outcome is None:
            self.plot.finish()
        else:
            self.plot.finish(outcome.time, outcome.force)
        trial.record.unlink(missing_ok=True)
        problem = describe_end(report)
        if problem is not None:
            self.context.tell(problem)
            self._find_cause(trial.scene, report, outcome)
        elif (averted := describe_averted(report)) is not None:
            self.context.tell(averted)
            self._find_cause(trial.scene, report, outcome)
        elif is_built_alike(self.context.session.organ, self._organ):
            self.context.session.mark_tested()
            self.context.assessor.begin()
        self.changed.emit()
        if outcome is not None:
            self.ended.emit(outcome)

    def _find_cause(
        self, scene: palpate.Scene, report: palpate.LoopReport, outcome: Outcome | None
    ) -> None:
        """Advice, where the run ended in an alarm or would have; trials take seconds."""
        if all(each.kind == palpate.AlarmKind.none for each in (report.alarm, report.averted)):
            return
        record = None if outcome is None else outcome.record
        self.context.jobs.start_unseen(
            "cause of an alarm",
            plan_cause_work(scene, report, record),
            self._advise,
            self.context.refuse,
        )

    def _advise(self, found: tuple[palpate.LoopReport, Cause | None, Element | None]) -> None:
        report, cause, element = found
        self.context.tell(advise(report, cause, element))
        surface = self.context.session.organ.surface
        if element is not None and surface is not None:
            self.context.look_wanted.emit(make_problem(element, surface))

    def _read_outcome(self, trial: Trial, report: palpate.LoopReport) -> Outcome | None:
        try:
            if trial.problem is not None:
                raise trial.problem
            record = palpate.read_record(str(trial.record))
        except OSError as problem:
            self.context.refuse(problem)
            return None
        if len(record.hand) == 0:
            return None
        script = self._script
        if script is not None and np.max(record.hand["time"]) < script[1].held:
            script = None  # it was stopped before it could be measured
        felt = read_felt(record, trial.scene.instruments[0].tool.radius, script)
        device = trial.device.name()
        return Outcome(self._name, self._organ, trial.scene, record, report, device, felt)

    def _on_changed(self, before: Organ, after: Organ) -> None:
        del before
        if self.trial is not None and not is_built_alike(after, self._organ):
            self.stop()
            self.context.tell(
                tr("The run was stopped because the organ was changed. Start it again."), "info"
            )


def find_target(scene: palpate.Scene, near: NDArray[np.float64] | None) -> Place:
    """Where a script presses: near a point [m], or at the top."""
    return find_top(scene) if near is None else find_place(scene, near)


def describe_refusal(problems: Sequence[Problem]) -> str:
    """Why an organ has no scene: the first error."""
    red = [p for p in problems if p.severity == "error" and p.stage != "publish"]
    if not red:
        return tr("The organ cannot be tested yet.")
    return tr("The organ cannot be tested yet: got {got}, expected {expected}.").format(
        got=say(red[0].got), expected=say(red[0].expected)
    )
