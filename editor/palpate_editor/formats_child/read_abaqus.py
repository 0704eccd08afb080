# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the input files of Abaqus and CalculiX (.inp) [Abaqus Keywords Reference]."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.lines import (
    Line,
    parse_ints,
    parse_reals,
    read_lines,
    split_blocks,
    take_table,
)
from palpate_editor.formats_child.scene import Refusal, Scene

KINDS = (
    (r"(?:D?C3D|AC3D|F3D|SC)(?:4|10)", "tetra"),
    (r"(?:D?C3D|AC3D|F3D|SC)(?:8|20|27)", "hexahedron"),
    (r"(?:D?C3D|AC3D|F3D|SC)(?:6|15)", "wedge"),
    (r"(?:D?C3D|AC3D|F3D)5", "pyramid"),
    (r"(?:S|SFM3D|M3D|R3D|STRI|DS|CP[SE]|CPEG|SAX|STRI6)(?:3|6|65)(?!D)", "triangle"),
    (r"(?:S|SFM3D|M3D|R3D|DS|CP[SE])(?:4|8|9)", "quad"),
)
"""Beginning of an element's type -> what it is; integration and formulation follow it."""


@dataclass(eq=False)
class Mesh:
    """Nodes and elements of a part, or of what stands outside of all."""

    nodes: list[np.ndarray] = field(default_factory=list)
    """Rows of number, x, y, z."""
    cells: list[tuple[str, np.ndarray, str]] = field(default_factory=list)
    """Kind, numbers of nodes, name of its set."""


@dataclass(eq=False)
class File:
    parts: dict[str, Mesh] = field(default_factory=dict)
    """By name in capitals; that of the empty name stands outside of parts."""
    instances: list[tuple[str, np.ndarray, np.ndarray]] = field(default_factory=list)
    """Name of a part, its rotation (3, 3) and its shift."""
    passed_over: dict[str, int] = field(default_factory=dict)
    """Types of elements that are no faces and fill no space."""
    notes: list[str] = field(default_factory=list)


def read_abaqus(path: str) -> Scene:
    """Raises Refusal."""
    lines = [line for line in read_lines(path) if not line[1].lstrip().startswith("**")]
    file = take_file([(n, text.lstrip()) for n, text in lines])
    used = file.instances or [(name, np.eye(3), np.zeros(3)) for name in file.parts]
    rows, points, first = CellRows(), [], 0
    names: dict[tuple[int, int], str] = {}
    numbers = []
    for name, turn, shift in used:
        mesh = file.parts.get(name)
        if mesh is None or not mesh.nodes:
            continue
        nodes = np.concatenate(mesh.nodes)
        points.append(nodes[:, 1:] @ turn.T + shift)
        numbers.append(first + nodes[:, 0].astype(np.int64))
        for kind, corners, of in mesh.cells:
            group = len(names) // 2 + 1
            label = " ".join(filter(None, (name if len(used) > 1 else "", of)))
            known = next((g for (d, g), n in names.items() if n == label), None)
            group = group if known is None else known
            if label:
                names[2, group] = names[3, group] = label
            rows.add(kind, first + corners, group if label else 0)
        first += int(max(nodes[:, 0].max(), 0)) + 1
    if not points:
        raise Refusal("", "no *NODE", "*NODE and *ELEMENT of Abaqus")
    notes = list(file.notes)
    if file.passed_over:
        told = ", ".join(f"{count} {kind}" for kind, count in sorted(file.passed_over.items()))
        notes.append(f"elements that are no faces and fill no space were passed over: {told}")
    mesh = build_mesh(np.concatenate(numbers), np.concatenate(points), rows, names, notes)
    return build_scene(path, mesh)


def take_file(lines: list[Line]) -> File:
    file, name = File(), ""
    for head, block in split_blocks(lines, "*"):
        word, options = parse_keyword(head[1])
        if word == "PART":
            name = options.get("NAME", "").upper()
        elif word == "ENDPART":
            name = ""
        elif word == "INSTANCE":
            turn, shift = take_place(block)
            file.instances.append((options.get("PART", "").upper(), turn, shift))
        elif word == "NODE":
            part = file.parts.setdefault(name, Mesh())
            part.nodes.append(take_table(block, 4, "number, x, y, z"))
        elif word == "ELEMENT":
            add_elements(file, file.parts.setdefault(name, Mesh()), head, block, options)
        elif word == "INCLUDE":
            file.notes.append(f"did not open {options.get('INPUT', '')}, which it includes")
        elif word in ("NGEN", "ELGEN", "NFILL", "NCOPY", "ELCOPY"):
            raise Refusal(f"line {head[0]}", f"*{word}", "nodes and elements written out")
    return file


def parse_keyword(text: str) -> tuple[str, dict[str, str]]:
    """Word and options; both without regard to capitals and blanks."""
    word, *rest = text.lstrip("*").split(",")
    options = {}
    for option in rest:
        name, _, value = option.partition("=")
        options[name.strip().upper()] = value.strip().strip('"')
    return "".join(word.split()).upper(), options


def take_place(block: list[Line]) -> tuple[np.ndarray, np.ndarray]:
    """Rotation and shift of an instance: a line x, y, z; then one of two points and an angle
    [degree] about the line through them. The shift is first."""
    rows = [parse_reals([word for word in text.split(",") if word.strip()], n) for n, text in block]
    shift = np.array(rows[0]) if rows and len(rows[0]) == 3 else np.zeros(3)
    if len(rows) < 2 or len(rows[1]) != 7:
        return np.eye(3), shift
    origin, axis = np.array(rows[1][:3]), np.array(rows[1][3:6]) - rows[1][:3]
    length = np.linalg.norm(axis)
    if not length > 0.0:
        return np.eye(3), shift
    turn = rotate(axis / length, np.deg2rad(rows[1][6]))
    return turn, turn @ (shift - origin) + origin


def rotate(axis: np.ndarray, angle: float) -> np.ndarray:
    """[Rodrigues]"""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross


def find_kind(name: str) -> str | None:
    for pattern, kind in KINDS:
        if re.match(pattern + r"(?!\d)", name):
            return kind
    return None


def add_elements(
    file: File, part: Mesh, head: Line, block: list[Line], options: dict[str, str]
) -> None:
    name = options.get("TYPE", "").upper()
    kind = find_kind(name)
    elements = join_continued(block)
    if kind is None:
        file.passed_over[name] = file.passed_over.get(name, 0) + len(elements)
        return
    if not elements:
        return
    by_width: dict[int, list[list[int]]] = {}
    for line in elements:
        by_width.setdefault(len(line), []).append(line)
    for rows in by_width.values():
        part.cells.append((kind, np.array(rows)[:, 1:], options.get("ELSET", "")))


def join_continued(block: list[Line]) -> list[list[int]]:
    """Numbers of each element; a line that ends with a comma goes on in the next."""
    found: list[list[int]] = []
    goes_on = False
    for line in block:
        words = [word for word in line[1].split(",") if word.strip()]
        values = parse_ints(words, line)
        if goes_on:
            found[-1] += values
        else:
            found.append(values)
        goes_on = line[1].rstrip().endswith(",")
    return found
