# SPDX-License-Identifier: BSD-3-Clause
"""The check of a device before attempts that count: hold still, touch three targets, press a wall,
press the stop button; the link, the picture and the ticks meanwhile. Knows no Qt.

The limits are chosen here, by no study: what a person would feel or see as broken.
"""

from __future__ import annotations

import enum
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.command.verb import Report
from palpate.runs.felt import read_column
from palpate.runs.live import Frame
from palpate.scene.pair_friction import keep_pairs

Array = NDArray[np.float64]


class Stage(enum.Enum):
    """What the hand is asked to do."""

    still = "still"
    targets = "targets"
    wall = "wall"
    stop = "stop"
    over = "over"


LENGTHS = {Stage.still: 2.0, Stage.targets: 9.0, Stage.wall: 7.0, Stage.stop: 6.0}
"""[s] of each stage at most; 24 s together."""
HALF, EDGE = 0.045, 0.0075
"""[m] half a side of the wall, and of the squares it is made of"""
BELOW = 0.01
"""[m] of the wall below the middle of the organ"""
TARGETS = ((-0.03, 0.0), (0.03, 0.0), (0.0, 0.03))
"""[m] on the wall, from its middle, in the order in which they are touched"""
REACH = 0.012
"""[m] of the tip beside a target that still counts"""
PRESSED = (0.6, 2.0)
"""[N] in which the wall is to be pressed"""
PRESS_TIME = 1.0
"""[s]"""
SMOOTHED = 50
"""[ticks] of the mean that noise is measured against"""
NOISE, DRIFT, BUZZ = 1e-4, 5e-3, 3e-4
"""[m] Root mean square of noise, drift of a hand that holds still, and of a tip at the wall"""
FORCE_ERROR = 0.2
"""[-] of the force that the motors should give"""
LOSS, ROUND_TRIP = 0.01, 20e-3
"""[-] of the reports, and [s]"""
LEAST_FPS, LATE = 24.0, 200e-6
"""[1/s] pictures, and [s] that 99 of 100 ticks are not later than"""


def build_wall(scene: palpate.Scene) -> palpate.Scene:
    """A level square that does not give way, under the middle of the scene's tissue, with the first
    tool of the scene, whose device is checked. What is felt there is the stiffness of the coupling
    and the tool alone.
    """
    x = np.concatenate([np.asarray(body.tissue.rest_position) for body in scene.bodies])
    middle = 0.5 * (x.min(axis=0) + x.max(axis=0)) - [0.0, 0.0, BELOW]
    line = np.arange(-HALF, HALF + 0.5 * EDGE, EDGE)
    grid = np.stack([*np.meshgrid(line, line, indexing="xy")], axis=-1).reshape(-1, 2)
    points = np.column_stack([grid, np.zeros(len(grid))]) + middle
    n = len(line)
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    first = np.column_stack([corner, corner + 1, corner + n])
    second = np.column_stack([corner + 1, corner + n + 1, corner + n])
    tissue = palpate.TissueModel(
        rest_position=points,
        mass=np.full(len(points), 1e-3),
        fixed=np.arange(len(points)),
        triangles=np.concatenate([first, second]),
    )
    body = palpate.SoftBody(tissue=tissue)
    return palpate.build_scene(
        palpate.Scene(bodies=[body], instruments=keep_pairs(scene.instruments[:1]), rate=scene.rate)
    )


