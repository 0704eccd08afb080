# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of an organ's history: what was done to it, by name, with the values it was done with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

MOST_LINES = 1000
MOST_TEXT = 500_000
"""[bytes] Of all lines together, which a file has room for."""
MOST_NUMBERS = 4_000_000
"""Vertex numbers and factors of all lines together; surfaces are not counted."""


@dataclass(frozen=True, eq=False)
class Line:
    """One operation. Its values are JSON, arrays that cannot be written, and surfaces."""

    edit: str
    """The name of the class that does it (palpate_editor.edits.LINES)."""
    values: Mapping[str, Any]
    text: int = field(init=False)
    """[bytes] it takes, about."""
    numbers: int = field(init=False)
    """In its arrays."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "text", count_text(self.values) + len(self.edit))
        object.__setattr__(self, "numbers", count_numbers(self.values))


def count_text(value: Any) -> int:
    """[bytes] About what a value takes as JSON."""
    if isinstance(value, Mapping):
        return sum(len(key) + 4 + count_text(part) for key, part in value.items())
    if isinstance(value, list | tuple):
        return 2 + sum(map(count_text, value))
    # a letter takes at most six bytes, as \\u0131
    return 6 * len(value) + 2 if isinstance(value, str) else 24


def count_numbers(value: Any) -> int:
    """In the arrays of a value, surfaces left out."""
    if isinstance(value, np.ndarray):
        return value.size
    if isinstance(value, Mapping):
        return sum(map(count_numbers, value.values()))
    if isinstance(value, list | tuple):
        return sum(map(count_numbers, value))
    return 0


def has_room(lines: tuple[Line, ...]) -> bool:
    """Whether a file has room for so many."""
    return (
        len(lines) <= MOST_LINES
        and sum(line.text for line in lines) <= MOST_TEXT
        and sum(line.numbers for line in lines) <= MOST_NUMBERS
    )
