# SPDX-License-Identifier: BSD-3-Clause
"""Any bytes as a script or a scene file: either is kept when written again, or refused.

Fuzzed by tests/fuzz/run_atheris.py; what it found stands in tests/fuzz/corpus.
"""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

from palpate.files.refusal import Refusal
from palpate.runs.script_file import read_script_file, write_script_file
from palpate.scene.scene_file import read_scene_file, write_scene_file


@cache
def folder() -> Path:
    """In memory where there is such a place, gone with the process."""
    memory = Path("/dev/shm")
    kept = tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None)
    folder.kept = kept  # type: ignore[attr-defined]
    return Path(kept.name)


def place(data: bytes) -> Path:
    path = folder() / "fuzzed.json"
    path.write_bytes(data)
    return path


def try_script(data: bytes) -> bool:
    """Whether the bytes are a script. Raises for whatever is neither one nor refused in words."""
    try:
        frames = read_script_file(place(data))
    except Refusal as refusal:
        assert str(refusal)
        return False
    again = folder() / "again.json"
    write_script_file(again, frames)
    assert [describe(frame) for frame in read_script_file(again)] == list(map(describe, frames))
    return True


def describe(frame: object) -> tuple[object, ...]:
    return frame.time, tuple(frame.position), frame.buttons  # type: ignore[attr-defined]


def try_scene_file(data: bytes) -> bool:
    """Whether the bytes are a scene file. Raises for what is neither one nor refused in words."""
    try:
        scene = read_scene_file(place(data))
    except Refusal as refusal:
        assert str(refusal)
        return False
    again = folder() / "again.json"
    write_scene_file(again, scene)
    assert read_scene_file(again) == scene
    return True
