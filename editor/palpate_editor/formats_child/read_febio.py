# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the models of FEBio (.feb), versions 1.2 to 4.0 [FEBio User Manual, "Mesh"]."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar
from xml.etree.ElementTree import Element, ParseError, XMLParser, parse

import numpy as np

from palpate_editor.formats_child.cells import CellRows, build_mesh, build_scene
from palpate_editor.formats_child.scene import Refusal, Scene

Number = TypeVar("Number", int, float)
KINDS = {
    "tet": "tetra",
    "hex": "hexahedron",
    "penta": "wedge",
    "pyra": "pyramid",
    "tri": "triangle",
    "quad": "quad",
}
"""How an element's type begins, its number of nodes behind -> what it is."""


def read_febio(path: str) -> Scene:
    """The mesh before anything moves; a part for each domain. Raises Refusal."""
    try:
        root = parse(path, XMLParser()).getroot()
    except ParseError as problem:
        line = problem.position[0]
        raise Refusal(f"line {line}", f"no XML ({problem.msg})", "a model of FEBio") from None
    if root.tag != "febio_spec":
        raise Refusal("header", f"<{root.tag[:40]}>", "<febio_spec>")
    found = [branch for name in ("Mesh", "Geometry") for branch in root.iter(name)]
    if not found:
        raise Refusal("", "no <Mesh>", "a model of FEBio with its mesh in the same file")
    numbers: list[int] = []
    points: list[list[float]] = []
    rows = CellRows()
    names: dict[tuple[int, int], str] = {}
    for mesh in found:
        for nodes in mesh.iter("Nodes"):
            for node in nodes.iter("node"):
                numbers.append(read_id(node))
                points.append(read_numbers(node, float, 3))
        for domain in mesh.iter("Elements"):
            add_domain(rows, names, domain)
    if not points:
        raise Refusal("", "no nodes", "a model of FEBio with its mesh in the same file")
    return build_scene(path, build_mesh(np.array(numbers), np.array(points), rows, names))


def read_id(node: Element) -> int:
    try:
        return int(node.get("id", ""))
    except ValueError:
        raise Refusal(f"<{node.tag}>", f"id '{node.get('id', '')}'", "a whole number") from None


def read_numbers(node: Element, kind: Callable[[str], Number], least: int) -> list[Number]:
    words = (node.text or "").replace(",", " ").split()
    try:
        values = [kind(word) for word in words]
    except ValueError:
        where = f"<{node.tag} id='{node.get('id', '')}'>"
        raise Refusal(where, f"'{' '.join(words)[:40]}'", "numbers") from None
    if len(values) < least:
        raise Refusal(f"<{node.tag} id='{node.get('id', '')}'>", f"{len(values)} numbers",
                      f"{least} at least")  # fmt: skip
    return values


def find_kind(name: str) -> str | None:
    letters = name.rstrip("0123456789").lower()
    return KINDS.get(letters)


def add_domain(rows: CellRows, names: dict[tuple[int, int], str], domain: Element) -> None:
    """Its elements are all of its type; before version 2 each is named by its own."""
    group = 1 + len(names) // 2
    name = domain.get("name") or domain.get("elset") or domain.get("part")
    names[2, group] = names[3, group] = name or f"domain {group}"
    by_kind: dict[tuple[str, int], list[list[int]]] = {}
    for element in domain:
        kind = find_kind(domain.get("type", "") if element.tag in ("elem", "e") else element.tag)
        if kind is not None:
            corners = read_numbers(element, int, 3)
            by_kind.setdefault((kind, len(corners)), []).append(corners)
    for (kind, _), corners in by_kind.items():
        rows.add(kind, np.array(corners), group)
