# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs, measures and steps in the words of the window."""

from __future__ import annotations

from typing import TYPE_CHECKING

from palpate.assessment.author import Json

from palpate_editor.views.translations import number, tr

if TYPE_CHECKING:
    from palpate_editor.views.scenario.task_draft import TaskDraft

BANDS = (("force_N", "N", 1.0), ("depth_m", "mm", 1e-3), ("distance_m", "mm", 1e-3))
"""Member, unit that is shown, and what that is in SI."""


def say_verb(verb: str) -> str:
    return {
        "touch": tr("Touch"), "hold": tr("Press and hold"), "push": tr("Push in"),
        "pull": tr("Pull out"), "grasp": tr("Grasp"), "release": tr("Let go"),
        "trace": tr("Follow a line"), "find": tr("Find and click"),
        "look": tr("Look at"), "remove": tr("Take out"), "carry": tr("Carry to"),
    }.get(verb, verb)  # fmt: skip


def say_tool_kind(kind: str) -> str:
    return {
        "ball": tr("Ball"), "probe": tr("Probe"), "laparoscope": tr("Laparoscope"),
        "grasper": tr("Grasper"), "syringe": tr("Syringe"),
    }.get(kind, kind)  # fmt: skip


def say_measure(measure: str) -> str:
    return {
        "force": tr("Force"), "force_rate": tr("Rate of force"), "contact": tr("Contact"),
        "depth": tr("Depth"), "distance": tr("Pulled distance"), "speed": tr("Speed"),
        "clearance": tr("Clearance"), "path.off": tr("Off the line"),
        "strain": tr("Strain"), "loose": tr("Dropped"), "out_of_view": tr("Tip out of view"),
        "object_force": tr("Force on an object"), "pad_pressure": tr("Pressure of the jaws"),
        "torn": tr("Torn tissue"),
    }.get(measure, measure)  # fmt: skip


def say_consequence(then: str) -> str:
    return {
        "warn": tr("a warning"), "error": tr("an error"), "end": tr("ends the task"),
    }.get(then, then)  # fmt: skip


def say_band(band: object, unit: str, scale: float) -> str:
    """0.1–0.4 N, ≥ 0.2 N; of parameters their names."""
    if not isinstance(band, list) or len(band) != 2:
        return ""
    least, most = (say_end(end, scale) for end in band)
    if least and most:
        return f"{least}\N{EN DASH}{most} {unit}"
    return (
        f"\N{GREATER-THAN OR EQUAL TO} {least} {unit}"
        if least
        else (f"\N{LESS-THAN OR EQUAL TO} {most} {unit}")
    )


def say_end(end: object, scale: float) -> str:
    if end is None:
        return ""
    return end if isinstance(end, str) else number(float(end) / scale, 3)  # type: ignore[arg-type]


def say_row(step: Json, draft: TaskDraft) -> str:
    """Verb, place, bands and dwell of a step, on one line."""
    parts = [say_verb(str(step.get("do")))]
    if "at" in step:
        parts.append(draft.name_place(str(step["at"])))
    parts += [say_band(step[key], unit, scale) for key, unit, scale in BANDS if key in step]
    if isinstance(step.get("for_s"), int | float) and step["for_s"] > 0:
        parts.append(f"{number(step['for_s'], 3)} s")
    return " \N{MIDDLE DOT} ".join(part for part in parts if part)
