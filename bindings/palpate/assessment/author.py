# SPDX-License-Identifier: BSD-3-Clause
"""Writing an assessment step by step: each change is a function from one to the next, as JSON.

An assessment that was changed may be wrong in itself; what is wrong with it is for the reader and
for `check` to say. AuthorError is for what cannot be done at all.
"""

from __future__ import annotations

import copy
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from palpate.assessment.sentences import say_limit, say_step

Json = dict[str, Any]

VERBS = (
    *("touch", "hold", "push", "pull", "grasp", "release", "trace", "find"),
    *("look", "remove", "carry"),
)
HOLDING = ("grasp", "pull", "release", "remove", "carry")
"""Verbs whose tool must be a grasper."""
SEEING = ("look",)
"""Verbs whose tool must be a laparoscope."""
SPACES: Mapping[str, str] = {"remove": "from", "carry": "to"}
"""Verbs that move an object, and their member for the space that is out of or into."""
MEASURES = (
    *("force", "force_rate", "contact", "depth", "distance", "speed", "clearance", "path.off"),
    *("strain", "loose", "out_of_view", "object_force", "pad_pressure", "torn"),
)
CONSEQUENCES = ("warn", "error", "end")
USUAL: Mapping[str, Json] = {
    "touch": {},
    "hold": {"force_N": [0.1, 0.4], "for_s": 2.0},
    "push": {"depth_m": [0.004, 0.008], "for_s": 0.5},
    "pull": {"distance_m": [0.004, 0.008], "for_s": 0.5},
    "grasp": {},
    "release": {},
    "trace": {"force_N": [0.05, 0.6], "share": 0.95},
    "find": {"force_N": [0.1, None]},
    "look": {"for_s": 1.0},
    "remove": {},
    "carry": {},
}
"""What a new step of a verb asks for."""
LIMIT_BOUNDS: Mapping[str, float] = {
    "force": 1.5, "force_rate": 20.0, "depth": 0.015, "distance": 0.02, "speed": 0.3,
    "clearance": 0.005, "path.off": 0.008, "strain": 0.4,
    "object_force": 1.0, "pad_pressure": 330e3,
}  # fmt: skip
TIME_LIMIT = 60.0
LANGUAGES = ("en", "tr")
"""In which new sentences are written."""


class AuthorError(ValueError):
    """A change that cannot be done, in a sentence."""


def make_id(text: str, taken: Iterable[str] = ()) -> str:
    """Of small letters, digits and hyphens; with a number behind it where it is taken."""
    base = re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")[:60] or "item"
    known, name, number = set(taken), base, 2
    while name in known:
        name, number = f"{base}-{number}", number + 1
    return name


def make_ids(texts: Iterable[str]) -> list[str]:
    """Of each another."""
    made: list[str] = []
    for text in texts:
        made.append(make_id(text, made))
    return made


def new_assessment(
    organ: str, titles: Mapping[str, str], identity: str = "", bodies: Sequence[str] = (),
    stones: Sequence[str] = (),
) -> Json:  # fmt: skip
    """Of one organ, without steps yet; `titles` by code of the language, with English. Of a scene
    of several organs `bodies` has the id of each, and `stones` that of each stone."""
    if not titles.get("en"):
        raise AuthorError("title: got none in English, expected one")
    objects = {name: {"rigid": number} for number, name in enumerate(stones)}
    return {
        "palpate_scenario": 1,
        "id": identity or make_id(titles["en"]),
        "version": "1.0.0",
        "title": "title",
        "organs": {name: {"body": number} for number, name in enumerate(bodies)}
        or {make_id(organ): {}},
        **({"objects": objects} if objects else {}),
        "tools": {"tip": {"kind": "grasper"}},
        "places": {},
        "steps": [],
        "finish": {"time_limit_s": TIME_LIMIT},
        "goals": [{"metric": "errors", "at_most": 0, "basis": {"kind": "designer"}}],
        "texts": {code: {"title": text} for code, text in titles.items() if text},
    }


def find(rows: Iterable[Json], identity: str) -> int:
    """Which row has this id."""
    known = [str(row.get("id")) for row in rows]
    if identity not in known:
        raise AuthorError(f"id: got {identity!r}, expected one of {', '.join(known) or 'none yet'}")
    return known.index(identity)


# ---------------------------------------------------------------- places


def add_place(assessment: Json, name: str, place: Json) -> tuple[Json, str]:
    """With one more place, and its id; the same place is there only once."""
    made = copy.deepcopy(assessment)
    places = made.setdefault("places", {})
    for known, other in places.items():
        if other == place:
            return made, known
    identity = make_id(name, places)
    places[identity] = copy.deepcopy(place)
    return made, identity


