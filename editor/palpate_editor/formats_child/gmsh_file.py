# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in a file of Gmsh: nodes, elements, names of groups.

Versions 1, 2, 4.0 and 4.1 [Gmsh's manual, "File formats"], text or binary of either byte order.
Sections of results are passed over, whatever they hold.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from palpate_editor.formats_child.gmsh_values import Sections, TextValues, Values, open_values
from palpate_editor.formats_child.scene import Refusal

NODES = {
    **{1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 8: 3, 9: 6, 10: 9, 11: 10, 12: 27, 13: 18, 14: 14},
    **{15: 1, 16: 8, 17: 20, 18: 15, 19: 13, 20: 9, 21: 10, 22: 12, 23: 15, 24: 15, 25: 21, 26: 4},
    **{27: 5, 28: 6, 29: 20, 30: 35, 31: 56, 36: 16, 37: 25, 92: 64, 93: 125},
}
"""Type of an element -> how many nodes it has; its corners come first."""
VERSIONS = ("1", "2", "4.0", "4.1")
EXPECTED = "a file of Gmsh, version 1, 2, 4.0 or 4.1"


@dataclass(frozen=True, eq=False)
class Elements:
    """Elements of one type."""

    type: int
    nodes: np.ndarray
    """(k, n) rows of GmshFile.points"""
    groups: np.ndarray
    """(k,) the first physical group of each; 0 for none"""


@dataclass(frozen=True, eq=False)
class GmshFile:
    points: np.ndarray
    """(n, 3)"""
    blocks: list[Elements]
    names: dict[tuple[int, int], str]
    """Dimension and number of a physical group -> its name."""
    lost: int
    """Elements that were left out: they name a node that is not there."""


def open_gmsh(path: str) -> GmshFile:
    """Raises Refusal."""
    with open(path, "rb") as file:
        content = file.read()
    version, values = find_version(content)
    if version == "1":
        numbers, points = read_rows_of_nodes(values("NOD"))
        rows = read_rows_of_elements(values("ELM"), is_first=True)
    elif version == "2":
        numbers, points = read_rows_of_nodes(values("Nodes", "ParametricNodes"))
        rows = read_rows_of_elements(values("Elements"), is_first=False)
    else:
        groups = read_entities(values.find("Entities"), version)
        numbers, points = read_blocks_of_nodes(values("Nodes"), version)
        rows = read_blocks_of_elements(values("Elements"), version, groups)
    blocks, lost = number_nodes(numbers, rows)
    return GmshFile(points, blocks, read_names(content), lost)


def find_version(content: bytes) -> tuple[str, Sections]:
    """Which version it is, and what opens its sections."""
    head = re.search(rb"\$MeshFormat\s+(\S+)[ \t]+(\S+)[ \t]+(\d+)[ \t]*\r?\n", content[:100_000])
    if head is None:
        if re.search(rb"\$NOD\b", content[:100_000]):
            return "1", open_values(content, True)
        raise Refusal("header", "no $MeshFormat", EXPECTED)
    words, kind, size = head.group(1).decode(errors="replace"), head.group(2), int(head.group(3))
    version = words if words.startswith("4.") else words.split(".")[0]
    if version == "4":
        version = "4.0" if count_first_numbers(content) == 2 else "4.1"
    if version not in VERSIONS or words == "1":
        raise Refusal("header", f"version {words}", EXPECTED)
    if kind == b"0":
        return version, open_values(content, True)
    one = content[head.end() : head.end() + 4]
    order = "<" if one == b"\1\0\0\0" else ">" if one == b"\0\0\0\1" else ""
    if not order or size not in (4, 8):
        raise Refusal("header", f"{one!r} and numbers of {size} bytes", "a one of four bytes")
    return version, open_values(content, False, order, size)


def count_first_numbers(content: bytes) -> int:
    """On the first line of the nodes: 4.0 has two there, 4.1 has four, and both may say "4"."""
    first = re.search(rb"\$Nodes\s*\n([^\n]*)", content)
    return len(first.group(1).split()) if first else 2


# ---------------------------------------------------------------- versions 1 and 2: row by row


def read_rows_of_nodes(values: Values) -> tuple[np.ndarray, np.ndarray]:
    count = values.take_count("nodes")
    if isinstance(values, TextValues) and values.section == "$ParametricNodes":
        return read_parametric_rows(values, count)
    numbers, points = values.take_records(count, "nodes", ints=1, reals=3)
    return numbers[:, 0], points


def read_parametric_rows(values: Values, count: int) -> tuple[np.ndarray, np.ndarray]:
    """number x y z dimension entity, then as many parameters as the entity has dimensions."""
    numbers, points = np.empty(count, np.int64), np.empty((count, 3))
    for i in range(count):
        row = values.take_reals(6, "nodes")
        numbers[i], points[i] = row[0], row[1:4]
        values.take_reals(int(row[4]) if row[4] in (1, 2) else 0, "nodes")
    return numbers, points


Rows = list[tuple[int, np.ndarray, np.ndarray]]
"""Type, numbers of nodes (k, n), groups (k,)."""


def count_nodes(kind: int) -> int:
    if kind not in NODES:
        raise Refusal("$Elements", f"an element of type {kind}", "a type of Gmsh's manual")
    return NODES[kind]


def read_rows_of_elements(values: Values, is_first: bool) -> Rows:
    """number type tags group entity ... nodes; in version 1 number type group entity nodes ..."""
    count = values.take_count("elements")
    rows: Rows = []
    while count > 0:
        if isinstance(values, TextValues):
            kind, told = (int(v) for v in values.peek(3, "elements")[1:])
            tags = 3 if is_first else told
            lead = 2 if is_first else 3
            size = lead + tags + count_nodes(kind)
            block = values.take_like(size, 2 if is_first else 3, count, "elements")
        else:
            kind, many, tags = (int(v) for v in values.take_ints(3, "elements"))
            lead, size = 1, 1 + tags + count_nodes(kind)
            if not 0 < many <= count:
                raise Refusal("$Elements", f"a block of {many} elements", f"1 to {count}")
            block = values.take_ints(many * size, "elements").reshape(many, size)
        groups = block[:, lead] if tags else np.zeros(len(block), np.int64)
        rows.append((kind, block[:, lead + tags :], np.abs(groups)))
        count -= len(block)
    return rows


# ---------------------------------------------------------------- versions 4: block by block


def read_entities(values: Values | None, version: str) -> dict[tuple[int, int], int]:
    """Dimension and number of an entity -> its first physical group, where it has one."""
    groups: dict[tuple[int, int], int] = {}
    if values is None:
        return groups
    for dimension, count in enumerate(values.take_sizes(4, "entities").tolist()):
        for _ in range(count):
            tag = int(values.take_ints(1, "entities")[0])
            is_point = dimension == 0
            values.take_reals(3 if is_point and version == "4.1" else 6, "entities")
            physical = values.take_ints(int(values.take_sizes(1, "entities")[0]), "entities")
            if len(physical):
                groups[dimension, tag] = abs(int(physical[0]))
            if not is_point:
                values.take_ints(int(values.take_sizes(1, "entities")[0]), "entities")
    return groups


def read_blocks_of_nodes(values: Values, version: str) -> tuple[np.ndarray, np.ndarray]:
    is_new = version == "4.1"
    many = int(values.take_sizes(4 if is_new else 2, "nodes")[0])
    numbers, points = [np.empty(0, np.int64)], [np.empty((0, 3))]
    for _ in range(many):
        first, second, has_parameters = (int(v) for v in values.take_ints(3, "nodes"))
        dimension = first if is_new else second
        count = int(values.take_sizes(1, "nodes")[0])
        columns = 3 + (dimension if has_parameters else 0)
        values.check(count, columns, "nodes")
        if is_new:
            numbers.append(values.take_sizes(count, "nodes"))
            points.append(values.take_reals(count * columns, "nodes").reshape(count, -1)[:, :3])
        else:
            found, x = values.take_records(count, "nodes", ints=1, reals=columns)
            numbers.append(found[:, 0])
            points.append(x[:, :3])
    return np.concatenate(numbers), np.concatenate(points)


def read_blocks_of_elements(
    values: Values, version: str, groups: dict[tuple[int, int], int]
) -> Rows:
    is_new = version == "4.1"
    many = int(values.take_sizes(4 if is_new else 2, "elements")[0])
    rows: Rows = []
    for _ in range(many):
        first, second, kind = (int(v) for v in values.take_ints(3, "elements"))
        entity = (first, second) if is_new else (second, first)
        count = int(values.take_sizes(1, "elements")[0])
        size = 1 + count_nodes(kind)
        values.check(count, size, "elements")
        take = values.take_sizes if is_new else values.take_ints
        block = take(count * size, "elements").reshape(count, size)
        rows.append((kind, block[:, 1:], np.full(count, groups.get(entity, 0))))
    return rows


# ---------------------------------------------------------------- what all have


def number_nodes(numbers: np.ndarray, rows: Rows) -> tuple[list[Elements], int]:
    """The rows of the nodes that elements name by number; those that name one that is not there are
    left out, and counted."""
    order = np.argsort(numbers, kind="stable")
    blocks, lost = [], 0
    for kind, nodes, groups in rows:
        place = np.searchsorted(numbers, nodes, sorter=order)
        found = order[np.minimum(place, len(order) - 1)] if len(order) else np.zeros_like(nodes)
        there = (numbers[found] == nodes).all(axis=1) if len(order) else np.zeros(len(nodes), bool)
        lost += int((~there).sum())
        blocks.append(Elements(kind, found[there], groups[there]))
    return blocks, lost


def read_names(content: bytes) -> dict[tuple[int, int], str]:
    """Of the physical groups, in quotes or without."""
    section = re.search(rb"\$PhysicalNames\s(.*?)\$EndPhysicalNames", content, re.DOTALL)
    names: dict[tuple[int, int], str] = {}
    for line in section.group(1).splitlines() if section else []:
        row = re.match(rb'\s*(\d+)\s+(\d+)\s+"?([^"]*?)"?\s*$', line)
        if row:
            names[int(row.group(1)), int(row.group(2))] = row.group(3).decode(errors="replace")
    return names
