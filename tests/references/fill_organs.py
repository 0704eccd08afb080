# SPDX-License-Identifier: BSD-3-Clause
"""Fills the shipped solid organs with tetrahedra, for solve_references.py to press.

.venv/bin/python tests/references/fill_organs.py
"""

from __future__ import annotations

from pathlib import Path

CHECKOUT = Path(__file__).parents[2]
FILLED = CHECKOUT / "build" / "references"
CELL_SIZE = {"spleen": 8e-3, "kidney": 7e-3, "liver": 14.5e-3}
"""[m] About two thousand tetrahedra each: what a simulation at 1 kHz can afford."""


def main() -> None:
    import numpy as np
    from palpate.mesh_file import read_mesh_file
    from palpate_editor import authoring

    FILLED.mkdir(parents=True, exist_ok=True)
    for name, cell_size in CELL_SIZE.items():
        surface = read_mesh_file(CHECKOUT / "meshes" / "published" / f"{name}.obj")
        solid = authoring.fill_interior(surface, cell_size)
        np.savez(FILLED / name, vertices=solid.vertices, tetrahedra=solid.tetrahedra)
        print(f"{name}: {len(solid.vertices)} vertices, {len(solid.tetrahedra)} tetrahedra")


if __name__ == "__main__":
    main()
