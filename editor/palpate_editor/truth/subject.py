# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that a truth is solved on: what of an organ the theory of elasticity knows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import palpate
from scipy.spatial import cKDTree

from palpate_editor import authoring
from palpate_editor.compile import mesh_of
from palpate_editor.document import Organ
from palpate_editor.edits import EditError, decimate_organ
from palpate_editor.edits.carry import carry_paint
from palpate_editor.truth.graded import Skin
from palpate_editor.truth.progress import TruthError
from palpate_editor.truth.tetrahedra import Floats, Ints, build_wall

COARSEST = 2000
"""Tetrahedra of a solid before it is graded, about, on the coarsest mesh."""
MOST_VERTICES = 8000
"""Of the surface of a body; one that has more is decimated to so many."""
FINER = (1.0, 0.81, 0.63)
"""Of the size of those cells, on every level."""


@dataclass(frozen=True, eq=False)
class Subject:
    """A body of linear, isotropic tissue, and what of it is held."""

    surface: Skin
    """That is touched, and where displacements are compared."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    build: Callable[[int], tuple[Floats, Ints]]
    """The tetrahedra of a level, before they are graded."""
    held: Callable[[Floats, Ints], Ints]
    """Of a mesh's boundary facets, those that are held."""
    fixed: Ints
    """Vertices of the surface that are held."""
    wall_thickness: float | None = None
    """[m] of a hollow body; None for a solid."""
    is_snapped: bool = True
    """What is new on the surface of the mesh goes to the surface that is touched."""
    scale: Callable[[Floats], Floats] | None = None
    """How many times stiffer the tissue is at points (n, 3); None where it is alike everywhere."""

    @property
    def is_hollow(self) -> bool:
        return self.wall_thickness is not None

    @property
    def plane_modulus(self) -> float:
        """[Pa] E* = E/(1 - nu²)."""
        return self.young_modulus / (1.0 - self.poisson_ratio**2)


def find_whole(organ: Organ) -> Organ:
    """The organ on the surface that was imported, where the one on the desk is a decimated one: a
    truth is of the body, not of how finely it is simulated."""
    imported = organ.imported
    if imported is None or organ.decimation is None or imported is organ.surface:
        return organ
    report = authoring.inspect_mesh(mesh_of(imported))
    if report.border_loops or report.self_intersecting_faces or report.non_manifold_edges:
        return organ
    if len(imported.vertices) <= MOST_VERTICES:
        return carry_paint(organ, imported)
    try:
        return decimate_organ(organ, MOST_VERTICES)(organ)
    except EditError:
        return organ


def take_subject(organ: Organ) -> Subject:
    """The body that an organ stands for. Raises TruthError where it is none that can be solved."""
    if organ.surface is None:
        raise TruthError("truth: got an organ without a surface, expected an imported mesh")
    skin = Skin(organ.surface.vertices, organ.surface.triangles.astype(np.int64))
    wall, fixed = organ.material.wall_thickness, np.flatnonzero(organ.fixed)
    if not organ.fixed[skin.triangles].all(axis=1).any():
        raise TruthError(
            "truth: got an organ of which no triangle is held, expected some held ones: a free "
            "body moves away from the tool"
        )
    scale = organ.stiffness_scale
    return Subject(
        surface=skin,
        young_modulus=organ.material.young_modulus,
        poisson_ratio=organ.material.poisson_ratio,
        build=fill(organ) if wall is None else hollow_out(skin, wall),
        held=lambda x, faces: find_held(skin, fixed, x, faces, wall),
        fixed=fixed,
        wall_thickness=wall,
        is_snapped=wall is None,
        scale=None if (scale == 1.0).all() else lambda x: scale[cKDTree(skin.x).query(x)[1]],
    )


def fill(organ: Organ) -> Callable[[int], tuple[Floats, Ints]]:
    """Tetrahedra inside a closed surface, smaller on every level."""
    assert organ.surface is not None
    surface = mesh_of(organ.surface)

    def build(level: int) -> tuple[Floats, Ints]:
        try:
            coarsest = authoring.choose_cell_size(surface, COARSEST)
            solid = authoring.fill_interior(surface, FINER[level] * coarsest)
        except ValueError as refused:
            raise TruthError(f"truth: the surface cannot be filled: {refused}") from None
        return np.asarray(solid.vertices), np.asarray(solid.tetrahedra, dtype=np.int64)

    return build


def hollow_out(skin: Skin, wall: float) -> Callable[[int], tuple[Floats, Ints]]:
    """A wall inwards of the surface, the same on every level: grading makes it finer."""
    normals = np.asarray(
        palpate.compute_vertex_normals(skin.x, np.asarray(skin.triangles, np.int32))
    )

    def build(level: int) -> tuple[Floats, Ints]:
        try:
            return build_wall(skin.x, skin.triangles, normals, wall)
        except ValueError as refused:
            raise TruthError(
                f"truth: got a wall of {1e3 * wall:g} mm, expected one that the surface has room "
                f"for: {refused}"
            ) from None

    return build


def find_held(skin: Skin, fixed: Ints, x: Floats, faces: Ints, wall: float | None) -> Ints:
    """Facets over triangles of the surface whose three corners the scene holds.

    A wall is held through its thickness: the inner facets under such triangles too.
    """
    middle = x[faces].mean(axis=1)
    closest, triangle = skin.project(middle)
    on = np.isin(skin.triangles[triangle], fixed).all(axis=1)
    if wall is not None:
        on &= np.linalg.norm(middle - closest, axis=1) < 1.05 * wall
    return faces[on]


def find_thickness(skin: Skin, point: Floats, direction: Floats, hollow: bool) -> float:
    """[m] from a place along the press to where the body ends, a hollow one with its far wall.

    Raises TruthError where nothing is behind the place.
    """
    a, b, c = (skin.x[skin.triangles[:, k]] for k in range(3))
    origin = point - 1e-5 * direction
    edges = np.stack([b - a, c - a, np.broadcast_to(direction, a.shape)], axis=2)
    crossed = np.abs(np.linalg.det(edges)) > 1e-15
    u, v, s = np.linalg.solve(edges[crossed], (origin - a[crossed])[..., None])[..., 0].T
    hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1.0 + 1e-9) & (s > 0.0)
    if not hit.any():
        at = ", ".join(f"{1e3 * v:.1f}" for v in point)
        raise TruthError(
            f"truth: got an open surface, with nothing behind the place at {at} mm, expected a "
            "closed one"
        )
    return float((np.max if hollow else np.min)(s[hit])) + 1e-5