def remove_unused_places(assessment: Json) -> Json:
    """Without the places that no step, limit or parameter names."""
    made = copy.deepcopy(assessment)
    used = {step.get("at") for step in made["steps"]}
    used |= {step.get(member) for step in made["steps"] for member in SPACES.values()}
    used |= {limit["when"].get("place") for limit in made.get("limits", [])}
    used |= {made.get("inclusion")}
    for parameter in made.get("parameters", {}).values():
        used |= set(parameter.get("choose", ())) if parameter.get("unit") == "place" else set()
    made["places"] = {name: place for name, place in made["places"].items() if name in used}
    return made


# ---------------------------------------------------------------- steps


def add_step(
    assessment: Json, verb: str, at: str | None, values: Mapping[str, Any] | None = None,
    identity: str = "",
) -> tuple[Json, str]:  # fmt: skip
    """With one more step at the end, what it says in every language, and its id."""
    if verb not in VERBS:
        raise AuthorError(f"do: got {verb!r}, expected one of {', '.join(VERBS)}")
    made = copy.deepcopy(assessment)
    name = identity or make_id(verb, (step["id"] for step in made["steps"]))
    if any(step["id"] == name for step in made["steps"]):
        raise AuthorError(f"id: got {name!r} once more, expected one of its own")
    step: Json = {"id": name, "do": verb}
    if at is not None:
        step["at"] = at
    elif verb != "release":
        raise AuthorError(f"at: got none, expected a place to {verb}")
    step |= {**USUAL[verb], **(values or {}), **choose_tool(made, verb)}
    if verb in SPACES and SPACES[verb] not in step:
        raise AuthorError(f"{SPACES[verb]}: got none, expected a space to {verb} it {SPACES[verb]}")
    step["say"] = make_id(f"step-{name}", made["texts"]["en"])
    made["steps"].append(step)
    return write_texts(made, step["say"], say_step, step), name


def choose_tool(assessment: Json, verb: str = "") -> Json:
    """Where there are several instruments, whose a new step or limit is: that of the last step, or
    the first that can do it."""
    tools = assessment.get("tools", {})
    if len(tools) < 2:
        return {}
    kind = "grasper" if verb in HOLDING else "laparoscope" if verb in SEEING else ""
    fit = [name for name, row in tools.items() if not kind or row.get("kind") == kind]
    fit = fit or list(tools)
    last = next((step.get("tool") for step in reversed(assessment["steps"])), None)
    return {"tool": last if last in fit else fit[0]}


def change_step(assessment: Json, identity: str, values: Mapping[str, Any]) -> Json:
    """With other values of a step; None takes one away. What it says follows, where nobody has
    written anything else.
    """
    made = copy.deepcopy(assessment)
    step = made["steps"][find(made["steps"], identity)]
    written = is_written(made, step["say"], say_step, step)
    new_verb = values.get("do", step["do"])
    if new_verb != step["do"]:
        kept = {key: step[key] for key in ("id", "at", "tool", "say", "after") if key in step}
        step.clear()
        step |= {**kept, "do": new_verb, **USUAL.get(new_verb, {})}
    apply_values(step, values)
    return made if written else write_texts(made, step["say"], say_step, step)


def apply_values(row: Json, values: Mapping[str, Any]) -> None:
    for key, value in values.items():
        if value is None:
            row.pop(key, None)
        else:
            row[key] = value


def duplicate_step(assessment: Json, identity: str) -> tuple[Json, str]:
    """With the same step once more behind it, and the id of that."""
    made = copy.deepcopy(assessment)
    number = find(made["steps"], identity)
    step = copy.deepcopy(made["steps"][number])
    step["id"] = make_id(identity, (other["id"] for other in made["steps"]))
    key, step["say"] = step["say"], make_id(f"step-{step['id']}", made["texts"]["en"])
    for texts in made["texts"].values():
        if key in texts:
            texts[step["say"]] = texts[key]
    made["steps"].insert(number + 1, step)
    return made, step["id"]


def move_step(assessment: Json, identity: str, to: int) -> Json:
    """With a step at another place of the list, counted from 0."""
    made = copy.deepcopy(assessment)
    step = made["steps"].pop(find(made["steps"], identity))
    made["steps"].insert(min(max(to, 0), len(made["steps"])), step)
    return made


def mute_step(assessment: Json, identity: str, muted: bool) -> Json:
    """A muted step stays in the list, and is not published."""
    return change_step(assessment, identity, {"muted": True if muted else None})


