# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedra that become small towards a place, on the surface they stand for."""

from __future__ import annotations

import logging
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from skfem import MeshTet

from palpate_editor.truth.tetrahedra import (
    Floats,
    Ints,
    compute_volumes,
    find_surface,
    turn_right,
)

# it tells of every array that it copies
logging.getLogger("skfem").setLevel(logging.ERROR)

NEAREST = 24
"""Triangles, by their middles, among which the closest point is looked for."""
ROUNDS = 40
LEAST_VOLUME = 0.2
"""Of a tetrahedron's volume, that must be left when its corners go to the surface."""


@dataclass(frozen=True)
class Grading:
    """Edges of `size` [m] up to `reach` [m] from places, growing by `slope` of what is beyond."""

    points: Floats
    """[m] (s, 3)"""
    size: float
    reach: float
    slope: float

    def edge(self, corners: Floats) -> Floats:
        """[m] (t,) that tetrahedra (t, 4, 3) may have, by their closest corner."""
        apart, _ = cKDTree(self.points).query(corners)
        return self.size + self.slope * np.maximum(apart.min(axis=1) - self.reach, 0.0)


@dataclass(frozen=True)
class Skin:
    """The surface that a body stands for: vertices [m] (n, 3), triangles (t, 3)."""

    x: Floats
    triangles: Ints

    def project(self, points: Floats) -> tuple[Floats, Ints]:
        """The closest points of the surface and the triangles they lie on."""
        corners = self.x[self.triangles]
        count = min(NEAREST, len(corners))
        _, near = cKDTree(corners.mean(axis=1)).query(points, count)
        near = np.reshape(near, (len(points), count))
        found = find_closest(np.repeat(points[:, None], count, 1), corners[near])
        best = ((found - points[:, None]) ** 2).sum(axis=2).argmin(axis=1)
        row = np.arange(len(points))
        return found[row, best], near[row, best]


def find_closest(p: Floats, triangle: Floats) -> Floats:
    """The closest points of triangles (..., 3, 3) to points (..., 3): inside, or on an edge."""
    a, b, c = (triangle[..., k, :] for k in range(3))
    normal = np.cross(b - a, c - a)
    square = (normal**2).sum(axis=-1, keepdims=True)
    foot = p - ((p - a) * normal).sum(axis=-1, keepdims=True) / square * normal
    inside = np.ones(p.shape[:-1], dtype=bool)
    best, least = foot, np.full(p.shape[:-1], np.inf)
    for q, r in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(r - q, foot - q) * normal).sum(axis=-1) >= 0.0
        part = ((p - q) * (r - q)).sum(axis=-1) / ((r - q) ** 2).sum(axis=-1)
        on_edge = q + np.clip(part, 0.0, 1.0)[..., None] * (r - q)
        off = ((p - on_edge) ** 2).sum(axis=-1)
        closer = off < least
        best, least = np.where(closer[..., None], on_edge, best), np.where(closer, off, least)
    return np.where(inside[..., None], foot, best)


def refine(x: Floats, t: Ints, grading: Grading, skin: Skin | None) -> tuple[Floats, Ints]:
    """Halves edges until none is longer than the grading says; what is new on the surface goes to
    the skin. Longest edges first, so that shapes stay good."""
    for _ in range(ROUNDS):
        corners = x[t]
        longest = find_longest(corners)
        marked = np.flatnonzero(longest > grading.edge(corners))
        if not len(marked):
            return x, t
        mesh = MeshTet(np.ascontiguousarray(x.T), np.ascontiguousarray(t.T)).refined(marked)
        before = len(x)
        x, t = mesh.p.T.copy(), mesh.t.T.astype(np.int64)
        t = turn_right(x, t)
        if skin is not None:
            x = snap(x, t, before, skin)
    raise ValueError(f"edges are still too long after {ROUNDS} rounds")


def find_longest(corners: Floats) -> Floats:
    pairs = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
    return np.max([np.linalg.norm(corners[:, i] - corners[:, j], axis=1) for i, j in pairs], axis=0)


def snap(x: Floats, t: Ints, first: int, skin: Skin) -> Floats:
    """Vertices from `first` that are on the surface, moved to the skin as far as shapes allow."""
    outside = np.unique(find_surface(t))
    moved = outside[outside >= first]
    if not len(moved):
        return x
    shift = np.zeros_like(x)
    shift[moved] = skin.project(x[moved])[0] - x[moved]
    rest = compute_volumes(x, t)
    for _ in range(8):
        flat = compute_volumes(x + shift, t) < LEAST_VOLUME * rest
        if not flat.any():
            return x + shift
        shift[np.unique(t[flat])] *= 0.5
    shift[np.unique(t[compute_volumes(x + shift, t) < LEAST_VOLUME * rest])] = 0.0
    return x + shift
