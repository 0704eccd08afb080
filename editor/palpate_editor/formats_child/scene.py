# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file holds, and the bytes that tell it to the program that asked (scene_stream.h)."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field, replace

import numpy as np

MAGIC = struct.pack("<Q", 0x33454E4543534C50)
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
    colour: tuple[float, ...] = ()
    """sRGB, 0 to 1; empty where the file says none."""
    colours: np.ndarray | None = None
    """(n, 3) uint8, sRGB, of the vertices; None where they have none, or all the same."""


@dataclass(frozen=True, eq=False)
class Filling:
    """Tetrahedra whose outer faces are the surface."""

    vertices: np.ndarray
    """(n, 3) in units and axes of the file"""
    tetrahedra: np.ndarray
    """(t, 4)"""


NO_FILLING = Filling(np.zeros((0, 3)), np.zeros((0, 4), np.int32))


@dataclass(frozen=True, eq=False)
class Scene:
    """All surfaces of a file."""

    parts: list[Part]
    notes: list[str] = field(default_factory=list)
    """What was odd but could be read all the same."""
    filling: Filling = NO_FILLING
    unit: str = ""
    """Stated by the file or its format: m, cm, mm, um, in or ft; empty for none."""
    up: str = ""
    """x, y, z, -x, -y or -z; empty where nothing is stated."""


def cut_out(
    name: str, vertices: np.ndarray, triangles: np.ndarray, colours: np.ndarray | None = None
) -> Part:
    """The vertices that some triangles use, in the order of the file, with their colours (n, 3)
    uint8. Raises Refusal for a corner that there is no vertex for."""
    triangles = np.asarray(triangles, np.int64).reshape(-1, 3)
    check_corners(name, triangles, len(vertices))
    used = np.unique(triangles)
    place = np.zeros(len(vertices), np.int32)
    place[used] = np.arange(len(used), dtype=np.int32)
    part = Part(name, np.asarray(vertices, float)[used], place[triangles])
    if colours is None or not np.ptp(colours[used], axis=0).any():
        return part
    return replace(part, colours=colours[used])


def check_corners(name: str, corners: np.ndarray, count: int) -> None:
    if corners.size == 0 or (corners.min() >= 0 and corners.max() < count):
        return
    wrong = corners[(corners < 0) | (corners >= count)][0]
    raise Refusal(f"part '{name}'", f"vertex {wrong}", f"an index below {count}")


MOST_LOST = 0.01
"""[-] of the cells of a file: where more of them lead nowhere, it is damaged."""


def check_lost(lost: int, kept: int, what: str, notes: list[str]) -> None:
    """Says that cells were left out that name a point that is not there. Raises Refusal where they
    are more than a few."""
    if lost == 0:
        return
    if lost > MOST_LOST * (lost + kept):
        raise Refusal("", f"{lost} of {lost + kept} {what} on points that are not there", "a mesh")
    notes.append(f"{lost} {what} on points that are not there were left out")


def encode_text(text: str) -> bytes:
    letters = text.encode(errors="replace")
    return struct.pack("<I", len(letters)) + letters


def encode_scene(scene: Scene) -> bytes:
    pieces = [MAGIC, struct.pack("<I", SCENE), encode_text(scene.unit)]
    pieces.append(encode_text(scene.up))
    pieces.append(struct.pack("<I", len(scene.notes)))
    pieces += [encode_text(note) for note in scene.notes]
    pieces.append(struct.pack("<I", len(scene.parts)))
    for part in scene.parts:
        pieces += [encode_text(part.name), struct.pack("<I", 0)]
        pieces += [encode_array(np.array(part.colour), "=f8")]
        pieces += [encode_array(part.vertices, "=f8"), encode_array(part.triangles, "=i4")]
        pieces += encode_paint(part)
    pieces.append(struct.pack("<I", 0))
    pieces.append(encode_array(scene.filling.vertices, "=f8"))
    pieces.append(encode_array(scene.filling.tetrahedra, "=i4"))
    return b"".join([*pieces, MAGIC])


def encode_paint(part: Part) -> list[bytes]:
    """Of each corner its place on a picture, and its colour; of each triangle no picture."""
    if part.colours is None:
        return [struct.pack("<I", 0), struct.pack("<I", 0)]
    colours = part.colours[part.triangles].reshape(-1, 3) / 255.0
    paint = np.hstack([np.zeros((len(colours), 2)), colours])
    return [encode_array(paint, "=f4"), encode_array(np.full(len(part.triangles), -1), "=i4")]


def encode_array(array: np.ndarray, kind: str) -> bytes:
    """How many rows, and what stands in them."""
    return struct.pack("<I", len(array)) + np.ascontiguousarray(array, kind).tobytes()


def encode_refusal(refusal: Refusal) -> bytes:
    texts = (refusal.where, refusal.got, refusal.expected)
    return b"".join([MAGIC, struct.pack("<I", REFUSAL), *map(encode_text, texts), MAGIC])


def decode_refusal(answer: bytes) -> tuple[str, str, str] | None:
    """Where, what was found and what was expected; None of an answer that is none."""
    head = MAGIC + struct.pack("<I", REFUSAL)
    if not answer.startswith(head):
        return None
    texts, at = [], len(head)
    for _ in range(3):
        (size,) = struct.unpack_from("<I", answer, at)
        texts.append(answer[at + 4 : at + 4 + size].decode(errors="replace"))
        at += 4 + size
    return texts[0], texts[1], texts[2]


def cut_filling(vertices: np.ndarray, cells: np.ndarray) -> Filling:
    """The vertices that some tetrahedra use, in the order of the file; each tetrahedron the right
    way round. Raises Refusal for a corner that there is no vertex for."""
    cells = np.asarray(cells, np.int64).reshape(-1, 4)
    check_corners("tetrahedra", cells, len(vertices))
    used = np.unique(cells)
    place = np.zeros(len(vertices), np.int32)
    place[used] = np.arange(len(used), dtype=np.int32)
    x = np.asarray(vertices, float)[used]
    filled = place[cells]
    a, b, c, d = (x[filled[:, i]] for i in range(4))
    inverted = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0.0
    filled[inverted] = filled[inverted][:, [0, 1, 3, 2]]
    return Filling(x, filled)


def describe_cells(cells: int) -> str:
    """Of cells that are no tetrahedra, or not all of them."""
    return (
        f"{cells} cells fill it: their outer faces are the surface, and the organ is filled again"
    )


def describe_tetrahedra(cells: int) -> str:
    return f"{cells} tetrahedra fill it, whose outer faces are the surface"
