# SPDX-License-Identifier: GPL-3.0-or-later
"""The tetrahedra that a file has, as the filling of the organ that was read from it."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Filling, Organ, Surface
from palpate_editor.document.constants import LEAST_TETRAHEDRA, MOST_TETRAHEDRA
from palpate_editor.edits.place_parts import place

LEAST_DIHEDRAL = 3.0
"""[degree] Between two faces of a tetrahedron: a flatter one asks for steps too short to feel."""

bounded: WeakKeyDictionary[Filling, WeakKeyDictionary[Surface, bool]] = WeakKeyDictionary()
"""Whether the outside of a filling is a surface: neither ever changes."""


def take_filling(
    scene: authoring.ImportedScene, unit: str, up: str, surface: Surface, ratio: float = 1.0
) -> tuple[Filling | None, str]:
    """The file's tetrahedra where they can fill the organ, and what is to be said of them; nothing
    where the file has none. `ratio` is that of `place_surfaces`."""
    if not len(scene.filling.tetrahedra):
        return None, ""
    points = ratio * place(np.asarray(scene.filling.vertices), unit, up)
    found = Filling(points, np.asarray(scene.filling.tetrahedra))
    fault = find_fault(found, surface)
    if fault:
        return None, describe_refilled(fault)
    return found, describe_own(np.degrees(palpate.compute_smallest_dihedral(solid_of(found))))


def describe_refilled(fault: str) -> str:
    return f"its tetrahedra are not used, and the organ is filled again: {fault}"


def describe_own(angle: float) -> str:
    return f"its tetrahedra fill the organ, the smallest angle between faces is {angle:.1f} degrees"


def solid_of(filling: Filling) -> palpate.SolidMesh:
    return palpate.SolidMesh(filling.vertices, filling.tetrahedra)


def find_fault(filling: Filling, surface: Surface) -> str:
    """Why tetrahedra cannot fill a surface; empty where they can."""
    count, least, most = len(filling.tetrahedra), LEAST_TETRAHEDRA, MOST_TETRAHEDRA
    if not least <= count <= most:
        return f"there are {count}, and an organ has {least} to {most}"
    solid = solid_of(filling)
    try:
        palpate.validate(solid)
    except ValueError as problem:
        return str(problem)
    angle = float(np.degrees(palpate.compute_smallest_dihedral(solid)))
    if angle < LEAST_DIHEDRAL:
        least_angle = LEAST_DIHEDRAL
        return f"faces at {angle:.2g} degrees to each other, where {least_angle:g} are needed"
    if not is_bounded_by(filling, surface):
        return "the surface is no longer their outside"
    return ""


def find_own_filling(organ: Organ) -> palpate.SolidMesh | None:
    """The file's tetrahedra, where they fill the organ as it is: they are as many as are asked for,
    nowhere finer than they are, and its surface is still their outside."""
    filling, surface, fill = organ.filling, organ.surface, organ.fill
    if filling is None or surface is None or fill.fine_region:
        return None
    if len(filling.tetrahedra) != fill.tetrahedra:
        return None
    return solid_of(filling) if is_bounded_by(filling, surface) else None


def is_bounded_by(filling: Filling, surface: Surface) -> bool:
    """Whether the faces that only one tetrahedron has are the triangles of the surface."""
    known = bounded.setdefault(filling, WeakKeyDictionary())
    if surface not in known:
        faces = np.asarray(palpate.find_boundary(solid_of(filling)))
        known[surface] = same_triangles(
            filling.vertices[faces], surface.vertices[surface.triangles]
        )
    return known[surface]


def same_triangles(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two lists (t, 3, 3) have the same corners, to the bit, in any order."""
    if one.shape != other.shape:
        return False
    return np.array_equal(sort_triangles(one), sort_triangles(other))


def sort_triangles(corners: np.ndarray) -> np.ndarray:
    """(t, 9) Corners in order within each triangle, and triangles in order."""
    points, number = np.unique(corners.reshape(-1, 3) + 0.0, axis=0, return_inverse=True)
    rows = np.sort(number.reshape(-1, 3), axis=1)
    rows = rows[np.lexsort(rows.T[::-1])]
    return points[rows].reshape(-1, 9)
