# SPDX-License-Identifier: BSD-3-Clause
"""A sheet: a patch of tissue with an even border, slightly domed.

The plain patch of 45 vertices and 66 triangles is the smallest scene of the paper.
"""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.relax import compute_angles
from scipy.spatial import Delaunay

ROUNDS = 150
"""Lloyd rounds; points on a plane are cheap."""

STEP = 0.8
"""Of the way to the middle of the neighbours."""

NUDGE = 0.05
"""Of the spacing, in the first try; more in each that follows."""

TRIES = 8
"""Beginnings; Lloyd's rounds end in the next best place, not in the best."""

GOOD_ANGLE = np.radians(33.0)
"""[rad] With this the first try will do."""


def sheet(
    vertices: int = 45,
    width: float = 0.072,
    depth: float = 0.060,
    dome: float = 0.0015,
    seed: int = 0,
) -> tuple[np.ndarray, np.ndarray]:
    """An open sheet of exactly `vertices` vertices in the plane of x and y, outside up.

    Of b border vertices, it has 2 vertices - 2 - b triangles.

    Args:
        vertices: At least 16.
        width: [m] Along x.
        depth: [m] Along y.
        dome: [m] By which the middle is higher than the border.
        seed: Places the inner points it starts from.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from above.
    """
    if vertices < 16:
        raise ValueError(f"sheet: vertices must be at least 16, got {vertices}")
    if not (0.0 < width < np.inf and 0.0 < depth < np.inf and 0.0 <= dome < np.inf):
        raise ValueError(f"sheet: expected positive sizes, got {width}, {depth}, {dome}")
    border = place_border(vertices, width, depth)
    rest = vertices - len(border)
    random = np.random.default_rng(seed)
    tries = (
        relax_inner(border, vertices, width, depth, NUDGE * (1 + k) * random.normal(size=(rest, 2)))
        for k in range(TRIES)
    )
    best = -1.0
    for tried, between in tries:
        smallest = compute_angles(np.column_stack([tried, np.zeros(vertices)]), between).min()
        if smallest > best:
            best, points, triangles = smallest, tried, between
        if best >= GOOD_ANGLE:
            break
    height = np.sin(np.pi * points[:, 0] / width) * np.sin(np.pi * points[:, 1] / depth)
    middle = np.array([0.5 * width, 0.5 * depth])
    return np.column_stack([points - middle, dome * height]), triangles


def relax_inner(
    border: np.ndarray, vertices: int, width: float, depth: float, nudges: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """All points, the border's first, after Lloyd's rounds; and the triangles between them."""
    inner = place_inner(width, depth, nudges)
    for _ in range(ROUNDS):
        points = np.concatenate([border, inner])
        displacement = find_displacement(points, triangulate(points, width * depth))
        inner = inner + STEP * displacement[len(border) :]
    points = np.concatenate([border, inner])
    return points, triangulate(points, width * depth)


def place_border(vertices: int, width: float, depth: float) -> np.ndarray:
    """Even points around the rectangle, about as far apart as the inner ones will be."""
    edge = np.sqrt(2.0 * width * depth / (np.sqrt(3.0) * vertices)) * 1.08
    nx, ny = max(2, round(width / edge)), max(2, round(depth / edge))
    x, y = width * np.arange(nx) / nx, depth * np.arange(ny) / ny
    sides = [
        np.column_stack([x, np.zeros(nx)]),
        np.column_stack([np.full(ny, width), y]),
        np.column_stack([width - x, np.full(nx, depth)]),
        np.column_stack([np.zeros(ny), depth - y]),
    ]
    return np.concatenate(sides)


def place_inner(width: float, depth: float, nudges: np.ndarray) -> np.ndarray:
    """Rows of a hexagonal grid, nudged so that no four points are on a circle.

    Args:
        width: [m]
        depth: [m]
        nudges: One per point, in parts of the spacing.
    """
    count = len(nudges)
    rows = max(1, round(np.sqrt(count * depth / width * 2.0 / np.sqrt(3.0))))
    per_row = [count // rows + (i < count % rows) for i in range(rows)]
    points = []
    for row, n in enumerate(per_row):
        shift = 0.25 if row % 2 else -0.25
        x = (np.arange(n) + 0.5 + shift) / n
        points.append(np.column_stack([x * width, np.full(n, (row + 0.5) / rows * depth)]))
    spacing = np.sqrt(width * depth / count)
    nudged = np.concatenate(points) + spacing * nudges
    margin = 0.02
    return np.clip(nudged, [margin * width, margin * depth],
                   [(1 - margin) * width, (1 - margin) * depth])  # fmt: skip


def triangulate(points: np.ndarray, area: float) -> np.ndarray:
    """Delaunay, counter-clockwise, without the flat triangles along the straight border."""
    triangles = Delaunay(points).simplices.astype(np.int64)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    twice = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    keep = np.abs(twice) > 1e-9 * area
    triangles, twice = triangles[keep], twice[keep]
    triangles[twice < 0.0] = triangles[twice < 0.0][:, ::-1]
    return triangles[np.lexsort(triangles.T[::-1])]


def find_displacement(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """From every point to the mean of its triangles' centres by area."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    area = 0.5 * np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    middle, weight = np.zeros_like(points), np.zeros(len(points))
    for corner in triangles.T:
        np.add.at(middle, corner, (a + b + c) / 3.0 * area[:, None])
        np.add.at(weight, corner, area)
    return middle / weight[:, None] - points
