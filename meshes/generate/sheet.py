# SPDX-License-Identifier: BSD-3-Clause
"""A flat piece of tissue with one border loop, its vertices in no grid."""

from __future__ import annotations

import numpy as np
from scipy.spatial import Delaunay

from palpate_meshes.generate.relax import relax

ROUNDS = 100
LEAST_VERTICES = 12


def count_border(vertices: int, size: tuple[float, float]) -> tuple[int, int]:
    """Segments along x and y that make border and inner edges about as long as one another."""
    edge = np.sqrt(2.0 * size[0] * size[1] / (np.sqrt(3.0) * vertices))
    return max(2, round(size[0] / edge)), max(2, round(size[1] / edge))


def spread_inside(count: int, size: tuple[float, float], seed: int) -> np.ndarray:
    """An R2 sequence in the unit square, drawn in from the border: even at every count."""
    plastic = 1.32471795724474602596
    start = np.random.default_rng(seed).uniform(0.0, 1.0, 2)
    unit = (start + np.outer(np.arange(count), [1.0 / plastic, 1.0 / plastic**2])) % 1.0
    margin = 0.5 / np.sqrt(count + 1.0)
    return (margin + (1.0 - 2.0 * margin) * unit - 0.5) * np.asarray(size)


def sheet(
    vertices: int = 200, seed: int = 0, *, size: tuple[float, float] = (0.072, 0.060)
) -> tuple[np.ndarray, np.ndarray]:
    """A rectangle in the plane z = 0, its outside up, with exactly `vertices` vertices.

    Args:
        vertices: At least 12.
        seed: Of where the inner vertices start from.
        size: [m] along x and y.

    Returns:
        Vertices [m] (n, 3) and triangles (2 n - 2 - b, 3) with b border vertices.
    """
    if vertices < LEAST_VERTICES:
        raise ValueError(f"vertices: got {vertices}, expected at least {LEAST_VERTICES}")
    nx, ny = count_border(vertices, size)
    half = 0.5 * np.asarray(size)
    x, y = np.linspace(-half[0], half[0], nx + 1), np.linspace(-half[1], half[1], ny + 1)
    border = np.concatenate(
        [
            np.stack([x[:-1], np.full(nx, -half[1])], axis=1),
            np.stack([np.full(ny, half[0]), y[:-1]], axis=1),
            np.stack([x[:0:-1], np.full(nx, half[1])], axis=1),
            np.stack([np.full(ny, -half[0]), y[:0:-1]], axis=1),
        ]
    )
    flat = np.concatenate([border, spread_inside(vertices - len(border), size, seed)])
    triangles = fill_rectangle(flat, len(border))
    points = np.column_stack([flat, np.zeros(len(flat))])

    def tangents(p: np.ndarray) -> np.ndarray:
        return np.broadcast_to(np.eye(3)[:2], (len(p), 2, 3)).copy()

    return relax(points, triangles, lambda p: p.copy(), tangents, lambda p: p, ROUNDS)


def fill_rectangle(flat: np.ndarray, border: int) -> np.ndarray:
    """Delaunay triangles, counter-clockwise from above; slivers along a straight side left out."""
    triangles = Delaunay(flat).simplices.astype(int)
    a, b, c = (flat[triangles[:, i]] for i in range(3))
    twice_area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    scale = np.ptp(flat, axis=0).prod() / len(flat)
    keep = np.abs(twice_area) > 1e-9 * scale
    triangles, turned = triangles[keep], twice_area[keep] < 0.0
    triangles[turned] = triangles[turned][:, [0, 2, 1]]
    if len(triangles) != 2 * len(flat) - 2 - border:
        raise ValueError(f"vertices: {len(flat)} do not fill the rectangle, choose another count")
    return triangles[np.lexsort(np.sort(triangles, axis=1).T)]
