# SPDX-License-Identifier: BSD-3-Clause
"""A closed organ: an ellipsoid bowed and hollowed into a spleen.

Shape after the real organ: convex where it lies under the diaphragm, hollow on the visceral side,
bowed along the tenth rib, with a notched front border. Sizes from anatomy, 12 x 7 x 4.5 cm.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from palpate_meshes.generate.relax import relax
from scipy.spatial import ConvexHull

ROUNDS = 60
"""Angles have settled after some forty."""


def ellipsoid(
    vertices: int = 600,
    radii: Sequence[float] = (0.024, 0.036, 0.060),
    bow: float = 1.0,
    hollow: float = 1.0,
    notches: float = 1.0,
    seed: int = 0,
) -> tuple[np.ndarray, np.ndarray]:
    """A closed surface of exactly `vertices` vertices and 2 vertices - 4 triangles.

    Args:
        vertices: At least 50.
        radii: [m] Half the thickness (x), depth (y) and height (z).
        bow: How far it bends along its height; 0 for not at all.
        hollow: How deep the visceral side (-x) is; 0 for a plain ellipsoid.
        notches: How deep the two notches of the front border (-y) are.
        seed: Turns the points it starts from: another mesh of the same organ.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from outside.
    """
    if vertices < 50:
        raise ValueError(f"ellipsoid: vertices must be at least 50, got {vertices}")
    if not (len(radii) == 3 and all(0.0 < r < np.inf for r in radii)):
        raise ValueError(f"ellipsoid: radii must be three positive lengths, got {radii}")
    points = spread_over_sphere(vertices, seed)
    triangles = hull_triangles(points)
    shape = np.array(radii, float)

    def organ(u: np.ndarray) -> np.ndarray:
        return deform(u, shape, bow, hollow, notches)

    return relax(points, triangles, organ, sphere_tangents, to_sphere, ROUNDS)


def deform(
    u: np.ndarray, radii: np.ndarray, bow: float, hollow: float, notches: float
) -> np.ndarray:
    """From points u of the unit sphere to the organ [m]; bends, never folds."""
    x, y, z = u.T
    # notches: the front border draws back at two heights, and sinks smoothly into the sides
    front = 0.5 * (1.0 - np.tanh(3.0 * (y + 0.55)))
    dents = 0.16 * np.exp(-(((z - 0.42) / 0.13) ** 2)) + 0.12 * np.exp(-(((z - 0.08) / 0.11) ** 2))
    y = y * (1.0 - notches * front * dents)
    # hollow: the visceral half is flattened, and sinks in most in its middle
    visceral = 0.5 * (1.0 - np.tanh(2.5 * x))
    sunk = np.exp(-((y / 0.62) ** 2) - ((z / 0.68) ** 2))
    x = x + hollow * visceral * (-0.35 * np.minimum(x, 0.0) + 0.62 * sunk)
    # the upper pole is broader than the lower
    broad = 1.0 + 0.10 * np.tanh(1.5 * z)
    placed = np.stack([x, y * broad, z], axis=1) * radii
    height = placed[:, 2] / radii[2]
    placed[:, 0] -= bow * 0.42 * radii[0] * height**2
    placed[:, 1] -= bow * 0.16 * radii[1] * height**2
    return placed


def spread_over_sphere(count: int, seed: int) -> np.ndarray:
    """Points on a Fibonacci spiral [Gonzalez10], turned at random by the seed."""
    k = np.arange(count) + 0.5
    height = 1.0 - 2.0 * k / count
    angle = np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    points = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=1)
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return points @ turn.T


def hull_triangles(points: np.ndarray) -> np.ndarray:
    """The Delaunay triangulation of points on a sphere is their hull."""
    triangles = ConvexHull(points).simplices.astype(np.int64)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    return triangles[np.lexsort(triangles.T[::-1])]


def to_sphere(p: np.ndarray) -> np.ndarray:
    return p / np.linalg.norm(p, axis=1)[:, None]


def sphere_tangents(u: np.ndarray) -> np.ndarray:
    """Two unit tangents per point, shape (n, 2, 3)."""
    away = np.eye(3)[np.abs(u).argmin(axis=1)]
    first = to_sphere(np.cross(u, away))
    return np.stack([first, np.cross(u, first)], axis=1)
