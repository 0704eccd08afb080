# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file holds, and the bytes that tell it to the program that asked (scene_stream.h)."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

import numpy as np

MAGIC = struct.pack("<Q", 0x31454E4543534C50)
SCENE, REFUSAL = 0, 1


class Refusal(Exception):
    """A file that is no mesh: where in it, what was found, what was expected."""

    def __init__(self, where: str, got: str, expected: str):
        super().__init__(got)
        self.where, self.got, self.expected = where, got, expected


@dataclass(frozen=True, eq=False)
class Part:
    """One named surface."""

    name: str
    vertices: np.ndarray
    """(n, 3) in units and axes of the file"""
    triangles: np.ndarray
    """(t, 3)"""


@dataclass(frozen=True, eq=False)
class Scene:
    """All surfaces of a file."""

    parts: list[Part]
    notes: list[str] = field(default_factory=list)
    """What was odd but could be read all the same."""


def cut_out(name: str, vertices: np.ndarray, triangles: np.ndarray) -> Part:
    """The vertices that some triangles use, in the order of the file. Raises Refusal for a corner
    that there is no vertex for."""
    triangles = np.asarray(triangles, np.int64).reshape(-1, 3)
    check_corners(name, triangles, len(vertices))
    used = np.unique(triangles)
    place = np.zeros(len(vertices), np.int32)
    place[used] = np.arange(len(used), dtype=np.int32)
    return Part(name, np.asarray(vertices, float)[used], place[triangles])


def check_corners(name: str, corners: np.ndarray, count: int) -> None:
    if corners.size == 0 or (corners.min() >= 0 and corners.max() < count):
        return
    wrong = corners[(corners < 0) | (corners >= count)][0]
    raise Refusal(f"part '{name}'", f"vertex {wrong}", f"an index below {count}")


def encode_text(text: str) -> bytes:
    letters = text.encode(errors="replace")
    return struct.pack("<I", len(letters)) + letters


def encode_scene(scene: Scene) -> bytes:
    pieces = [MAGIC, struct.pack("<I", SCENE), encode_text(""), encode_text("")]
    pieces.append(struct.pack("<I", len(scene.notes)))
    pieces += [encode_text(note) for note in scene.notes]
    pieces.append(struct.pack("<I", len(scene.parts)))
    for part in scene.parts:
        pieces.append(encode_text(part.name))
        for array, kind in ((part.vertices, "=f8"), (part.triangles, "=i4")):
            pieces.append(struct.pack("<I", len(array)))
            pieces.append(np.ascontiguousarray(array, kind).tobytes())
    return b"".join([*pieces, MAGIC])


def encode_refusal(refusal: Refusal) -> bytes:
    texts = (refusal.where, refusal.got, refusal.expected)
    return b"".join([MAGIC, struct.pack("<I", REFUSAL), *map(encode_text, texts), MAGIC])


def describe_filling(cells: int) -> str:
    return f"{cells} cells fill it: their outer faces are the surface; the organ is filled again"
