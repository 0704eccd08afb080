# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of Medit (.mesh as text, .meshb binary), as TetWild, MMG and CGAL write
them, and from Netgen's neutral format, which has the same extension [libMeshb's manual; Netgen's,
"Mesh formats"]."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from palpate_editor.formats_child.cells import CellMesh, CellRows, build_mesh, build_scene
from palpate_editor.formats_child.gmsh_values import TextValues
from palpate_editor.formats_child.scene import Refusal, Scene

CELLS = {
    "Triangles": ("triangle", 3, 6),
    "Quadrilaterals": ("quad", 4, 7),
    "Tetrahedra": ("tetra", 4, 8),
    "Prisms": ("wedge", 6, 9),
    "Hexahedra": ("hexahedron", 8, 10),
    "Pyramids": ("pyramid", 5, 49),
}
"""Keyword -> kind, corners, and what stands for it in a binary file."""
VERTICES, END = 4, 54
"""Keywords of binary files."""
KEYWORD = re.compile(rb"(?<![\w.+-])(?!NaN\b|Inf)[A-Z][A-Za-z]{2,}\b")
EXPECTED = "a file of Medit: MeshVersionFormatted, Dimension 3, Vertices"


def read_medit(path: str) -> Scene:
    """Raises Refusal."""
    with open(path, "rb") as file:
        content = file.read()
    if content[:4] in (b"\1\0\0\0", b"\0\0\0\1"):
        mesh = read_binary(content)
    elif b"MeshVersionFormatted" in content[:4096]:
        mesh = read_text(content)
    elif re.match(rb"\s*\d+\s", content):
        mesh = read_neutral(content)
    else:
        raise Refusal("header", describe_head(content), EXPECTED)
    return build_scene(path, mesh)


def describe_head(content: bytes) -> str:
    line = content[:40].decode(errors="replace").split("\n")[0].strip()
    return "'" + "".join(letter if letter.isprintable() else "?" for letter in line) + "'"


def read_text(content: bytes) -> CellMesh:
    text = re.sub(rb"#[^\n]*", b"", content)
    marks = list(KEYWORD.finditer(text))
    ends = [mark.start() for mark in marks[1:]] + [len(text)]
    points = np.empty((0, 3))
    rows = CellRows()
    for mark, end in zip(marks, ends, strict=True):
        word = mark.group().decode()
        if word == "Dimension":
            check_dimension(int(TextValues(word, text[mark.end() : end]).take_ints(1, word)[0]))
        elif word == "Vertices":
            values = TextValues(word, text[mark.end() : end])
            points = take_rows(values, 3, "vertices")[0]
        elif word in CELLS:
            kind, corners, _ = CELLS[word]
            values = TextValues(word, text[mark.end() : end])
            found, groups = take_rows(values, corners, word.lower())
            rows.add(kind, values.to_whole(found, word.lower()), groups)
    if len(points) == 0:
        raise Refusal("", "no Vertices", EXPECTED)
    return build_mesh(np.arange(1, len(points) + 1), points, rows)


def take_rows(values: TextValues, size: int, what: str) -> tuple[np.ndarray, np.ndarray]:
    """A count, then rows of so many numbers and a reference: (n, size), (n,)."""
    count = int(values.take_ints(1, what)[0])
    values.check(count, size + 1, what)
    rows = values.take_reals(count * (size + 1), what).reshape(count, size + 1)
    return rows[:, :size], values.to_whole(rows[:, size], what)


def check_dimension(dimension: int) -> None:
    if dimension != 3:
        raise Refusal("Dimension", str(dimension), "3")


# ---------------------------------------------------------------- binary


@dataclass
class Bytes:
    """Numbers one after the other; counts, positions and reals grow with the version."""

    content: bytes
    order: str
    version: int = 1
    at: int = 4

    def take(self, kind: str, count: int, what: str) -> np.ndarray:
        of = np.dtype(self.order + kind)
        if count < 0 or count * of.itemsize > len(self.content) - self.at:
            raise Refusal(f"byte {self.at}", "its end", f"more {what}")
        found = np.frombuffer(self.content, of, count, self.at)
        self.at += count * of.itemsize
        return found

    @property
    def whole(self) -> str:
        return "i8" if self.version >= 4 else "i4"

    @property
    def place(self) -> str:
        return "i8" if self.version >= 3 else "i4"

    @property
    def real(self) -> str:
        return "f4" if self.version == 1 else "f8"


def read_binary(content: bytes) -> CellMesh:
    data = Bytes(content, "<" if content[0] == 1 else ">")
    data.version = int(data.take("i4", 1, "header")[0])
    if not 1 <= data.version <= 4:
        raise Refusal("header", f"version {data.version}", "version 1 to 4 of Medit's binary files")
    points, rows = np.empty((0, 3)), CellRows()
    kinds = {code: (kind, corners) for kind, corners, code in CELLS.values()}
    while data.at < len(content):
        code = int(data.take("i4", 1, "keywords")[0])
        if code == END:
            break
        behind = int(data.take(data.place, 1, "keywords")[0])
        if code == 3:
            check_dimension(int(data.take("i4", 1, "header")[0]))
        elif code == VERTICES:
            points = take_fields(data, data.real, 3, "vertices")[0].astype(float)
        elif code in kinds:
            kind, corners = kinds[code]
            found, groups = take_fields(data, data.whole, corners, f"{kind}s")
            rows.add(kind, found, groups)
        if not data.at <= behind <= len(content):
            if behind == 0:
                break
            where = f"keyword {code}"
            raise Refusal(where, f"a next one at byte {behind}", f"{data.at} to {len(content)}")
        data.at = behind
    if len(points) == 0:
        raise Refusal("", "no Vertices", EXPECTED)
    return build_mesh(np.arange(1, len(points) + 1), points, rows)


def take_fields(data: Bytes, kind: str, size: int, what: str) -> tuple[np.ndarray, np.ndarray]:
    count = int(data.take(data.whole, 1, what)[0])
    record = np.dtype([("of", data.order + kind, (size,)), ("group", data.order + data.whole)])
    raw = data.take("u1", count * record.itemsize, what)
    rows = raw.view(record)
    return rows["of"], rows["group"]


# ---------------------------------------------------------------- Netgen's neutral format


def read_neutral(content: bytes) -> CellMesh:
    """How many points, their coordinates; how many tetrahedra, each with its domain before its
    corners; how many triangles, each with its face."""
    values = TextValues("", content)
    count = values.take_count("points")
    points = values.take_reals(3 * count, "points").reshape(count, 3)
    rows = CellRows()
    for kind, size in (("tetra", 4), ("triangle", 3)):
        if values.count_left() == 0:
            break
        many = values.take_count(f"{kind}s")
        found = values.take_ints(many * (size + 1), f"{kind}s").reshape(many, size + 1)
        rows.add(kind, found[:, 1:], found[:, 0])
    return build_mesh(np.arange(1, count + 1), points, rows)
