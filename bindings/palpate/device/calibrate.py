# SPDX-License-Identifier: BSD-3-Clause
"""The guided calibration: home, joint ranges, what the motors really push; then written."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.command.verb import Report
from palpate.device.fit import JointFit, find_change, find_home_offset, fit_joints, fit_motors
from palpate.device.hand import bring, watch
from palpate.device.link import Link, to_list
from palpate.device.poses import ARM, HOME, PLACES, POSES, Pose, average_counts
from palpate.device.scale import DIRECTIONS, ask_scale, measure_pulls, read_scale

Array = NDArray[np.float64]


class Guide:
    """Where a guided calibration stands: which pose is next, and what was read in those before."""

    def __init__(self) -> None:
        self.counts: dict[str, Array] = {}

    @property
    def pose(self) -> Pose | None:
        """To be brought about next; None once all were."""
        left = [pose for pose in POSES if pose.name not in self.counts]
        return left[0] if left else None

    def take(self, seen: ArrayLike) -> None:
        """The counts (n, 6) read in the pose. Raises PoorData, and stays at the pose."""
        assert self.pose is not None
        self.counts[self.pose.name] = average_counts(seen, self.pose)

    def go_back(self) -> None:
        """Forgets the last pose."""
        if self.counts:
            self.counts.popitem()

    def fit(self, before: palpate.Calibration) -> JointFit:
        """Raises PoorData."""
        return fit_joints(before, self.counts)


def find_before(link: Link) -> palpate.Calibration:
    """What the device has, or, where it has none, what it would have as it was designed."""
    if link.status().link is palpate.LinkState.uncalibrated:
        return palpate.find_calibration(palpate.Plant())
    return link.driver.calibration()


def run_calibrate(link: Link, store: bool = True, forces: bool = True) -> Report:
    """Guides through the poses, then through the pushes against a scale, and writes what came out.

    Angles are written first, for motors push the right way only with them. Raises DeviceError,
    PoorData.
    """
    link.begin()
    try:
        return calibrate(link, store, forces)
    finally:
        link.end()


def calibrate(link: Link, store: bool, forces: bool) -> Report:
    before = find_before(link)
    guide = Guide()
    while guide.pose is not None:
        bring(link, guide.pose)
        guide.take(watch(link).counts)
    found = guide.fit(before)
    kept = link.store(found.calibration) if store else found.calibration
    factors = None
    if store and forces:
        pulls = list(measure_pulls(link, read_scale if link.arm else ask_scale))
        if len(pulls) == len(DIRECTIONS):
            stronger, factors = fit_motors(kept, pulls)
            kept = link.store(stronger)
        link.driver.enable(False)
    bring(link, POSES[0])
    offset = find_home_offset(kept, np.mean(watch(link).counts, axis=0))
    return {
        "device": link.name,
        "stored": store,
        "joints": describe_joints(before, kept, found),
        "torque_factors": None if factors is None else to_list(factors),
        "torque_full_Nm": to_list(np.asarray(kept.torque_full)),
        "home_offset_degree": to_list(np.degrees(offset)),
    }


def describe_joints(
    before: palpate.Calibration, after: palpate.Calibration, fit: JointFit
) -> list[Report]:
    rows: list[Report] = [
        {
            "joint": name,
            "zero_counts": after.joints[j].zero,
            "degree_per_count": float(np.degrees(after.joints[j].scale)),
            "min_counts": after.joints[j].min,
            "max_counts": after.joints[j].max,
            "moved_by_degree": find_change(before, after, j),
            "residual_degree": float(np.degrees(fit.residual[j])) if j < ARM else None,
        }
        for j, name in enumerate(PLACES)
    ]
    return rows


def describe_calibration(report: Report) -> str:
    lines = [f"{report['device']}: {'written to its EEPROM' if report['stored'] else 'not stored'}"]
    for joint in report["joints"]:
        line = (
            f"  {joint['joint']:12} zero {joint['zero_counts']}, "
            f"{joint['degree_per_count']:+.4f} degree a count, "
            f"{joint['min_counts']} to {joint['max_counts']}; "
            f"moved by {joint['moved_by_degree']:+.2f} degree"
        )
        if joint["residual_degree"] is not None:
            line += f", off its line by {joint['residual_degree']:.2f}"
        lines.append(line)
    factors = report["torque_factors"]
    told = "not checked" if factors is None else ", ".join(f"{factor:.3f}" for factor in factors)
    lines.append(f"  motors       {told}{'' if factors is None else ' times the torque before'}")
    off = max(abs(angle) for angle in report["home_offset_degree"])
    lines.append(f"  at {HOME}      {off:.2f} degree off at most")
    return "\n".join(lines)
