# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from Netgen's own files (.vol), as EIDORS reads them too."""

from __future__ import annotations

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import Line, parse_ints, read_lines, take_table
from palpate_editor.formats_child.scene import Refusal, Scene

SOLIDS = {4: "tetra", 10: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron"}
FLAT = {3: "triangle", 6: "triangle", 4: "quad", 8: "quad"}


def read_netgen(path: str) -> Scene:
    """Raises Refusal."""
    lines = read_lines(path, "#")
    if not lines or lines[0][1].strip() != "mesh3d":
        got = lines[0][1].strip()[:40] if lines else ""
        raise Refusal("header", f"'{got}'", "mesh3d, which a file of Netgen begins with")
    rows, points = CellRows(), np.empty((0, 3))
    at = 1
    while at < len(lines):
        word = lines[at][1].strip().lower()
        at += 1
        if word == "points":
            found = take_lines(lines, at, word)
            points = take_table(found, 3, "x y z")
        elif word.startswith("surfaceelements"):
            found = take_lines(lines, at, word)
            add_elements(rows, found, FLAT, lead=4)
        elif word == "volumeelements":
            found = take_lines(lines, at, word)
            add_elements(rows, found, SOLIDS, lead=1)
        else:
            continue
        at += 1 + len(found)
    if len(points) == 0:
        raise Refusal("", "no points", "a mesh of Netgen: surfaceelements, points")
    return build_scene(path, build_mesh(np.arange(1, len(points) + 1), points, rows))


def take_lines(lines: list[Line], at: int, word: str) -> list[Line]:
    """As many as the first of them says."""
    count = parse_ints(lines[at][1].split()[:1], lines[at])[0] if at < len(lines) else 0
    found = lines[at + 1 : at + 1 + count] if count >= 0 else []
    if count < 0 or len(found) < count:
        raise Refusal(word, f"{len(found)} lines", f"{count}, as it says")
    return found


def add_elements(rows: CellRows, lines: list[Line], kinds: dict[int, str], lead: int) -> None:
    """`lead` numbers, of which the last for a solid is its material and the first for a face its
    surface, then how many corners, and the corners."""
    by_size: dict[int, list[list[int]]] = {}
    for line in lines:
        words = line[1].split()
        head = parse_ints(words[: lead + 1], line)
        if len(head) <= lead or head[lead] not in kinds:
            got = f"{head[lead]} corners" if len(head) > lead else "too few numbers"
            raise Refusal(f"line {line[0]}", got, "an element of Netgen")
        size = head[lead]
        corners = parse_ints(words[lead + 1 : lead + 1 + size], line)
        if len(corners) < size:
            raise Refusal(f"line {line[0]}", f"{len(corners)} corners", str(size))
        by_size.setdefault(size, []).append([head[0], *corners])
    for size, found in by_size.items():
        table = np.array(found)
        rows.add(kinds[size], table[:, 1:], table[:, 0])