def remove_step(assessment: Json, identity: str) -> Json:
    made = copy.deepcopy(assessment)
    step = made["steps"].pop(find(made["steps"], identity))
    forget_step(made, identity)
    return forget_text(made, step["say"])


def without_muted(assessment: Json) -> Json:
    """As it is published: without the steps that are muted."""
    steps = assessment.get("steps")
    if not isinstance(steps, list):
        return assessment
    made = copy.deepcopy(assessment)
    for step in list(made["steps"]):
        if not isinstance(step, dict) or "muted" not in step:
            continue
        if step.pop("muted") is True:
            made["steps"].remove(step)
            forget_step(made, str(step.get("id")))
    return made


def forget_step(made: Json, identity: str) -> None:
    """Takes a step out of the lists of others."""
    rows = [("after", step) for step in made["steps"]]
    rows += [("during", limit) for limit in made.get("limits", [])]
    for key, row in rows:
        if isinstance(row, dict) and identity in row.get(key, ()):
            row[key] = [other for other in row[key] if other != identity]
            if key == "during" and not row[key]:
                del row[key]


# ---------------------------------------------------------------- limits


def add_limit(
    assessment: Json, measure: str, values: Mapping[str, Any] | None = None, then: str = "error",
    identity: str = "",
) -> tuple[Json, str]:  # fmt: skip
    """With one more limit, and its id; `values` are of `when`."""
    if measure not in MEASURES:
        raise AuthorError(f"measure: got {measure!r}, expected one of {', '.join(MEASURES)}")
    if then not in CONSEQUENCES:
        raise AuthorError(f"then: got {then!r}, expected one of {', '.join(CONSEQUENCES)}")
    made = copy.deepcopy(assessment)
    limits = made.setdefault("limits", [])
    name = identity or make_id(measure, (limit["id"] for limit in limits))
    if any(limit["id"] == name for limit in limits):
        raise AuthorError(f"id: got {name!r} once more, expected one of its own")
    when: Json = {"measure": measure, **choose_tool(made)}
    if measure in LIMIT_BOUNDS and not {"above", "below"} & set(values or ()):
        when["below" if measure == "clearance" else "above"] = LIMIT_BOUNDS[measure]
    apply_values(when, values or {})
    limit = {"id": name, "when": when, "then": then,
             "say": make_id(f"limit-{name}", made["texts"]["en"])}  # fmt: skip
    limits.append(limit)
    return write_texts(made, limit["say"], say_limit, limit), name


def change_limit(
    assessment: Json, identity: str, values: Mapping[str, Any], then: str = ""
) -> Json:
    made = copy.deepcopy(assessment)
    limit = made["limits"][find(made.get("limits", []), identity)]
    written = is_written(made, limit["say"], say_limit, limit)
    apply_values(limit["when"], values)
    limit["then"] = then or limit["then"]
    return made if written else write_texts(made, limit["say"], say_limit, limit)


def remove_limit(assessment: Json, identity: str) -> Json:
    made = copy.deepcopy(assessment)
    limit = made["limits"].pop(find(made.get("limits", []), identity))
    if not made["limits"]:  # an empty list is refused
        del made["limits"]
    return forget_text(made, limit["say"])


# ---------------------------------------------------------------- texts


def set_text(assessment: Json, key: str, code: str, text: str) -> Json:
    """An empty text is missing, which is an error in English and a warning elsewhere."""
    made = copy.deepcopy(assessment)
    texts = made["texts"].setdefault(code, {})
    if text or code == "en":
        texts[key] = text
    else:
        texts.pop(key, None)
    return made


def write_texts(made: Json, key: str, say: Any, row: Json) -> Json:
    """Writes what a row says into every language that has sentences of ours."""
    for code in LANGUAGES:
        if code == "en" or code in made["texts"]:
            made["texts"].setdefault(code, {})[key] = say(row, code)
    return made


def is_written(assessment: Json, key: str, say: Any, row: Json) -> bool:
    """Whether the author has replaced the default sentence."""
    texts = assessment["texts"]
    return any(texts.get(code, {}).get(key, say(row, code)) != say(row, code) for code in LANGUAGES)


def forget_text(made: Json, key: str) -> Json:
    """Takes a text out of every language, unless something says it still."""
    said = [made["title"], *(step["say"] for step in made["steps"])]
    if key not in [*said, *(limit["say"] for limit in made.get("limits", []))]:
        for texts in made["texts"].values():
            texts.pop(key, None)
    return made
