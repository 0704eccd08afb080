# SPDX-License-Identifier: BSD-3-Clause
"""Fewer vertices, exactly as many as asked for: the shortest edges are drawn together first."""

from __future__ import annotations

import heapq
import math

import numpy as np
from palpate_meshes.generate.field import Array
from palpate_meshes.generate.relax import find_border_vertices

LEAST_COSINE = 0.5
"""No triangle is turned by 60 degrees or more."""
MOST_NEIGHBOURS = 9

Corners = tuple[int, int, int]
Place = tuple[float, float, float]


def collapse(
    vertices: Array, triangles: Array, count: int, border: int | None = None
) -> tuple[Array, Array]:
    """A mesh of exactly `count` vertices, `border` of them on its border.

    Args:
        vertices: (n, 3)
        triangles: (t, 3), manifold, with one border loop or none.
        count: At most n.
        border: Vertices to be left on the loop; None leaves the loop as it is.

    Raises ValueError where so few cannot be reached without folding the surface.
    """
    mesh = Shrinking(vertices, triangles)
    if border is not None:
        mesh.shrink_border(border)
    mesh.shrink(count)
    return mesh.as_arrays()


class Shrinking:
    """A mesh whose edges are being drawn together."""

    def __init__(self, vertices: Array, triangles: Array):
        self.at: list[Place] = [tuple(row) for row in vertices.tolist()]
        self.corners: dict[int, Corners] = dict(enumerate(map(tuple, triangles.tolist())))
        self.around: list[set[int]] = [set() for _ in self.at]
        for triangle, corners in self.corners.items():
            for vertex in corners:
                self.around[vertex].add(triangle)
        self.border = set(find_border_vertices(triangles).tolist())
        self.count = len(self.at)
        self.changes = [0] * len(self.at)

    def shrink(self, count: int) -> None:
        """Draws edges together until `count` vertices are left; the border stays."""
        heap = self.sort_edges(range(len(self.at)))
        while self.count > count:
            x, y = self.take(heap)
            if x in self.border and y in self.border:
                continue
            if y in self.border:
                x, y = y, x
            place = self.at[x] if x in self.border else middle(self.at[x], self.at[y])
            if self.may_join(x, y, place):
                self.join(x, y, place, heap)

    def shrink_border(self, count: int) -> None:
        """Draws border edges together until the loop has `count` vertices."""
        heap = self.sort_edges(sorted(self.border))
        while len(self.border) > count:
            x, y = self.take(heap)
            on_loop = x in self.border and y in self.border
            if not on_loop or len(self.around[x] & self.around[y]) != 1:
                continue
            place = middle(self.at[x], self.at[y])
            if self.may_join(x, y, place):
                self.join(x, y, place, heap)

    def take(self, heap: list[tuple[float, int, int, int]]) -> tuple[int, int]:
        """The shortest edge that is still as it was when it was measured."""
        while heap:
            _, x, y, change = heapq.heappop(heap)
            if self.around[x] and self.around[y] and self.changes[x] + self.changes[y] == change:
                return x, y
        raise ValueError(f"{self.count} vertices are the fewest that keep the surface unfolded")

    def neighbours(self, vertex: int) -> set[int]:
        found = {v for t in self.around[vertex] for v in self.corners[t]}
        found.discard(vertex)
        return found

    def measure_edge(self, x: int, y: int) -> tuple[float, int, int, int]:
        a, b = self.at[x], self.at[y]
        dx, dy, dz = a[0] - b[0], a[1] - b[1], a[2] - b[2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        return (length, x, y, self.changes[x] + self.changes[y])

    def sort_edges(self, vertices: range | list[int]) -> list[tuple[float, int, int, int]]:
        pairs = ((x, y) for x in vertices for y in sorted(self.neighbours(x)) if x < y)
        heap = [self.measure_edge(x, y) for x, y in pairs]
        heapq.heapify(heap)
        return heap

    def may_join(self, x: int, y: int, place: Place) -> bool:
        """Whether the surface stays manifold, unfolded, and no fan too large or too small."""
        shared = self.around[x] & self.around[y]
        near_x, near_y = self.neighbours(x), self.neighbours(y)
        common = near_x & near_y
        if len(common) != len(shared) or len(near_x | near_y) - 2 > MOST_NEIGHBOURS:
            return False
        if any(len(self.around[v]) <= (1 if v in self.border else 3) for v in common):
            return False
        for triangle in sorted((self.around[x] | self.around[y]) - shared):
            old = [self.at[v] for v in self.corners[triangle]]
            new = [place if v in (x, y) else self.at[v] for v in self.corners[triangle]]
            if not keeps_facing(normal_of(old), normal_of(new)):
                return False
        return True

    def join(self, x: int, y: int, place: Place, heap: list[tuple[float, int, int, int]]) -> None:
        """Puts y into x, at `place`."""
        for triangle in self.around[x] & self.around[y]:
            for vertex in self.corners.pop(triangle):
                self.around[vertex].discard(triangle)
        for triangle in self.around[y]:
            self.corners[triangle] = tuple(x if v == y else v for v in self.corners[triangle])
            self.around[x].add(triangle)
        self.around[y] = set()
        self.border.discard(y)
        self.at[x] = place
        self.count -= 1
        self.changes[x] += 1
        for vertex in sorted(self.neighbours(x)):
            heapq.heappush(heap, self.measure_edge(min(x, vertex), max(x, vertex)))

    def as_arrays(self) -> tuple[Array, Array]:
        left = [v for v, triangles in enumerate(self.around) if triangles]
        number = np.full(len(self.at), -1)
        number[left] = np.arange(len(left))
        corners = np.array([self.corners[t] for t in sorted(self.corners)])
        return np.array([self.at[v] for v in left]), number[corners]


def middle(a: Place, b: Place) -> Place:
    return (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]))


def normal_of(corners: list[Place]) -> Place:
    a, b, c = corners
    ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    return (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)


def keeps_facing(old: Place, new: Place) -> bool:
    along = old[0] * new[0] + old[1] * new[1] + old[2] * new[2]
    length2 = old[0] * old[0] + old[1] * old[1] + old[2] * old[2]
    length2 *= new[0] * new[0] + new[1] * new[1] + new[2] * new[2]
    return along > LEAST_COSINE * math.sqrt(length2)
