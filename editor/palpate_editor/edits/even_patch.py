# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles of a patch over a hole as long as those around it: split, collapsed, flipped and moved
along the patch, as isotropic remeshing does it, with the rim left alone."""

from __future__ import annotations

from math import atan2, dist, pi, sqrt

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Surface

ROUNDS = 6
LONGEST, SHORTEST = 1.45, 0.65
"""[-] of the length that is wanted: edges beyond are split or collapsed."""
ADMITTED = (0.5, 2.0)
"""[-] of it: edges that are good enough."""
TURN = 0.3
"""Cosine of the angle by which a triangle may turn."""

Edge = tuple[int, int]
Triangle = tuple[int, int, int]
Point = tuple[float, float, float]
"""Plain numbers: arrays of three take ten times as long."""


def even_patches(closed: Surface, vertices: int, triangles: int) -> Surface:
    """A surface whose first vertices and triangles, as many as are said, had holes, with the rest
    made even; the very same where that would not be better, or would cross something."""
    patch = Patch(closed, vertices, triangles)
    before = patch.measure()
    for _ in range(ROUNDS):
        patch.split_long()
        patch.collapse_short()
        patch.flip()
        patch.relax()
    if patch.measure() <= before:
        return closed
    evened = patch.build(closed, vertices, triangles)
    return closed if crosses_more(evened, closed) else evened


def crosses_more(evened: Surface, closed: Surface) -> bool:
    faces = [
        authoring.find_self_intersecting_faces(palpate.SurfaceMesh(s.vertices, s.triangles))
        for s in (evened, closed)
    ]
    return faces[0] is None or (faces[1] is not None and len(faces[0]) > len(faces[1]))


def subtract(a: Point, b: Point) -> Point:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a: Point, b: Point) -> Point:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def dot(a: Point, b: Point) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def mean(points: list[Point]) -> Point:
    x, y, z = (sum(each) / len(points) for each in zip(*points, strict=True))
    return x, y, z


def find_normal(a: Point, b: Point, c: Point) -> Point:
    """Of unit length; 0 of a flat triangle."""
    n = cross(subtract(b, a), subtract(c, a))
    size = sqrt(dot(n, n))
    return (n[0] / size, n[1] / size, n[2] / size) if size > 0.0 else (0.0, 0.0, 0.0)


def edge_of(a: int, b: int) -> Edge:
    return (a, b) if a < b else (b, a)


class Patch:
    """The triangles over holes, with what hangs together there."""

    def __init__(self, closed: Surface, vertices: int, triangles: int):
        used = np.unique(closed.triangles[triangles:])
        self.x: dict[int, Point] = {
            v: tuple(p) for v, p in zip(used.tolist(), closed.vertices[used].tolist(), strict=True)
        }
        self.first = vertices
        self.next = len(closed.vertices)
        self.triangles: dict[int, Triangle] = {}
        self.around: dict[int, set[int]] = {v: set() for v in self.x}
        self.made = 0
        for a, b, c in closed.triangles[triangles:].tolist():
            self.add((a, b, c))
        outer = closed.triangles[:triangles]
        near = outer[np.isin(outer, list(self.x)).sum(axis=1) >= 2].tolist()
        sides = [(t[i], t[(i + 1) % 3]) for t in near for i in range(3)]
        self.outer = {edge_of(a, b) for a, b in sides}
        """Edges that are there already."""
        rows = closed.triangles[triangles:]
        used, numbers = np.unique(rows, return_inverse=True)
        self.shape = closed.vertices[used], numbers.reshape(-1, 3).astype(np.int32)
        self.tree = palpate.AabbTree(*self.shape)
        self.measure_rim()

    def measure_rim(self) -> None:
        """[m] How long edges are at each vertex of the rims."""
        lengths: dict[int, list[float]] = {}
        for (a, b), faces in self.list_edges().items():
            if len(faces) == 1:
                for v in (a, b):
                    lengths.setdefault(v, []).append(self.length(a, b))
        self.rim = np.array([self.x[v] for v in lengths]).reshape(-1, 3)
        self.rim_lengths = np.array([np.mean(each) for each in lengths.values()])
        self.size = {v: self.find_size(v) for v in self.x}

    # ------------------------------------------------------------ what there is

    def add(self, triangle: Triangle) -> None:
        self.triangles[self.made] = triangle
        for v in triangle:
            self.around[v].add(self.made)
        self.made += 1

    def drop(self, face: int) -> None:
        for v in self.triangles.pop(face):
            self.around[v].discard(face)

    def list_edges(self) -> dict[Edge, list[int]]:
        edges: dict[Edge, list[int]] = {}
        for face, (a, b, c) in self.triangles.items():
            for edge in (edge_of(a, b), edge_of(b, c), edge_of(c, a)):
                edges.setdefault(edge, []).append(face)
        return edges

    def list_inner(self) -> list[tuple[float, Edge]]:
        """Edges between two triangles and how long they are beside what is wanted."""
        inner = [edge for edge, faces in self.list_edges().items() if len(faces) == 2]
        return [(self.length(*edge) / self.wanted(edge), edge) for edge in inner]

    def length(self, a: int, b: int) -> float:
        return dist(self.x[a], self.x[b])

    def wanted(self, edge: Edge) -> float:
        """[m]"""
        return 0.5 * (self.size[edge[0]] + self.size[edge[1]])

    def find_size(self, v: int) -> float:
        """[m] How long edges are to be at a vertex: as on the rims, the nearer ones first."""
        square = ((self.rim - np.array(self.x[v])) ** 2).sum(axis=1)
        weights = 1.0 / np.maximum(square, 1e-12 * square.max())
        return float((weights * self.rim_lengths).sum() / weights.sum())

    def neighbours(self, v: int) -> set[int]:
        return {w for face in self.around[v] for w in self.triangles[face]} - {v}

    def measure(self) -> float:
        """[-] of the inner edges that are good enough; 1 where there is none."""
        ratios = np.array([ratio for ratio, _ in self.list_inner()])
        low, high = ADMITTED
        return float(((ratios >= low) & (ratios <= high)).mean()) if len(ratios) else 1.0

    def faces_of(self, edge: Edge) -> list[int]:
        return sorted(self.around[edge[0]] & self.around[edge[1]])

    # ------------------------------------------------------------ what is changed

    def split_long(self) -> None:
        for ratio, (a, b) in sorted(self.list_inner(), reverse=True):
            faces = self.faces_of((a, b)) if a in self.around and b in self.around else []
            if ratio <= LONGEST or len(faces) != 2:
                continue
            m, self.next = self.next, self.next + 1
            self.x[m], self.around[m] = mean([self.x[a], self.x[b]]), set()
            self.size[m] = self.wanted((a, b))
            for face in faces:
                triangle = self.triangles[face]
                self.drop(face)
                self.add(tuple(m if v == a else v for v in triangle))
                self.add(tuple(m if v == b else v for v in triangle))

    def collapse_short(self) -> None:
        for ratio, (a, b) in sorted(self.list_inner()):
            if ratio >= SHORTEST:
                break
            if a not in self.around or b not in self.around or len(self.faces_of((a, b))) != 2:
                continue
            # what goes is the later vertex: those of the rims come first
            if b >= self.first:
                self.collapse(b, a)

    def collapse(self, gone: int, kept: int) -> None:
        ring, other = self.neighbours(gone), self.neighbours(kept)
        if len(ring & other) != 2:
            return
        if any(edge_of(kept, v) in self.outer for v in ring - other - {kept}):
            return
        place = self.x[kept]
        if kept >= self.first:
            place = mean([self.x[gone], self.x[kept]])
        shared = set(self.faces_of(edge_of(gone, kept)))
        moved = (self.around[gone] | self.around[kept]) - shared
        if not all(self.may_move(face, {gone: place, kept: place}) for face in moved):
            return
        changed = [self.triangles[face] for face in sorted(self.around[gone] - shared)]
        for face in sorted(self.around[gone]):
            self.drop(face)
        for triangle in changed:
            self.add(tuple(kept if v == gone else v for v in triangle))
        self.x[kept] = place
        del self.x[gone], self.around[gone]

    def may_move(self, face: int, places: dict[int, Point]) -> bool:
        before = find_normal(*(self.x[v] for v in self.triangles[face]))
        after = find_normal(*(places.get(v, self.x[v]) for v in self.triangles[face]))
        return dot(before, after) > TURN or not any(before)

    def flip(self) -> None:
        """Where opposite angles are more than a half turn together [Delaunay34]."""
        for edge in sorted(edge for edge, faces in self.list_edges().items() if len(faces) == 2):
            faces = self.faces_of(edge)
            if len(faces) != 2:
                continue
            a, b = edge
            c, d = (next(v for v in self.triangles[f] if v not in edge) for f in faces)
            if c == d or edge_of(c, d) in self.outer or self.around[c] & self.around[d]:
                continue
            if self.angle(c, a, b) + self.angle(d, a, b) <= pi + 1e-9:
                continue
            first = self.triangles[faces[0]]
            if first[(first.index(a) + 1) % 3] != b:
                a, b = b, a
            made = [(c, a, d), (c, d, b)]
            old = [find_normal(*(self.x[v] for v in self.triangles[f])) for f in faces]
            new = [find_normal(*(self.x[v] for v in triangle)) for triangle in made]
            if min(dot(n, o) for n in new for o in old) <= TURN:
                continue
            for face in faces:
                self.drop(face)
            for triangle in made:
                self.add(triangle)

    def angle(self, at: int, a: int, b: int) -> float:
        p, q = subtract(self.x[a], self.x[at]), subtract(self.x[b], self.x[at])
        n = cross(p, q)
        return atan2(sqrt(dot(n, n)), dot(p, q))

    def relax(self) -> None:
        """Each vertex to the middle of its neighbours, and back onto the patch as it was."""
        for v in sorted(v for v in self.x if v >= self.first):
            middle = mean([self.x[w] for w in sorted(self.neighbours(v))])
            near = palpate.find_closest_point(self.tree, self.shape[0], np.array(middle))
            corners = self.shape[0][self.shape[1][near.triangle]]
            x, y, z = (np.asarray(near.weights) @ corners).tolist()
            place = (x, y, z)
            if all(self.may_move(face, {v: place}) for face in self.around[v]):
                self.x[v] = place

    # ------------------------------------------------------------ what came of it

    def build(self, closed: Surface, vertices: int, triangles: int) -> Surface:
        inner = sorted(v for v in self.x if v >= vertices)
        number = {v: v for v in self.x if v < vertices}
        number |= {v: vertices + i for i, v in enumerate(inner)}
        points = [closed.vertices[:vertices], np.array([self.x[v] for v in inner]).reshape(-1, 3)]
        rows = [[number[v] for v in self.triangles[face]] for face in sorted(self.triangles)]
        faces = np.concatenate([closed.triangles[:triangles], np.array(rows, np.int32)])
        return Surface(np.concatenate(points), faces)
