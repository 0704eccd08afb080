# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the meshes of Ansys Fluent as text (.msh, .cas) [Ansys Fluent User's Guide, "Mesh
file format"]: the faces that have a cell on one side only."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from palpate_editor.formats_child.cells import find_numbers
from palpate_editor.formats_child.gmsh_values import TextValues
from palpate_editor.formats_child.scene import Refusal, Scene, check_lost, cut_out

NODES, FACES, ZONES = 10, 13, (39, 45)
SECTION = re.compile(rb"\(\s*(\d+)\s*(\([^()]*\))?\s*(\()?")
NAMED = re.compile(rb"\(\s*(?:39|45)\s*\(\s*(\d+)\s+(\S+)\s+([^\s()]+)")
EXPECTED = "a mesh of Fluent as text"


def read_fluent(path: str) -> Scene:
    """A part for each zone of outer faces. Raises Refusal."""
    with open(path, "rb") as file:
        content = file.read()
    if re.search(rb"\n\(\s*[23]0(?:10|13)\s*\(", content):
        raise Refusal("", "binary sections", f"{EXPECTED}, as Fluent writes it without 'Binary'")
    numbers: list[np.ndarray] = []
    points: list[np.ndarray] = []
    outer: dict[int, list[np.ndarray]] = {}
    for kind, head, body in list_sections(content):
        if kind == NODES:
            numbers.append(np.arange(head[1], head[2] + 1))
            points.append(take_nodes(head, body))
        elif kind == FACES:
            outer.setdefault(head[0], []).append(take_outer(head, body))
    if not points or not outer:
        raise Refusal("", "no nodes and faces", EXPECTED)
    return build_scene(path, content, np.concatenate(numbers), np.concatenate(points), outer)


def build_scene(
    path: str,
    content: bytes,
    numbers: np.ndarray,
    points: np.ndarray,
    outer: dict[int, list[np.ndarray]],
) -> Scene:
    names = {int(m[1]): m[3].decode(errors="replace") for m in NAMED.finditer(content)}
    parts, notes, lost, kept = [], [], 0, 0
    used = {zone: np.concatenate(found) for zone, found in outer.items()}
    used = {zone: triangles for zone, triangles in used.items() if len(triangles)}
    for zone, triangles in used.items():
        rows, there = find_numbers(numbers, triangles)
        whole = there.all(axis=1)
        lost, kept = lost + int((~whole).sum()), kept + int(whole.sum())
        name = names.get(zone, Path(path).stem if len(used) == 1 else f"zone {zone}")
        parts.append(cut_out(name, points, rows[whole]))
    check_lost(lost, kept, "faces", notes)
    if not parts:
        raise Refusal("", "no faces with a cell on one side only", "the outside of a mesh")
    return Scene(parts, notes)


def list_sections(content: bytes) -> Iterator[tuple[int, list[int], bytes]]:
    """Number, head (hexadecimal) and body of the sections of nodes and faces that have a body."""
    for mark in SECTION.finditer(content):
        kind = int(mark[1])
        if kind not in (NODES, FACES) or mark[2] is None or mark[3] is None:
            continue
        words = mark[2].strip(b"()").split()
        try:
            head = [int(word, 16) for word in words]
        except ValueError:
            head = []
        if len(head) < 4:
            where = f"byte {mark.start()}"
            raise Refusal(where, f"a head of {len(head)} numbers", "four or five of a section")
        end = content.find(b")", mark.end())
        if end < 0:
            raise Refusal(f"section ({kind}", "the end of the file", "its closing bracket")
        yield kind, head, content[mark.end() : end]


def take_nodes(head: list[int], body: bytes) -> np.ndarray:
    if len(head) > 4 and head[4] == 2:
        raise Refusal("nodes", "two dimensions", "three")
    values = TextValues("nodes", body)
    count = head[2] - head[1] + 1
    values.check(count, 3, "nodes")
    return values.take_reals(3 * count, "nodes").reshape(-1, 3)


def take_outer(head: list[int], body: bytes) -> np.ndarray:
    """(t, 3) Corners, by number: zone first last kind size; then of each face its corners, after
    their count where the size is 0 or 5, and the cells on either side, 0 where there is none."""
    size = head[4] if len(head) > 4 else 0
    found = []
    rows = body.splitlines()
    for line in rows:
        try:
            words = [int(word, 16) for word in line.split()]
        except ValueError:
            shown = line[:40].decode(errors="replace").strip()
            raise Refusal(f"faces of zone {head[0]}", f"'{shown}'", "hexadecimal numbers") from None
        if not words:
            continue
        many, corners = (words[0], words[1:]) if size in (0, 5) else (size, words)
        if len(corners) != many + 2:
            got = f"{len(words)} numbers"
            raise Refusal(f"faces of zone {head[0]}", got, f"{many} corners and two cells")
        if 0 in corners[many:]:
            found += [[corners[0], corners[i], corners[i + 1]] for i in range(1, many - 1)]
    whole = head[2] - head[1] + 1
    if sum(bool(line.strip()) for line in rows) != whole:
        raise Refusal(f"faces of zone {head[0]}", f"{len(rows)} lines", f"{whole} faces")
    return np.array(found, np.int64).reshape(-1, 3)
