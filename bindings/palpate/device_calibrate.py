# SPDX-License-Identifier: BSD-3-Clause
"""Finding what a device's counts mean: its joints at their stops, whose angles the design gives."""

from __future__ import annotations

import copy
import sys

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.device_link import Link
from palpate.verb import Report

PLACES = ("yaw", "elevation", "forearm")
STEPS = tuple((joint, end) for joint in range(3) for end in ("lower", "upper"))
STILL = 0.5
"""[s] over which the counts of a stop are averaged."""
SHORTEST = 100
"""[counts] between the stops of a joint; less is a sensor that is not turned with it."""


def run_calibrate(link: Link, store: bool = True) -> Report:
    """Guides through the stops of the three arm joints and fits zero, scale and range.

    Weights, torques and the gimbal stay as the device has them; a new one gets those of the design.
    Raises DeviceError, RuntimeError.
    """
    link.open()
    link.driver.enable(False)
    if link.status().link is palpate.LinkState.uncalibrated:
        before = palpate.find_calibration(palpate.Plant())
    else:
        before = link.driver.calibration()
    nominal = palpate.Arm()
    counts = np.zeros((3, 2))
    for joint, end in STEPS:
        held = bring_to_stop(link, joint, end)
        counts[joint, int(end == "upper")] = average_counts(link, held)[joint]
    found = fit_joints(before, counts, nominal.joint_min, nominal.joint_max)
    if store:
        link.driver.store(found)
        found = link.driver.calibration()
    return {
        "device": link.name,
        "stored": store,
        "joints": [
            {
                "joint": name,
                "zero_counts": found.joints[j].zero,
                "degree_per_count": float(np.degrees(found.joints[j].scale)),
                "min_counts": found.joints[j].min,
                "max_counts": found.joints[j].max,
                "moved_by_degree": find_change(before, found, j),
            }
            for j, name in enumerate(PLACES)
        ],
    }


def fit_joints(
    before: palpate.Calibration,
    counts: NDArray[np.float64],
    lower: NDArray[np.float64],
    upper: NDArray[np.float64],
) -> palpate.Calibration:
    """A straight line through both stops of each joint: counts (3, 2), angles [rad] (3,).

    Raises RuntimeError where a joint hardly moved.
    """
    found = copy.copy(before)
    joints = [copy.copy(joint) for joint in before.joints]
    for j, name in enumerate(PLACES):
        span = counts[j, 1] - counts[j, 0]
        if abs(span) < SHORTEST:
            raise RuntimeError(
                f"{name}: {abs(span):.0f} counts between its stops, expected {SHORTEST} or more; "
                "is its sensor turned by it?"
            )
        scale = (upper[j] - lower[j]) / span
        ends = sorted(counts[j])
        joints[j].scale = float(scale)
        joints[j].zero = max(0, round(counts[j, 0] - lower[j] / scale))
        joints[j].min, joints[j].max = round(ends[0]), round(ends[1])
    found.joints = joints
    return found


def find_change(before: palpate.Calibration, after: palpate.Calibration, joint: int) -> float:
    """[degree] by which the angle in the middle of the range is another than before."""
    middle = (after.joints[joint].min + after.joints[joint].max) // 2
    counts = [middle] * 6
    angles = [palpate.compute_angles(each, counts)[joint] for each in (before, after)]
    return float(np.degrees(angles[1] - angles[0]))


def bring_to_stop(link: Link, joint: int, end: str) -> NDArray[np.float64] | None:
    """A hand does it: ours in a simulation, otherwise that of whoever reads the sentence.

    Returns where a simulated hand holds the joints [rad].
    """
    if link.core is None:
        print(
            f"turn the {PLACES[joint]} joint to its {end} stop, hold it there, press Enter",
            file=sys.stderr,
        )
        sys.stdin.readline()
        return None
    plant = link.core.plant()
    joints = 0.5 * (plant.joint_min + plant.joint_max)
    joints[joint] = (plant.joint_min if end == "lower" else plant.joint_max)[joint]
    return joints


def average_counts(link: Link, held: NDArray[np.float64] | None) -> NDArray[np.float64]:
    seen: list[list[int]] = []

    def keep(sample: palpate.HapticSample) -> None:
        del sample
        if held is not None and link.core is not None:
            state = link.core.state()
            state.joints, state.rates = held, np.zeros(3)
        if link.driver.take_status():
            seen.append(list(link.driver.status().counts))

    link.run(0.05, each=keep)
    seen.clear()
    link.run(STILL, each=keep)
    return np.array(seen, dtype=float).mean(axis=0)


def describe_calibration(report: Report) -> str:
    lines = [f"{report['device']}: {'written to its EEPROM' if report['stored'] else 'not stored'}"]
    for joint in report["joints"]:
        lines.append(
            f"  {joint['joint']:10} zero {joint['zero_counts']}, "
            f"{joint['degree_per_count']:+.4f} degree a count, "
            f"{joint['min_counts']} to {joint['max_counts']}; "
            f"moved by {joint['moved_by_degree']:+.2f} degree"
        )
    return "\n".join(lines)
