# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from TetGen's files (.node beside .ele and .face, .smesh, .poly), from those of VegaFEM
(.veg), which iMSTK reads as well, and from those of openCARP (.pts beside .elem) [TetGen 1.6's
manual, section 5; VegaFEM's "volumetric mesh"; openCARP's "mesh format"]."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from palpate_editor.formats_child.cells import CellMesh, CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import (
    Line,
    count_columns,
    parse_ints,
    read_lines,
    split_blocks,
    take_table,
    take_whole,
)
from palpate_editor.formats_child.scene import Refusal, Scene


def read_tetgen(path: str) -> Scene:
    """Raises Refusal. Of .node, .ele and .face any may be named: the others lie beside it."""
    name = Path(path)
    suffix = name.suffix.lower()
    if suffix in (".smesh", ".poly"):
        return build_scene(path, read_facets(name))
    numbers, points = read_nodes(find_beside(name, ".node"))
    rows = CellRows()
    wanted = (suffix,) if suffix in (".ele", ".face") else (".ele", ".face")
    for extension in wanted:
        beside = name if extension == suffix else name.with_suffix(extension)
        if beside.is_file():
            add_cells(rows, read_lines(str(beside), "#"), extension)
            break
    else:
        raise Refusal("", "points alone", f"{name.stem}.ele or {name.stem}.face beside it")
    return build_scene(path, build_mesh(numbers, points, rows))


def find_beside(name: Path, extension: str) -> Path:
    for beside in (name.with_suffix(extension), name.with_suffix(extension.upper())):
        if beside.is_file():
            return beside
    raise Refusal("", f"no {name.stem}{extension} beside it", "the points of its cells there")


def read_nodes(path: Path) -> tuple[np.ndarray, np.ndarray]:
    lines = read_lines(str(path), "#")
    return take_nodes(lines, path.name)[:2]


def take_nodes(lines: list[Line], name: str) -> tuple[np.ndarray, np.ndarray, list[Line]]:
    """Numbers and points of the first lines, and the lines behind them."""
    count, dimension = take_head(lines, 2, name)
    if dimension != 3:
        raise Refusal(f"{name}, line {lines[0][0]}", f"{dimension} dimensions", "3")
    rows = check_count(lines, count, "points", name)
    table = take_table(rows, 4, "number x y z")
    return table[:, 0].astype(np.int64), table[:, 1:], lines[count + 1 :]


def take_head(lines: list[Line], columns: int, name: str) -> list[int]:
    if not lines or count_columns(lines[0]) < columns:
        raise Refusal(name, "no counts in its first line", f"{columns} whole numbers")
    return parse_ints(lines[0][1].split()[:columns], lines[0])


def check_count(lines: list[Line], count: int, what: str, name: str) -> list[Line]:
    rows = lines[1 : count + 1] if count >= 0 else []
    if len(rows) < count or count < 0:
        raise Refusal(name, f"{len(lines) - 1} lines", f"{count} {what}, as its first line says")
    return rows


def add_cells(rows: CellRows, lines: list[Line], extension: str) -> None:
    """number corners [attribute]"""
    count, size = take_head(lines, 2, extension)
    kind, corners = ("tetra", 4) if extension == ".ele" else ("triangle", 3)
    if extension == ".ele" and size < 4:
        raise Refusal(extension, f"cells of {size} corners", "tetrahedra")
    found = check_count(lines, count, "cells", extension)
    size = size if extension == ".ele" else 3
    has_group = extension == ".ele" and bool(found) and count_columns(found[0]) > 1 + size
    table = take_table(found, 1 + size + int(has_group), "number corners").astype(np.int64)
    rows.add(kind, table[:, 1 : 1 + corners], table[:, 1 + size] if has_group else 0)


def read_facets(name: Path) -> CellMesh:
    """Of .smesh, one polygon a line, or .poly, polygons in facets."""
    lines = read_lines(str(name), "#")
    if take_head(lines, 1, name.name)[0] == 0:
        numbers, points = read_nodes(find_beside(name, ".node"))
        rest = lines[1:]
    else:
        numbers, points, rest = take_nodes(lines, name.name)
    if not rest:
        raise Refusal(name.name, "points without facets", "facets behind them")
    count = parse_ints(rest[0][1].split()[:1], rest[0])[0]
    rows, fans = CellRows(), []
    is_simple = name.suffix.lower() == ".smesh"
    at = 1
    for _ in range(count):
        many = 1
        if not is_simple:
            many = take_first(rest, at, name)
            at += 1
        for _ in range(many):
            corners, at = take_polygon(rest, at, name)
            fans += [[corners[0], b, c] for b, c in zip(corners[1:-1], corners[2:], strict=True)]
    if fans:
        rows.add("triangle", np.array(fans))
    return build_mesh(numbers, points, rows)


