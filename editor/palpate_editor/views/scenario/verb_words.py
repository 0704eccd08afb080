# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Scenario stage does, as a verb that does the same to a file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from palpate.assessment import author, author_tools, author_values
from palpate.assessment.author import Json

Words = list[str]
OPTIONS = {
    "force_N": "--force", "depth_m": "--depth", "distance_m": "--distance", "for_s": "--for",
    "within_s": "--within", "share": "--share", "at": "--at", "do": "--do",
    "from": "--space", "to": "--space",
}  # fmt: skip
"""Members of a step, as `palpate scenario step` says them."""
UNITS = {"force_N": "N", "depth_m": "m", "distance_m": "m", "for_s": "s", "within_s": "s"}


def find_words(act: Callable[..., Any], arguments: tuple[Any, ...]) -> Words:
    """Verb and options of a change by a function of palpate.assessment; none where no one verb does
    the same.
    """
    say = SAYINGS.get(act)
    return [] if say is None else say(*arguments)


def list_new_places(before: Json | None, after: Json) -> list[tuple[str, Json]]:
    """Those that a change has put in, or made another."""
    known = {} if before is None else before.get("places", {})
    return [(name, row) for name, row in after.get("places", {}).items() if known.get(name) != row]


def say_place(place: Json) -> str:
    """As --at has it."""
    if "region" in place:
        return f"region:{str(place['region']).partition('/')[2]}"
    if "object" in place:
        return f"object:{place['object']}"
    for kind in ("ball", "space"):
        if kind in place:
            return f"{kind}:" + ",".join(map(str, place[kind]))
    return "path:" + ":".join(",".join(map(str, point)) for point in place["path"])


def say_value(name: str, value: Any) -> str:
    unit = UNITS.get(name, "")
    if isinstance(value, list):
        ends = ["" if end is None else end if isinstance(end, str) else f"{end!r}{unit}"
                for end in value]  # fmt: skip
        return "..".join(ends)
    return f"{value!r}{unit}" if isinstance(value, int | float) else str(value)


def say_step(identity: str, values: Mapping[str, Any]) -> Words:
    words = ["step", "--change", identity]
    for name, value in values.items():
        if name in OPTIONS:
            words.append(f"{OPTIONS[name]}={'none' if value is None else say_value(name, value)}")
    return words


def say_limit(identity: str, values: Mapping[str, Any], then: str = "") -> Words:
    words = ["limit", "--change", identity]
    words += [f"--{name}={value}" for name, value in values.items() if name in ("above", "below")]
    return [*words, "--then", then] if then else words


def say_move(identity: str, to: int) -> Words:
    return ["step", "--move", identity, "--to", str(to + 1)]


def say_mute(identity: str, muted: bool) -> Words:
    return ["step", "--mute" if muted else "--unmute", identity]


def say_text(key: str, code: str, text: str) -> Words:
    return ["text", key, text, "--in", code]


def say_parameter(name: str, values: Mapping[str, Any]) -> Words:
    words = ["parameter", "--set", name]
    for key, value in values.items():
        if key == "uniform":
            words.append(f"--uniform={value[0]!r}..{value[1]!r}")
        elif key == "choose":
            words.append("--choose=" + ",".join(map(str, value)))
        else:
            words.append(f"--{key}={value}")
    return words


def say_level_value(name: str, level: str, value: float | None) -> Words:
    return [
        "parameter",
        "--set",
        name,
        "--level",
        f"{level}={'' if value is None else repr(value)}",
    ]


def say_use_in_limit(identity: str, name: str, unit: str) -> Words:
    del unit
    return ["limit", "--change", identity, f"--above=${name}"]


TOOL_OPTIONS = {
    "radius_m": ("--radius", "m"), "length_m": ("--length", "m"), "friction": ("--friction", ""),
    "jaw_opening_rad": ("--jaw-opening", ""), "grip_force_N": ("--grip-force", "N"),
    "trocar_height_m": ("--trocar-height", "m"), "trocar_side_m": ("--trocar-side", "m"),
    "fulcrum_m": ("--fulcrum", "m"),
}  # fmt: skip


def say_tool(name: str, values: Mapping[str, Any]) -> Words:
    words = ["tool", "--set", name]
    for member, value in values.items():
        if member in TOOL_OPTIONS and value is not None:
            option, unit = TOOL_OPTIONS[member]
            words.append(f"{option}={value!r}{unit}")
    return words


SAYINGS: dict[Callable[..., Any], Callable[..., Words]] = {
    author.change_step: say_step,
    author.duplicate_step: lambda identity: ["step", "--duplicate", identity],
    author.move_step: say_move,
    author.mute_step: say_mute,
    author.remove_step: lambda identity: ["step", "--remove", identity],
    author.change_limit: say_limit,
    author.remove_limit: lambda identity: ["limit", "--remove", identity],
    author.set_text: say_text,
    author_tools.set_kind: lambda name, kind: ["tool", "--set", name, "--kind", kind],
    author_tools.set_tool: say_tool,
    author_tools.remove_tool: lambda name: ["tool", "--remove", name],
    author_tools.give_step: lambda step, name: ["step", "--change", step, "--tool", name],
    author_values.set_time: lambda seconds: ["time", f"{seconds!r}s"],
    author_values.add_level: lambda name: ["level", "--add", name],
    author_values.remove_level: lambda name: ["level", "--remove", name],
    author_values.set_parameter: say_parameter,
    author_values.set_level_value: say_level_value,
    author_values.remove_parameter: lambda name: ["parameter", "--remove", name],
    author_values.rename_parameter: lambda old, new: ["parameter", "--rename", old, "--to", new],
    author_values.use_in_limit: say_use_in_limit,
}