@dataclass
class DeviceCheck:
    """Follows a run on the wall, frame by frame, and says at its end what was found."""

    scene: palpate.Scene
    """Of build_wall."""
    read_status: Callable[[], palpate.DeviceStatus] | None = None
    """Of the arm; None where the device gives no status."""
    stage: Stage = Stage.still
    since: float = 0.0
    """[s] of the run when the stage began"""
    target: int = 0
    """The next one of TARGETS."""
    stopped: bool = False
    """The stop button was seen pressed."""
    spans: dict[Stage, tuple[float, float]] = field(default_factory=dict)
    """[s] of the run, of each stage that is over"""
    done: dict[Stage, bool] = field(default_factory=dict)
    """Whether the hand has done what a stage asks for."""
    ratios: list[float] = field(default_factory=list)
    """[-] applied by commanded force, while the wall was pressed"""
    _pressed_since: float | None = None

    @property
    def middle(self) -> Array:
        """[m] (3,) of the wall."""
        x = np.asarray(self.scene.bodies[0].tissue.rest_position)
        return 0.5 * (x.min(axis=0) + x.max(axis=0))

    def place(self, target: int) -> Array:
        """[m] (3,) of a target."""
        return self.middle + [*TARGETS[target], 0.0]

    @property
    def over(self) -> bool:
        return self.stage is Stage.over

    def take(self, frame: Frame, clock: float, cut: bool) -> None:
        """A frame; `clock` [s] goes on while the run rests because its motors are `cut`."""
        if self.over:
            return
        if self.stage is Stage.targets:
            self._take_target(frame)
        elif self.stage is Stage.wall:
            self._take_press(frame)
        elif self.stage is Stage.stop:
            self.stopped = self.stopped or cut
            self.done[Stage.stop] = self.stopped and not cut
        elif self.stage is Stage.still:
            self.done[Stage.still] = clock - self.since >= LENGTHS[Stage.still]
        if self.done.get(self.stage) or clock - self.since >= LENGTHS[self.stage]:
            self._go_on(clock)

    def take_rest(self, clock: float) -> None:
        """No frame, for the run rests: its motors are cut."""
        self.stopped = self.stopped or self.stage is Stage.stop
        if not self.over and clock - self.since >= LENGTHS[self.stage]:
            self._go_on(clock)

    def _take_target(self, frame: Frame) -> None:
        side = np.asarray(frame.tool_position) - self.place(self.target)
        if frame.touching and np.hypot(side[0], side[1]) <= REACH:
            self.target += 1
            self.done[Stage.targets] = self.target == len(TARGETS)

    def _take_press(self, frame: Frame) -> None:
        force = float(np.linalg.norm(frame.force))
        if not PRESSED[0] <= force <= PRESSED[1]:
            self._pressed_since = None
            return
        if self._pressed_since is None:
            self._pressed_since = frame.time
        if self.read_status is not None:
            status = self.read_status()
            wanted = float(np.linalg.norm(status.force_commanded))
            if wanted > 0.0:
                self.ratios.append(float(np.linalg.norm(status.force_applied)) / wanted)
        self.done[Stage.wall] = frame.time - self._pressed_since >= PRESS_TIME

    def _go_on(self, clock: float) -> None:
        self.spans[self.stage] = self.since, clock
        self.done.setdefault(self.stage, False)
        order = list(Stage)
        following = order[order.index(self.stage) + 1]
        if following is Stage.stop and self.read_status is None:
            following = Stage.over
        self.stage, self.since = following, clock

    # ------------------------------------------------------------ what was found

    def describe(
        self, record: palpate.Record, costs: palpate.LoopReport, fps: float, with_force: bool
    ) -> Report:
        """What a session keeps: each check with value and bound, the fault of a device that ended
        the check early, and whether all are met.
        """
        checks = [
            tell("display", fps, "1/s", LEAST_FPS, fps >= LEAST_FPS),
            tell("ticks", costs.lateness.p99, "s", LATE, costs.lateness.p99 <= LATE),
        ]
        if not with_force:
            return finish(checks, False, costs.fault)
        if self.read_status is not None:
            status = self.read_status()
            lost = status.lost_reports / max(1, status.reports)
            trip = status.round_trip_p99
            checks += [
                tell("link_loss", lost, "-", LOSS, lost <= LOSS),
                tell("round_trip", trip, "s", ROUND_TRIP, 0.0 < trip <= ROUND_TRIP),
            ]
        tips = np.asarray(read_column(record, "hand", "position"), dtype=float)
        second = round(self.scene.rate)
        # not the first: the motors come on, and the hand finds its place
        noise, drift = measure_rest(tips[self.find_rows(Stage.still, len(tips))][-second:])
        buzz = float("inf")
        if self.done.get(Stage.wall, False):
            buzz, _ = measure_rest(tips[self.find_rows(Stage.wall, len(tips))][-second:])
        checks += [
            tell("noise", noise, "m", NOISE, noise <= NOISE),
            tell("drift", drift, "m", DRIFT, drift <= DRIFT),
            tell("targets", self.target, "-", len(TARGETS), self.done.get(Stage.targets, False)),
            tell("wall", PRESS_TIME if self.done.get(Stage.wall) else 0.0, "s", PRESS_TIME,
                 self.done.get(Stage.wall, False)),
            tell("buzz", buzz, "m", BUZZ, buzz <= BUZZ),
        ]  # fmt: skip
        if self.read_status is not None:
            off = abs(float(np.median(self.ratios)) - 1.0) if self.ratios else 1.0
            stop = self.done.get(Stage.stop, False)
            checks += [
                tell("force", off, "-", FORCE_ERROR, off <= FORCE_ERROR),
                tell("stop", float(self.stopped), "-", 1.0, stop),
            ]
        return finish(checks, True, costs.fault)

    def find_rows(self, stage: Stage, count: int) -> slice:
        """Of a record, those of a stage."""
        start, end = self.spans.get(stage, (0.0, 0.0))
        rate = self.scene.rate
        return slice(min(round(start * rate), count), min(round(end * rate), count))


def measure_rest(tips: Array) -> tuple[float, float]:
    """[m] The noise of a tip that is to rest, root mean square about its mean of 50 ms, and its
    drift from the first quarter of a second to the last.
    """
    if len(tips) <= SMOOTHED:
        return float("inf"), float("inf")
    window = np.full(SMOOTHED, 1.0 / SMOOTHED)
    smooth = np.column_stack([np.convolve(tips[:, k], window, "valid") for k in range(3)])
    start = (SMOOTHED - 1) // 2
    off = tips[start : start + len(smooth)] - smooth
    quarter = min(250, len(tips) // 2)
    drift = np.linalg.norm(tips[-quarter:].mean(axis=0) - tips[:quarter].mean(axis=0))
    return float(np.sqrt((off**2).sum(axis=1).mean())), float(drift)


def tell(name: str, value: float, unit: str, bound: float, ok: bool) -> Report:
    finite = float(value) if np.isfinite(value) else None
    return {"name": name, "value": finite, "unit": unit, "bound": float(bound), "ok": bool(ok)}


def is_broken(fault: palpate.DeviceFault) -> bool:
    """A check cannot go on with such a device; motors that are cut are what one stage asks for."""
    return fault not in (palpate.DeviceFault.none, palpate.DeviceFault.motors_cut)


def finish(checks: list[Report], with_force: bool, fault: palpate.DeviceFault) -> Report:
    note = "" if with_force else "no force; not comparable"
    if is_broken(fault):
        note = f"ended early: {fault.name}"
    ok = not is_broken(fault) and all(check["ok"] for check in checks)
    return {"force": with_force, "note": note, "checks": checks, "ok": ok,
            "ended_early": is_broken(fault)}  # fmt: skip
