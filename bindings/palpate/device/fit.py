# SPDX-License-Identifier: BSD-3-Clause
"""From counts in known poses, and from a scale's readings, to the calibration of a device."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.command.sentence import PoorData
from palpate.device.poses import ARM, HOME, HOME_JOINTS, PLACES, POSES, SHORTEST

Array = NDArray[np.float64]

BENT = 2.0
"""[degree] that home may lie off the line through both stops."""
ROUNDING = 1e-4
"""Share by which a number may change on its way through the wire's whole numbers."""
LEAST_FACTOR, MOST_FACTOR = 0.5, 2.0
"""Of a motor's torque over the one that is believed."""


@dataclass(frozen=True)
class JointFit:
    """What came of the poses."""

    calibration: palpate.Calibration
    residual: Array
    """[rad] (3,) the most that a pose lies off the line of its joint."""


def fit_joints(before: palpate.Calibration, counts: Mapping[str, Array]) -> JointFit:
    """The line nearest to the three poses of each joint of the arm, and the gimbal's zeros.

    angle = scale (count - zero), least squares; `counts` by pose. The gimbal's scales, lengths,
    weights and torques stay. Raises PoorData.
    """
    found = copy.copy(before)
    joints = [copy.copy(joint) for joint in before.joints]
    residual = np.zeros(ARM)
    for j, name in enumerate(PLACES[:ARM]):
        angle = np.array([HOME_JOINTS[j], *(p.joints()[j] for p in POSES if p.joint == j)])
        stops = [counts[pose.name][j] for pose in POSES if pose.joint == j]
        count = np.array([counts[HOME][j], *stops])
        require_range(name, count)
        scale, offset = np.polyfit(count, angle, 1)
        residual[j] = np.abs(scale * count + offset - angle).max()
        if residual[j] > np.radians(BENT):
            raise PoorData(
                "%1: home lies %2 degrees off the line through its stops, expected %3 at most; "
                "was each pose reached, and is its magnet centred?",
                name,
                f"{np.degrees(residual[j]):.1f}",
                f"{BENT:g}",
            )
        joints[j].scale = float(scale)
        joints[j].zero = round(-offset / scale)
        joints[j].min, joints[j].max = round(min(stops)), round(max(stops))
    for j in range(ARM, len(PLACES)):
        joints[j].zero = round(counts[HOME][j])
    found.joints = joints
    return JointFit(found, residual)


def require_range(name: str, count: Array) -> None:
    """Home between two stops that are far enough apart."""
    home, lower, upper = count
    if abs(upper - lower) < SHORTEST:
        raise PoorData(
            "%1: %2 counts between its stops, expected %3 or more; is its sensor turned by it?",
            name,
            f"{abs(upper - lower):.0f}",
            SHORTEST,
        )
    if not min(lower, upper) < home < max(lower, upper):
        raise PoorData("%1: home does not lie between its stops; was the right joint moved?", name)


def find_change(before: palpate.Calibration, after: palpate.Calibration, joint: int) -> float:
    """[degree] by which the angle in the middle of the range is another than before."""
    middle = (after.joints[joint].min + after.joints[joint].max) // 2
    counts = [middle] * len(PLACES)
    angles = [palpate.compute_angles(each, counts)[joint] for each in (before, after)]
    return float(np.degrees(angles[1] - angles[0]))


def find_differences(wanted: palpate.Calibration, kept: palpate.Calibration) -> list[str]:
    """What a device keeps otherwise than it was given, by name; the wire's rounding is none."""
    wrong = []
    for name, given, has in zip(PLACES, wanted.joints, kept.joints, strict=True):
        same = (given.zero, given.min, given.max) == (has.zero, has.min, has.max)
        if not same or abs(given.scale - has.scale) > ROUNDING * abs(given.scale):
            wrong.append(name)
    for name in ("upper_length", "forearm_length", "torque_full", "upper_weight", "forearm_weight"):
        given, has = np.asarray(getattr(wanted, name)), np.asarray(getattr(kept, name))
        if (np.abs(given - has) > ROUNDING * np.abs(given) + 1e-6).any():
            wrong.append(name)
    return wrong


def find_home_offset(calibration: palpate.Calibration, counts: ArrayLike) -> Array:
    """[rad] (6,) by which sensors that stand at home say they do not."""
    whole = [round(float(count)) for count in np.asarray(counts)]
    angles = np.asarray(palpate.compute_angles(calibration, whole))
    return angles - np.concatenate([HOME_JOINTS, np.zeros(len(PLACES) - ARM)])


@dataclass(frozen=True)
class Pull:
    """What a scale said while the motors pushed in one direction, weakly and then more strongly."""

    direction: Array
    """(3,) unit."""
    joints: Array
    """[rad] (3,)"""
    duty: Array
    """(2, 3) that the motors really had, -255 to 255."""
    reading: Array
    """[N] (2,) along the direction."""


def fit_motors(before: palpate.Calibration, pulls: list[Pull]) -> tuple[palpate.Calibration, Array]:
    """Torques of full duty that explain the readings, and the factors (3,) to those before.

    The difference of both readings is that of the motors alone: weight and friction, which are the
    same in both, fall out. d . J^-T diag(s) dtau = dr, solved for s. Raises PoorData.
    """
    rows, readings = [], []
    torque_full = np.asarray(before.torque_full)
    arm = palpate.find_arm(before)
    for pull in pulls:
        torque = torque_full * np.diff(pull.duty, axis=0)[0] / 255.0
        jacobian = np.asarray(palpate.compute_jacobian(arm, pull.joints))
        rows.append(np.linalg.solve(jacobian, pull.direction) * torque)
        readings.append(float(np.diff(pull.reading)[0]))
    matrix = np.array(rows)
    if matrix.shape != (ARM, ARM) or np.linalg.cond(matrix) > 100.0:
        raise PoorData("The pulls do not tell the motors apart; the arm has to be at home.")
    factors = np.linalg.solve(matrix, readings)
    for name, factor in zip(PLACES, factors, strict=False):
        require_factor(name, float(factor))
    found = copy.copy(before)
    found.torque_full = torque_full * factors
    return found, factors


def require_factor(name: str, factor: float) -> None:
    if factor < 0.0:
        raise PoorData(
            "The %1 motor pulls where it should push: swap its two wires, then try again.", name
        )
    if not LEAST_FACTOR <= factor <= MOST_FACTOR:
        raise PoorData(
            "The %1 motor gives %2 times the torque expected, %3 to %4 can be believed; check its "
            "drive, its supply and what was read.",
            name,
            f"{factor:.2f}",
            f"{LEAST_FACTOR:g}",
            f"{MOST_FACTOR:g}",
        )
