# SPDX-License-Identifier: GPL-3.0-or-later
"""Every edit leaves a line in the organ's history, by which it can be done again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from functools import cache, wraps
from types import UnionType
from typing import Any, get_args, get_origin, get_type_hints

import numpy as np
from palpate.files.json_part import json_kind, read_value
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import LATER

from palpate_editor.document import EMPTY, History, Line, Organ, Surface, freeze
from palpate_editor.document.history import has_room
from palpate_editor.edits.edit import Edit
from palpate_editor.edits.keep_colours import keep_colours


def write_down(kind: type) -> None:
    """Lets every call of an edit of this class leave its line, and keep the organ's colours."""
    call = kind.__call__

    @wraps(call)
    def noted(self: Edit, organ: Organ) -> Organ:
        made = call(self, organ)
        begins = getattr(self, "begins", False)
        return note(self, organ, made if begins else keep_colours(organ, made))

    kind.__call__ = noted  # type: ignore[method-assign]


def note(edit: Edit, before: Organ, after: Organ) -> Organ:
    """`after` with the line of the edit behind those of `before`.

    Edits that the edit itself called leave none. An import begins the history again, with the
    constants of before; so does an edit for whose line there is no room.
    """
    line = write_line(edit)
    begins = getattr(edit, "begins", False) and before.surface is not None
    history = before.history or History(replace(before, history=None))
    lines = (*history.lines, line)
    if begins:
        history = History(take_surface_away(before))
        lines = (line,)
    elif not has_room(lines):
        folded = history.folded + len(history.lines)
        history, lines = History(replace(before, history=None), folded=folded), (line,)
    return replace(after, history=replace(history, lines=lines))


SURFACES_OWN = ("source", "segmentation", "assembly", "decimation", "filling", "far_field")
"""Of an organ, what goes with its surface."""


def take_surface_away(organ: Organ) -> Organ:
    """What of an organ outlasts the import of another surface."""
    bare = {name: getattr(EMPTY, name) for name in SURFACES_OWN}
    arrays = {name: getattr(EMPTY, name) for name in ("fixed", "stiffness_scale", "regions")}
    return replace(organ, imported=None, surface=None, history=None, **bare, **arrays)


# ---------------------------------------------------------------- from an edit to its line


def write_line(edit: Edit) -> Line:
    """By its class and fields. An edit that holds what it made says as `repeat` what makes that."""
    told = getattr(edit, "repeat", edit)
    return Line(type(told).__name__, write_fields(told))


def write_fields(part: Any) -> dict[str, Any]:
    """In the order in which a file has them."""
    hints, unsaid = find_hints(type(part)), find_unsaid(part)
    names = sorted(set(hints) - unsaid)
    return {name: write_field(getattr(part, name), hints[name]) for name in names}


def find_unsaid(part: Any) -> set[str]:
    later = (f for f in fields(part) if f.metadata.get(LATER))
    return {f.name for f in later if getattr(part, f.name) == f.default}


@cache
def find_hints(kind: type) -> dict[str, Any]:
    """Field -> type."""
    hints = get_type_hints(kind)
    return {f.name: hints[f.name] for f in fields(kind)}


def list_kinds(hint: Any) -> tuple[Any, ...]:
    return tuple(get_args(hint)) if isinstance(hint, UnionType) else (hint,)


def write_field(value: Any, hint: Any = None) -> Any:
    if isinstance(value, Surface):
        return value
    if np.ndarray in list_kinds(hint) and np.ndim(value) == 1:
        value = np.asarray(value)
    if isinstance(value, np.ndarray) and value.ndim:
        whole = np.issubdtype(value.dtype, np.integer)
        return freeze(value, np.int32 if whole else np.float64, (None,))
    if isinstance(value, np.generic | np.ndarray):
        return value.item()
    if is_dataclass(value):
        return write_fields(value)
    if isinstance(value, int) and float in list_kinds(hint):
        return float(value)
    if isinstance(value, Mapping):
        return {name: write_field(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [write_field(part) for part in value]
    return value


# ---------------------------------------------------------------- and back


def read_line(line: Line, kinds: Mapping[str, type], file: object, where: str) -> Edit:
    """The edit of a line. Raises Refusal where its values are not those of such an edit."""
    kind = kinds.get(line.edit)
    if kind is None:
        known = ", ".join(sorted(kinds))
        raise Refusal(file, f"{where}.edit", json_kind(line.edit), f"one of {known}")
    return read_fields(file, where, kind, line.values)


def read_fields(file: object, where: str, kind: Any, values: Any) -> Any:
    if not isinstance(values, Mapping):
        raise Refusal(file, where, say(values), "an object")
    hints = find_hints(kind)
    names = list(hints)
    for name in values:
        if name not in names:
            raise Refusal(file, f"{where}.{name}", "an unknown value", f"one of {', '.join(names)}")
    read = {
        name: read_field(file, f"{where}.{name}", hints[name], value)
        for name, value in values.items()
    }
    try:
        return kind(**read)
    except TypeError:
        missing = [name for name in names if name not in values]
        raise Refusal(file, where, f"no {', '.join(missing)}", "every value of it") from None


def read_field(file: object, where: str, hint: Any, value: Any) -> Any:
    """A value of one of the types that a field may have: those of a document, None beside one,
    surfaces, arrays of one dimension."""
    kinds = list_kinds(hint)
    if value is None and type(None) in kinds:
        return None
    for kind in (np.ndarray, Surface):
        if isinstance(value, kind) and kind in kinds:
            return value
    if isinstance(value, np.ndarray | Surface):
        raise Refusal(file, where, say(value), say_kinds(kinds))
    plain = [k for k in kinds if k not in (type(None), np.ndarray, Surface)]
    if len(plain) != 1:
        raise Refusal(file, where, say(value), say_kinds(kinds))
    if is_dataclass(plain[0]):
        return read_fields(file, where, plain[0], value)
    return read_plain(file, where, plain[0], value)


def read_plain(file: object, where: str, kind: Any, value: Any) -> Any:
    """Text, numbers, and tuples of them; a tuple of so many must have as many."""
    parts, origin = get_args(kind), get_origin(kind)
    if origin is not tuple or Ellipsis in parts:
        return read_value(file, where, kind, value)
    if not isinstance(value, list) or len(value) != len(parts):
        raise Refusal(file, where, say(value), f"a list of {len(parts)}")
    return tuple(
        read_value(file, f"{where}[{row}]", part, each)
        for row, (part, each) in enumerate(zip(parts, value, strict=True))
    )


def say(value: Any) -> str:
    if isinstance(value, Surface):
        return "a surface"
    if isinstance(value, np.ndarray):
        return f"an array of {value.size} numbers"
    return "an object" if isinstance(value, Mapping) else json_kind(value)


def say_kinds(kinds: tuple[Any, ...]) -> str:
    names = {np.ndarray: "an array", Surface: "a surface", type(None): "null"}
    return " or ".join(names.get(kind, getattr(kind, "__name__", str(kind))) for kind in kinds)
