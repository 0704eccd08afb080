# SPDX-License-Identifier: BSD-3-Clause
"""The worst moments of a run: what was seen from two seconds before a limit was passed on."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.live import Frame
from palpate.scene.surfaces import join_positions, join_torn
from palpate.viewport.instruments import SeenInstrument, see_instruments

BEFORE, AFTER = 2.0, 1.0
"""[s] of a moment."""
KEPT = 2
"""Moments: those with the longest time beyond a limit."""


@dataclass(frozen=True)
class Shot:
    """One picture of a run."""

    time: float
    """[s] of the run"""
    surface: NDArray[np.float32]
    """[m] (n, 3)"""
    tip: NDArray[np.float64]
    """[m]"""
    instruments: list[SeenInstrument]
    force: NDArray[np.float64]
    """[N]"""
    rigid: tuple[palpate.RigidSnapshot, ...] = ()
    torn: NDArray[np.float32] | None = None
    """[-] (n,), as Frame.torn of all bodies; None where none of them tears"""


@dataclass
class Moment:
    """Where a limit was passed."""

    limit: int
    """of the task"""
    time: float
    """[s] of the run"""
    duration: float = 0.0
    """[s] beyond the limit"""
    shots: list[Shot] = field(default_factory=list)


class Moments:
    """Takes the frames of a run as they are drawn, and keeps those around its worst moments."""

    def __init__(self, scene: palpate.Scene) -> None:
        self._scene = scene
        self.found: list[Moment] = []
        self._last: deque[Shot] = deque()
        self._counts: list[int] = []
        self._durations: list[float] = []
        self._open: list[Moment] = []

    def take(self, frame: Frame) -> None:
        limits = frame.task.limits
        if not limits:
            return
        surface = np.asarray(join_positions(frame.positions), dtype=np.float32)
        seen = see_instruments(self._scene, frame)
        torn = join_torn(frame.torn, frame.positions)
        shot = Shot(frame.time, surface, frame.tool_position, seen, frame.force, frame.rigid, torn)
        self._last.append(shot)
        while self._last and frame.time - self._last[0].time > BEFORE:
            self._last.popleft()
        counts = [limit.count for limit in limits]
        before = self._counts or [0] * len(counts)
        since = self._durations or [0.0] * len(counts)
        for number, (now, then) in enumerate(zip(counts, before, strict=True)):
            if now > then:
                made = Moment(number, frame.time, -since[number], list(self._last))
                self._open.append(made)
        self._counts = counts
        self._durations = [limit.duration for limit in limits]
        for moment in list(self._open):
            if moment.shots[-1] is not shot:
                moment.shots.append(shot)
            if frame.time - moment.time > AFTER:
                self._close(moment, limits[moment.limit].duration)

    def finish(self, durations: list[float]) -> list[Moment]:
        """The worst first; [s] of each limit in all, at the end of the run."""
        for moment in list(self._open):
            self._close(moment, durations[moment.limit])
        return self.found

    def _close(self, moment: Moment, duration: float) -> None:
        self._open.remove(moment)
        moment.duration += duration
        self.found.append(moment)
        self.found.sort(key=lambda each: -each.duration)
        del self.found[KEPT:]
