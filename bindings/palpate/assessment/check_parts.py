# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with an assessment that is refused: its parts are read one by one, so that all that
is wrong with any of them is said at once.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from typing import Any

from palpate import scenario
from palpate.assessment.check import check_texts, find_problems
from palpate.assessment.check_problem import ERROR, Problem
from palpate.assessment.publish import with_assessment
from palpate.files.refusal import Refusal

Json = dict[str, Any]
PARTS = ("steps", "limits", "goals")
PLAIN_STEP = {"id": "step", "do": "release", "say": "title"}


def find_all_problems(file: object, assessment: Json, organ: scenario.Scenario) -> list[Problem]:
    """Errors first. Of an assessment that may be refused, for an organ that is published."""
    try:
        return find_problems(with_assessment(file, assessment, organ))
    except Refusal as refusal:
        whole = tell(refusal)
    found: dict[Problem, None] = {}
    for each in check_parts(file, assessment, organ):
        found[each] = None
    if not found:
        found[whole] = None
    try:
        for each in check_texts(assessment):
            found[each] = None
    except (KeyError, TypeError, AttributeError):
        pass  # texts that are none were refused
    return sorted(found, key=lambda each: each.severity != ERROR)


def check_parts(file: object, assessment: Json, organ: scenario.Scenario) -> Iterator[Problem]:
    """Every row of every part alone, beside what all of them may name; and the steps' order."""
    rest = {key: value for key, value in assessment.items() if key not in PARTS}
    frame = refuse_of(file, {**rest, "tools": graspers(rest), "steps": [PLAIN_STEP]}, organ)
    if frame is not None:
        yield tell(frame)
        return
    for part in PARTS:
        rows = assessment.get(part, [])
        if not isinstance(rows, list):
            rows = []
        for number, row in enumerate(rows):
            refused = refuse_of(file, with_row(rest, assessment, part, row), organ)
            if refused is not None:
                yield tell(refused, part, number, row)
    yield from check_ids(assessment)


def check_ids(assessment: Json) -> Iterator[Problem]:
    """Steps that wait for what is none, and ids that are there twice."""
    for part in ("steps", "limits"):
        rows = [row for row in assessment.get(part, []) if isinstance(row, dict)]
        ids = [row.get("id") for row in rows]
        for number, row in enumerate(rows):
            if row.get("id") in ids[:number]:
                yield Problem(ERROR, f"{part}[{number}].id", f"got {row['id']!r} once more")
            for key in ("after", "during"):
                for other in row.get(key, []):
                    steps = [each.get("id") for each in assessment["steps"]]
                    if other not in steps:
                        text = f"got {other!r}, expected the id of a step"
                        yield Problem(ERROR, f"{part}[{number}].{key}", text)


def with_row(rest: Json, assessment: Json, part: str, row: Any) -> Json:
    """An assessment with one row of one part, and with no other row that could be refused."""
    alone = copy.deepcopy(row)
    if isinstance(alone, dict):
        alone.pop("after", None)
        alone.pop("during", None)
    if part == "steps":
        return {**rest, "steps": [alone]}
    return {**rest, "tools": graspers(rest), "steps": [PLAIN_STEP], part: [alone]}


def graspers(rest: Json) -> Json:
    """The same tools, which can hold, so that a step to let go can be read."""
    tools = copy.deepcopy(rest.get("tools", {}))
    for tool in tools.values() if isinstance(tools, dict) else ():
        if isinstance(tool, dict) and tool.get("kind") == "probe":
            tool["kind"] = "grasper"
    return tools


def refuse_of(file: object, assessment: Json, organ: scenario.Scenario) -> Refusal | None:
    try:
        with_assessment(file, assessment, organ)
    except Refusal as refusal:
        return refusal
    return None


def tell(refusal: Refusal, part: str = "", number: int = 0, row: Any = None) -> Problem:
    """Of a row that was read alone, with the place it has in the file."""
    del row
    where = str(refusal.where)
    if part:
        where = where.replace(f"{part}[0]", f"{part}[{number}]")
    return Problem(ERROR, where, f"got {refusal.got}, expected {refusal.expected}")
