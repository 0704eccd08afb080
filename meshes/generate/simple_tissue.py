# SPDX-License-Identifier: BSD-3-Clause
"""The simple tissue of the first experiments: a small patch with an even border."""

from __future__ import annotations

import numpy as np
from palpate_meshes.generate.settle import DECIMALS
from palpate_meshes.generate.sheet import sheet

VERTICES = 45
WIDTH, DEPTH, DOME = 0.072, 0.060, 0.0015
"""[m] Of the usual one."""


def simple_tissue(
    vertices: int = VERTICES, size: float = 1.0, seed: int = 0
) -> tuple[np.ndarray, np.ndarray]:
    """An open sheet of exactly `vertices` vertices, outside up; 45 have a border of 22.

    Args:
        vertices: At least 16.
        size: [-] Times as large as the usual one, which is 72 by 60 mm.
        seed: Another mesh.

    Returns:
        Vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise from above.
    """
    points, triangles = sheet(vertices, WIDTH, DEPTH, DOME, seed)
    return size * np.round(points, DECIMALS), triangles


def simple_tissue_regions(p: np.ndarray, n: np.ndarray) -> dict[str, np.ndarray]:
    """Masks of the vertices at p [mm] with normals n."""
    x, y = p[:, 0], p[:, 1]
    border = (np.abs(x) > 500.0 * WIDTH - 0.01) | (np.abs(y) > 500.0 * DEPTH - 0.01)
    return {"middle": x * x + y * y < 15.0 * 15.0, "border": border, "attachment": border}
