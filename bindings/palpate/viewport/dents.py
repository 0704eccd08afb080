# SPDX-License-Identifier: BSD-3-Clause
"""How dark a dent is: a surface that is pressed in sees less of the sky than it did at rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

AROUND = 0.02
"""[m] cells over which the surface around a dent is averaged, a few times as wide as a fingertip's
dent, so that an organ that bends stays as light as it was."""
HALF_DARK = 1e-3
"""[m] depth against the surface around it at which half of the sky is gone. The true share would be
less; so a dent of 3 mm is seen from where a trainee sees the whole organ, be it as large as the
liver and drawn at a third of its width and height."""


class Dents:
    """The depth of dents of one surface against how it was at rest."""

    def __init__(self, rest: Array, normals: Array):
        """`rest` [m] (n, 3) and unit normals (n, 3) there."""
        self._rest, self._normals = rest - rest.mean(axis=0), normals.copy()
        self._cells, self._shares = share_among_cells(self._rest)
        self._weights = np.maximum(np.bincount(self._cells.ravel(), self._shares.ravel()), 1e-12)

    def measure(self, vertices: Array) -> Array:
        """[m] (n,) of each vertex below the surface around it; 0 where it stands out."""
        moved = self._take_back(vertices)
        against = np.empty_like(moved)
        for axis in range(3):
            sums = np.bincount(self._cells.ravel(), (self._shares * moved[:, axis]).ravel())
            around = (self._shares * (sums / self._weights)[self._cells]).sum(axis=0)
            against[:, axis] = around - moved[:, axis]
        return np.maximum(np.einsum("ij,ij->i", against, self._normals), 0.0)

    def shade(self, vertices: Array) -> Array:
        """[-] (n,) what is left of the sky: 1 outside dents."""
        return 1.0 / (1.0 + (self.measure(vertices) / HALF_DARK) ** 2)

    def _take_back(self, vertices: Array) -> Array:
        """[m] (n, 3) how far each vertex has moved, seen from a surface that moves, turns and grows
        with all of them as nearly as it can."""
        now = vertices - vertices.mean(axis=0)
        matching = now.T @ self._rest
        if not np.isfinite(matching).all():
            return now - self._rest
        left, sizes, right = np.linalg.svd(matching)
        if np.linalg.det(left @ right) < 0.0:  # a mirror image is no turn
            left[:, 2], sizes[2] = -left[:, 2], -sizes[2]
        growth = sizes.sum() / max((self._rest**2).sum(), 1e-300)
        return now @ (left @ right) - growth * self._rest


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
