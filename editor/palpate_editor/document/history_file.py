# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of a history in a file: few of them, however many lines there are.

An array that the file has already is named, `{"array": "imported/vertices"}`. Rows of numbers of
all lines stand behind each other in two arrays, `{"integers": [start, stop]}` and
`{"numbers": [start, stop]}`. A surface is `{"surface": [vertices, triangles]}`,
with its colours behind them where it has some.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from palpate.files.json_part import json_kind
from palpate.files.refusal import Refusal

from palpate_editor.document.surface import Surface

Json = dict[str, Any]
Arrays = dict[str, np.ndarray]

PLACE = "history"
ROWS: dict[str, type] = {"integers": np.int32, "numbers": np.float64}
MARKS = ("array", "surface", *ROWS)
"""An object of one of these alone stands for an array or a surface."""


def digest(array: np.ndarray) -> tuple[str, tuple[int, ...], bytes]:
    raw = np.ascontiguousarray(array)
    return raw.dtype.str, raw.shape, hashlib.sha256(raw.tobytes()).digest()


class Packing:
    """Puts values into JSON, their arrays beside it."""

    def __init__(self, known: Mapping[str, np.ndarray]):
        """`known`: arrays that the file has anyway."""
        self.names = {digest(array): name for name, array in reversed(known.items())}
        self.whole: Arrays = {}
        self.rows: dict[str, list[np.ndarray]] = {name: [] for name in ROWS}
        self.ends = dict.fromkeys(ROWS, 0)

    def pack(self, value: Any) -> Any:
        if isinstance(value, Surface):
            arrays = (value.vertices, value.triangles, value.colours)
            return {"surface": [self.pack(array) for array in arrays if array is not None]}
        if isinstance(value, np.ndarray):
            return self.pack_array(value)
        if isinstance(value, Mapping):
            return {key: self.pack(part) for key, part in value.items()}
        if isinstance(value, list | tuple):
            return [self.pack(part) for part in value]
        return value

    def pack_array(self, array: np.ndarray) -> Json:
        key = digest(array)
        if key in self.names:
            return {"array": self.names[key]}
        if array.ndim == 1:
            kind = "integers" if np.issubdtype(array.dtype, np.integer) else "numbers"
            start = self.ends[kind]
            self.rows[kind].append(array.astype(ROWS[kind]))
            self.ends[kind] += len(array)
            return {kind: [start, self.ends[kind]]}
        name = f"{PLACE}/{len(self.whole)}"
        self.names[key], self.whole[name] = name, array
        return {"array": name}

    def list_arrays(self) -> Arrays:
        """What was put beside the JSON."""
        rows = {f"{PLACE}/{kind}": np.concatenate(r) for kind, r in self.rows.items() if r}
        return {**self.whole, **rows}


class Unpacking:
    """Takes values out of JSON that `Packing` made. Raises Refusal for whatever is damaged."""

    def __init__(self, arrays: Arrays, file: str):
        self.file = file
        self.arrays = dict(arrays)
        self.own = {name: arrays.pop(name) for name in list(arrays) if name.startswith(f"{PLACE}/")}
        self.unused = set(self.own)

    def refuse(self, where: str, got: Any, expected: str) -> Refusal:
        return Refusal(self.file, where, json_kind(got), expected)

    def unpack(self, where: str, value: Any) -> Any:
        if isinstance(value, list):
            return [self.unpack(f"{where}[{row}]", part) for row, part in enumerate(value)]
        if not isinstance(value, dict):
            return value
        if len(value) == 1 and (mark := next(iter(value))) in MARKS:
            if mark == "surface":
                return self.unpack_surface(where, value[mark])
            return self.unpack_array(where, mark, value[mark])
        return {key: self.unpack(f"{where}.{key}", part) for key, part in value.items()}

    def unpack_array(self, where: str, mark: str, value: Any) -> np.ndarray:
        if mark == "array":
            if not isinstance(value, str) or value not in self.arrays:
                raise self.refuse(where, value, "the name of an array of this file")
            self.unused.discard(value)
            return self.arrays[value]
        rows = self.own.get(f"{PLACE}/{mark}")
        if rows is None or rows.ndim != 1 or rows.dtype != ROWS[mark]:
            expected = f"{np.dtype(ROWS[mark]).str} of shape (n)"
            raise self.refuse(f"{PLACE}/{mark}", rows is not None, expected)
        self.unused.discard(f"{PLACE}/{mark}")
        whole = isinstance(value, list) and len(value) == 2 and all(type(v) is int for v in value)
        if not whole or not 0 <= value[0] <= value[1] <= len(rows):
            raise self.refuse(where, value, f"two ascending numbers of 0 to {len(rows)}")
        found = rows[value[0] : value[1]].copy()
        found.flags.writeable = False
        return found

    def unpack_surface(self, where: str, value: Any) -> Surface:
        if not isinstance(value, list) or len(value) not in (2, 3):
            raise self.refuse(where, value, "vertices and triangles, and perhaps colours")
        vertices, triangles, *rest = (self.unpack(where, part) for part in value)
        for array, dtype in ((vertices, np.float64), (triangles, np.int32)):
            fits = isinstance(array, np.ndarray) and array.dtype == dtype
            if not fits or array.ndim != 2 or array.shape[1] != 3:
                raise Refusal(self.file, where, "another array", f"{np.dtype(dtype).str} (n, 3)")
        if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(vertices):
            numbers = f"vertex numbers {triangles.min()} to {triangles.max()}"
            raise Refusal(self.file, where, numbers, f"0 to {len(vertices) - 1}")
        return Surface(vertices, triangles, self.check_colours(where, rest, len(vertices)))

    def check_colours(self, where: str, rest: list[Any], count: int) -> np.ndarray | None:
        if not rest:
            return None
        colours = rest[0]
        fits = isinstance(colours, np.ndarray) and colours.dtype == np.uint8
        if not fits or colours.shape != (count, 3):
            raise Refusal(self.file, where, "another array", f"|u1 of shape ({count}, 3)")
        return colours

    def finish(self) -> None:
        """Refuses an array that nobody took."""
        if self.unused:
            raise Refusal(self.file, sorted(self.unused)[0], "an unknown array", "those of lines")
