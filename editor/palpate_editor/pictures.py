# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures that a file's surfaces are painted with, decoded in a process of its own: as wary as
that of the mesh, since a picture is no less foreign than it."""

from __future__ import annotations

import os
import struct
import subprocess
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from palpate.system.isolated import build_isolated

from palpate_editor import authoring

CHILD = Path(__file__).parent / "formats_child" / "picture.py"
MEMORY = 1_500_000_000
"""[bytes] Of address space, for all pictures of a file."""
SECONDS = 30
"""[s] Of processor time, and on a clock."""


def decode_pictures(
    pictures: Sequence[authoring.Picture],
) -> tuple[list[np.ndarray | None], list[str]]:
    """(h, w, 3) uint8, sRGB, from the upper left, of each; None and a sentence for what is no
    picture, or too large a one."""
    if not pictures:
        return [], []
    if find_spec("PIL") is None:
        said = "its pictures stay behind: the package pillow, which decodes them, is not there"
        return [None] * len(pictures), [f"{said} (pip install palpate-editor[formats])"]
    given = struct.pack("<I", len(pictures)) + b"".join(
        struct.pack("<I", len(picture.bytes)) + picture.bytes for picture in pictures
    )
    try:
        run = subprocess.run(
            [*build_isolated(CHILD, list_folders()), str(MEMORY), str(SECONDS)],
            input=given,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=SECONDS,
            check=False,
        )
        answer = run.stdout
    except subprocess.TimeoutExpired as late:
        answer = late.stdout or b""
    return take_answer(pictures, answer)


def list_folders() -> str:
    folders = []
    for name in ("palpate_editor", "PIL"):
        found = find_spec(name)
        if found is not None and found.origin is not None:
            folders.append(str(Path(found.origin).parent.parent))
    return os.pathsep.join(dict.fromkeys(folders))


def take_answer(
    pictures: Sequence[authoring.Picture], answer: bytes
) -> tuple[list[np.ndarray | None], list[str]]:
    decoded: list[np.ndarray | None] = []
    notes, at = [], 0
    for picture in pictures:
        pixels, why, at = take_picture(answer, at)
        decoded.append(pixels)
        if pixels is None:
            notes.append(f"the picture {picture.name} stays behind: {why}")
    return decoded, notes


def take_picture(answer: bytes, at: int) -> tuple[np.ndarray | None, str, int]:
    """The next picture, or why there is none; and where the one behind it begins."""
    ended = "it was not decoded in the time and memory there is for it"
    if len(answer) < at + 8:
        return None, ended, len(answer)
    width, height = struct.unpack_from("<2I", answer, at)
    at += 8
    if width == 0 or height == 0:
        (size,) = struct.unpack_from("<I", answer, at)
        return None, answer[at + 4 : at + 4 + size].decode(errors="replace"), at + 4 + size
    if len(answer) < at + 3 * width * height:
        return None, ended, len(answer)
    pixels = np.frombuffer(answer, np.uint8, 3 * width * height, at)
    return pixels.reshape(height, width, 3), "", at + 3 * width * height
