# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of Gmsh (.msh 2.2, 4.0 and 4.1, text or binary), through meshio."""

from __future__ import annotations

import re
from pathlib import Path

import meshio
import numpy as np
from meshio import gmsh

from palpate_editor.formats_child.scene import (
    NO_FILLING,
    Part,
    Refusal,
    Scene,
    cut_filling,
    cut_out,
    describe_cells,
    describe_tetrahedra,
)

FACES = {
    "tetra": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
    "pyramid": [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
    "wedge": [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    "hexahedron": [
        *((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4)),
        *((1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
    ],
}
"""Cell -> its faces from outside, by corners in the order of Gmsh."""
CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}
"""Further points of a cell of higher order follow its corners."""

Polygons = list[tuple[np.ndarray, np.ndarray]]
"""Corners (k, 3) or (k, 4), and the group of each (k,)."""


def read_gmsh(path: str) -> Scene:
    """The outer faces of cells that fill space, where there are some, else the faces; a part for
    each physical group. Raises Refusal."""
    check_head(path)
    mesh = gmsh.read(path)
    notes: list[str] = []
    solid = collect(mesh, tuple(FACES))
    polygons = find_outside(solid) if solid else collect_polygons(mesh)
    filling = NO_FILLING
    if solid:
        count = sum(len(cells) for _, cells, _ in solid)
        if all(kind == "tetra" for kind, _, _ in solid):
            filling = cut_filling(mesh.points, np.concatenate([cells for _, cells, _ in solid]))
            notes.append(describe_tetrahedra(count))
        else:
            notes.append(describe_cells(count))
    triangles = np.concatenate([split(corners) for corners, _ in polygons] or [np.empty((0, 3))])
    if len(triangles) == 0:
        raise Refusal("", "no faces", "a surface made of triangles or quadrilaterals")
    group = np.concatenate([np.repeat(g, corners.shape[1] - 2) for corners, g in polygons])
    dimension = 3 if solid else 2
    return Scene(list_parts(Path(path).stem, mesh, triangles, group, dimension), notes, filling)


def check_head(path: str) -> None:
    with open(path, "rb") as file:
        head = file.read(4096)
    at = head.find(b"$MeshFormat")
    if at < 0:
        raise Refusal("header", "no $MeshFormat", "a file of Gmsh, version 2.2, 4.0 or 4.1")
    version = re.match(rb"\$MeshFormat\s+(\S+)", head[at:])
    words = version.group(1).decode(errors="replace") if version else "none"
    if words not in ("2", "2.0", "2.1", "2.2", "4", "4.0", "4.1"):
        raise Refusal("header", f"version {words}", "version 2.2, 4.0 or 4.1")


def collect(mesh: meshio.Mesh, kinds: tuple[str, ...]) -> list[tuple[str, np.ndarray, np.ndarray]]:
    """The cells of some kinds, without their inner points, and their physical groups."""
    groups = mesh.cell_data.get("gmsh:physical")
    found = []
    for i, block in enumerate(mesh.cells):
        kind = re.sub(r"\d+$", "", block.type)
        if kind not in kinds or len(block.data) == 0:
            continue
        group = np.zeros(len(block.data), int) if groups is None else np.asarray(groups[i])
        found.append((kind, np.asarray(block.data)[:, : CORNERS[kind]], group))
    return found


def collect_polygons(mesh: meshio.Mesh) -> Polygons:
    return [(cells, group) for _, cells, group in collect(mesh, ("triangle", "quad"))]


def find_outside(solid: list[tuple[str, np.ndarray, np.ndarray]]) -> Polygons:
    """The faces that only one of all cells has."""
    faces: dict[int, list[np.ndarray]] = {3: [], 4: []}
    groups: dict[int, list[np.ndarray]] = {3: [], 4: []}
    for kind, cells, group in solid:
        for face in FACES[kind]:
            faces[len(face)].append(cells[:, face])
            groups[len(face)].append(group)
    polygons = []
    for size in (3, 4):
        if not faces[size]:
            continue
        corners = np.concatenate(faces[size])
        _, which, times = np.unique(
            np.sort(corners, axis=1), axis=0, return_inverse=True, return_counts=True
        )
        single = times[which.ravel()] == 1
        polygons.append((corners[single], np.concatenate(groups[size])[single]))
    return polygons


def split(corners: np.ndarray) -> np.ndarray:
    """Triangles of triangles or quadrilaterals."""
    if corners.shape[1] == 3:
        return corners
    return np.stack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]], axis=1).reshape(-1, 3)


def list_parts(
    stem: str, mesh: meshio.Mesh, triangles: np.ndarray, group: np.ndarray, dimension: int
) -> list[Part]:
    names = {int(number): name for name, (number, of) in mesh.field_data.items() if of == dimension}
    ids = np.unique(group)
    if len(ids) == 1:
        return [cut_out(names.get(int(ids[0]), stem), mesh.points, triangles)]
    return [
        cut_out(names.get(int(i), f"{stem} {i}"), mesh.points, triangles[group == i]) for i in ids
    ]
