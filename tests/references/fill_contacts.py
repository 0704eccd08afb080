# SPDX-License-Identifier: BSD-3-Clause
"""Fills the shipped organs for contact references, on their own surfaces and finer than usual.

    .venv/bin/python tests/references/fill_contacts.py

What it writes, solve_contacts.py grades and presses. Solid organs are filled twice, the second time
with smaller cells; hollow ones get walls on the shipped surface itself, vertex by vertex.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import numpy as np

CHECKOUT = Path(__file__).parents[2]
CONTACTS = CHECKOUT / "build" / "contacts"
CELLS = {
    "spleen": (8e-3, 6.5e-3, 5e-3),
    "kidney": (7e-3, 5.7e-3, 4.5e-3),
    "liver": (14.5e-3, 12e-3, 10e-3),
}
"""[m] From the coarsest mesh to the finest."""
WALLS = {"gallbladder": 2.5e-3, "stomach": 4e-3}
"""[m] The thickness of tissues.toml."""


def main() -> None:
    CONTACTS.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[1:] or [*CELLS, *WALLS]:
        write(name)


def write(name: str) -> None:
    import palpate
    from palpate.runs.run import read_scene
    from palpate.scene.mesh_file import read_mesh_file
    from palpate_editor import authoring
    from palpate_editor.truth.tetrahedra import build_wall

    path = CHECKOUT / "meshes" / "published" / f"{name}.obj"
    surface = read_mesh_file(path)
    tissue = read_scene(path.with_suffix(".palpate")).bodies[0].tissue
    if np.asarray(tissue.rest_position).shape != np.asarray(surface.vertices).shape:
        raise SystemExit(f"{name}: the published scene has other vertices than {path.name}")
    meshes = {}
    for level, cell in enumerate(CELLS.get(name, ())):
        solid = authoring.fill_interior(surface, cell)
        meshes[f"vertices{level}"] = solid.vertices
        meshes[f"tetrahedra{level}"] = solid.tetrahedra
    if name in WALLS:
        normals = palpate.compute_vertex_normals(surface.vertices, surface.triangles)
        wall = build_wall(
            np.asarray(surface.vertices),
            np.asarray(surface.triangles),
            np.asarray(normals),
            WALLS[name],
        )
        meshes["vertices0"], meshes["tetrahedra0"] = wall
    np.savez(
        CONTACTS / name,
        x=surface.vertices,
        triangles=surface.triangles,
        fixed=tissue.fixed,
        sha256=hashlib.sha256(path.read_bytes()).hexdigest(),
        **meshes,
    )
    counts = [len(mesh) for key, mesh in meshes.items() if key.startswith("tetrahedra")]
    print(f"{name}: {counts} tetrahedra")


if __name__ == "__main__":
    main()
