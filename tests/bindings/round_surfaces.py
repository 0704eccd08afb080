# SPDX-License-Identifier: BSD-3-Clause
"""Round surfaces made in code, for looking at."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

RADIUS = 0.05
"""[m]"""


def ball(count: int = 400, radius: float = RADIUS) -> tuple[np.ndarray, np.ndarray]:
    """A closed sphere of evenly spread points, counter-clockwise from outside."""
    k = np.arange(count) + 0.5
    z = 1.0 - 2.0 * k / count
    angle = np.pi * (3.0 - np.sqrt(5.0)) * k
    flat = np.sqrt(1.0 - z * z)
    x = np.stack([flat * np.cos(angle), flat * np.sin(angle), z], axis=1)
    triangles = ConvexHull(x).simplices.copy()
    corners = x[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", normal, corners.mean(axis=1)) < 0.0
    triangles[inward] = triangles[inward][:, [0, 2, 1]]
    return radius * x, triangles.astype(np.int32)


def bowl(count: int = 800, radius: float = RADIUS) -> tuple[np.ndarray, np.ndarray]:
    """The lower half of a ball, open at the top."""
    x, triangles = ball(count, radius)
    return x, triangles[x[triangles][:, :, 2].max(axis=1) < 0.0]
