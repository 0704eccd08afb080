# SPDX-License-Identifier: BSD-3-Clause
"""From a field to a mesh of exactly so many well-shaped triangles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from palpate_meshes.generate.collapse import collapse
from palpate_meshes.generate.field import Array, Field, Point
from palpate_meshes.generate.net import build_net, is_manifold
from palpate_meshes.generate.opening import Opening, cut_open, place_rim
from palpate_meshes.generate.relax import (
    STEP,
    compute_normals,
    find_border_vertices,
    find_displacement,
    flip_edges,
    measure,
)
from palpate_meshes.generate.repair import repair_triangles

ROUNDS = 40
"""Angles have settled after some thirty."""
DENSE = 1.9
"""Vertices of the net per vertex wanted, so that collapses have a choice."""
LEAST_DENSE = 5000
"""A coarser net would lose notches and grooves before there is a surface to put them on."""
CELLS_PER_AREA = 1.5
"""A surface runs through this many cells per squared cell, the mean over its directions."""
TRIES = 8
FINER = 0.93
"""[-] From one try to the next."""
PROBE = 1e-2
"""[mm] Half the way over which a field's slope is measured."""
DECIMALS = 8
"""Of vertices in metres: files stay small, and nobody can feel 10 nm."""


@dataclass(frozen=True)
class Shape:
    """A field, where it is, and where it is cut open."""

    field: Field
    low: Point
    """[mm] A corner of a box that holds the organ."""
    high: Point
    """[mm]"""
    least: int = 50
    """Vertices with which its shape can still be known."""
    opening: Opening | None = None


def build_mesh(shape: Shape, vertices: int, seed: int) -> tuple[Array, Array]:
    """A mesh of exactly `vertices` vertices.

    The seed moves the grid under the organ: another mesh of the same shape.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.

    Raises ValueError for too few vertices.
    """
    if vertices < shape.least:
        raise ValueError(f"vertices must be at least {shape.least}, got {vertices}")
    points, triangles = build_dense(shape, vertices, seed)
    rim = None
    if shape.opening is not None:
        points, triangles = cut_open(points, triangles, shape.opening)
        rim = shape.opening.vertices
    points, triangles = collapse(points, triangles, vertices, rim)
    if shape.opening is not None:
        points = place_rim(points, triangles, shape.field, shape.opening)
    points, triangles = settle(points, triangles, shape.field)
    return np.round(1e-3 * points, DECIMALS), sort_triangles(triangles)


def build_dense(shape: Shape, vertices: int, seed: int) -> tuple[Array, Array]:
    """The net that is fine enough for `vertices` vertices, and manifold."""
    low, high = np.asarray(shape.low, float), np.asarray(shape.high, float)
    nudge = np.random.default_rng(seed).random(3)
    cell = float((high - low).max()) / 48.0
    points, triangles = build_net(shape.field, low - cell * nudge, high, cell)
    area = 0.5 * float(measure(compute_normals(points, triangles)).sum())
    cell = math.sqrt(CELLS_PER_AREA * area / max(LEAST_DENSE, DENSE * vertices))
    for _ in range(TRIES):
        points, triangles = build_net(shape.field, low - cell * nudge, high, cell)
        if is_manifold(triangles, len(points)):
            return points, triangles
        cell *= FINER
    raise ValueError(f"no grid down to {cell:.2g} mm catches the organ as one sound surface")


def settle(points: Array, triangles: Array, field: Field) -> tuple[Array, Array]:
    """Rounds of flips and moves along the surface; border vertices stay."""
    free = np.ones(len(points), bool)
    free[find_border_vertices(triangles)] = False
    for left in reversed(range(ROUNDS)):
        triangles = flip_all(points, triangles, 3)
        displacement = STEP * find_displacement(points, triangles)[free]
        points = points.copy()
        moved = points[free] + displacement
        for _ in range(1 if left else 4):
            moved = step_to_surface(field, moved, measure(displacement).max())
        points[free] = moved
    triangles = flip_all(points, triangles, 10)

    def put_back(p: Array, longest: float) -> Array:
        return step_to_surface(field, step_to_surface(field, p, longest), longest)

    return repair_triangles(points, triangles, put_back)


def flip_all(points: Array, triangles: Array, passes: int) -> Array:
    for _ in range(passes):
        triangles, flips = flip_edges(points, triangles)
        if flips == 0:
            break
    return triangles


def step_to_surface(field: Field, p: Array, longest: float) -> Array:
    """One step of Newton's method, of at most `longest` [mm] or a hundredth of one."""
    here = field(p)
    slope = np.stack([field(p + PROBE * axis) - here for axis in np.eye(3)], axis=1) / PROBE
    x, y, z = slope.T
    along = -here / np.maximum(x * x + y * y + z * z, 1e-6)
    step = along[:, None] * slope
    length = measure(step)
    return p + step * np.minimum(1.0, max(longest, 0.01) / np.maximum(length, 1e-12))[:, None]


def sort_triangles(triangles: Array) -> Array:
    """Every triangle from its least vertex on, in ascending order."""
    first = triangles.argmin(axis=1)
    corner = (first[:, None] + np.arange(3)) % 3
    turned = np.take_along_axis(triangles, corner, axis=1)
    return turned[np.lexsort(turned.T[::-1])]
