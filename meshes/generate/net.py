# SPDX-License-Identifier: BSD-3-Clause
"""A dense closed mesh of where a field is zero: surface nets on a grid."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.field import Array, Field
from palpate_meshes.generate.relax import find_edges, measure
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

BLOCK = 8
"""Cells along a block that is looked at as a whole first."""
STEEPEST = 2.5
"""A field may change by this much per mm; blocks farther from zero are filled without looking."""
CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
EDGES = [
    (a, b) for a in range(8) for b in range(a + 1, 8) if abs(CORNERS[a] - CORNERS[b]).sum() == 1
]


def build_net(field: Field, low: Array, high: Array, cell: float) -> tuple[Array, Array]:
    """Vertices [mm] and triangles, outward, of the surface inside a box.

    Args:
        field: Zero on the surface, which must be closed inside the box.
        low: [mm] A corner of the box, (3,).
        high: [mm] The opposite corner.
        cell: [mm] Edges come out about this long.

    Closed, but not manifold where the grid is too coarse for the surface: is_manifold tells.
    Raises ValueError where the surface leaves the box.
    """
    shape = np.ceil((high - low) / cell).astype(int) + 1
    shape = -(-shape // BLOCK) * BLOCK
    values = sample(field, low, shape, cell)
    inside = values < 0.0
    faces = [np.take(inside, i, axis) for axis in range(3) for i in (0, -1)]
    if any(face.any() for face in faces):
        raise ValueError("the organ does not fit into its box")
    cells, points = place_vertices(values, inside)
    quads = join_cells(inside, cells)
    points = low + cell * points
    return points, split_quads(points, quads)


def sample(field: Field, low: Array, shape: Array, cell: float) -> Array:
    """The field on a grid; far from zero only its sign is right."""
    blocks = shape // BLOCK
    index = np.stack(np.meshgrid(*(np.arange(n) for n in blocks), indexing="ij"), axis=-1)
    index = index.reshape(-1, 3)
    middle = field(low + cell * (BLOCK * index + 0.5 * (BLOCK - 1)))
    near = np.abs(middle) < STEEPEST * cell * BLOCK * 0.87
    values = np.empty((*blocks, BLOCK, BLOCK, BLOCK))
    values[tuple(index.T)] = middle[:, None, None, None]
    step = np.stack(np.meshgrid(*(np.arange(BLOCK),) * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    for part in np.array_split(index[near], max(1, near.sum() // 400)):
        p = low + cell * (BLOCK * part[:, None, :] + step[None]).reshape(-1, 3)
        values[tuple(part.T)] = field(p).reshape(-1, BLOCK, BLOCK, BLOCK)
    return values.transpose(0, 3, 1, 4, 2, 5).reshape(shape)


def place_vertices(values: Array, inside: Array) -> tuple[Array, Array]:
    """The number of every cell the surface runs through, -1 elsewhere, and a point in each [cell]:
    the mean of where the surface crosses its edges."""
    count = sum(shifted(inside.astype(np.int8), corner) for corner in CORNERS)
    crossed = (count > 0) & (count < 8)
    cells = np.full(crossed.shape, -1, np.int64)
    at = np.stack(np.nonzero(crossed), axis=1)
    cells[crossed] = np.arange(len(at))
    corner = [values[tuple((at + c).T)] for c in CORNERS]
    total, crossings = np.zeros((len(at), 3)), np.zeros(len(at))
    for a, b in EDGES:
        change = (corner[a] < 0.0) != (corner[b] < 0.0)
        gap = np.where(change, corner[a] - corner[b], 1.0)
        t = np.where(change, corner[a] / gap, 0.0)
        place = CORNERS[a] + t[:, None] * (CORNERS[b] - CORNERS[a])
        total += np.where(change[:, None], place, 0.0)
        crossings += change
    return cells, at + total / crossings[:, None]


def shifted(grid: Array, corner: Array) -> Array:
    """For every cell the value at one of its corners."""
    n = np.array(grid.shape) - 1
    return grid[tuple(slice(c, c + m) for c, m in zip(corner, n, strict=True))]


def join_cells(inside: Array, cells: Array) -> Array:
    """A quad around every grid edge whose ends lie on different sides."""
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        here = [slice(0, -1)] * 3
        there = list(here)
        there[axis] = slice(1, None)
        change = inside[tuple(here)] != inside[tuple(there)]
        at = np.stack(np.nonzero(change), axis=1)
        du, dv = np.eye(3, dtype=np.int64)[u], np.eye(3, dtype=np.int64)[v]
        ring = [cells[tuple((at - d).T)] for d in (du + dv, dv, np.zeros(3, np.int64), du)]
        quad = np.stack(ring, axis=1)
        # counter-clockwise seen from where the field is positive
        outward = inside[tuple(at.T)]
        quad[~outward] = quad[~outward][:, ::-1]
        quads.append(quad)
    return np.concatenate(quads)


def split_quads(points: Array, quads: Array) -> Array:
    """Two triangles each, along the shorter diagonal."""
    a, b, c, d = (points[quads[:, i]] for i in range(4))
    first = measure(a - c) <= measure(b - d)
    one = np.where(first[:, None], quads[:, [0, 1, 2]], quads[:, [1, 2, 3]])
    two = np.where(first[:, None], quads[:, [0, 2, 3]], quads[:, [1, 3, 0]])
    return np.concatenate([one, two])


def is_manifold(triangles: Array, count: int) -> bool:
    """Whether every edge has two triangles and every vertex one fan of them."""
    key = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    _, uses = np.unique(key[:, 0] * count + key[:, 1], return_counts=True)
    return bool((uses == 2).all() and count_fans(triangles, count) == count)


def count_fans(triangles: Array, count: int) -> int:
    """Fans of triangles around all vertices; one per vertex where the surface is manifold."""
    edges, sides, _ = find_edges(triangles)
    # corner of a triangle: 3 t + i; across an edge, the corners at the same vertex belong together
    rows, columns = [], []
    for end in range(2):
        corner = [
            3 * sides[:, s] + (triangles[sides[:, s]] == edges[:, end, None]).argmax(axis=1)
            for s in range(2)
        ]
        paired = sides[:, 1] >= 0
        rows.append(corner[0][paired])
        columns.append(corner[1][paired])
    i, j = np.concatenate(rows), np.concatenate(columns)
    n = 3 * len(triangles)
    fans, _ = connected_components(coo_matrix((np.ones(len(i)), (i, j)), shape=(n, n)), False)
    return int(fans)
