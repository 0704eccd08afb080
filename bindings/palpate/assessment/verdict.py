# SPDX-License-Identifier: BSD-3-Clause
"""What came of an attempt, as a report: from its events alone, so from a record as well."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import palpate
from palpate import scenario
from palpate.command.verb import Report

KINDS = {int(kind): kind.name for kind in palpate.TaskEvent}
STEPS = ("step_begun", "step_done", "step_overdue", "click_missed")
LIMITS = ("limit_opened", "limit_closed")


def pick_events(events: Iterable[Any]) -> list[Any]:
    """Those of a task among the events of a run, in order."""
    return [event for event in events if int(event["kind"]) in KINDS]


def describe_event(event: Any, drawn: scenario.DrawnTask) -> Report:
    """Its tick, kind and value, and the step, limit or outcome that it is of."""
    kind = KINDS[int(event["kind"])]
    index, value = int(event["index"]), float(event["value"])
    told: Report = {"tick": int(event["tick"]), "kind": kind, "value": value}
    if kind in STEPS:
        told["step"] = drawn.steps[index]
    elif kind in LIMITS:
        told["limit"] = drawn.limits[index]
    else:
        told["outcome"] = palpate.Outcome(index).name
    return told


def describe_verdict(
    drawn: scenario.DrawnTask,
    state: palpate.TaskState,
    events: Iterable[Any],
    assessment: dict[str, Any],
) -> Report:
    """The whole verdict of an attempt, as JSON has it."""
    return {
        **describe_attempt(drawn),
        "outcome": state.outcome.name,
        "time_s": state.time,
        "errors": state.errors,
        "warnings": state.warnings,
        "peak_force_N": state.peak_force,
        "steps": [
            {
                "id": name,
                "status": step.status.name,
                "from_tick": step.from_tick if step.from_tick >= 0 else None,
                "until_tick": step.until_tick if step.until_tick >= 0 else None,
                "overdue": step.overdue,
            }
            for name, step in zip(drawn.steps, state.steps, strict=True)
        ],
        "limits": [
            {
                "id": name,
                "count": limit.count,
                "duration_s": limit.duration,
                "excess": limit.excess,
                "worst": limit.worst if limit.count else None,
            }
            for name, limit in zip(drawn.limits, state.limits, strict=True)
        ],
        "goals": judge_goals(drawn, state, assessment),
        "events": [describe_event(event, drawn) for event in events],
    }


def describe_attempt(drawn: scenario.DrawnTask) -> Report:
    """What was asked: the header of a record has it, and a verdict."""
    return {
        "assessment": drawn.id,
        "version": drawn.version,
        "assessment_sha256": drawn.sha256,
        "level": drawn.level,
        "seed": drawn.seed,
        "drawn": {each.name: each.place or each.value for each in drawn.values},
    }


def judge_goals(
    drawn: scenario.DrawnTask, state: palpate.TaskState, assessment: dict[str, Any]
) -> list[Report]:
    """Each goal of the designer with what was reached; of a task that was not done, none is met."""
    reached = {
        "time": state.time,
        "errors": state.errors,
        "warnings": state.warnings,
        "peak_force": state.peak_force,
    }
    values = {f"${each.name}": each.value for each in drawn.values}
    goals = []
    for goal in assessment.get("goals", []):
        value = reached[goal["metric"]]
        bounds = {
            name: values.get(goal[name], goal[name])
            for name in ("at_least", "at_most")
            if name in goal
        }
        met = state.outcome is palpate.Outcome.done and bounds.get(
            "at_least", value
        ) <= value <= bounds.get("at_most", value)
        basis = goal["basis"]["kind"]
        goals.append({"metric": goal["metric"], "value": value, **bounds, "met": met,
                      "basis": basis})  # fmt: skip
    return goals
