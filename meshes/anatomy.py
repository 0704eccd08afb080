# SPDX-License-Identifier: BSD-3-Clause
"""The organs by name: how each is made, and where on it the named parts of anatomy are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from palpate_meshes.generate.collecting_system import (
    collecting_system,
    collecting_system_regions,
)
from palpate_meshes.generate.gallbladder import gallbladder, gallbladder_regions
from palpate_meshes.generate.kidney import kidney, kidney_regions
from palpate_meshes.generate.kidney_stone import kidney_stone, kidney_stone_regions
from palpate_meshes.generate.liver import liver, liver_regions
from palpate_meshes.generate.relax import compute_normals, measure
from palpate_meshes.generate.simple_tissue import simple_tissue, simple_tissue_regions
from palpate_meshes.generate.spleen import spleen, spleen_regions
from palpate_meshes.generate.stomach import stomach, stomach_regions

Mesh = tuple[np.ndarray, np.ndarray]
Masks = dict[str, np.ndarray]

GENERATORS: dict[str, tuple[Callable[..., Mesh], Callable[[np.ndarray, np.ndarray], Masks]]] = {
    "simple_tissue": (simple_tissue, simple_tissue_regions),
    "spleen": (spleen, spleen_regions),
    "kidney": (kidney, kidney_regions),
    "collecting_system": (collecting_system, collecting_system_regions),
    "kidney_stone": (kidney_stone, kidney_stone_regions),
    "gallbladder": (gallbladder, gallbladder_regions),
    "liver": (liver, liver_regions),
    "stomach": (stomach, stomach_regions),
}
"""Name -> what makes the mesh, and what masks its regions."""

ATTACHMENT = "attachment"
"""The region that something of the body holds: fixed by default."""


def generate(name: str, **parameters: float) -> Mesh:
    """An organ by name. Raises ValueError for another name or parameters that give no mesh."""
    return find_generator(name)[0](**parameters)


def find_regions(
    name: str, vertices: np.ndarray, triangles: np.ndarray, size: float = 1.0
) -> dict[str, np.ndarray]:
    """The vertices of every named region, ascending.

    Args:
        name: Of the organ.
        vertices: [m] As it was generated.
        triangles: (t, 3)
        size: [-] The size it was generated with.
    """
    normals = np.zeros_like(vertices)
    for corner in triangles.T:
        np.add.at(normals, corner, compute_normals(vertices, triangles))
    normals /= measure(normals)[:, None]
    masks = find_generator(name)[1](1e3 * vertices / size, normals)
    return {region: np.flatnonzero(mask).astype(np.int32) for region, mask in masks.items()}


def find_generator(
    name: str,
) -> tuple[Callable[..., Mesh], Callable[[np.ndarray, np.ndarray], Masks]]:
    if name not in GENERATORS:
        raise ValueError(f"organ: got {name!r}, expected one of {', '.join(GENERATORS)}")
    return GENERATORS[name]
