# SPDX-License-Identifier: BSD-3-Clause
"""How dark a dent is: a surface that is pressed in sees less of the sky than it did at rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

AROUND = 0.02
"""[m] cells over which the surface around a dent is averaged, a few times as wide as a fingertip's
dent, so that an organ that moves or swells as a whole stays as light as it was."""
HALF_DARK = 1.5e-3
"""[m] depth against the surface around it at which half of the sky is gone. The true share would be
less; so a dent of 3 mm is seen from where a trainee sees the whole organ."""


class Dents:
    """The depth of dents of one surface against how it was at rest."""

    def __init__(self, rest: Array, normals: Array):
        """`rest` [m] (n, 3) and unit normals (n, 3) there."""
        self._rest, self._normals = rest.copy(), normals.copy()
        self._cells, self._shares = share_among_cells(self._rest)
        self._weights = np.maximum(np.bincount(self._cells.ravel(), self._shares.ravel()), 1e-12)

    def measure(self, vertices: Array) -> Array:
        """[m] (n,) of each vertex below the surface around it; 0 where it stands out."""
        moved = vertices - self._rest
        against = np.empty_like(moved)
        for axis in range(3):
            sums = np.bincount(self._cells.ravel(), (self._shares * moved[:, axis]).ravel())
            around = (self._shares * (sums / self._weights)[self._cells]).sum(axis=0)
            against[:, axis] = around - moved[:, axis]
        return np.maximum(np.einsum("ij,ij->i", against, self._normals), 0.0)

    def shade(self, vertices: Array) -> Array:
        """[-] (n,) what is left of the sky: 1 outside dents."""
        return 1.0 / (1.0 + (self.measure(vertices) / HALF_DARK) ** 2)


def share_among_cells(points: Array) -> tuple[NDArray[np.intp], Array]:
    """The corners (8, n) of the cells that points [m] (n, 3) lie in, numbered from 0, and the
    shares (8, n) of each point in them, linear between them."""
    scaled = (points - points.min(axis=0)) / AROUND
    base = np.floor(scaled).astype(np.intp)
    part = scaled - base
    counts = base.max(axis=0) + 2
    corners, shares = [], []
    for corner in np.ndindex(2, 2, 2):
        at = base + corner
        corners.append((at[:, 0] * counts[1] + at[:, 1]) * counts[2] + at[:, 2])
        shares.append(np.where(corner, part, 1.0 - part).prod(axis=1))
    _, cells = np.unique(np.concatenate(corners), return_inverse=True)
    return cells.reshape(8, len(points)), np.array(shares)
