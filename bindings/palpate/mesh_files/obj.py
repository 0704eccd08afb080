# SPDX-License-Identifier: BSD-3-Clause
"""Wavefront OBJ: vertices and faces; everything that does not change the surface is passed over."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from palpate.error import FileError
from palpate.mesh_files.rows import fan, quote, read_numbers

PASSED_OVER = frozenset(
    ("vt", "vn", "vp", "o", "g", "s", "mg", "l", "p", "mtllib", "usemtl", "maplib", "usemap")
    + ("bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj")
)
"""Tokens of the format that say nothing about where the surface is."""


def join_lines(text: str) -> Iterator[tuple[int, str]]:
    """Number and content of each line without its comment; one after a backslash belongs to it."""
    begun, kept = 0, ""
    for number, line in enumerate(text.splitlines(), start=1):
        begun = begun or number
        kept += line.partition("#")[0].rstrip()
        if kept.endswith("\\"):
            kept = kept[:-1] + " "
            continue
        yield begun, kept
        begun, kept = 0, ""
    if kept:
        yield begun, kept


def read_obj(file: str, content: bytes) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Vertices, shape (n, 3), and triangles, shape (t, 3). Raises FileError, naming the line."""
    vertices: list[list[float]] = []
    triangles: list[tuple[int, int, int]] = []
    lines: list[int] = []
    for number, line in join_lines(content.decode("utf-8", errors="replace")):
        token, *rest = line.split() or [""]
        if token == "v":
            vertices.append(read_vertex(file, number, line, rest))
        elif token == "f":
            face = fan(read_corners(file, number, line, rest, len(vertices)))
            triangles += face
            lines += [number] * len(face)
        elif token and token not in PASSED_OVER:
            raise FileError(
                file, f"line {number}", quote(line), "v, f or another word of polygons in an OBJ"
            )
    corners = np.array(triangles, dtype=np.int64).reshape(-1, 3)
    wrong = np.flatnonzero((corners >= len(vertices)).any(axis=1))
    if len(wrong) > 0:
        found = f"vertex {corners[wrong[0]].max() + 1}"
        raise FileError(file, f"line {lines[wrong[0]]}", found, f"1 to {len(vertices)}")
    return np.array(vertices, dtype=np.float64).reshape(-1, 3), corners


def read_vertex(file: str, number: int, line: str, tokens: list[str]) -> list[float]:
    """x y z; a weight, or a colour, may follow."""
    expected = "v and three finite numbers"
    if len(tokens) not in (3, 4, 6, 7):
        raise FileError(file, f"line {number}", quote(line), expected)
    return read_numbers(file, number, line, tokens, expected)[:3]


def read_corners(file: str, number: int, line: str, tokens: list[str], so_far: int) -> list[int]:
    """Vertex indices from 0 of `i`, `i/t`, `i//n` or `i/t/n`; negative ones count back."""
    where = f"line {number}"
    if len(tokens) < 3:
        raise FileError(file, where, quote(line), "f and three corners or more")
    corners = []
    for token in tokens:
        try:
            vertex, *others = [int(part) if part else None for part in token.split("/")]
        except ValueError:
            vertex, others = None, []
        if vertex is None or len(others) > 2:
            raise FileError(file, where, repr(token), "a corner: i, i/t, i//n or i/t/n")
        if vertex == 0 or vertex < -so_far:
            raise FileError(
                file, where, f"vertex {vertex}", f"1 and up, or -1 to -{so_far} counting back"
            )
        corners.append(vertex - 1 if vertex > 0 else so_far + vertex)
    return corners
