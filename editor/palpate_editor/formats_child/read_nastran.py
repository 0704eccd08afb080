# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the bulk data of Nastran (.bdf, .nas, .fem) [MSC Nastran's Quick Reference Guide]:
fields of 8 or 16 letters, or behind commas."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import Line, parse_ints, parse_real, read_lines
from palpate_editor.formats_child.scene import Refusal, Scene

KINDS = {
    **dict.fromkeys(("CTRIA3", "CTRIAR", "CTRIA6"), ("triangle", 3)),
    **dict.fromkeys(("CQUAD4", "CQUADR", "CQUAD8"), ("quad", 4)),
    "CTETRA": ("tetra", 4),
    "CPYRAM": ("pyramid", 5),
    "CPYRA": ("pyramid", 5),
    "CPENTA": ("wedge", 6),
    "CHEXA": ("hexahedron", 8),
}
"""Card -> kind and corners; points on the middles of edges follow them."""


def read_nastran(path: str) -> Scene:
    """Raises Refusal."""
    numbers, points, other = [], [], 0
    cells: dict[str, list[list[int]]] = {}
    for line, name, fields in list_cards(read_lines(path, "$")):
        if name == "GRID":
            numbers.append(parse_ints([read_field(fields, 0)], line)[0])
            points.append([parse_real(read_field(fields, i) or "0", line[0]) for i in (2, 3, 4)])
            other += read_field(fields, 1) not in ("", "0")
        elif name in KINDS:
            kind, size = KINDS[name]
            words = [read_field(fields, i) for i in range(1, 2 + size)]
            words[0] = words[0] or "0"
            cells.setdefault(kind, []).append(parse_ints(words, line))
    if not numbers:
        raise Refusal("", "no GRID", "GRID and elements of Nastran")
    rows = CellRows()
    for kind, found in cells.items():
        table = np.array(found)
        rows.add(kind, table[:, 1:], table[:, 0])
    notes = []
    if other:
        notes.append(
            f"{other} points say a coordinate system of their own, which was not looked at"
        )
    mesh = build_mesh(np.array(numbers), np.array(points), rows, notes=notes)
    return build_scene(path, mesh)


def read_field(fields: list[str], i: int) -> str:
    return fields[i].strip() if i < len(fields) else ""


def list_cards(lines: list[Line]) -> Iterator[tuple[Line, str, list[str]]]:
    """Each card of the bulk data with its fields, its continuations joined."""
    card: tuple[Line, str, list[str]] | None = None
    begin = next((i for i, (_, text) in enumerate(lines) if is_begin(text)), -1)
    for line in lines[begin + 1 :]:
        text = line[1].expandtabs(8)
        if text.strip().upper().startswith("ENDDATA"):
            break
        name, fields = split_card(text)
        if name in ("", "+", "*") or name[0] in "+*":
            if card is not None:
                card[2].extend(fields)
            continue
        if card is not None:
            yield card
        card = (line, name.rstrip("*").upper(), fields)
    if card is not None:
        yield card


def is_begin(text: str) -> bool:
    words = text.upper().split()
    return len(words) >= 2 and words[0] == "BEGIN" and words[1].startswith("BULK")


def split_card(text: str) -> tuple[str, list[str]]:
    """Its name, and its fields without what names its continuation."""
    if "," in text:
        words = [word.strip() for word in text.split(",")]
        return words[0], words[1:9] if "*" not in words[0] else words[1:5]
    name = text[:8].strip()
    if "*" in name:
        return name, [text[8 + 16 * i : 24 + 16 * i] for i in range(4)]
    return name, [text[8 + 8 * i : 16 + 8 * i] for i in range(8)]
