# SPDX-License-Identifier: BSD-3-Clause
"""A live run of a scene with its devices, as a window or a script follows it. Knows no Qt."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import palpate

MOST_TICKS = 2**23
"""Of a record: 2 h 19 min at 1 kHz; kMostRows of core/sim/session/private/record_layout.h."""
LONGEST = MOST_TICKS / 1000
"""[s] of a record at 1 kHz; no script and no wait for a device lasts longer."""


def find_longest(scene: palpate.Scene) -> float:
    """[s] that a run can be recorded; the instruments share the rows of a record."""
    return MOST_TICKS // len(scene.instruments) / scene.rate


@dataclass(frozen=True, slots=True)
class Frame:
    """The world as the haptic thread last left it for others, at most 8 ms ago."""

    tick: int
    time: float
    """[s] of the run, in which a pause takes none."""
    positions: tuple[NDArray[np.float64], ...]
    """[m] (n, 3) of each body's tissue."""
    instruments: tuple[palpate.InstrumentSnapshot, ...]
    """Of each instrument and its device; of the first of them, the fields below."""
    tool_position: NDArray[np.float64]
    """[m] (3,)"""
    force: NDArray[np.float64]
    """[N] (3,) on the hand, as the device was sent it; none while its motors are not on."""
    touching: bool
    motors: palpate.MotorState
    """Of the device."""
    cost: float
    """[s] of the last tick."""
    lateness: float
    """[s] of the last tick."""
    substeps: tuple[int, ...]
    """Of each body, in the last tick."""
    safeguards: tuple[palpate.Safeguard, ...]
    """Of each body, in the last tick."""
    missed_ticks: int
    """Since the start."""
    sample: palpate.HapticSample
    """What the device said of the hand."""
    task: palpate.TaskState
    """How far the task is; without steps where there is none."""
    rigid: tuple[palpate.RigidSnapshot, ...] = ()
    """Where each rigid body is."""
    torn: tuple[NDArray[np.float32], ...] = ()
    """[-] (n,) of each body's vertices, 0 to 1: how far it has torn there; empty (0,) of a body
    that does not tear."""


def fit_record(options: palpate.LoopOptions, longest: float) -> palpate.LoopOptions:
    """The options with an end that a record of `longest` [s] reaches."""
    if options.duration > longest:
        raise ValueError(
            f"duration: got {options.duration:g} s, expected at most {longest:g} s, which a record "
            "holds"
        )
    if options.duration > 0.0:
        return options
    ending = copy(options)
    ending.duration = longest
    return ending


class LiveRun:
    """The 1 kHz loop over a scene, its record, and the newest frame to draw.

    One thread calls it. Nothing here holds up the haptic thread. As a context manager it starts,
    and finishes at the end.
    """

    def __init__(
        self,
        scene: palpate.Scene,
        device: palpate.HapticDevice | Sequence[palpate.HapticDevice],
        *,
        record: str | os.PathLike[str] | None = None,
        header: Mapping[str, object] | None = None,
        options: palpate.LoopOptions | None = None,
        task: palpate.Task | None = None,
    ):
        """`device` drives the instrument of the scene, or there is one for each of several, in
        their order. `record` is the .prec file to write and `header` what it says of the run;
        `options` are those of the loop. A recorded run without a duration ends when its record is
        full. Raises OSError where the record cannot be written, ValueError for a duration it cannot
        hold or another number of devices. `task`, of build_task with the scene, is judged, and ends
        the run when it is decided.
        """
        self.scene, self.device = scene, device
        self.record = None if record is None else Path(record)
        self._recorder: palpate.Recorder | None = None
        log = None
        options = options or palpate.LoopOptions()
        if record is not None:
            options = fit_record(options, find_longest(scene))
            self._recorder = palpate.Recorder(
                os.fspath(record),
                json.dumps(dict(header or {})),
                instruments=len(scene.instruments),
                bodies=len(scene.bodies),
            )
            log = self._recorder.log()
        self._loop = (
            palpate.Loop(scene, tuple(device), options, log, task)
            if isinstance(device, Sequence)
            else palpate.Loop(scene, device, options, log, task)
        )
        self._pausing = False

    @property
    def running(self) -> bool:
        """From start() until the end of the run; true while it is paused."""
        return self._loop.running()

    @property
    def paused(self) -> bool:
        """From pause() until resume()."""
        return self._pausing

    def start(self) -> None:
        """Raises RuntimeError the second time: a run is run once."""
        self._loop.start()

    def pause(self) -> None:
        """Within a tick: the device gets zero forces, and the time of the run stands still."""
        self._pausing = True
        self._loop.pause()

    def resume(self) -> None:
        """Goes on where it was paused; the force fades in as at the start."""
        self._pausing = False
        self._loop.resume()

    def wait(self, timeout: float) -> bool:
        """[s] True once the run has ended by itself, which one without a duration never does."""
        return self._loop.wait(timeout)

    def take_frame(self) -> Frame | None:
        """What is newer than the frame last taken, or None. Its arrays belong to the caller."""
        if not self._loop.take_snapshot():
            return None
        now = self._loop.snapshot()
        return Frame(
            now.tick,
            now.time,
            tuple(body.position for body in now.bodies),
            now.instruments,
            np.array(now.tool_position),
            np.array(now.force),
            now.touching,
            now.motors,
            now.cost,
            now.lateness,
            tuple(body.substeps for body in now.bodies),
            tuple(body.safeguard for body in now.bodies),
            now.missed_ticks,
            now.sample,
            now.task,
            now.rigid,
            tuple(body.torn for body in now.bodies),
        )

    def report(self) -> palpate.LoopReport:
        """Costs and faults so far."""
        return self._loop.report()

    def finish(self) -> palpate.LoopReport:
        """Stops the loop, completes the record, and says what the run cost. May be repeated.

        Raises OSError where the record could not be written.
        """
        self._loop.stop()
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            recorder.finish()
        return self._loop.report()

    def __enter__(self) -> LiveRun:
        self.start()
        return self

    def __exit__(self, *problem: object) -> None:
        self.finish()
