# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from Gambit's neutral files (.neu) and from AVS's unstructured cells (.inp) [Gambit
Modeling Guide, "Neutral file format"; AVS Developer's Guide, "UCD files"]."""

from __future__ import annotations

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import Line, parse_ints, read_lines, take_table
from palpate_editor.formats_child.scene import Refusal, Scene

GAMBIT = {
    2: ("quad", (0, 1, 2, 3)),
    3: ("triangle", (0, 1, 2)),
    4: ("hexahedron", (0, 1, 3, 2, 4, 5, 7, 6)),
    5: ("wedge", tuple(range(6))),
    6: ("tetra", (0, 1, 2, 3)),
    7: ("pyramid", (0, 1, 3, 2, 4)),
}
"""Number of a shape -> what it is, and its corners in our order; of the lowest order alone."""
UCD = {"tri": ("triangle", 3), "quad": ("quad", 4), "tet": ("tetra", 4), "hex": ("hexahedron", 8),
       "prism": ("wedge", 6), "pyr": ("pyramid", 5)}  # fmt: skip
UCD_FLAT = ("pt", "line")


def read_gambit(path: str) -> Scene:
    """Raises Refusal."""
    lines = read_lines(path)
    nodes = take_section(lines, "NODAL COORDINATES")
    cells = take_section(lines, "ELEMENTS/CELLS")
    table = take_table(nodes, 4, "number x y z")
    by_kind: dict[str, list[list[int]]] = {}
    at = 0
    while at < len(cells):
        line = cells[at]
        words = parse_ints(line[1].split(), line)
        at += 1
        while len(words) >= 3 and len(words) < 3 + words[2]:
            if at == len(cells):
                raise Refusal("ELEMENTS/CELLS", "its end", "more corners of an element")
            words += parse_ints(cells[at][1].split(), cells[at])
            at += 1
        kind, corners = GAMBIT.get(words[1] if len(words) > 3 else 0, ("", ()))
        if kind and words[2] == len(corners):
            by_kind.setdefault(kind, []).append([words[3 + i] for i in corners])
        elif words[1:2] != [1]:
            got = f"an element of kind {words[1]} with {words[2]} nodes" if words[2:] else "too few"
            raise Refusal(f"line {line[0]}", got, "elements of the lowest order")
    rows = CellRows()
    for kind, found in by_kind.items():
        rows.add(kind, np.array(found))
    return build_scene(path, build_mesh(table[:, 0], table[:, 1:], rows))


def take_section(lines: list[Line], name: str) -> list[Line]:
    """Up to ENDOFSECTION. Raises Refusal."""
    begin = next((i for i, (_, text) in enumerate(lines) if text.lstrip().startswith(name)), -1)
    if begin < 0:
        raise Refusal("", f"no {name}", "a neutral file of Gambit")
    for end in range(begin + 1, len(lines)):
        if lines[end][1].strip() == "ENDOFSECTION":
            return lines[begin + 1 : end]
    raise Refusal(name, "the end of the file", "ENDOFSECTION")


def read_ucd(path: str) -> Scene:
    """Counts of points and cells; number and place of each point; number, material, kind and
    corners of each cell. Raises Refusal."""
    lines = read_lines(path, "#")
    head = parse_ints(lines[0][1].split()[:2], lines[0]) if lines else []
    if len(head) < 2:
        raise Refusal("header", "no counts", "how many points and cells there are")
    points, cells = lines[1 : 1 + head[0]], lines[1 + head[0] : 1 + sum(head)]
    if min(head) < 0 or len(points) < head[0] or len(cells) < head[1]:
        got = f"{len(lines) - 1} lines"
        raise Refusal("", got, f"{head[0]} points and {head[1]} cells, as its header says")
    table = take_table(points, 4, "number x y z")
    by_kind: dict[str, list[list[int]]] = {}
    for line in cells:
        words = line[1].split()
        word = words[2] if len(words) > 2 else ""
        if word in UCD_FLAT:
            continue
        if word not in UCD or len(words) < 3 + UCD[word][1]:
            raise Refusal(f"line {line[0]}", f"'{line[1].strip()[:40]}'",
                          "number, material, kind and corners of a cell")  # fmt: skip
        kind, size = UCD[word]
        row = parse_ints([words[1], *words[3 : 3 + size]], line)
        by_kind.setdefault(kind, []).append(row)
    rows = CellRows()
    for kind, found in by_kind.items():
        rows.add(kind, np.array(found)[:, 1:], np.array(found)[:, 0])
    return build_scene(path, build_mesh(table[:, 0], table[:, 1:], rows))
