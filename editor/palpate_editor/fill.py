# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids: the tetrahedra inside an organ's surface, and the tissue they make."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
import palpate
from palpate.scene_file import build_material, enumerator

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface

TETRAHEDRA = 3000
"""About how many fill an organ: what ticks a thousand times a second with time to spare."""

filled: WeakKeyDictionary[Surface, palpate.SolidMesh] = WeakKeyDictionary()
"""A surface never changes, so neither does what fills it."""


def fill_surface(surface: Surface) -> palpate.SolidMesh:
    """About TETRAHEDRA inside a surface. Raises ValueError where it is open or crosses itself."""
    if surface not in filled:
        mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
        cell_size = authoring.choose_cell_size(mesh, TETRAHEDRA)
        filled[surface] = authoring.fill_interior(mesh, cell_size)
    return filled[surface]


def build_filled(organ: Organ) -> palpate.TissueModel:
    """The solid of an organ under its own surface. Raises ValueError naming what is wrong.

    What is painted on the surface is carried inside: a vertex of the tetrahedra is as stiff as the
    nearest vertex of the surface is scaled, and held where it lies on the outside and that one is.
    """
    assert organ.surface is not None
    surface = palpate.SurfaceMesh(organ.surface.vertices, organ.surface.triangles)
    solid = fill_surface(organ.surface)
    nearest = find_nearest(np.asarray(solid.vertices), organ.surface.vertices)
    outside = np.zeros(len(nearest), dtype=bool)
    outside[palpate.find_boundary(solid)] = True
    options = palpate.SolidOptions(
        fixed=np.flatnonzero(outside & organ.fixed[nearest]),
        stiffness_scale=organ.stiffness_scale[nearest],
        drag=organ.model.drag,
        damping_law=enumerator(palpate.DampingLaw, "model.damping_law", organ.model.damping_law),
    )
    linear = organ.model.kind == "linear_solid"
    build = palpate.build_linear_solid if linear else palpate.build_solid
    model = build(solid, build_material(organ.material), options)
    return palpate.cover_with_skin(model, surface)


def find_nearest(points: np.ndarray, among: np.ndarray) -> np.ndarray:
    """(n,) the vertex of `among` nearest to each point."""
    rows = max(1, 2_000_000 // max(1, len(among)))
    found = [
        np.linalg.norm(points[at : at + rows, None] - among[None], axis=2).argmin(axis=1)
        for at in range(0, len(points), rows)
    ]
    return np.concatenate(found)
