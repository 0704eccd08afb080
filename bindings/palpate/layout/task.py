# SPDX-License-Identifier: BSD-3-Clause
"""The judged task of a layout, which it keeps as the JSON that `palpate scenario` writes."""

from __future__ import annotations

import json
from dataclasses import replace

from palpate.assessment.author import Json, make_ids, new_assessment, without_muted
from palpate.files.refusal import Refusal
from palpate.layout.document import Layout, LayoutError

NO_TASK = "no assessment"
TASK = "JSON that says palpate_scenario, as `palpate scenario new` writes it"


def find_task(layout: Layout) -> Json | None:
    """None of a scene to feel. Raises LayoutError for what is none."""
    if not layout.assessment:
        return None
    task = parse_task(layout.assessment)
    if task is None:
        raise LayoutError(f"task: got {NO_TASK}, expected {TASK}")
    return task


def parse_task(text: str) -> Json | None:
    """None of text that is no assessment."""
    try:
        task = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return task if isinstance(task, dict) and "palpate_scenario" in task else None


def require_task(path: object, text: str) -> None:
    """Raises Refusal for what a file has in place of an assessment, or of none."""
    if text and parse_task(text) is None:
        raise Refusal(path, "assessment", NO_TASK, TASK)


def set_task(layout: Layout, task: Json | None) -> Layout:
    """None takes it away."""
    text = "" if task is None else json.dumps(task, ensure_ascii=False)
    return replace(layout, assessment=text)


def begin_task(layout: Layout) -> Json:
    """One without steps, of all organs and stones of the layout. Raises AuthorError."""
    name = layout.title or " + ".join(body.name for body in layout.bodies)
    return new_assessment(
        name,
        {"en": name, "tr": layout.title_tr or name},
        bodies=make_ids(body.name for body in layout.bodies),
        stones=make_ids(stone.name for stone in layout.stones),
    )


def has_steps(task: Json | None) -> bool:
    """Whether there is something that is published of it."""
    return task is not None and bool(without_muted(task).get("steps"))
