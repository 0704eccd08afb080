# SPDX-License-Identifier: BSD-3-Clause
"""What the check of a device asks for, and what it has found, in words."""

from __future__ import annotations

from palpate.command.verb import Report
from palpate.player.sentences import format_number, say_no_force, translate
from palpate.runs.device_check import PRESSED, TARGETS, DeviceCheck, Stage


def say_stage(check: DeviceCheck, with_force: bool) -> str:
    """What is to be done now."""
    if not with_force:
        return say_no_force()
    if check.stage is Stage.still:
        return translate("Player", "Device check: hold the tool still.")
    if check.stage is Stage.targets:
        text = translate("Player", "Device check: touch the marked point, %1 of %2.")
        text = text.replace("%1", str(min(check.target + 1, len(TARGETS))))
        return text.replace("%2", str(len(TARGETS)))
    if check.stage is Stage.wall:
        text = translate("Player", "Device check: press the middle with %1 to %2 N for a second.")
        for number, bound in enumerate(PRESSED, start=1):
            text = text.replace(f"%{number}", format_number(bound, 1))
        return text
    if check.stage is Stage.stop and check.stopped:
        return translate("Player", "Device check: release the stop button.")
    if check.stage is Stage.stop:
        return translate("Player", "Device check: press the stop button of the device.")
    return ""


def say_check(check: Report) -> str:
    """One finding: whether it is as it should be, its value and its bound."""
    mark = "\N{CHECK MARK}" if check["ok"] else "\N{MULTIPLICATION X}"
    return f"{mark} {say_found(check)}"


def say_found(check: Report) -> str:
    """Value and bound as people read them."""
    name = check["name"]
    if name == "stop":
        return translate("Player", "Stop button")
    form, scale, decimals = {
        "display": (translate("Player", "Pictures: %1 a second, at least %2"), 1.0, 0),
        "ticks": (translate("Player", "Force updates: %1 ms late, at most %2 ms"), 1e3, 2),
        "link_loss": (translate("Player", "Lost reports: %1 %, at most %2 %"), 1e2, 1),
        "round_trip": (translate("Player", "Round trip: %1 ms, at most %2 ms"), 1e3, 1),
        "noise": (translate("Player", "Noise: %1 mm, at most %2 mm"), 1e3, 2),
        "drift": (translate("Player", "Drift: %1 mm, at most %2 mm"), 1e3, 1),
        "targets": (translate("Player", "Points touched: %1 of %2"), 1.0, 0),
        "wall": (translate("Player", "Wall pressed: %1 s of %2 s"), 1.0, 0),
        "buzz": (translate("Player", "Buzz at the wall: %1 mm, at most %2 mm"), 1e3, 2),
        "force": (translate("Player", "Force of the motors: %1 % off, at most %2 %"), 1e2, 0),
    }[name]
    value = check["value"]
    said = "\N{EN DASH}" if value is None else format_number(scale * value, decimals)
    return form.replace("%1", said).replace("%2", format_number(scale * check["bound"], decimals))
