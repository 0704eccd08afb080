# SPDX-License-Identifier: BSD-3-Clause
"""Whose attempts a window plays, what is kept of them, and what is said after each."""

from __future__ import annotations

import json
import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import QObject, QTimer

import palpate
from palpate.assessment.verdict import judge_goals
from palpate.command.verb import Report, WrongCall
from palpate.files.refusal import Refusal
from palpate.player.boards import Board
from palpate.player.debrief import Debriefed
from palpate.player.moments import Moment, Moments
from palpate.player.overlays import Overlays
from palpate.player.sentences import say_no_force, translate
from palpate.runs.kept_play import Keeper, describe_kept, open_store
from palpate.runs.live import Frame
from palpate.runs.play import Play
from palpate.translation.refusals import say_refusal
from palpate.viewport import View

if TYPE_CHECKING:
    from palpate.records.people import Person
    from palpate.records.store import Store

SHOT_MS = 33
"""[ms] between two pictures of a moment that is shown again."""


class Host(Protocol):
    """What it needs of the window."""

    play: Play
    over: Overlays
    view: View
    scene: palpate.Scene
    language: str

    def show_board(self, board: Board | None) -> None: ...
    def use_language(self, code: str) -> None: ...
    def restart(self) -> None: ...
    def close(self) -> bool: ...


class Attendance(QObject):
    """Of a scenario without a task that is judged it does nothing."""

    def __init__(self, window: Host, parent: QObject):
        super().__init__(parent)
        self.window, self.play, self.over = window, window.play, window.over
        self.keeper: Keeper | None = None
        self.moments = Moments()
        self.found: list[Moment] = []
        self._store: Store | None = None
        self._person: Person | None = None
        self._before: list[Report] = []
        self._practice: tempfile.TemporaryDirectory[str] | None = None
        self._count = 0
        self._shots: list[int] = []
        """Which picture of which moment is shown, where one is."""
        self._timer = QTimer(self, interval=SHOT_MS)
        self._timer.timeout.connect(self._show_shot)
        who, consent = self.over.who, self.over.consent
        who.code_entered.connect(self._take_code)
        who.new_wanted.connect(self._take_new)
        who.guest_wanted.connect(self._take_guest)
        who.practice_wanted.connect(self._practise)
        who.languages.chosen.connect(window.use_language)
        consent.agreed.connect(self._agree)
        consent.declined.connect(self._practise)
        self.over.debrief.restart.clicked.connect(window.restart)
        self.over.debrief.quit.clicked.connect(window.close)
        self.over.debrief.moment_wanted.connect(self.show_moment)

    @property
    def practising(self) -> bool:
        """Nothing is kept: records go with the window."""
        return self._practice is not None

    @property
    def judged(self) -> bool:
        return self.play.drawn is not None

    def first_board(self) -> Board:
        """Who plays, where that is asked."""
        asked = self.judged and self.keeper is None and not self.play.hand and not self.play.frames
        return self.over.who if asked else self.over.start

    def use(self, keeper: Keeper) -> None:
        """The attempts of a person who was named before the window."""
        self.keeper = keeper
        self._brief()

    # ------------------------------------------------------------ who

    def _open(self) -> Store | None:
        try:
            self._store = self._store or open_store()
        except (OSError, Refusal) as problem:
            text = translate("Player", "The database cannot be used, so nothing can be kept: %1")
            self.over.who.refuse(text.replace("%1", say_refusal(str(problem))))
            self.over.place()
        return self._store

    def _take_code(self, code: str) -> None:
        from palpate.records.people import find_person

        store = self._open()
        if store is None:
            return
        self._person = find_person(store, code)
        if self._person is None:
            text = translate("Player", "Nobody has the code %1 on this computer.")
            self.over.who.refuse(text.replace("%1", code))
            self.over.place()
        elif self._person.practice:
            self._keep()
        else:
            self._ask("")

    def _take_new(self) -> None:
        self._add(guest=False)

    def _take_guest(self) -> None:
        self._add(guest=True)

    def _add(self, guest: bool) -> None:
        from palpate.records.people import add_person

        store = self._open()
        if store is not None:
            self._person = add_person(store, guest)
            self._ask(self._person.code or "")

    def _ask(self, code: str) -> None:
        self.over.consent.tell(self.window.language, code)
        self.window.show_board(self.over.consent)

    def _agree(self) -> None:
        from palpate.records.people import give_consent

        assert self._store is not None and self._person is not None
        self._person = give_consent(self._store, self._person, self.window.language)
        self._keep()

    def _keep(self) -> None:
        assert self._store is not None and self._person is not None
        try:
            self.keeper = Keeper(self._store, self._person, self.play)
        except (OSError, WrongCall) as problem:
            self.over.who.refuse(str(problem))
            return
        self._brief()

    def _practise(self) -> None:
        self.keeper = self._person = None
        self._practice = tempfile.TemporaryDirectory(prefix="palpate-practice-")
        self._brief()

    def _brief(self) -> None:
        """What comes before the first attempt: steps, limits, and the attempts before."""
        self._before = [] if self.keeper is None else self.keeper.list_before()
        folder = None if self.keeper is None else self.keeper.store.traces
        limits = self.play.say_limits()
        self.over.start.tell_brief(limits, self._before, self._has_force(), folder)
        self.window.show_board(self.over.start)

    def _has_force(self) -> bool:
        return bool(self.play.arm) or not self.judged

    # ------------------------------------------------------------ a run

    def begin(self) -> Path | None:
        """Where the next record goes: the trace of an attempt whose row is on the disk now, or, of
        practice, what goes with the window; None where nobody was asked.
        """
        self._timer.stop()
        self.moments, self.found = Moments(), []
        if self._practice is not None:
            self._count += 1
            return Path(self._practice.name) / f"{self._count}.prec"
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
        return self.over.debrief

    def _say_practice(self) -> str:
        return translate("Player", "Practice: nothing was kept.") if self.practising else ""

    # ------------------------------------------------------------ moments

    def show_moment(self, number: int) -> None:
        """Once more, as it was seen."""
        self._shots = [number, 0]
        self.window.show_board(None)
        self._timer.start()

    def _show_shot(self) -> None:
        number, at = self._shots
        shots = self.found[number].shots if number < len(self.found) else []
        view = self.window.view
        if at >= len(shots):
            self._timer.stop()
            view.show_force(None)
            self.window.show_board(self.over.debrief)
            return
        shot = shots[at]
        view.move_surface(shot.surface)
        view.show_tool(shot.tip, self.window.scene.instruments[0].tool.radius)
        view.show_force(shot.tip, shot.force)
        self.over.clock.show_time(shot.time)
        self._shots = [number, at + 1]
