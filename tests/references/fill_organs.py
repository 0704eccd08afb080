# SPDX-License-Identifier: BSD-3-Clause
"""Fills the shipped solid organs and an ellipsoid with tetrahedra, and gives the hollow ones walls.

    .venv/bin/python tests/references/fill_organs.py

What it writes, solve_references.py presses.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import numpy as np

CHECKOUT = Path(__file__).parents[2]
FILLED = CHECKOUT / "build" / "references"
CELL_SIZE = {"spleen": 8e-3, "kidney": 7e-3, "liver": 14.5e-3, "ellipsoid": 8e-3}
"""[m] About two thousand tetrahedra each: what a simulation at 1 kHz can afford."""
SEMI_AXES = (0.05, 0.035, 0.03)
"""[m] of the ellipsoid of [accuracy: quarter]."""
WALLS = {"gallbladder": (500, 2.5e-3), "stomach": (600, 4e-3)}
"""Vertices that the surface is decimated to, and the thickness [m] of tissues.toml."""


def main() -> None:
    names = sys.argv[1:] or [*CELL_SIZE, *WALLS]
    FILLED.mkdir(parents=True, exist_ok=True)
    for name in names:
        fill(name) if name in CELL_SIZE else wall(name)


def fill(name: str) -> None:
    from palpate_editor import authoring

    solid = authoring.fill_interior(read_surface(name), CELL_SIZE[name])
    save(name, solid.vertices, solid.tetrahedra)


def wall(name: str) -> None:
    import palpate
    from palpate_editor import authoring
    from palpate_editor.truth.tetrahedra import build_wall

    count, thickness = WALLS[name]
    coarse = authoring.decimate(read_surface(name), count).mesh
    normals = palpate.compute_vertex_normals(coarse.vertices, coarse.triangles)
    save(name, *build_wall(coarse.vertices, coarse.triangles, normals, thickness))


def read_surface(name: str):
    import palpate
    from bodies import build_ellipsoid
    from palpate.scene.mesh_file import read_mesh_file
    from palpate_editor.truth.tetrahedra import find_surface

    if name != "ellipsoid":
        return read_mesh_file(path_of(name))
    x, t = build_ellipsoid(SEMI_AXES, 16)
    faces = find_surface(t)
    used, corners = np.unique(faces, return_inverse=True)
    return palpate.SurfaceMesh(x[used], corners.reshape(-1, 3))


def path_of(name: str) -> Path:
    return CHECKOUT / "meshes" / "published" / f"{name}.obj"


def save(name: str, vertices, tetrahedra) -> None:
    path = path_of(name)
    made_of = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else ""
    np.savez(FILLED / name, vertices=vertices, tetrahedra=tetrahedra, sha256=made_of)
    print(f"{name}: {len(vertices)} vertices, {len(tetrahedra)} tetrahedra")


if __name__ == "__main__":
    main()
