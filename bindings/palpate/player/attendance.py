# SPDX-License-Identifier: BSD-3-Clause
"""What goes with the attempts of a window: a brief, signals, what is kept, and a debrief."""

from __future__ import annotations

import json
import math
from pathlib import Path

from PySide6.QtCore import QObject

import palpate
from palpate.assessment.verdict import judge_goals
from palpate.command.verb import Report
from palpate.player.admission import Admission
from palpate.player.boards import Board
from palpate.player.debrief import Debriefed
from palpate.player.ghost import Ghost
from palpate.player.host import Host
from palpate.player.moment_replay import MomentReplay
from palpate.player.moments import Moment, Moments
from palpate.player.sentences import say_no_force, translate
from palpate.player.signals import Signals
from palpate.runs.kept_play import Keeper, describe_kept
from palpate.runs.live import Frame
from palpate.runs.next_attempt import has_next


class Attendance(QObject):
    """Of a scenario without a task that is judged it does nothing."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window, self.play, self.over = window, window.play, window.over
        self.moments = Moments(window.scene)
        self.found: list[Moment] = []
        self._before: list[Report] = []
        self._limits: list[str] = []
        self._count = 0
        self._came_from: Board = self.over.start
        self.admission = Admission(window, self)
        self.admission.admitted.connect(self._brief)
        self.signals = Signals(self.over, window.view, self)
        self.moment = MomentReplay(window, self)
        self.ghost = Ghost(window, self)
        self.ghost.ended.connect(self._show_start)
        start, debrief = self.over.start, self.over.debrief
        start.ghost.clicked.connect(self.ghost.show)
        start.ghost.setVisible(self.ghost.is_offered())
        start.history.clicked.connect(self.show_history)
        debrief.restart.clicked.connect(window.restart)
        debrief.another.clicked.connect(window.play_another)
        debrief.quit.clicked.connect(window.close)
        debrief.moment_wanted.connect(self.show_moment)
        debrief.see_history.clicked.connect(self.show_history)
        self.over.history.back.clicked.connect(self.leave_history)
        self.over.menu.sounds.chosen.connect(self._set_sounds)

    @property
    def keeper(self) -> Keeper | None:
        return self.admission.keeper

    @property
    def practising(self) -> bool:
        """Nothing is kept: records go with the window."""
        return self.admission.practice_folder is not None

    @property
    def judged(self) -> bool:
        return self.play.drawn is not None

    def may_begin(self) -> bool:
        """Not before a person has said who they are, and agreed or chosen practice."""
        return self.admission.may_play

    # ------------------------------------------------------------ before

    def _brief(self) -> None:
        """What comes before the first attempt: steps, limits, and the attempts before."""
        self._before = [] if self.keeper is None else self.keeper.list_before()
        folder = None if self.keeper is None else self.keeper.store.traces
        limits = self.play.say_limits()
        start = self.over.start
        start.tell_brief(limits, self._before, self._has_force(), folder)
        start.check.setVisible(self.judged)
        start.history.setVisible(bool(self._before))
        self._show_start()

    def _show_start(self) -> None:
        self.window.show_board(self.over.start)

    def _has_force(self) -> bool:
        return bool(self.play.arm) or not self.judged

    # ------------------------------------------------------------ a run

    def begin(self) -> Path | None:
        """Where the next record goes: the trace of an attempt whose row is on the disk now, or, of
        practice, what goes with the window; None where nobody was asked.
        """
        self.close()
        self.signals.reset()
        self._limits = self.play.say_limits()
        self.moments, self.found = Moments(self.window.scene), []
        folder = self.admission.practice_folder
        if folder is not None:
            self._count += 1
            return Path(folder) / f"{self._count}.prec"
        if self.keeper is None:
            return None
        self._before = self.keeper.list_before()
        return self.keeper.begin().trace

    def give_up(self) -> None:
        if self.keeper is not None:
            self.keeper.give_up()

    def take(self, frame: Frame) -> None:
        """A frame that is drawn."""
        if self.judged:
            self.moments.take(frame)
            self.signals.take(frame.task, self._limits)
            self.over.force.show_task(*self._find_force(frame.task))

    def _find_force(self, state: palpate.TaskState) -> tuple[tuple[float, float] | None, float]:
        """[N] The band of the step that is to be done now, and the least limit of force."""
        assert self.play.drawn is not None
        task = self.play.drawn.task
        active = [n for n, step in enumerate(state.steps)
                  if step.status is palpate.StepStatus.active]  # fmt: skip
        band = None
        if active:
            force = task.steps[active[0]].force
            if math.isfinite(force.least) or math.isfinite(force.most):
                band = force.least, force.most
        bounds = [
            limit.bound for limit in task.limits
            if limit.measure is palpate.TaskMeasure.force and limit.above and limit.place < 0
            and (not limit.during or set(limit.during) & set(active))
        ]  # fmt: skip
        return band, min(bounds, default=math.inf)

    def end(self, record: Path, costs: palpate.LoopReport) -> None:
        """A run is over and its record complete. Raises OSError where its verdict is not kept."""
        self.signals.fade()
        state = self.play.state
        if state is not None:
            self.found = self.moments.finish([limit.duration for limit in state.limits])
        if self.keeper is None or self.keeper.begun is None:
            return
        if state is None or costs.ticks == 0:
            self.keeper.give_up()
        else:
            self.keeper.end(describe_kept(self.play, record, costs, state))

    def debrief(self) -> Board | None:
        """What is said of it; None where there was no task."""
        state = self.play.state
        if not self.judged or state is None:
            return None
        assert self.play.drawn is not None
        assessment = json.loads(self.play.scenario.assessment)
        kept = (
            self._say_practice()
            if self.keeper is None
            else translate("Player", "Kept in %1").replace("%1", str(self.keeper.store.path))
        )
        if not self._has_force():
            kept += "\n" + say_no_force()
        self.over.debrief.tell(
            Debriefed(
                state=state,
                goals=judge_goals(self.play.drawn, state, assessment),
                limits=self.play.say_limits(),
                moments=self.found,
                history=self._before,
                kept=kept,
            )
        )
        self.over.debrief.another.setVisible(has_next(self.play))
        self.over.debrief.see_history.setVisible(self.keeper is not None)
        return self.over.debrief

    def _say_practice(self) -> str:
        return translate("Player", "Practice: nothing was kept.") if self.practising else ""

    # ------------------------------------------------------------ afterwards

    def show_moment(self, number: int) -> None:
        """Once more, as it was seen."""
        if number < len(self.found):
            self.moment.show(self.found[number])

    def show_history(self) -> None:
        """All attempts of the person so far."""
        board = self.over.board()
        if self.keeper is None or board is None:
            return
        self._came_from = board
        self.over.history.tell(self.keeper.list_history(), self.window.theme)
        self.window.show_board(self.over.history)

    def leave_history(self) -> None:
        if self.over.board() is self.over.history:
            self.window.show_board(self._came_from)

    def leave(self) -> bool:
        """Esc: ends what is shown over the brief or the debrief; False where nothing is."""
        for shown in (self.ghost, self.moment):
            if shown.busy:
                shown.stop()
                return True
        if self.admission.check.busy:
            self.admission.check.leave()
            return True
        if self.over.board() is self.over.history:
            self.leave_history()
            return True
        return False

    def close(self) -> None:
        """The window goes."""
        self.ghost.close()
        self.moment.close()
        self.admission.check.close()

    def _set_sounds(self, code: str) -> None:
        self.signals.audible = code == "on"
