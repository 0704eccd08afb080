# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the keyword files of LS-DYNA (.k, .key, .dyn) [LS-DYNA Keyword User's Manual]."""

from __future__ import annotations

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import (
    Line,
    parse_ints,
    parse_real,
    read_lines,
    split_blocks,
)
from palpate_editor.formats_child.scene import Refusal, Scene

Cells = dict[str, list[list[int]]]
"""Kind -> rows of part and corners."""


def read_dyna(path: str) -> Scene:
    """Raises Refusal."""
    numbers: list[int] = []
    points: list[list[float]] = []
    cells: Cells = {}
    names: dict[tuple[int, int], str] = {}
    for head, block in split_blocks(read_lines(path, "$"), "*"):
        word = head[1].split()[0].upper()
        if word == "*NODE":
            for line in block:
                fields = split_fields(line, (8, 16, 16, 16))
                numbers.append(parse_ints(fields[:1], line)[0])
                points.append([parse_real(field or "0", line[0]) for field in fields[1:4]])
        elif word.startswith("*ELEMENT_SHELL"):
            add_shells(cells, block)
        elif word.startswith("*ELEMENT_SOLID"):
            add_solids(cells, block)
        elif word == "*PART" and len(block) >= 2:
            number = parse_ints(split_fields(block[1], (10,))[:1], block[1])[0]
            names[2, number] = names[3, number] = block[0][1].strip()
    if not points:
        raise Refusal("", "no *NODE", "*NODE and *ELEMENT of LS-DYNA")
    rows = CellRows()
    for kind, found in cells.items():
        table = np.array(found)
        rows.add(kind, table[:, 1:], table[:, 0])
    return build_scene(path, build_mesh(np.array(numbers), np.array(points), rows, names))


def split_fields(line: Line, widths: tuple[int, ...]) -> list[str]:
    """Of fixed widths, or behind commas."""
    text = line[1]
    if "," in text:
        return [word.strip() for word in text.split(",")]
    fields, at = [], 0
    for width in widths:
        fields.append(text[at : at + width].strip())
        at += width
    return fields


def take_ints(line: Line, count: int) -> list[int]:
    fields = [field for field in split_fields(line, (8,) * count) if field]
    return parse_ints(fields, line)


def add_shells(cells: Cells, block: list[Line]) -> None:
    """number part corners; of a triangle the last corner is there twice, or is 0."""
    for line in block:
        row = take_ints(line, 6)
        if len(row) < 5:
            continue  # the thicknesses or the beta of the element before
        corners = row[2:6]
        is_triangle = len(corners) == 3 or corners[3] in (0, corners[2])
        kind = "triangle" if is_triangle else "quad"
        cells.setdefault(kind, []).append([row[1], *corners[: 3 if is_triangle else 4]])


def add_solids(cells: Cells, block: list[Line]) -> None:
    """number part corners in one line, or the corners in a second; a corner that is there more than
    once makes a brick a tetrahedron, a pyramid or a wedge."""
    at = 0
    while at < len(block):
        line = block[at]
        row = take_ints(line, 10)
        at += 1
        if len(row) == 2:
            if at == len(block):
                raise Refusal(f"line {line[0]}", "the last of its elements", "a line of corners")
            row += take_ints(block[at], 10)
            at += 1
        kind, corners = name_solid([n for n in row[2:10] if n != 0], line)
        cells.setdefault(kind, []).append([row[1], *corners])


def name_solid(nodes: list[int], line: Line) -> tuple[str, list[int]]:
    if len(nodes) == 4 or (len(nodes) == 8 and len(set(nodes[3:])) == 1):
        return "tetra", nodes[:4]
    if len(nodes) == 8 and len(set(nodes[4:])) == 1:
        return "pyramid", nodes[:5]
    if len(nodes) == 6 or (len(nodes) == 8 and nodes[4] == nodes[5] and nodes[6] == nodes[7]):
        n = nodes
        return "wedge", n[:6] if len(n) == 6 else [n[0], n[1], n[4], n[3], n[2], n[6]]
    if len(nodes) == 8:
        return "hexahedron", nodes
    raise Refusal(f"line {line[0]}", f"{len(nodes)} corners", "4, 6 or 8 of a solid")
