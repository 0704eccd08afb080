# SPDX-License-Identifier: BSD-3-Clause
"""Script files: where a hand goes and when it takes hold, as readable JSON.

What a ScriptedDevice follows. bindings/palpate/schemas/script.schema.json describes the file.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.files.json_document import read_document
from palpate.files.json_part import json_kind, read_part
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.runs.live import LONGEST

FORMAT, VERSION = "palpate script", 1
MOST_FRAMES = 100_000
MOST_BYTES = 32 * 2**20


@dataclass(frozen=True)
class FramePart:
    """One key frame of a script."""

    time: float
    """[s] since the run began, later than that of the frame before."""
    position: tuple[float, ...]
    """[m] of the middle of the tip."""
    buttons: int = 0
    """From this time on: 1 takes hold of what the tip touches."""


def write_script_file(path: Path, frames: Sequence[palpate.KeyFrame]) -> None:
    """Writes whole or not at all. Raises OSError, and ValueError for frames nothing can follow."""
    palpate.ScriptedDevice(frames)
    rows = [
        {
            "time": frame.time,
            "position": np.asarray(frame.position).tolist(),
            "buttons": frame.buttons,
        }
        for frame in frames
    ]
    lines = ",\n    ".join(json.dumps(row, allow_nan=False) for row in rows)
    text = (
        f'{{\n  "format": "{FORMAT}",\n  "version": {VERSION},\n  "frames": [\n    {lines}\n  ]\n}}'
    )
    write_whole(path, (text + "\n").encode())


def read_script_file(path: Path) -> list[palpate.KeyFrame]:
    """Reads and checks a script. Raises Refusal or OSError."""
    data = read_document(
        path, format=FORMAT, version=VERSION, what="a script", most_bytes=MOST_BYTES
    )
    rows = check_head(path, data)
    frames = [read_frame(path, k, row) for k, row in enumerate(rows)]
    for k, (before, frame) in enumerate(zip(frames, frames[1:], strict=False), start=1):
        if not frame.time > before.time:
            raise Refusal(
                path, f"frames[{k}].time", f"{frame.time:g} s", f"more than {before.time:g} s"
            )
    return frames


def check_head(path: Path, data: dict[str, Any]) -> list[Any]:
    """The rows of a script whose outer form is right."""
    unknown = set(data) - {"format", "version", "frames"}
    if unknown:
        raise Refusal(path, sorted(unknown)[0], "an unknown field", "format, version and frames")
    rows = data.get("frames")
    if not isinstance(rows, list) or not 1 <= len(rows) <= MOST_FRAMES:
        found = f"{len(rows)} frames" if isinstance(rows, list) else json_kind(rows)
        raise Refusal(path, "frames", found, f"a list of 1 to {MOST_FRAMES}")
    return rows


def read_frame(path: Path, number: int, row: Any) -> palpate.KeyFrame:
    where = f"frames[{number}]"
    frame = read_part(path, where, FramePart, row)
    if not 0.0 <= frame.time <= LONGEST:
        raise Refusal(path, f"{where}.time", f"{frame.time:g} s", f"0 to {LONGEST:g} s")
    if len(frame.position) != 3:
        raise Refusal(path, f"{where}.position", f"{len(frame.position)} numbers", "3, in metres")
    if not 0 <= frame.buttons <= 255:
        raise Refusal(path, f"{where}.buttons", str(frame.buttons), "0 to 255")
    return palpate.KeyFrame(frame.time, frame.position, frame.buttons)
