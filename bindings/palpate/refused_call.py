# SPDX-License-Identifier: BSD-3-Clause
"""The sentence for a call that no signature takes; the compiled module asks for it.

What pybind11 says lists every signature and every argument. Here the first argument that does not
fit is found by the words of the signature, and named with what it was and what was expected.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

NUMBER = "typing.SupportsFloat | typing.SupportsIndex"
WHOLE = "typing.SupportsInt | typing.SupportsIndex"
MODULES = r"palpate(?:\._sim|_editor\._authoring)\."
"""What the names of bound classes begin with."""
LONGEST = 60
"""[characters] of a value that a refusal repeats."""


@dataclass(frozen=True)
class Parameter:
    name: str
    kind: str
    required: bool
    keyword_only: bool


def describe(value: object) -> str:
    """What a value is, in short: "str 'abc'", "float64 of shape (4, 3)"."""
    if isinstance(value, np.ndarray):
        return f"{value.dtype.name} of shape {value.shape}"
    if value is None:
        return "None"
    shown = " ".join(repr(value).split())
    if len(shown) > LONGEST:
        shown = shown[: LONGEST - 3] + "..."
    name = type(value).__name__
    return (
        shown
        if shown.startswith((name, f"<{name}")) or "palpate" in shown[:9]
        else f"{name} {shown}"
    )


def split_signature(text: str) -> list[str]:
    """What stands between the commas at the outermost level."""
    parts, depth, quoted, start = [], 0, "", 0
    for at, letter in enumerate(text):
        if quoted:
            quoted = "" if letter == quoted else quoted
        elif letter in "\"'":
            quoted = letter
        elif letter in "([{<":
            depth += 1
        elif letter in ")]}" or (letter == ">" and text[at - 1] != "-"):
            depth -= 1
        elif letter == "," and depth == 0:
            parts.append(text[start:at].strip())
            start = at + 1
    return [part for part in [*parts, text[start:].strip()] if part]


def read_signature(text: str) -> list[Parameter]:
    """Parameters of one signature, without self."""
    opening = text.index("(")
    closing = text.rindex(") -> ") if ") -> " in text else text.rindex(")")
    found, keyword_only = [], False
    for part in split_signature(text[opening + 1 : closing]):
        if part == "*":
            keyword_only = True
            continue
        if part == "/":
            continue
        name, _, rest = part.partition(": ")
        kind, equals, _ = rest.partition(" = ")
        if name != "self":
            found.append(Parameter(name, kind, not equals, keyword_only))
    return found


def name_kind(kind: str) -> str:
    """A type of pybind11's in words."""
    if size := re.search(r'"\[(\d+), 1\]"', kind):
        return f"numbers of shape ({size[1]},)"
    if size := re.search(r'"\[(\d+), (\d+)\]"', kind):
        return f"numbers of shape ({size[1]}, {size[2]})"
    if size := re.search(r'FixedSize\((\d+)\)|"FixedSize\((\d+)\)"', kind):
        return f"{size[1] or size[2]} of them in a list"
    kind = kind.replace(NUMBER, "a number").replace(WHOLE, "a whole number")
    kind = re.sub(r"typing\.Annotated\[numpy\.typing\.\w+, numpy\.(\w+)\]", r"an array of \1", kind)
    kind = re.sub(rf"{MODULES}(?:_scenario\.)?|collections\.abc\.|typing\.", "", kind)
    return kind.replace(" | ", " or ")


def find_class(kind: str) -> type | None:
    """The class that a signature names, with its module."""
    module = re.match(MODULES, kind)
    found: object = sys.modules.get(module[0].removesuffix(".")) if module else None
    for part in re.sub(MODULES, "", kind).split("."):
        found = getattr(found, part, None)
    return found if isinstance(found, type) else None


def fits_array(value: object, shape: tuple[int, ...]) -> bool:
    try:
        array = np.asarray(value)
    except ValueError:
        return False
    column = len(shape) == 2 and shape[1] == 1
    return array.dtype.kind in "biuf" and (
        array.shape == shape or (column and array.shape in (shape[:1], shape[::-1]))
    )


