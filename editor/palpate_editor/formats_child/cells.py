# SPDX-License-Identifier: GPL-3.0-or-later
"""The outside of cells, as files of simulations have them: points, elements of a few kinds."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

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
"""Cell -> its faces from outside, by corners in the order of Gmsh, Abaqus and Nastran."""
CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}
"""Further points of a cell of higher order follow its corners."""
EXPECTED = "a surface made of triangles or quadrilaterals, or cells that fill space"


@dataclass(frozen=True, eq=False)
class Block:
    """Cells of one kind."""

    kind: str
    """Of CORNERS."""
    corners: np.ndarray
    """(k, c) rows of the points"""
    groups: np.ndarray
    """(k,) what each belongs to; 0 for nothing"""


@dataclass(frozen=True, eq=False)
class CellMesh:
    points: np.ndarray
    """(n, 3)"""
    blocks: list[Block]
    names: dict[tuple[int, int], str] = field(default_factory=dict)
    """Dimension, 2 or 3, and number of a group -> its name."""
    lost: int = 0
    """Cells that were left out: they name a point that is not there."""
    notes: list[str] = field(default_factory=list)


@dataclass(eq=False)
class CellRows:
    """Cells as a file lists them, by the numbers that it gives its points."""

    rows: list[tuple[str, np.ndarray, np.ndarray]] = field(default_factory=list)
    """Kind, numbers of points (k, c), groups (k,)."""

    def add(self, kind: str, numbers: np.ndarray, groups: np.ndarray | int = 0) -> None:
        """Without what follows the corners."""
        corners = np.asarray(numbers, np.int64)[:, : CORNERS[kind]]
        if corners.shape[1] < CORNERS[kind]:
            got = f"{corners.shape[1]} points of a {kind}"
            raise Refusal("", got, f"{CORNERS[kind]} of them")
        self.rows.append((kind, corners, np.broadcast_to(groups, len(corners)).astype(np.int64)))

    def find_points(self, numbers: np.ndarray) -> tuple[list[Block], int]:
        """The blocks, and how many cells were left out, which name a point that is not there."""
        blocks, lost = [], 0
        for kind, corners, groups in self.rows:
            found, there = find_numbers(numbers, corners)
            kept = there.all(axis=1)
            lost += int((~kept).sum())
            blocks.append(Block(kind, found[kept], groups[kept]))
        return blocks, lost


def find_numbers(numbers: np.ndarray, wanted: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The rows in `numbers` that have the wanted ones, and which of them are there at all."""
    if len(numbers) == 0:
        return np.zeros_like(wanted), np.zeros(wanted.shape, bool)
    order = np.argsort(numbers, kind="stable")
    place = np.searchsorted(numbers, wanted, sorter=order)
    found = order[np.minimum(place, len(order) - 1)]
    return found, numbers[found] == wanted


def build_mesh(
    numbers: np.ndarray,
    points: np.ndarray,
    rows: CellRows,
    names: dict[tuple[int, int], str] | None = None,
    notes: Iterable[str] = (),
) -> CellMesh:
    """Of points (n, 3) with their numbers (n,) in the file, and cells."""
    blocks, lost = rows.find_points(np.asarray(numbers, np.int64))
    return CellMesh(np.asarray(points, float), blocks, names or {}, lost, list(notes))


def build_scene(path: str, mesh: CellMesh) -> Scene:
    """The outer faces of cells that fill space, where there are some, else the faces; a part for
    each group. Raises Refusal."""
    notes = list(mesh.notes)
    check_lost(mesh.lost, sum(len(block.corners) for block in mesh.blocks), "elements", notes)
    solid = [block for block in mesh.blocks if block.kind in FACES and len(block.corners)]
    filling = NO_FILLING
    if solid:
        solid = share_points(mesh.points, solid)
        count = sum(len(block.corners) for block in solid)
        if all(block.kind == "tetra" for block in solid):
            filling = cut_filling(mesh.points, np.concatenate([b.corners for b in solid]))
            notes.append(describe_tetrahedra(count))
        else:
            notes.append(describe_cells(count))
    polygons = find_outside(solid) if solid else [(b.corners, b.groups) for b in mesh.blocks]
    triangles = np.concatenate([split(corners) for corners, _ in polygons] or [np.empty((0, 3))])
    if len(triangles) == 0:
        raise Refusal("", "no faces", EXPECTED)
    group = np.concatenate([np.repeat(g, corners.shape[1] - 2) for corners, g in polygons])
    dimension = 3 if solid else 2
    return Scene(list_parts(Path(path).stem, mesh, triangles, group, dimension), notes, filling)


def share_points(points: np.ndarray, solid: list[Block]) -> list[Block]:
    """Cells that have points of their own where they meet share them; tetrahedra that have a corner
    twice are gone."""
    used = np.unique(np.concatenate([block.corners.ravel() for block in solid]))
    _, first, which = np.unique(points[used], axis=0, return_index=True, return_inverse=True)
    place = np.zeros(len(points), np.int64)
    place[used] = used[first[which.ravel()]]
    shared = []
    for block in solid:
        corners = place[block.corners]
        kept = np.ones(len(corners), bool)
        if block.kind == "tetra":
            kept = (np.diff(np.sort(corners, axis=1), axis=1) > 0).all(axis=1)
        shared.append(Block(block.kind, corners[kept], block.groups[kept]))
    return shared


Polygons = list[tuple[np.ndarray, np.ndarray]]
"""Corners (k, 3) or (k, 4), and the group of each (k,)."""


def find_outside(solid: list[Block]) -> Polygons:
    """The faces that only one of all cells has."""
    faces: dict[int, list[np.ndarray]] = {3: [], 4: []}
    groups: dict[int, list[np.ndarray]] = {3: [], 4: []}
    for block in solid:
        for face in FACES[block.kind]:
            faces[len(face)].append(block.corners[:, face])
            groups[len(face)].append(block.groups)
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
    stem: str, mesh: CellMesh, triangles: np.ndarray, group: np.ndarray, dimension: int
) -> list[Part]:
    names = {number: name for (of, number), name in mesh.names.items() if of == dimension}
    ids = np.unique(group)
    if len(ids) == 1:
        return [cut_out(names.get(int(ids[0]), stem), mesh.points, triangles)]
    return [
        cut_out(names.get(int(i), f"{stem} {i}"), mesh.points, triangles[group == i]) for i in ids
    ]
