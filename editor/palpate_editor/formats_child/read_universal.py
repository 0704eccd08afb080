# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from universal files of I-DEAS (.unv), as Salome writes them: datasets 2411 or 781 of
nodes and 2412 or 780 of elements [UC-SDRL's "Universal file datasets"]."""

from __future__ import annotations

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import Line, parse_ints, parse_reals, read_lines
from palpate_editor.formats_child.scene import Refusal, Scene

LINEAR = {
    **dict.fromkeys((41, 51, 61, 74, 81, 91), ("triangle", (0, 1, 2))),
    **dict.fromkeys((44, 54, 64, 71, 84, 94), ("quad", (0, 1, 2, 3))),
    111: ("tetra", (0, 1, 2, 3)),
    112: ("wedge", tuple(range(6))),
    115: ("hexahedron", tuple(range(8))),
}
CURVED = {
    **dict.fromkeys((42, 52, 62, 72, 82, 92), ("triangle", (0, 2, 4))),
    **dict.fromkeys((45, 55, 65, 75, 85, 95), ("quad", (0, 2, 4, 6))),
    113: ("wedge", (0, 2, 4, 9, 11, 13)),
    116: ("hexahedron", (0, 2, 4, 6, 12, 14, 16, 18)),
    118: ("tetra", (0, 2, 4, 9)),
}
"""Number of an element's kind -> what it is, and where its corners stand among its nodes."""
KINDS = {**LINEAR, **CURVED, 74: ("triangle", (0, 1, 2)), 71: ("quad", (0, 1, 2, 3))}
BEAMS = (11, 21, 22, 23, 24, 121, 122)
"""They have one line more."""


def read_universal(path: str) -> Scene:
    """Raises Refusal."""
    numbers: list[int] = []
    points: list[list[float]] = []
    cells: dict[str, list[list[int]]] = {}
    for kind, lines in list_datasets(read_lines(path)):
        if kind in ("2411", "781"):
            for head, row in zip(lines[::2], lines[1::2], strict=False):
                numbers.append(parse_ints(head[1].split()[:1], head)[0])
                points.append(take_point(row))
        elif kind in ("2412", "780"):
            add_elements(cells, lines)
    if not points:
        raise Refusal("", "no dataset 2411 of nodes", "a universal file of nodes and elements")
    rows = CellRows()
    for name, found in cells.items():
        table = np.array(found)
        rows.add(name, table[:, 1:], table[:, 0])
    return build_scene(path, build_mesh(np.array(numbers), np.array(points), rows))


def take_point(row: Line) -> list[float]:
    words = row[1].replace("D", "e").replace("d", "e").split()
    if len(words) != 3:
        raise Refusal(f"line {row[0]}", f"{len(words)} numbers", "x y z")
    return parse_reals(words, row)


def list_datasets(lines: list[Line]) -> list[tuple[str, list[Line]]]:
    """Number and lines of each, which stand between two lines of -1."""
    ends = [i for i, (_, text) in enumerate(lines) if text.strip() == "-1"]
    if len(ends) < 2:
        raise Refusal("header", "no datasets between lines of -1", "a universal file")
    return [
        (lines[a + 1][1].strip(), lines[a + 2 : b])
        for a, b in zip(ends[::2], ends[1::2], strict=False)
        if b > a + 1
    ]


def add_elements(cells: dict[str, list[list[int]]], lines: list[Line]) -> None:
    """number kind property material colour nodes; then the nodes, eight in a line."""
    at = 0
    while at < len(lines):
        head = parse_ints(lines[at][1].split(), lines[at])
        if len(head) < 6:
            raise Refusal(f"line {lines[at][0]}", f"{len(head)} numbers", "6 of an element")
        kind, size = head[1], head[5]
        at += 2 if kind in BEAMS else 1
        nodes: list[int] = []
        while len(nodes) < size:
            if at >= len(lines):
                raise Refusal("elements", "their end", "more nodes of an element")
            nodes += parse_ints(lines[at][1].split(), lines[at])
            at += 1
        if kind in KINDS:
            name, corners = KINDS[kind]
            if size <= max(corners):
                got = f"{size} nodes"
                raise Refusal(f"line {lines[at - 1][0]}", got, f"those of a {name}")
            cells.setdefault(name, []).append([head[2], *(nodes[i] for i in corners)])
