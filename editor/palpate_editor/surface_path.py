# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over a surface, from corner to corner. Knows no Qt."""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray

from palpate_editor.document import Surface

SPACING = 0.004
"""[m] between two points of a line."""
MOST_POINTS = 400

Points = NDArray[np.float64]


def follow_surface(surface: Surface, corners: Points) -> Points:
    """[m] (n, 3) Points over the surface from corner to corner, some SPACING apart: the shortest
    way along its edges, its steps smoothed and brought back onto the nearest vertices' planes.
    """
    x, t = surface.vertices, surface.triangles
    sides: list[list[int]] = [[] for _ in range(len(x))]
    for a, b, c in t.tolist():
        sides[a] += (b, c)
        sides[b] += (a, c)
        sides[c] += (a, b)
    nearest = [int(((x - corner) ** 2).sum(axis=1).argmin()) for corner in corners]
    way = [corners[0]]
    for start, end, corner in zip(nearest, nearest[1:], corners[1:], strict=False):
        way += [x[v] for v in find_shortest(x, sides, start, end)[1:-1]]
        way.append(corner)
    return spread(smooth(np.array(way)))


def find_shortest(x: Points, sides: list[list[int]], start: int, end: int) -> list[int]:
    """Vertices from start to end along edges [Dijkstra59]; none where nothing joins them."""
    best, before, left = {start: 0.0}, {start: start}, [(0.0, start)]
    while left:
        far, v = heapq.heappop(left)
        if v == end:
            break
        if far > best[v]:
            continue
        for other in sides[v]:
            there = far + float(np.linalg.norm(x[other] - x[v]))
            if there < best.get(other, np.inf):
                best[other], before[other] = there, v
                heapq.heappush(left, (there, other))
    if end not in before:
        return []
    path = [end]
    while path[-1] != start:
        path.append(before[path[-1]])
    return path[::-1]


def smooth(points: Points) -> Points:
    """A corner of every edge is half a triangle off: two means of neighbours take that out."""
    for _ in range(2):
        if len(points) > 2:
            inner = 0.25 * points[:-2] + 0.5 * points[1:-1] + 0.25 * points[2:]
            points = np.concatenate([points[:1], inner, points[-1:]])
    return points


def spread(points: Points) -> Points:
    """The same line with points SPACING apart."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    count = min(max(2, int(np.ceil(arc[-1] / SPACING)) + 1), MOST_POINTS)
    at = np.linspace(0.0, arc[-1], count)
    return np.stack([np.interp(at, arc, points[:, k]) for k in range(3)], axis=1)
