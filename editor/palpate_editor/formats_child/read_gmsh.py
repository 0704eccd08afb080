# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of Gmsh (.msh 1, 2, 4.0 and 4.1, text or binary)."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from palpate_editor.formats_child.gmsh_file import GmshFile, open_gmsh
from palpate_editor.formats_child.scene import (
    NO_FILLING,
    Part,
    Refusal,
    Scene,
    check_lost,
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
KINDS = {
    **dict.fromkeys((2, 9, 20, 21, 22, 23, 24, 25), "triangle"),
    **dict.fromkeys((3, 10, 16, 36, 37), "quad"),
    **dict.fromkeys((4, 11, 29, 30, 31), "tetra"),
    **dict.fromkeys((5, 12, 17, 92, 93), "hexahedron"),
    **dict.fromkeys((6, 13, 18), "wedge"),
    **dict.fromkeys((7, 14, 19), "pyramid"),
}
"""Type of an element, as Gmsh numbers them -> what it is."""

Cells = list[tuple[str, np.ndarray, np.ndarray]]
"""Kind, corners (k, c), and the group of each (k,)."""
Polygons = list[tuple[np.ndarray, np.ndarray]]
"""Corners (k, 3) or (k, 4), and the group of each (k,)."""


def read_gmsh(path: str) -> Scene:
    """The outer faces of cells that fill space, where there are some, else the faces; a part for
    each physical group. Raises Refusal."""
    mesh = open_gmsh(path)
    notes: list[str] = []
    check_lost(mesh.lost, sum(len(block.nodes) for block in mesh.blocks), "elements", notes)
    solid = collect(mesh, tuple(FACES))
    filling = NO_FILLING
    if solid:
        solid = share_points(mesh.points, solid)
        count = sum(len(cells) for _, cells, _ in solid)
        if all(kind == "tetra" for kind, _, _ in solid):
            filling = cut_filling(mesh.points, np.concatenate([cells for _, cells, _ in solid]))
            notes.append(describe_tetrahedra(count))
        else:
            notes.append(describe_cells(count))
    polygons = find_outside(solid) if solid else collect_polygons(mesh)
    triangles = np.concatenate([split(corners) for corners, _ in polygons] or [np.empty((0, 3))])
    if len(triangles) == 0:
        raise Refusal("", "no faces", "a surface made of triangles or quadrilaterals")
    group = np.concatenate([np.repeat(g, corners.shape[1] - 2) for corners, g in polygons])
    dimension = 3 if solid else 2
    return Scene(list_parts(Path(path).stem, mesh, triangles, group, dimension), notes, filling)


def collect(mesh: GmshFile, kinds: tuple[str, ...]) -> Cells:
    """The cells of some kinds, without their inner points, and their physical groups."""
    found = []
    for block in mesh.blocks:
        kind = KINDS.get(block.type)
        if kind in kinds and len(block.nodes) > 0:
            found.append((kind, block.nodes[:, : CORNERS[kind]], block.groups))
    return found


def collect_polygons(mesh: GmshFile) -> Polygons:
    return [(cells, group) for _, cells, group in collect(mesh, ("triangle", "quad"))]


def share_points(points: np.ndarray, solid: Cells) -> Cells:
    """Cells that have points of their own where they meet share them; tetrahedra that have a corner
    twice are gone."""
    used = np.unique(np.concatenate([cells.ravel() for _, cells, _ in solid]))
    _, first, which = np.unique(points[used], axis=0, return_index=True, return_inverse=True)
    place = np.zeros(len(points), np.int64)
    place[used] = used[first[which.ravel()]]
    shared: Cells = []
    for kind, cells, group in solid:
        corners = place[cells]
        kept = np.ones(len(cells), bool)
        if kind == "tetra":
            kept = (np.diff(np.sort(corners, axis=1), axis=1) > 0).all(axis=1)
        shared.append((kind, corners[kept], group[kept]))
    return shared


def find_outside(solid: Cells) -> Polygons:
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
    stem: str, mesh: GmshFile, triangles: np.ndarray, group: np.ndarray, dimension: int
) -> list[Part]:
    names = {number: name for (of, number), name in mesh.names.items() if of == dimension}
    ids = np.unique(group)
    if len(ids) == 1:
        return [cut_out(names.get(int(ids[0]), stem), mesh.points, triangles)]
    return [
        cut_out(names.get(int(i), f"{stem} {i}"), mesh.points, triangles[group == i]) for i in ids
    ]
