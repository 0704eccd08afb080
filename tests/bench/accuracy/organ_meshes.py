# SPDX-License-Identifier: BSD-3-Clause
"""Meshes for engines that have no near field: small elements under the ball, or alike everywhere.

A recipe is BASE, or BASE:PER_RADIUS:SLOPE for elements of the ball's radius over PER_RADIUS under
it, growing by SLOPE of the distance, on the shipped surface, as those of the truth are. A base is
the organ filled with tetrahedra, its wall as one layer of them, or, as shell_BASE, the middle
surface of the wall.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
from palpate.scene.mesh_file import read_mesh_file
from palpate_editor import authoring
from palpate_editor.truth.contact import find_gap, find_touch
from palpate_editor.truth.graded import Grading, Skin, refine
from palpate_editor.truth.subject import find_held
from palpate_editor.truth.tetrahedra import build_wall, find_surface
from work import Floats, Ints, Mesh, Work

PUBLISHED = Path(__file__).parents[3] / "meshes" / "published"
CELLS = {"coarse": 11e-3, "middle": 8e-3, "fine": 5.5e-3}
"""[m] of the tetrahedra that fill a solid."""
WALL_VERTICES = {"coarse": 400, "middle": 800, "fine": 1600, "finest": 3200}
"""Of the surface that a wall stands on."""
SHELL = "shell_"


class Body:
    """The shipped organ of a work, to be meshed."""

    def __init__(self, work: Work, fixed: Ints):
        self.work, self.fixed = work, fixed
        self.surface = read_mesh_file(PUBLISHED / f"{work.shipped}.obj")
        x, triangles = np.asarray(self.surface.vertices), np.asarray(self.surface.triangles)
        self.skin = Skin(x, triangles.astype(np.int64))

    def make_mesh(self, recipe: str) -> Mesh:
        base, *grading = recipe.split(":")
        if base.startswith(SHELL):
            return self.make_shell(WALL_VERTICES[base.removeprefix(SHELL)])
        x, cells = self.fill(CELLS[base]) if self.is_solid else self.thicken(WALL_VERTICES[base])
        if grading:
            x, cells = self.refine(x, cells, float(grading[0]), float(grading[1]))
        faces = find_surface(cells)
        held = find_held(self.skin, self.fixed, x, faces, self.work.wall_thickness)
        return Mesh(x, cells, np.unique(held), *self.find_touches(x, faces))

    @property
    def is_solid(self) -> bool:
        return self.work.wall_thickness is None

    def fill(self, cell: float) -> tuple[Floats, Ints]:
        solid = authoring.fill_interior(self.surface, cell)
        return np.asarray(solid.vertices), np.asarray(solid.tetrahedra, dtype=np.int64)

    def decimate(self, count: int) -> tuple[Floats, Ints, Floats]:
        """Vertices, triangles and outward normals of the surface with fewer vertices."""
        mesh = authoring.decimate(self.surface, count).mesh
        x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
        return x, triangles, np.asarray(palpate.compute_vertex_normals(x, triangles))

    def thicken(self, count: int) -> tuple[Floats, Ints]:
        return build_wall(*self.decimate(count), float(self.work.wall_thickness or 0.0))

    def make_shell(self, count: int) -> Mesh:
        """The middle of the wall; what is touched lies half of it further out."""
        x, triangles, normals = self.decimate(count)
        half = 0.5 * float(self.work.wall_thickness or 0.0)
        middle = x - half * normals
        return Mesh(
            middle,
            triangles.astype(np.int64),
            self.find_held_vertices(x),
            *self.find_touches(middle, triangles, half),
        )

    def refine(self, x: Floats, t: Ints, per_radius: float, slope: float) -> tuple[Floats, Ints]:
        work = self.work
        wide = float(np.sqrt(work.radius * work.depths[-1]))
        size, reach = work.radius / per_radius, min(1.1 * work.radius, 1.5 * wide)
        grading = Grading(np.array([work.point]), size, reach, slope)
        return refine(x, t, grading, self.skin if self.is_solid else None)

    def find_touches(self, x: Floats, faces: Ints, extra: float = 0.0) -> tuple[float, float]:
        """[m] Heights of the ball's centre over the place when it first touches faces, and
        vertices; `extra` [m] is the radius of what it touches."""
        point, direction = np.array(self.work.point), np.array(self.work.direction)
        radius = self.work.radius + extra
        offset = x[np.unique(faces)] - point
        near = np.linalg.norm(offset, axis=1) < 3.0 * radius
        vertices = -find_gap(offset[near], direction, radius, 0.0)
        return find_touch(x, faces, point, direction, radius), float(np.max(vertices))

    def find_held_vertices(self, x: Floats) -> Ints:
        """Vertices of a decimated surface that lie where the shipped one is mostly held."""
        vertices, triangles = self.skin.x, self.skin.triangles
        tree, is_held = palpate.AabbTree(vertices, triangles), np.zeros(len(vertices))
        is_held[self.fixed] = 1.0
        near = [palpate.find_closest_point(tree, vertices, point) for point in x]
        share = [is_held[triangles[n.triangle]] @ np.asarray(n.weights) for n in near]
        return np.flatnonzero(np.array(share) >= 0.5)
