# SPDX-License-Identifier: BSD-3-Clause
"""The poses of a guided calibration, and what the sensors said in each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.command.sentence import PoorData

PLACES = ("yaw", "elevation", "forearm", "gimbal yaw", "gimbal pitch", "gimbal roll")
ARM = 3
"""Of them are joints of the arm."""
HOME = "home"
HOME_JOINTS = np.radians((0.0, 30.0, 30.0))
"""[rad] straight ahead, as a set square of 30 degrees holds it: both links at a right angle."""
STILL = 0.5
"""[s] over which counts are averaged."""
RESTLESS = 6
"""[counts] that a joint may move in this time."""
SHORTEST = 100
"""[counts] between the stops of a joint; less is a sensor that is not turned with it."""
LOWEST, HIGHEST = 8, 1015
"""[counts] beyond which the device itself takes a sensor's wire for cut or shorted."""
FEWEST = 10
"""Readings in the time: fewer are no average."""


@dataclass(frozen=True)
class Pose:
    """Where the arm is to be brought."""

    name: str
    """HOME, or a joint and its end, such as "yaw lower"."""
    degrees: tuple[float, float, float]
    """Of the arm's joints, by the design; a stop is where the joint named cannot go further."""
    joint: int | None = None
    """Whose stop it is."""
    upper: bool = False

    def joints(self) -> NDArray[np.float64]:
        """[rad]"""
        return np.radians(self.degrees)


def build_poses() -> tuple[Pose, ...]:
    """Home, then both stops of each joint, the others where the arm is well bent."""
    stops = np.degrees(np.stack([palpate.Arm().joint_min, palpate.Arm().joint_max], axis=1))
    others = {
        ("yaw", 0): (0.0, 30.0, 30.0),
        ("yaw", 1): (0.0, 30.0, 30.0),
        ("elevation", 0): (0.0, 0.0, 30.0),
        ("elevation", 1): (0.0, 0.0, 60.0),
        ("forearm", 0): (0.0, 10.0, 0.0),
        ("forearm", 1): (0.0, 50.0, 0.0),
    }
    poses = [Pose(HOME, (0.0, 30.0, 30.0))]
    for (name, end), rest in others.items():
        joint = PLACES.index(name)
        degrees = list(rest)
        degrees[joint] = float(stops[joint, end])
        first, second, third = degrees
        poses.append(
            Pose(f"{name} {'upper' if end else 'lower'}", (first, second, third), joint, bool(end))
        )
    return tuple(poses)


POSES = build_poses()


def average_counts(seen: ArrayLike, pose: Pose) -> NDArray[np.float64]:
    """The middle of what was read (n, 6) while the arm was to be still. Raises PoorData."""
    counts = np.asarray(seen, dtype=float)
    if len(counts) < FEWEST:
        raise PoorData(
            "Only %1 readings came in half a second: check the cable first.", len(counts)
        )
    judged = range(len(PLACES)) if pose.joint is None else [pose.joint]
    for joint in judged:
        moved = np.ptp(counts[:, joint])
        if moved > RESTLESS:
            raise PoorData(
                "%1 moved by %2 counts while it was read; hold it still and try again.",
                PLACES[joint],
                f"{moved:.0f}",
            )
        middle = counts[:, joint].mean()
        if not LOWEST <= middle <= HIGHEST:
            raise PoorData(
                "%1 reads %2 of 0 to 1023, the end of its scale; check its wires and its magnet.",
                PLACES[joint],
                f"{middle:.0f}",
            )
    return counts.mean(axis=0)
