# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over a slice: round the chosen voxels, and where a surface goes through it."""

from __future__ import annotations

import numpy as np

from palpate_editor.scan import Scan

OFF = 1e-6
"""[voxel] By which a cut avoids vertices that lie on a slice."""


def outline(mask: np.ndarray) -> np.ndarray:
    """(2 n, 2) ends of n lines along the edges of voxels; of voxel i its middle is at i."""
    padded = np.pad(mask, 1)
    i, j = np.nonzero(padded[1:, 1:-1] != padded[:-1, 1:-1])
    across = np.stack([i - 0.5, j - 0.5, i - 0.5, j + 0.5], axis=1)
    i, j = np.nonzero(padded[1:-1, 1:] != padded[1:-1, :-1])
    along = np.stack([i - 0.5, j - 0.5, i + 0.5, j - 0.5], axis=1)
    return np.concatenate((across, along)).reshape(-1, 2)


def find_voxel_places(scan: Scan, vertices: np.ndarray) -> np.ndarray:
    """(n, 3) Slice, row and column, of points [m] in the patient."""
    return np.linalg.solve(scan.steps, (vertices - scan.origin).T).T[:, ::-1]


def cut_surface(
    places: np.ndarray, triangles: np.ndarray, axis: int, index: int, kept: tuple[int, int]
) -> np.ndarray:
    """(2 n, 2) ends of the lines in which triangles meet a slice.

    Args:
        places: (v, 3) vertices in slice, row and column.
        triangles: (t, 3)
        axis: Of the slices: 0, 1 or 2.
        index: Of the slice.
        kept: The axes of the two columns of the result.
    """
    height = places[:, axis] - (index + OFF)
    above = height[triangles] > 0.0
    met = triangles[above.any(axis=1) & ~above.all(axis=1)]
    if not len(met):
        return np.empty((0, 2))
    above = height[met] > 0.0
    # the corner that is alone on its side first
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), above.argmin(axis=1))
    rows = np.arange(len(met))
    ends = []
    for turn in (1, 2):
        one, other = met[rows, alone], met[rows, (alone + turn) % 3]
        share = height[one] / (height[one] - height[other])
        ends.append(places[one] + share[:, None] * (places[other] - places[one]))
    return np.stack(ends, axis=1).reshape(-1, 3)[:, kept]