def take_first(lines: list[Line], at: int, name: Path) -> int:
    """How many polygons a facet has."""
    if at >= len(lines):
        raise Refusal(name.name, "its end", "more facets")
    words = parse_ints(lines[at][1].split()[:2], lines[at])
    if len(words) > 1 and words[1] > 0:
        raise Refusal(f"line {lines[at][0]}", "a facet with holes", "facets without")
    return words[0]


def take_polygon(lines: list[Line], at: int, name: Path) -> tuple[list[int], int]:
    """A count and so many corners, which may go on in the next lines; and where it ends."""
    words: list[int] = []
    while not words or len(words) < 1 + words[0]:
        if at >= len(lines):
            raise Refusal(name.name, "its end", "more corners of a facet")
        words += parse_ints(lines[at][1].split(), lines[at])
        at += 1
    return words[1 : 1 + words[0]], at


# ---------------------------------------------------------------- VegaFEM


def read_vega(path: str) -> Scene:
    """*VERTICES and *ELEMENTS, of tetrahedra or cubes; each may be in a file that is named."""
    numbers, points = np.empty(0, np.int64), np.empty((0, 3))
    rows = CellRows()
    for head, lines in split_blocks(include(path), "*"):
        word = head[1].split()[0].upper()
        if word == "*VERTICES":
            numbers, points, _ = take_nodes(lines, "*VERTICES")
        elif word == "*ELEMENTS":
            add_vega_cells(rows, lines)
    if len(points) == 0:
        raise Refusal("", "no *VERTICES", "*VERTICES and *ELEMENTS of VegaFEM")
    return build_scene(path, build_mesh(numbers, points, rows))


def include(path: str) -> list[Line]:
    lines: list[Line] = []
    for line in read_lines(path, "#"):
        words = line[1].split()
        if words[0].upper() == "*INCLUDE" and len(words) > 1:
            beside = Path(path).parent / words[1]
            if not beside.is_file():
                raise Refusal(f"line {line[0]}", f"no {words[1]} beside it", "the file it includes")
            lines += read_lines(str(beside), "#")
        else:
            lines.append(line)
    return lines


def add_vega_cells(rows: CellRows, lines: list[Line]) -> None:
    kinds = {"TET": ("tetra", 4), "TETS": ("tetra", 4), "CUBIC": ("hexahedron", 8)}
    word = lines[0][1].strip().upper() if lines else ""
    is_named = not word[:1].isdigit()
    kind, corners = kinds.get(word, ("", 0)) if is_named else kinds["TET"]
    if not kind:
        raise Refusal("*ELEMENTS", f"'{word[:40]}'", "TET or CUBIC")
    body = lines[1:] if is_named else lines
    count = take_head(body, 2, "*ELEMENTS")[0]
    found = check_count(body, count, "cells", "*ELEMENTS")
    rows.add(kind, take_whole(found, 1 + corners, "number corners")[:, 1:])


# ---------------------------------------------------------------- openCARP

CARP = {
    "Tt": ("tetra", 4),
    "Hx": ("hexahedron", 8),
    "Pr": ("wedge", 6),
    "Py": ("pyramid", 5),
    "Tr": ("triangle", 3),
    "Qd": ("quad", 4),
}


def read_carp(path: str) -> Scene:
    """A count of points and their coordinates in .pts [um]; a count of cells in .elem, each with a
    word for its kind, corners from 0 and perhaps a region."""
    name = Path(path)
    points_file, cells_file = find_beside(name, ".pts"), find_beside(name, ".elem")
    lines = read_lines(str(points_file))
    count = take_head(lines, 1, points_file.name)[0]
    points = take_table(check_count(lines, count, "points", points_file.name), 3, "x y z")
    lines = read_lines(str(cells_file))
    found = check_count(lines, take_head(lines, 1, cells_file.name)[0], "cells", cells_file.name)
    by_kind: dict[str, list[Line]] = {}
    for number, text in found:
        word, _, rest = text.strip().partition(" ")
        if word in CARP:
            by_kind.setdefault(word, []).append((number, rest))
        elif word != "Ln":
            raise Refusal(f"{cells_file.name}, line {number}", f"'{word[:40]}'", "a kind of cell")
    rows = CellRows()
    for word, cells in by_kind.items():
        kind, corners = CARP[word]
        has_region = count_columns(cells[0]) > corners
        table = take_whole(cells, corners + int(has_region), "corners")
        rows.add(kind, table[:, :corners], table[:, corners] if has_region else 0)
    return replace(build_scene(path, build_mesh(np.arange(count), points, rows)), unit="um")
