# SPDX-License-Identifier: BSD-3-Clause
"""What the guided calibration says in each of its steps."""

from __future__ import annotations

import numpy as np

from palpate.device.calibration import Calibration, Stage
from palpate.device.fit import find_change
from palpate.device.poses import ARM, PLACES, POSES
from palpate.device_window.sentences import (
    number,
    say_direction,
    say_joint,
    say_pose,
    translate,
)

DASH = "\N{EN DASH}"


def say_stage() -> tuple[str, ...]:
    """The steps by name."""
    return (
        translate("Device", "Home"),
        translate("Device", "Ranges"),
        translate("Device", "Write"),
        translate("Device", "Forces"),
        translate("Device", "Check"),
    )


def say_step(run: Calibration | None) -> tuple[str, str]:
    """What is to be done now: a title and how."""
    if run is None or run.stage is Stage.begin:
        return translate("Device", "Guided calibration"), translate(
            "Device",
            "Seven poses tell what the sensors' counts mean, three pushes against a spring scale "
            "tell what the motors give. The motors stay off until the pushes. It takes five "
            "minutes.",
        )
    if run.stage is Stage.poses:
        pose = run.guide.pose
        assert pose is not None
        title, text = say_pose(pose)
        place = translate("Device", "Pose %1 of %2: ")
        place = place.replace("%1", str(len(run.guide.counts) + 1)).replace("%2", str(len(POSES)))
        return title, place + text
    if run.stage is Stage.angles:
        return translate("Device", "This is what came out"), translate(
            "Device",
            "Check that the residuals are small, then write it to the device. It is read back "
            "and compared.",
        )
    if run.stage is Stage.forces:
        return say_push(run)
    if run.stage is Stage.motors:
        return translate("Device", "The motors' true torques"), translate(
            "Device",
            "In multiples of the values before. Write them, or leave the motors as they were.",
        )
    if run.home_offset is None:
        return translate("Device", "Written and read back"), translate(
            "Device", "Bring the arm home once more to see how far off it is now."
        )
    off = number(float(np.degrees(np.abs(run.home_offset).max())), 2)
    return translate("Device", "%1° off home at most").replace("%1", off), translate(
        "Device", "The device keeps this calibration. Measure again, or begin again."
    )


def say_push(run: Calibration) -> tuple[str, str]:
    direction = say_direction(run.direction)
    if run.force:
        title = translate("Device", "It pushes %1 with %2")
        text = translate(
            "Device",
            "Hold it at home with the scale, against the push, and take over what the scale reads "
            "(1 N is 102 g).",
        )
        return title.replace("%1", direction).replace(
            "%2", f"{number(run.force, 2)}\N{NO-BREAK SPACE}N"
        ), text
    title = translate("Device", "Force check: %1").replace("%1", direction)
    return title, translate(
        "Device",
        "Hook a spring scale to the stylus at home. The motors come on and push this way, weakly "
        "and then more strongly. Without a scale, leave this out.",
    )


def say_buttons(run: Calibration | None, working: bool) -> tuple[str, str, str]:
    """Of the main button, of going back, and of leaving; empty where there is none."""
    if working:
        return translate("Device", "Hold still…"), "", ""
    if run is None or run.stage is Stage.begin:
        return translate("Device", "Begin"), "", ""
    cancel, back = translate("Device", "Cancel"), translate("Device", "Back")
    if run.stage is Stage.poses:
        return translate("Device", "Take this pose"), back if run.guide.counts else "", cancel
    if run.stage is Stage.angles:
        return translate("Device", "Write to the device"), back, cancel
    if run.stage is Stage.forces:
        go = translate("Device", "Take over") if run.force else translate("Device", "Push")
        return go, "", translate("Device", "Leave out the force check")
    if run.stage is Stage.motors:
        write = translate("Device", "Write to the device")
        return write, "", translate("Device", "Leave the motors as they were")
    return translate("Device", "Measure at home"), "", translate("Device", "Begin again")


def say_results(run: Calibration) -> list[list[str]]:
    """A table with its head; nothing before there is something to tell."""
    if run.fit is None or run.before is None or run.stage is Stage.poses:
        return []
    columns = [
        (translate("Device", "zero"), say_zero),
        (translate("Device", "moved"), say_moved),
        (translate("Device", "residual"), say_residual),
    ]
    if run.home_offset is not None:
        columns.append((translate("Device", "off home"), say_offset))
    if run.factors is not None:
        columns.append((translate("Device", "torque"), say_factor))
    rows = [["", *(name for name, _ in columns)]]
    for j, name in enumerate(PLACES):
        rows.append([say_joint(name), *(text(run, j) for _, text in columns)])
    return rows


def say_degrees(angle: float) -> str:
    """Of radians."""
    return f"{number(float(np.degrees(angle)), 2)}°"


def say_zero(run: Calibration, joint: int) -> str:
    assert run.fit is not None
    return str((run.kept or run.fit.calibration).joints[joint].zero)


def say_moved(run: Calibration, joint: int) -> str:
    assert run.fit is not None and run.before is not None
    change = find_change(run.before, run.kept or run.fit.calibration, joint)
    return f"{number(change, 2)}°"


def say_residual(run: Calibration, joint: int) -> str:
    assert run.fit is not None
    return say_degrees(float(run.fit.residual[joint])) if joint < ARM else DASH


def say_offset(run: Calibration, joint: int) -> str:
    assert run.home_offset is not None
    return say_degrees(float(run.home_offset[joint]))


def say_factor(run: Calibration, joint: int) -> str:
    assert run.factors is not None
    return f"×{number(float(run.factors[joint]), 3)}" if joint < ARM else DASH
