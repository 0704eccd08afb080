# SPDX-License-Identifier: GPL-3.0-or-later
"""Which vertices a brush or a selection means.

A stamp paints what is inside the brush's ball AND faces the viewer AND is connected, inside the
ball, to what was hit: so it never paints through a thin wall, nor on what lies behind a fold.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from palpate_editor.document import freeze


@dataclass(frozen=True, eq=False)
class Neighbours:
    """Who is joined to whom by an edge, as compressed rows."""

    start: np.ndarray
    """(n + 1,) where the neighbours of each vertex begin"""
    ids: np.ndarray
    """Vertex numbers, ascending within a row"""

    @property
    def count(self) -> int:
        return len(self.start) - 1

    def of(self, vertices: np.ndarray) -> np.ndarray:
        """The neighbours of all `vertices` in one row, repeated as often as they are found."""
        begin, length = self.start[vertices], np.diff(self.start)[vertices]
        # where each row's numbers stand: its begin, counted up, row after row
        offset = np.repeat(begin - np.concatenate(([0], np.cumsum(length)[:-1])), length)
        return self.ids[offset + np.arange(len(offset))]


def build_neighbours(triangles: np.ndarray, vertex_count: int | None = None) -> Neighbours:
    """Once for every topology. A vertex no triangle has stands alone."""
    count = int(triangles.max(initial=-1)) + 1 if vertex_count is None else vertex_count
    corners = np.asarray(triangles, dtype=np.int64)
    one, other = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    # each directed edge as one number: unique() sorts by row, then by neighbour
    both = np.unique(np.concatenate((one * count + other, other * count + one)))
    start = np.concatenate(([0], np.cumsum(np.bincount(both // max(count, 1), minlength=count))))
    return Neighbours(
        freeze(start, np.int64, (None,)), freeze(both % max(count, 1), np.int64, (None,))
    )


def flood(seeds: np.ndarray, allowed: np.ndarray, neighbours: Neighbours) -> np.ndarray:
    """Numbers of the allowed vertices that allowed ones join to the seeds, ascending."""
    reached = np.zeros(len(allowed), bool)
    front = np.unique(seeds[allowed[seeds]])
    while front.size:
        reached[front] = True
        around = neighbours.of(front)
        front = np.unique(around[allowed[around] & ~reached[around]])
    return np.flatnonzero(reached)


def stamp(
    vertices: np.ndarray,
    normals: np.ndarray,
    triangles: np.ndarray,
    neighbours: Neighbours,
    triangle: int,
    hit: np.ndarray,
    radius: float,
    direction: np.ndarray,
    *,
    front_only: bool = True,
    connected: bool = True,
) -> np.ndarray:
    """Numbers of the vertices that a brush means, ascending.

    Args:
        vertices: [m] (n, 3)
        normals: [-] (n, 3), outward
        triangles: (t, 3)
        neighbours: Of the same triangles.
        triangle: The one that was hit.
        hit: [m] (3,) where.
        radius: [m] of the brush.
        direction: [-] (3,) in which the viewer looks.
        front_only: Leave out what faces away from the viewer.
        connected: Leave out what is not joined to the hit triangle by edges within the brush.
    """
    meant = ((vertices - hit) ** 2).sum(axis=1) < radius**2
    if front_only:
        meant &= normals @ np.asarray(direction) < 0.0
    if not connected:
        return np.flatnonzero(meant)
    return flood(find_seeds(vertices, triangles, triangle, hit, meant), meant, neighbours)


def find_seeds(
    vertices: np.ndarray, triangles: np.ndarray, triangle: int, hit: np.ndarray, meant: np.ndarray
) -> np.ndarray:
    """Corners of the hit triangle from which a stamp spreads.

    A brush smaller than the triangle reaches no corner: it then means the one closest to the hit,
    so that a click is never lost.
    """
    corners = np.asarray(triangles[triangle], dtype=np.int64)
    if not meant[corners].any():
        closest = corners[((vertices[corners] - hit) ** 2).sum(axis=1).argmin()]
        meant[closest] = True
    return corners


def compute_falloff(
    vertices: np.ndarray, ids: np.ndarray, hit: np.ndarray, radius: float, falloff: float = 1.0
) -> np.ndarray:
    """[-] (k,) 1 in the middle of a brush down to 0 at its rim, smooth at both.

    `falloff` [-] is the share of the radius over which it falls: 0 for a hard rim.
    """
    distance = np.linalg.norm(vertices[ids] - hit, axis=1) / radius
    if falloff <= 0.0:
        return np.ones(len(ids))
    fall = np.clip((1.0 - distance) / falloff, 0.0, 1.0)
    return fall * fall * (3.0 - 2.0 * fall)


def select_linked(vertices: np.ndarray, neighbours: Neighbours) -> np.ndarray:
    """Numbers of all vertices joined to some of `vertices` by edges: whole pieces, ascending."""
    seeds = np.asarray(vertices, dtype=np.int64)
    return flood(seeds, np.ones(neighbours.count, bool), neighbours)


def grow(vertices: np.ndarray, neighbours: Neighbours) -> np.ndarray:
    """The vertices and their neighbours, ascending."""
    ids = np.asarray(vertices, dtype=np.int64)
    return np.union1d(ids, neighbours.of(ids))


def shrink(vertices: np.ndarray, neighbours: Neighbours) -> np.ndarray:
    """Those of the vertices all of whose neighbours are among them, ascending."""
    ids = np.unique(np.asarray(vertices, dtype=np.int64))
    outside = np.ones(neighbours.count, bool)
    outside[ids] = False
    return np.setdiff1d(ids, neighbours.of(np.flatnonzero(outside)))


def smooth(
    values: np.ndarray, vertices: np.ndarray, neighbours: Neighbours, strength: float = 0.5
) -> np.ndarray:
    """(k,) values at `vertices`, each moved by `strength` towards the mean of its neighbours'."""
    ids = np.asarray(vertices, dtype=np.int64)
    degree = np.diff(neighbours.start)[ids]
    rows = np.repeat(np.arange(len(ids)), degree)
    total = np.bincount(rows, values[neighbours.of(ids)], minlength=len(ids))
    mean = np.where(degree > 0, total / np.maximum(degree, 1), values[ids])
    return (1.0 - strength) * values[ids] + strength * mean
