# SPDX-License-Identifier: GPL-3.0-or-later
"""Small surfaces, and what is made of surfaces, for tests of what repairs them."""

from __future__ import annotations

import numpy as np
import palpate

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]) * 0.010
CUBE = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
     [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]]
)  # fmt: skip
"""A cube of 1 cm, outside out."""


def mesh_of(vertices: object, triangles: object) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(np.array(vertices, float), np.array(triangles))


def together(*meshes: palpate.SurfaceMesh) -> palpate.SurfaceMesh:
    first = np.cumsum([0] + [len(m.vertices) for m in meshes])
    return mesh_of(
        np.concatenate([m.vertices for m in meshes]),
        np.concatenate([np.asarray(m.triangles) + k for m, k in zip(meshes, first, strict=False)]),
    )


def scaled(mesh: palpate.SurfaceMesh, factor: float) -> palpate.SurfaceMesh:
    centre = np.asarray(mesh.vertices).mean(axis=0)
    return mesh_of(centre + factor * (np.asarray(mesh.vertices) - centre), mesh.triangles)


def inside_out(mesh: palpate.SurfaceMesh) -> palpate.SurfaceMesh:
    return mesh_of(mesh.vertices, np.asarray(mesh.triangles)[:, ::-1])
