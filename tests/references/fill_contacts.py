# SPDX-License-Identifier: BSD-3-Clause
"""Fills the shipped organs for contact references, on their own surfaces and finer than usual.

    .venv/bin/python tests/references/fill_contacts.py [NAME ...]

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
WALLS = {"gallbladder": 2.5e-3, "stomach": 4e-3, "wall_2mm": 2e-3}
"""[m] The thickness of tissues.toml, and one that other engines are compared on."""
SURFACES = {"wall_2mm": "gallbladder"}
"""Whose shipped surface, and what of it is held, a body has that is no shipped organ itself."""


def main() -> None:
    CONTACTS.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[1:] or [*CELLS, *WALLS]:
        write(name)


def write(name: str) -> None:
    import palpate
    from palpate.scene.mesh_file import read_mesh_file
    from palpate.study.contact_reference import read_contact_reference
    from palpate_editor import authoring
    from palpate_editor.truth.tetrahedra import build_wall

    shipped = SURFACES.get(name, name)
    path = CHECKOUT / "meshes" / "published" / f"{shipped}.obj"
    surface = read_mesh_file(path)
    # a published solid or decimated wall has particles of its own; the reference keeps which of the
    # shipped surface are held, and a test holds it to the scene
    fixed = read_contact_reference(shipped).fixed
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
        fixed=np.array(fixed),
        sha256=hashlib.sha256(path.read_bytes()).hexdigest(),
        **meshes,
    )
    counts = [len(mesh) for key, mesh in meshes.items() if key.startswith("tetrahedra")]
    print(f"{name}: {counts} tetrahedra")


if __name__ == "__main__":
    main()
