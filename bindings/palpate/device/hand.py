# SPDX-License-Identifier: BSD-3-Clause
"""Bringing a device into a pose, by a simulated hand or a person's, and looking at it there."""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.device.link import Link
from palpate.device.poses import PLACES, STILL, Pose

Array = NDArray[np.float64]

SETTLE = 1.0
"""[s] in which a simulated hand comes to a pose."""
OVER = np.radians(0.5)
"""[rad] that a hand goes on pressing where a joint has its stop."""
SEEN = 0.01
"""[s] between two readings of a device."""


class Gather:
    """What a device said while it was to be still."""

    def __init__(self) -> None:
        self.counts: list[list[int]] = []
        self._joints: list[Array] = []
        self._duty: list[list[int]] = []
        self._last = -1.0

    def add(self, status: palpate.DeviceStatus) -> None:
        """A status, where it is newer than the last."""
        if status.time == self._last:
            return
        self._last = status.time
        self.counts.append(list(status.counts))
        self._joints.append(np.array(status.joints))
        self._duty.append(list(status.duty))

    def joints(self) -> Array:
        """[rad] (3,)"""
        return np.mean(self._joints, axis=0)

    def duty(self) -> Array:
        """(3,)"""
        return np.mean(np.array(self._duty, dtype=float), axis=0)


def aim(link: Link, pose: Pose) -> None:
    """Lets the hand of a simulated device bring about a pose, pressing a little at a stop, with the
    stylus in line with the forearm.
    """
    if link.arm is None:
        return
    plant = link.arm.core().plant()
    arm = palpate.find_arm(plant)
    joints = pose.joints()
    if pose.joint is not None:
        joints[pose.joint] += OVER if pose.upper else -OVER
    # as a template would, it carries the arm
    carried = palpate.compute_weight_torque(arm, joints)
    lift = np.asarray(palpate.compute_tip_force(arm, joints, carried)) / plant.hand.stiffness
    link.arm.widen(True)
    in_line = palpate.compute_stylus(joints, np.zeros(3))
    link.hold(np.asarray(palpate.compute_tip(arm, joints)) + lift, in_line)


def bring(link: Link, pose: Pose) -> None:
    """A hand does it: ours in a simulation, otherwise that of the person who reads the sentence."""
    if link.arm is None:
        ask(f"{describe_pose(pose)}; hold it there, press Enter")
    else:
        aim(link, pose)
        link.run(SETTLE)


def describe_pose(pose: Pose) -> str:
    if pose.joint is None:
        return (
            "bring the arm home: straight ahead, the upper link 30 degrees above level, the "
            "forearm at a right angle to it, the stylus in line with the forearm"
        )
    where = dict(zip(PLACES, pose.degrees, strict=False))
    rest = ", ".join(
        f"{name} near {angle:.0f} degrees" for name, angle in where.items()
        if name != PLACES[pose.joint]
    )  # fmt: skip
    end = "upper" if pose.upper else "lower"
    return f"turn the {PLACES[pose.joint]} joint to its {end} stop ({rest})"


def ask(question: str) -> str:
    print(question, file=sys.stderr)
    return sys.stdin.readline()


def watch(link: Link, seconds: float = STILL) -> Gather:
    """What a device says for a while."""
    gather = Gather()
    for _ in range(round(seconds / SEEN)):
        gather.add(link.run(SEEN))
    return gather
