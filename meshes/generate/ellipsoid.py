# SPDX-License-Identifier: BSD-3-Clause
"""A closed organ like a spleen: an ellipsoid, bowed, hollow on its visceral side."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from palpate_meshes.generate.relax import relax

ROUNDS = 30
LEAST_VERTICES = 12
GOLDEN_ANGLE = np.pi * (3.0 - np.sqrt(5.0))


def spread_on_sphere(count: int, seed: int) -> np.ndarray:
    """Evenly spread unit vectors: a Fibonacci lattice, shaken by a tenth of its spacing."""
    z = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    turn = GOLDEN_ANGLE * np.arange(count)
    ring = np.sqrt(1.0 - z * z)
    points = np.stack([ring * np.cos(turn), ring * np.sin(turn), z], axis=1)
    spacing = np.sqrt(4.0 * np.pi / count)
    points += np.random.default_rng(seed).uniform(-0.1, 0.1, points.shape) * spacing
    return points / np.linalg.norm(points, axis=1)[:, None]


def triangulate_sphere(points: np.ndarray) -> np.ndarray:
    """The convex hull's triangles, counter-clockwise from outside."""
    triangles = ConvexHull(points).simplices
    a, b, c = (points[triangles[:, i]] for i in range(3))
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    triangles[inward] = triangles[inward][:, [0, 2, 1]]
    return triangles[np.lexsort(np.sort(triangles, axis=1).T)]


def find_tangents(points: np.ndarray) -> np.ndarray:
    """Two unit tangents per point of the unit sphere, shape (n, 2, 3)."""
    axis = np.where(np.abs(points[:, :1]) < 0.7, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    first = np.cross(points, axis)
    first /= np.linalg.norm(first, axis=1)[:, None]
    return np.stack([first, np.cross(points, first)], axis=1)


def settle_on_sphere(points: np.ndarray) -> np.ndarray:
    return points / np.linalg.norm(points, axis=1)[:, None]


def ellipsoid(
    vertices: int = 600,
    seed: int = 0,
    *,
    radii: tuple[float, float, float] = (0.060, 0.038, 0.026),
    bow: float = 0.012,
    hollow: float = 0.012,
) -> tuple[np.ndarray, np.ndarray]:
    """A closed organ of genus 0 with exactly `vertices` vertices and 2 `vertices` - 4 triangles.

    Args:
        vertices: At least 12.
        seed: Of the points' small disorder.
        radii: [m] along x (the length), y and z.
        bow: [m] how far both ends hang below the middle.
        hollow: [m] how deep the lower (visceral) side is pressed in.

    Returns:
        Vertices [m] (n, 3) and triangles (2 n - 4, 3).
    """
    if vertices < LEAST_VERTICES:
        raise ValueError(f"vertices: got {vertices}, expected at least {LEAST_VERTICES}")

    def organ(p: np.ndarray) -> np.ndarray:
        # p lies on or beside the unit sphere; smooth everywhere, so tangents can be pulled back
        x, y, z = (p * np.asarray(radii)).T
        below = 0.5 * (1.0 - np.tanh(3.0 * p[:, 2]))
        dent = hollow * below * np.exp(-((p[:, 0] / 0.55) ** 2) - ((p[:, 1] / 0.5) ** 2))
        return np.stack([x, y, z - bow * p[:, 0] ** 2 + dent], axis=1)

    points = spread_on_sphere(vertices, seed)
    return relax(points, triangulate_sphere(points), organ, find_tangents, settle_on_sphere, ROUNDS)
