# SPDX-License-Identifier: BSD-3-Clause
"""Dataclasses read from JSON, every field checked against its annotation.

An unknown field is refused: a parameter that has no effect is an error, not a habit.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Collection
from dataclasses import fields, is_dataclass
from types import UnionType
from typing import Any, get_args, get_type_hints

from palpate.files.refusal import Refusal


def read_part(
    file: object,
    name: str,
    kind: type,
    section: Any,
    *,
    without: Collection[str] = (),
    whole: bool = False,
) -> Any:
    """An instance of the dataclass `kind`. Raises Refusal.

    Args:
        file: What refusals call the file.
        name: Where in it the section stands.
        kind: Its fields are text, truths, numbers, None beside a number, tuples of those, or
            dataclasses of that sort, None beside one, tuples of one.
        section: The JSON object.
        without: Fields that are kept elsewhere and keep their defaults.
        whole: Nothing may be missing, whether it has a default or not.
    """
    if not isinstance(section, dict):
        raise Refusal(file, name, json_kind(section), "an object")
    known = {f.name for f in fields(kind)} - set(without)
    unknown, missing = sorted(set(section) - known), sorted(known - set(section))
    if unknown:
        expected = "one of " + ", ".join(sorted(known))
        raise Refusal(file, f"{name}.{unknown[0]}", "an unknown field", expected)
    hints = get_type_hints(kind)
    values = {
        key: read_value(file, f"{name}.{key}", hints[key], value, whole)
        for key, value in section.items()
    }
    try:
        if whole and missing:
            raise TypeError
        return kind(**values)
    except TypeError:
        raise Refusal(file, name, "no " + ", ".join(missing), "every field of it") from None


def is_number(value: Any) -> bool:
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number beyond what a float can be
        return False


def is_whole(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def is_text(value: Any) -> bool:
    return isinstance(value, str)


def list_of(test: Callable[[Any], bool]) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, list) and all(map(test, value))


def floats(values: list[float]) -> tuple[float, ...]:
    return tuple(map(float, values))


KINDS: dict[Any, tuple[str, Callable[[Any], bool], Callable[[Any], Any]]] = {
    str: ("text", is_text, str),
    bool: ("true or false", lambda value: isinstance(value, bool), bool),
    int: ("a whole number", is_whole, int),
    float: ("a finite number", is_number, float),
    float | None: (
        "a finite number or null",
        lambda value: value is None or is_number(value),
        lambda value: None if value is None else float(value),
    ),
    tuple[str, ...]: ("a list of text", list_of(is_text), tuple),
    tuple[int, ...]: ("a list of whole numbers", list_of(is_whole), tuple),
    tuple[float, ...]: ("a list of finite numbers", list_of(is_number), floats),
}
"""Annotation -> what it is called, what JSON it takes, what becomes of that."""


def read_value(file: object, where: str, hint: Any, value: Any, whole: bool = False) -> Any:
    """One field, checked against its annotation. Numbers must be finite."""
    if hint not in KINDS:
        return read_parts(file, where, hint, value, whole)
    expected, takes, convert = KINDS[hint]
    if not takes(value):
        raise Refusal(file, where, json_kind(value), expected)
    try:
        return convert(value)
    except OverflowError:  # a whole number beyond what a float can be
        raise Refusal(file, where, json_kind(value), expected) from None


def read_parts(file: object, where: str, hint: Any, value: Any, whole: bool) -> Any:
    """A dataclass, one that may be null, or a list of one."""
    [*kinds] = filter(is_dataclass, get_args(hint))
    if not kinds:
        return read_part(file, where, hint, value, whole=whole)
    if isinstance(hint, UnionType):
        return None if value is None else read_part(file, where, kinds[0], value, whole=whole)
    if not isinstance(value, list):
        raise Refusal(file, where, json_kind(value), "a list")
    return tuple(
        read_part(file, f"{where}[{row}]", kinds[0], part, whole=whole)
        for row, part in enumerate(value)
    )


def json_kind(value: Any) -> str:
    text = json.dumps(value)
    return text if len(text) <= 40 else text[:37] + "..."
