# SPDX-License-Identifier: BSD-3-Clause
"""What is seen and said of a run that goes on, frame by frame."""

from __future__ import annotations

import numpy as np

import palpate
from palpate.player.attendance import Attendance
from palpate.player.host import Host
from palpate.player.sentences import name_wrong, say_damped, say_forces, say_held, say_slow
from palpate.runs.live import Frame
from palpate.runs.pinch import find_pinches
from palpate.runs.stretch import StretchGauge
from palpate.viewport import show_frame

SLOW = 0.02
"""[-] share of missed ticks in a second that the trainee is told of."""
ARROW = 0.8
"""[-] length of the arrow that stands for a full column of force, in radii of the organ."""


class RunView:
    """In the window of a trainee."""

    def __init__(self, window: Host, attendance: Attendance):
        self._window, self._over = window, window.over
        self._attendance = attendance
        self._gauge: StretchGauge | None = None
        self.reset()

    def reset(self) -> None:
        """Another run begins."""
        self.time = self.force = 0.0
        """[s] of the run, and [N] on the hand, as last seen."""
        self._second = self._missed = self._damped = 0
        self._window.marks.show_first()

    def show(self, frame: Frame) -> None:
        view, scene, over = self._window.view, self._window.scene, self._over
        self.time = frame.time
        show_frame(view, scene, frame)
        self._window.marks.show(frame)
        view.force_scale = ARROW * view.scenery.radius / over.force.range
        view.show_force(frame.tool_position, frame.force)
        self.force = float(np.linalg.norm(frame.force))
        self._show_forces(frame)
        over.clock.show_time(frame.time)
        self.tell_steps(frame.task)
        self._attendance.take(frame)
        if int(frame.time) != self._second:
            self._second = int(frame.time)
            missed, self._missed = frame.missed_ticks - self._missed, frame.missed_ticks
            held = say_held(max(frame.safeguards))
            over.warning.tell(held or self._say_trouble(missed, self._count_damped(frame)))
            over.place()

    def _show_forces(self, frame: Frame) -> None:
        """Of each instrument, where there are several, and of what its jaws hold."""
        drawn = self._window.play.drawn
        scene = self._window.scene
        if self._gauge is None or self._gauge.scene is not scene:
            self._gauge = StretchGauge(scene)
        pinches = find_pinches(frame, None if drawn is None else drawn.task, self._gauge)
        wrong = name_wrong(pinches, several=len(frame.instruments) > 1)
        rows, hud = say_forces(frame, pinches), self._window.view.hud
        more = len(rows) != len(hud.rows)
        hud.show_rows(rows, wrong)
        if more:  # banners stand below it
            self._over.place()

    def show_last(self, frame: Frame) -> None:
        """The one with which it ended: what has moved since is seen no more."""
        self.time = frame.time
        self._over.clock.show_time(frame.time)
        self.tell_steps(frame.task)
        self._attendance.take(frame)

    def tell_steps(self, state: palpate.TaskState) -> None:
        """Marks on the task card what is done and what is to be done now."""
        play = self._window.play
        if play.drawn is None:
            return
        before, play.state = play.state, state
        now = [step.status for step in state.steps]
        if before is None or now != [step.status for step in before.steps]:
            self._over.tell_task()
            self._over.place()

    def _count_damped(self, frame: Frame) -> int:
        """Interventions of the passivity controllers since this was asked last."""
        count = sum(instrument.interventions for instrument in frame.instruments)
        since, self._damped = count - self._damped, count
        return since

    def _say_trouble(self, missed: int, damped: int) -> str:
        """Of the last second."""
        due = round(self._window.scene.rate)
        if missed > SLOW * due:
            return say_slow(missed, due)
        return say_damped(damped) if damped > 0 else ""
