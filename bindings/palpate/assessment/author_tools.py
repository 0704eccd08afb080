# SPDX-License-Identifier: BSD-3-Clause
"""The instruments of an assessment: which there are, of which shape, and whose each step is.

As in palpate.assessment.author, each change is a function from one assessment to the next.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

from palpate.assessment.author import HOLDING, AuthorError, Json, apply_values, make_id
from palpate.assessment.author_values import require_name
from palpate.assessment.instruments import MOST_INSTRUMENTS, SHAPES
from palpate.scene.instrument_kinds import KINDS
from palpate.scene.scene_parts import ToolPart


def set_kind(assessment: Json, name: str, kind: str) -> Json:
    """With an instrument of the usual numbers of its kind, new or another one of this name.

    Raises AuthorError for another kind than a grasper where a step holds with it.
    """
    if kind not in KINDS:
        raise AuthorError(f"kind: got {kind!r}, expected one of {', '.join(KINDS)}")
    holds = [f"step {step['id']}" for step in list_steps(assessment, name) if step["do"] in HOLDING]
    if holds and kind != "grasper":
        said = f"a grasper: with {name!r} hold {', '.join(holds)}"
        raise AuthorError(f"kind: got {kind!r}, expected {said}")
    usual = KINDS[kind]
    values: Json = {"kind": kind, "radius_m": usual.radius, "length_m": usual.length}
    values |= {"friction": usual.friction}
    if usual.jaw_opening:
        values |= {"jaw_opening_rad": usual.jaw_opening, "grip_force_N": ToolPart.grip_force}
    before = assessment.get("tools", {}).get(name, {})
    kept = ["force_max_N"]
    if usual.length > 0.0:
        kept += ["trocar_height_m", "trocar_side_m", "trocar_m", "fulcrum_m"]
    values |= {key: before[key] for key in kept if key in before}
    made = copy.deepcopy(assessment)
    tools = made.setdefault("tools", {})
    if name not in tools:
        made = add_tool(made, name)
        tools = made["tools"]
    row = tools[name].get("instrument")
    tools[name] = values if row is None else {**values, "instrument": row}
    return made


def add_tool(made: Json, name: str) -> Json:
    """With one more, behind the others; from then on steps and limits say whose they are."""
    tools = made["tools"]
    if len(tools) >= MOST_INSTRUMENTS:
        raise AuthorError(f"tools: got one more than {MOST_INSTRUMENTS}, expected no more")
    first = next(iter(tools), None)
    for number, row in enumerate(tools.values()):
        row.setdefault("instrument", number)
    rows = {row["instrument"] for row in tools.values()}
    tools[require_name("tool", name)] = {"kind": "probe", "instrument": max(rows, default=-1) + 1}
    for row in list_users(made):
        if first is not None:
            row.setdefault("tool", first)
    return made


def set_tool(assessment: Json, name: str, values: Mapping[str, Any]) -> Json:
    """With other numbers of an instrument; None takes one away."""
    require_tool(assessment, name)
    unknown = set(values) - SHAPES
    if unknown:
        raise AuthorError(f"tool: got {sorted(unknown)[0]!r}, expected {', '.join(sorted(SHAPES))}")
    made = copy.deepcopy(assessment)
    apply_values(made["tools"][name], values)
    return made


def remove_tool(assessment: Json, name: str) -> Json:
    """Raises AuthorError for the only one, and where a step or a limit is its."""
    require_tool(assessment, name)
    if len(assessment["tools"]) == 1:
        raise AuthorError(f"tool: {name!r} is the only one")
    users = [f"step {step['id']}" for step in assessment["steps"] if step.get("tool") == name]
    users += [f"limit {limit['id']}" for limit in assessment.get("limits", [])
              if limit["when"].get("tool") == name]  # fmt: skip
    if users:
        raise AuthorError(f"tool: {name!r} is that of {', '.join(users)}")
    made = copy.deepcopy(assessment)
    gone = made["tools"].pop(name).get("instrument", 0)
    for row in made["tools"].values():
        row["instrument"] -= row["instrument"] > gone
    if len(made["tools"]) == 1:
        del next(iter(made["tools"].values()))["instrument"]
    return made


def give_step(assessment: Json, step_id: str, tool: str) -> Json:
    """A step is done with another instrument; one that holds needs a grasper."""
    row = require_tool(assessment, tool)
    made = copy.deepcopy(assessment)
    step = next((each for each in made["steps"] if each.get("id") == step_id), None)
    if step is None:
        raise AuthorError(f"id: got {step_id!r}, expected a step")
    if step["do"] in HOLDING and row.get("kind") != "grasper":
        raise AuthorError(f"tool: got {tool!r}, a {row.get('kind')}, expected a grasper")
    step["tool"] = tool
    return made


def name_tool(assessment: Json, kind: str) -> str:
    """A name that no instrument has yet."""
    return make_id(kind, assessment.get("tools", {}))


def list_steps(assessment: Json, name: str) -> list[Json]:
    """That are done with an instrument of this name, which the only one need not say."""
    tools = assessment.get("tools", {})
    only = name if set(tools) == {name} else None
    return [step for step in assessment.get("steps", []) if step.get("tool", only) == name]


def list_users(made: Json) -> list[Json]:
    """Rows that say with which instrument: steps, and what limits watch."""
    return [*made["steps"], *(limit["when"] for limit in made.get("limits", []))]


def require_tool(assessment: Json, name: str) -> Json:
    tools = assessment.get("tools", {})
    if name not in tools:
        raise AuthorError(f"tool: got {name!r}, expected one of {', '.join(tools) or 'none'}")
    row: Json = tools[name]
    return row