def fits_one(value: object, kind: str) -> bool:
    if shape := re.search(r'"\[(\d+), (\d+)\]"', kind):
        return fits_array(value, (int(shape[1]), int(shape[2])))
    if kind == NUMBER:
        return hasattr(value, "__float__") or hasattr(value, "__index__")
    if kind == WHOLE:
        return not isinstance(value, float) and (
            hasattr(value, "__index__") or hasattr(value, "__int__")
        )
    if kind in ("bool", "str", "bytes"):
        return isinstance(value, {"bool": bool | np.bool_, "str": str, "bytes": bytes}[kind])
    if re.match(MODULES, kind):
        known = find_class(kind)
        return known is None or isinstance(value, known)
    if kind == "None":
        return value is None
    if sequence := re.search(r"(?:Sequence|list)\[(.*)\]", kind):
        if isinstance(value, str | bytes) or not isinstance(value, Iterable):
            return False
        return "[" in sequence[1] or all(fits(entry, sequence[1]) for entry in value)
    return True


def fits(value: object, kind: str) -> bool:
    """Whether a type of pybind11's words takes a value, as far as words tell."""
    if fits_one(value, kind):
        return True
    if NUMBER in kind or WHOLE in kind:
        rest = kind.replace(NUMBER, "").replace(WHOLE, "").strip(" |")
        known = NUMBER if NUMBER in kind else WHOLE
        return (
            "[" not in kind
            and kind != known
            and (fits_one(value, known) or (rest != "" and fits(value, rest)))
        )
    return (
        " | " in kind
        and "[" not in kind
        and any(fits_one(value, part) for part in kind.split(" | "))
    )


def find_fault(
    parameters: list[Parameter], given: tuple[Any, ...], named: Mapping[str, Any]
) -> tuple[int, str] | None:
    """How many arguments fitted before one did not, and what is wrong with that; None: nothing."""
    known = [parameter.name for parameter in parameters]
    places = [parameter for parameter in parameters if not parameter.keyword_only]
    takes = ", ".join(known) or "no arguments"
    if len(given) > len(places):
        most = f"at most {len(places)}" if places else "none: they go by name"
        return 0, f"got {len(given)} arguments by place, expected {most} ({takes})"
    for name in named:
        if name not in known:
            return 0, f"got an argument {name!r}, expected {takes}"
    values = {parameter.name: value for parameter, value in zip(places, given, strict=False)}
    for name in named:
        if name in values:
            return 0, f"{name}: got twice, expected once"
    values.update(named)
    for fitted, parameter in enumerate(parameters):
        if parameter.name not in values:
            if parameter.required:
                return (
                    fitted,
                    f"{parameter.name}: got nothing, expected {name_kind(parameter.kind)}",
                )
        elif not fits(values[parameter.name], parameter.kind):
            found = describe(values[parameter.name])
            return fitted, f"{parameter.name}: got {found}, expected {name_kind(parameter.kind)}"
    return None


def require_no_override(subclass: type) -> None:
    """Raises TypeError for a subclass with a method of its own where only C++ calls that method."""
    compiled = [base for base in subclass.__mro__ if base.__module__ == "palpate._sim"]
    for name in {name for base in compiled for name in vars(base) if not name.startswith("_")}:
        owner = next(base for base in subclass.__mro__ if name in vars(base))
        if owner.__module__ != "palpate._sim":
            raise TypeError(
                f"{subclass.__name__}.{name}: got a method of a Python class, expected none: the "
                f"haptic thread, which Python never enters, calls that of {compiled[0].__name__}; "
                "to write a device in Python, hand its driver to a PythonDevice"
            )


def explain(name: str, text: str, given: tuple[Any, ...], named: Mapping[str, Any]) -> TypeError:
    """The refusal of a call of `name`, from what pybind11 says of it and the arguments."""
    if "(): incompatible " not in text:
        return TypeError(f"{name}: {text}")
    signatures = re.findall(r"^    \d+\. (.*)$", text, flags=re.MULTILINE)
    method = any("(self: " in signature for signature in signatures) or name.endswith(".__init__")
    given = given[1:] if method else given
    called = name.removesuffix(".__init__")
    parameters = [read_signature(signature) for signature in signatures]
    faults = [fault for each in parameters if (fault := find_fault(each, given, named))]
    if faults and len(faults) == len(parameters):
        shown = max(faults)[1] if len(faults) == 1 else max(faults, key=lambda fault: fault[0])[1]
        # what is assigned to a property has no name of its own
        shown = re.sub(r"^(?:arg\d|value): ", "", shown)
        return TypeError(f"{called}: {shown}")
    found = ", ".join([*map(describe, given), *(f"{k}={describe(v)}" for k, v in named.items())])
    takes = " or ".join(
        "(" + ", ".join(f"{p.name}: {name_kind(p.kind)}" for p in each) + ")" for each in parameters
    )
    return TypeError(f"{called}: got ({found}), expected {takes}")
