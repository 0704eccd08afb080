# SPDX-License-Identifier: BSD-3-Clause
"""STL, as text and binary, welded: equal corners become one vertex."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from palpate.error import FileError
from palpate.mesh_files.rows import quote, read_numbers, require_finite

HEADER = 84
"""[bytes] before the first triangle of a binary file: 80 of text, and how many triangles."""
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read_stl(file: str, content: bytes) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Vertices, shape (n, 3), and triangles, shape (t, 3). Raises FileError, naming the place."""
    count = int.from_bytes(content[80:HEADER], "little") if len(content) >= HEADER else -1
    expected = HEADER + count * TRIANGLE.itemsize
    # a binary file may begin with the word solid too, so its length decides
    if len(content) != expected and content.lstrip()[:5].lower() == b"solid":
        corners = read_text(file, content.decode("utf-8", errors="replace"))
    elif len(content) < HEADER:
        raise FileError(file, "", f"{len(content)} bytes", f"text, or at least {HEADER} bytes")
    elif len(content) < expected:
        found = f"{len(content)} bytes"
        raise FileError(file, "byte 80", found, f"{expected} for its {count} triangles")
    else:
        table = np.frombuffer(content, dtype=TRIANGLE, count=count, offset=HEADER)
        corners = table["corners"].reshape(-1, 3).astype(np.float64)
        require_finite(file, corners, "corner")
    return weld(corners)


def weld(corners: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Corners, shape (3 t, 3), as vertices in the order in which they first come, and triangles."""
    # minus zero is the same place as zero
    _, first, number = np.unique(corners + 0.0, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    return corners[first[order]] + 0.0, place[number.reshape(-1)].reshape(-1, 3)


def read_text(file: str, text: str) -> NDArray[np.float64]:
    """Corners, shape (3 t, 3), of `facet normal / outer loop / vertex x y z` three times."""
    corners: list[list[float]] = []
    of_facet = 0
    number, line = 0, ""
    for number, line in enumerate(text.splitlines(), start=1):
        tokens = line.lower().split()
        token = tokens[0] if tokens else ""
        if token == "vertex":
            if len(tokens) != 4:
                raise FileError(file, f"line {number}", quote(line), "vertex and three numbers")
            expected = "vertex and three finite numbers"
            corners.append(read_numbers(file, number, line, tokens[1:], expected))
            of_facet += 1
        elif token == "endfacet":
            if of_facet != 3:
                raise FileError(file, f"line {number}", f"{of_facet} corners", "3 in each facet")
            of_facet = 0
        elif token and token not in ("solid", "endsolid", "facet", "outer", "endloop"):
            expected = "solid, facet, outer loop, vertex, endloop, endfacet or endsolid"
            raise FileError(file, f"line {number}", quote(line), expected)
    if of_facet != 0:
        raise FileError(file, f"line {number}", "the end within a facet", "endfacet and endsolid")
    return np.array(corners, dtype=np.float64).reshape(-1, 3)
