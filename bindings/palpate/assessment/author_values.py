# SPDX-License-Identifier: BSD-3-Clause
"""What an assessment has beside its steps and limits: time, places by name, levels, parameters.

As in palpate.assessment.author, each change is a function from one assessment to the next.
"""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Mapping
from typing import Any

from palpate.assessment.author import AuthorError, Json, apply_values, find, make_id

UNITS = ("N", "m", "s", "rad", "m3", "1", "place")
"""Of parameters."""
BANDS = {"force_N": "N", "depth_m": "m", "distance_m": "m"}
"""Members of a step that are bands, and their units."""
NAME = re.compile(r"[a-z0-9_-]{1,100}")


def set_time(assessment: Json, seconds: float) -> Json:
    """[s] after which the task is over."""
    if not seconds > 0.0:
        raise AuthorError(f"time: got {seconds:g} s, expected more than 0")
    made = copy.deepcopy(assessment)
    made["finish"]["time_limit_s"] = seconds
    return made


def require_name(what: str, name: str) -> str:
    if not NAME.fullmatch(name):
        raise AuthorError(f"{what}: got {name!r}, expected small letters, digits, - and _")
    return name


# ---------------------------------------------------------------- places


def set_place(assessment: Json, name: str, place: Json) -> Json:
    """With a place of this name; what names it goes on to name it."""
    made = copy.deepcopy(assessment)
    made.setdefault("places", {})[require_name("place", name)] = copy.deepcopy(place)
    return made


def remove_place(assessment: Json, name: str) -> Json:
    """Raises AuthorError where something names it."""
    if name not in assessment.get("places", {}):
        known = ", ".join(assessment.get("places", {})) or "none yet"
        raise AuthorError(f"place: got {name!r}, expected one of {known}")
    users = [f"step {step['id']}" for step in assessment["steps"] if step.get("at") == name]
    users += [f"limit {limit['id']}" for limit in assessment.get("limits", [])
              if limit["when"].get("place") == name]  # fmt: skip
    users += [f"parameter {key}" for key, row in assessment.get("parameters", {}).items()
              if row.get("unit") == "place" and name in row.get("choose", ())]  # fmt: skip
    if assessment.get("inclusion") == name:
        users.append("inclusion")
    if users:
        raise AuthorError(f"place: {name!r} is that of {', '.join(users)}")
    made = copy.deepcopy(assessment)
    del made["places"][name]
    return made


# ---------------------------------------------------------------- levels


def add_level(assessment: Json, name: str) -> Json:
    """With one more level, behind the others; its parameters have their usual values."""
    made = copy.deepcopy(assessment)
    levels = made.setdefault("levels", [])
    if require_name("level", name) in levels:
        raise AuthorError(f"level: got {name!r} once more, expected a new one")
    levels.append(name)
    return made


def remove_level(assessment: Json, name: str) -> Json:
    """Without a level and all values of it."""
    made = copy.deepcopy(assessment)
    levels = made.get("levels", [])
    if name not in levels:
        raise AuthorError(f"level: got {name!r}, expected one of {', '.join(levels) or 'none yet'}")
    levels.remove(name)
    if not levels:
        del made["levels"]
    for row in made.get("parameters", {}).values():
        if name in row.get("levels", {}):
            del row["levels"][name]
            if not row["levels"]:
                del row["levels"]
    return made


# ---------------------------------------------------------------- parameters


def set_parameter(assessment: Json, name: str, values: Mapping[str, Any]) -> Json:
    """With a parameter: its `unit`, and `value` (with `levels`), `uniform` or `choose`. Of one that
    is there only what is given changes; another kind takes the place of the old one.
    """
    made = copy.deepcopy(assessment)
    rows = made.setdefault("parameters", {})
    row = rows.setdefault(require_name("parameter", name), {})
    kinds = [kind for kind in ("value", "uniform", "choose") if kind in values]
    if len(kinds) > 1:
        raise AuthorError(f"parameter: got {' and '.join(kinds)}, expected one of them")
    for kind in ("value", "uniform", "choose"):
        if kinds and kind != kinds[0]:
            row.pop(kind, None)
    apply_values(row, values)
    if "value" not in row:
        row.pop("levels", None)
    unit = row.get("unit")
    if unit not in UNITS:
        raise AuthorError(f"unit: got {unit!r}, expected one of {', '.join(UNITS)}")
    if not {"value", "uniform", "choose"} & set(row):
        raise AuthorError(f"parameter: got no value of {name!r}, expected value, uniform or choose")
    return made


