# SPDX-License-Identifier: BSD-3-Clause
"""A guided calibration that a window follows: where it stands, and what comes next. Knows no Qt."""

from __future__ import annotations

import enum
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.command.sentence import PoorData
from palpate.device.calibrate import Guide, find_before
from palpate.device.fit import JointFit, Pull, find_differences, find_home_offset, fit_motors
from palpate.device.hand import SEEN, Gather, aim
from palpate.device.link import Link
from palpate.device.poses import POSES, STILL
from palpate.device.scale import DIRECTIONS, WEAK, find_strong, lean, power_up

Array = NDArray[np.float64]
Work = Callable[[], object]
"""Takes its time: to be done in another thread."""


class Stage(enum.Enum):
    """Where a calibration stands."""

    begin = enum.auto()
    poses = enum.auto()
    angles = enum.auto()
    """All poses were read: what came out is to be looked at, and written."""
    forces = enum.auto()
    """Against a scale, one push after the other."""
    motors = enum.auto()
    """All pushes were read: what came out is to be looked at, and written."""
    done = enum.auto()


@dataclass(frozen=True)
class Reading:
    """What came of half a second of stillness."""

    gather: Gather
    scale: float | None
    """[N] along the push, where the hand is a simulated one."""


class Calibration:
    """One run of it on a link that has begun. Methods that return Work leave it to the caller."""

    def __init__(self, link: Link):
        self.link = link
        self.stage = Stage.begin
        self.guide = Guide()
        self.fit: JointFit | None = None
        self.before: palpate.Calibration | None = None
        self.kept: palpate.Calibration | None = None
        """What the device has now, read back from it."""
        self.factors: Array | None = None
        self.home_offset: Array | None = None
        """[rad] (6,) off home, by the newest reading in the home pose."""
        self._stronger: palpate.Calibration | None = None
        self._pulls: list[Pull] = []
        self._half: tuple[Array, float] | None = None
        self._pushed = 0.0

    def read(self) -> Work:
        """What the device says while it is still, and what a simulated hand holds against [N]."""
        link, direction = self.link, self.unit_vector()

        def work() -> Reading:
            gather, held = Gather(), []
            for _ in range(round(STILL / SEEN)):
                gather.add(link.run(SEEN))
                if link.arm is not None:
                    held.append(-float(np.asarray(link.arm.hand_force()) @ direction))
            return Reading(gather, float(np.mean(held)) if held else None)

        return work

    # ------------------------------------------------------------ home and ranges

    def start(self) -> None:
        """Raises DeviceError where the device's own calibration cannot be read."""
        self.link.driver.enable(False)
        self.before = find_before(self.link)
        self.stage = Stage.poses
        aim(self.link, POSES[0])

    def take_pose(self, gather: Gather) -> None:
        """Raises PoorData, and stays at the pose; at the last, it begins again with the poses."""
        self.guide.take(gather.counts)
        if self.guide.pose is not None:
            aim(self.link, self.guide.pose)
            return
        assert self.before is not None
        try:
            self.fit = self.guide.fit(self.before)
        except PoorData:
            self.guide.go_back()
            raise
        self.stage = Stage.angles

    def go_back(self) -> None:
        """To the pose before."""
        self.guide.go_back()
        self.stage = Stage.poses
        if self.guide.pose is not None:
            aim(self.link, self.guide.pose)

    def write_angles(self) -> Work:
        assert self.fit is not None
        return self._write(self.fit.calibration)

    def end_writing(self, kept: palpate.Calibration) -> None:
        """What was read back. Raises PoorData where it is something else than was written."""
        wanted = self._stronger if self.stage is Stage.motors else self.fit and self.fit.calibration
        assert wanted is not None
        wrong = find_differences(wanted, kept)
        if wrong:
            raise PoorData(
                "The device stored something else than was written: %1.", ", ".join(wrong)
            )
        self.kept = kept
        aim(self.link, POSES[0])
        self.stage = Stage.done if self.stage is Stage.motors else Stage.forces

    def _write(self, calibration: palpate.Calibration) -> Work:
        link = self.link
        return lambda: link.store(calibration)

    # ------------------------------------------------------------ forces

    @property
    def direction(self) -> str:
        """Of the push that is made now or comes next."""
        return list(DIRECTIONS)[min(len(self._pulls), len(DIRECTIONS) - 1)]

    def unit_vector(self) -> Array:
        """(3,) unit, of the push."""
        return np.array(DIRECTIONS[self.direction])

    @property
    def force(self) -> float:
        """[N] that the device pushes with now."""
        return self._pushed

    @property
    def next_force(self) -> float:
        """[N] of the push that comes next."""
        return find_strong(self.link) if self._half is not None else WEAK

    def push(self) -> Work:
        """Leans the motors on the scale; at first they have to be switched on."""
        link, wanted, before = self.link, self.next_force, self._pushed
        direction = self.unit_vector()
        self._pushed = wanted

        def work() -> None:
            if link.status().mode is not palpate.DeviceMode.run:
                power_up(link)
            lean(link, before * direction, wanted * direction)

        return work

    def take_push(self, gather: Gather, reading: float) -> Work | None:
        """What the scale said [N]. Returns what has to be done before the next push.

        Raises PoorData with the last, and begins again with the pushes.
        """
        if self._half is None:
            self._half = (gather.duty(), reading)
            return None
        duty, first = self._half
        direction = self.unit_vector()
        self._pulls.append(
            Pull(
                direction,
                gather.joints(),
                np.array([duty, gather.duty()]),
                np.array([first, reading]),
            )
        )
        strong, self._half, self._pushed = self._pushed, None, 0.0
        if len(self._pulls) == len(DIRECTIONS):
            self._fit_motors()
        link, last = self.link, self.stage is Stage.motors

        def work() -> None:
            lean(link, strong * direction, np.zeros(3))
            if last:
                link.driver.enable(False)

        return work

    def _fit_motors(self) -> None:
        assert self.kept is not None
        pulls, self._pulls = self._pulls, []
        self._stronger, self.factors = fit_motors(self.kept, pulls)
        self.stage = Stage.motors

    def leave_forces(self) -> None:
        """Nobody has a scale: what is known of the motors stays."""
        self.rest()
        self.stage = Stage.done

    def rest(self) -> None:
        """No push any more, motors off."""
        self._half, self._pushed = None, 0.0
        self._pulls = []
        self.link.push()
        self.link.driver.enable(False)

    def write_motors(self) -> Work:
        assert self._stronger is not None
        return self._write(self._stronger)

    # ------------------------------------------------------------ afterwards

    def take_home(self, gather: Gather) -> None:
        """How far a device that stands at home says that it does not."""
        assert self.kept is not None
        self.home_offset = find_home_offset(self.kept, np.mean(gather.counts, axis=0))
