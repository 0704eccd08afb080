# SPDX-License-Identifier: GPL-3.0-or-later
"""Where on a surface a problem is: its triangles, for the eye and for the command line."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import palpate

from palpate_editor.authoring import MeshReport
from palpate_editor.document import Surface
from palpate_editor.document.rules import ANGLE_LEAST
from palpate_editor.edits.keep_outer import find_outer
from palpate_editor.edits.repair import find_crowded, find_disagreeing, list_sides


def find_faces(key: str, surface: Surface, report: MeshReport) -> np.ndarray | None:
    """Numbers of the triangles, ascending; None of a problem that is nowhere in particular."""
    if key == "non_manifold":
        return find_crowded(surface.triangles)
    if key == "one_sided":
        return find_disagreeing(surface.triangles)
    if key in ("crossing", "self_intersections"):
        return np.asarray(report.crossing_faces, np.int32)
    if key == "shells":
        return find_lesser(surface)
    if key == "inner":
        return np.flatnonzero(~find_outer(surface)).astype(np.int32)
    if key == "holes":
        return find_border(surface.triangles)
    if key == "thin":
        return np.asarray(report.thin_faces, np.int32)
    if key == "angles":
        return np.flatnonzero(compute_angles(surface) < np.radians(ANGLE_LEAST)).astype(np.int32)
    return None


def find_lesser(surface: Surface) -> np.ndarray:
    """The triangles of every piece but the one with the most of them."""
    shell = np.asarray(palpate.find_shells(len(surface.vertices), surface.triangles))
    of_triangle = shell[surface.triangles[:, 0]]
    largest = np.bincount(of_triangle).argmax()
    return np.flatnonzero(of_triangle != largest).astype(np.int32)


def find_border(triangles: np.ndarray) -> np.ndarray:
    """The triangles that have a side to themselves, ascending."""
    return np.unique(np.flatnonzero(list_sides(triangles)[1] == 1) // 3).astype(np.int32)


def find_around(triangles: np.ndarray, vertices: Sequence[int]) -> np.ndarray:
    """The triangles that have one of these vertices, ascending."""
    return np.flatnonzero(np.isin(triangles, vertices).any(axis=1)).astype(np.int32)


def find_nearest_face(surface: Surface, point: Sequence[float]) -> np.ndarray:
    """The one triangle nearest to a point [m] inside."""
    tree = palpate.AabbTree(surface.vertices, surface.triangles)
    near = palpate.find_closest_point(tree, surface.vertices, np.asarray(point))
    return np.array([near.triangle], np.int32)


def compute_angles(surface: Surface) -> np.ndarray:
    """[rad] (t,) the smallest angle of each triangle; 0 of one without an area."""
    corners = surface.vertices[surface.triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    back = -np.roll(sides, 1, axis=1)
    across = np.linalg.norm(np.cross(sides, back), axis=2)
    return np.arctan2(across, (sides * back).sum(axis=2)).min(axis=1)


def find_place(surface: Surface, faces: np.ndarray) -> list[float]:
    """[m] The middle of that triangle which is nearest to the middle of them all."""
    middles = surface.vertices[surface.triangles[faces]].mean(axis=1)
    away = np.linalg.norm(middles - np.median(middles, axis=0), axis=1)
    return [float(c) for c in middles[away.argmin()]]