def set_level_value(assessment: Json, name: str, level: str, value: float | None) -> Json:
    """The value that a parameter has at a level; None for its usual one."""
    row = require_parameter(assessment, name)
    levels = assessment.get("levels", [])
    if level not in levels:
        known = ", ".join(levels) or "none yet"
        raise AuthorError(f"level: got {level!r}, expected one of {known}")
    if "value" not in row:
        raise AuthorError(f"parameter: {name!r} is drawn by the seed, and has no value of a level")
    values = {**row.get("levels", {}), level: value}
    values = {key: each for key, each in values.items() if each is not None}
    return set_parameter(assessment, name, {"levels": values or None})


def remove_parameter(assessment: Json, name: str) -> Json:
    """Raises AuthorError where something uses it."""
    require_parameter(assessment, name)
    users = find_users(assessment, name)
    if users:
        raise AuthorError(f"parameter: {name!r} is used by {', '.join(users)}")
    made = copy.deepcopy(assessment)
    del made["parameters"][name]
    if not made["parameters"]:
        del made["parameters"]
    return made


def rename_parameter(assessment: Json, old: str, new: str) -> Json:
    """With another name wherever it is used."""
    require_parameter(assessment, old)
    if require_name("parameter", new) in assessment["parameters"]:
        raise AuthorError(f"parameter: got {new!r} once more, expected a new name")
    text = json.dumps(assessment).replace(f'"${old}"', f'"${new}"')
    made: Json = json.loads(text.replace(f"{{{old}:", f"{{{new}:"))
    rows = made["parameters"]
    made["parameters"] = {new if name == old else name: row for name, row in rows.items()}
    return made


def require_parameter(assessment: Json, name: str) -> Json:
    rows = assessment.get("parameters", {})
    if name not in rows:
        raise AuthorError(f"parameter: got {name!r}, expected one of {', '.join(rows) or 'none'}")
    row: Json = rows[name]
    return row


def find_users(assessment: Json, name: str) -> list[str]:
    """Steps, limits and texts that use a parameter."""
    said, users = f'"${name}"', []
    for kind in ("steps", "limits"):
        for row in assessment.get(kind, []):
            if said in json.dumps(row):
                users.append(f"{kind[:-1]} {row['id']}")
    for key in ("places", "goals", "finish", "inclusion", "tools"):
        if said in json.dumps(assessment.get(key, None)):
            users.append(key)
    for code, texts in assessment["texts"].items():
        users += [f"text {code}.{key}" for key, text in texts.items() if f"{{{name}:" in text]
    return users


def use_in_step(assessment: Json, step_id: str, member: str, end: int, name: str) -> Json:
    """A parameter as the least (end 0) or the most (end 1) of a band of a step."""
    row = require_parameter(assessment, name)
    if member not in BANDS:
        raise AuthorError(f"band: got {member!r}, expected one of {', '.join(BANDS)}")
    require_unit(name, row, BANDS[member])
    made = copy.deepcopy(assessment)
    step = made["steps"][find(made["steps"], step_id)]
    band = list(step.get(member, [None, None]))
    band[end] = f"${name}"
    step[member] = band
    return made


def use_in_limit(assessment: Json, limit_id: str, name: str, unit: str) -> Json:
    """A parameter as the bound of a limit whose measure has a unit."""
    require_unit(name, require_parameter(assessment, name), unit)
    made = copy.deepcopy(assessment)
    when = made["limits"][find(made["limits"], limit_id)]["when"]
    when["below" if "below" in when else "above"] = f"${name}"
    return made


def require_unit(name: str, row: Json, unit: str) -> None:
    if row.get("unit") != unit:
        raise AuthorError(f"parameter: {name!r} is of unit {row.get('unit')}, expected {unit}")


def name_parameter(assessment: Json, base: str) -> str:
    """A name that no parameter has yet."""
    return make_id(base, assessment.get("parameters", {}))
