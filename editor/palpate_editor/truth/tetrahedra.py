# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedra as arrays: positions [m] (n, 3), corners (t, 4), each of positive volume."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MICRON = 1e-6
"""Coordinates are whole micrometres, so a mesh and its hash are exact."""


def build_wall(
    x: Floats, triangles: Ints, normals: Floats, thickness: float
) -> tuple[Floats, Ints]:
    """A wall inwards of a surface: its vertices come first, then those of the inner face.

    Where the surface turns so tightly that the inner face would fold, the wall is made thinner.
    Raises ValueError where it folds, however thin it is made.
    """
    count, depth = len(x), np.full(len(x), thickness)
    a, b, c = np.sort(triangles, axis=1).T
    # prisms cut by vertex number, so that neighbours cut the sides between them alike
    cells = np.vstack(
        [
            np.stack([a, b, c, c + count], axis=1),
            np.stack([a, b, b + count, c + count], axis=1),
            np.stack([a, a + count, b + count, c + count], axis=1),
        ]
    )
    turns = np.array([np.linalg.det(np.eye(3)[np.argsort(t)]) for t in triangles])
    signs = np.concatenate([-turns, turns, -turns])
    for _ in range(40):
        body = np.vstack([x, x - depth[:, None] * normals])
        flat = signs * compute_volumes(body, cells) < 0.02 * np.median(
            share_volume(x, triangles, depth)
        )
        if not flat.any():
            return finish(body, cells)
        depth[np.unique(cells[flat] % count)] *= 0.85
    raise ValueError("the wall folds, however thin it is made")


def share_volume(x: Floats, triangles: Ints, depth: Floats) -> Floats:
    """[m³] of a third of the prism over each triangle."""
    a, b, c = (x[triangles[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return area * depth[triangles].mean(axis=1) / 3.0


def finish(x: Floats, t: Ints) -> tuple[Floats, Ints]:
    """Whole micrometres, and every tetrahedron of positive volume."""
    return np.round(x / MICRON) * MICRON, turn_right(x, t)


def turn_right(x: Floats, t: Ints) -> Ints:
    """The same tetrahedra, each of positive volume."""
    turned = compute_volumes(x, t) < 0.0
    t = t.copy()
    t[turned] = t[turned][:, [0, 2, 1, 3]]
    return t


def compute_volumes(x: Floats, t: Ints) -> Floats:
    """[m³] (t,) signed."""
    a, b, c = (x[t[:, k]] - x[t[:, 0]] for k in (1, 2, 3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0


def find_surface(t: Ints) -> Ints:
    """The faces that only one tetrahedron has, counter-clockwise from outside."""
    faces = np.vstack([t[:, f] for f in ([1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1])])
    _, first, count = np.unique(
        np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True
    )
    return faces[np.sort(first[count == 1])]
