# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems on the organ: red where nothing can be built yet, and a look at one of them."""

from __future__ import annotations

from math import asin, atan2

import numpy as np
import palpate
from palpate.render import Appearance, Shape
from PySide6.QtCore import QObject

from palpate_editor.document import Surface
from palpate_editor.document.problems import Problem
from palpate_editor.problem_places import find_place
from palpate_editor.views.context import Context

MARK, LOOKED = "problems", "looked at"
RED = Appearance(
    (0.95, 0.10, 0.08), gloss=0.1, subsurface=0.0, seen_through=True, casts_shadow=False
)
AMBER = Appearance(
    (1.00, 0.62, 0.05), gloss=0.1, subsurface=0.0, seen_through=True, casts_shadow=False
)
STAGES = ("import", "repair")
"""Where they are shown: further on the surface is taken to be good."""
LIFT = 1e-3
"""[-] of the diagonal: how far the marks stand off the surface."""
NEAR = 0.15
"""[-] of the diagonal: how much of the surface is in sight around a place."""


class ProblemMarks(QObject):
    """Paints the triangles of every error red while the stages of the surface are open."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.stage = context.stage
        self.shown: tuple[Surface, np.ndarray] | None = None
        self.looked: Surface | None = None
        context.assessed.connect(self.show)
        context.stage_shown.connect(self.on_stage)
        context.preview_shown.connect(self.show)
        context.session.changed.connect(self.show)

    def on_stage(self, stage: str) -> None:
        if stage != self.stage:
            self.forget_looked()
        self.stage = stage
        self.show()

    def show_looked(self, surface: Surface, faces: np.ndarray) -> None:
        """Paints the triangles of the problem that is looked at, whatever its severity."""
        self.forget_looked()
        self.looked = surface
        self.context.view.show_part(LOOKED, build_shape(surface, faces), AMBER)

    def forget_looked(self) -> None:
        if self.looked is not None:
            self.looked = None
            self.context.view.show_part(LOOKED, None, AMBER)

    def show(self, *_: object) -> None:
        """Paints what there is; nothing is done where it is painted already."""
        surface, faces = self.context.session.organ.surface, self.find_faces()
        if surface is not self.looked or self.context.previewing:
            self.forget_looked()
        if surface is None or not len(faces):
            if self.shown is not None:
                self.shown = None
                self.context.view.show_part(MARK, None, RED)
            return
        shown = self.shown
        if shown is not None and shown[0] is surface and np.array_equal(shown[1], faces):
            return
        self.shown = surface, faces
        self.context.view.show_part(MARK, None, RED)  # its triangles may be others
        self.context.view.show_part(MARK, build_shape(surface, faces), RED)

    def find_faces(self) -> np.ndarray:
        """The triangles of every error of the surface that the view shows."""
        assessment = self.context.assessment
        none = np.empty(0, np.int32)
        if assessment is None or self.context.previewing or self.stage not in STAGES:
            return none
        if assessment.organ.surface is not self.context.session.organ.surface:
            return none
        found = [
            p.faces for p in assessment.problems if p.severity == "error" and p.faces is not None
        ]
        return np.unique(np.concatenate([none, *found]))

    def look_at(self, problem: Problem) -> None:
        """Flies to one of its triangles, from outside."""
        surface = self.context.session.organ.surface
        assessment = self.context.assessment
        if problem.faces is None or not len(problem.faces) or surface is None:
            return
        if assessment is None or assessment.organ.surface is not surface:
            return
        middle, outward = find_view(surface, problem.faces)
        self.show_looked(surface, problem.faces)
        view = self.context.view
        view.orbit(0.0, 0.0)  # from here on the camera is where it is put
        x, y, z = (float(value) for value in outward)
        view.look_from(atan2(y, x), asin(max(-0.99, min(0.99, z))))
        view.camera.target = middle
        size = NEAR * float(palpate.compute_diagonal(surface.vertices))
        view.camera.distance = size / view.camera.field_of_view
        view.update()


def build_shape(surface: Surface, faces: np.ndarray) -> Shape:
    """The triangles a hair off the surface, on both sides of it."""
    x = surface.vertices[surface.triangles[faces]]
    normals = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    lift = LIFT * float(palpate.compute_diagonal(surface.vertices)) * normals[:, None]
    corners = np.concatenate([x + lift, (x - lift)[:, ::-1]]).reshape(-1, 3)
    directions = np.repeat(np.concatenate([normals, -normals]), 3, axis=0)
    return Shape(corners, directions, np.arange(len(corners), dtype=np.int32).reshape(-1, 3))


def find_view(surface: Surface, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The middle of one triangle [m], and a direction from which it is in sight: that in which its
    surface faces, else the one away from the middle of the organ, else any that is free."""
    middle = np.array(find_place(surface, faces))
    x = surface.vertices[surface.triangles[faces]]
    nearest = np.linalg.norm(x.mean(axis=1) - middle, axis=1).argmin()
    normal = np.cross(x[nearest, 1] - x[nearest, 0], x[nearest, 2] - x[nearest, 0])
    wanted = [normal, middle - surface.vertices.mean(axis=0), *list_directions(), -normal]
    directions = [d / np.linalg.norm(d) for d in wanted if np.linalg.norm(d) > 0.0]
    tree = palpate.AabbTree(surface.vertices, surface.triangles)
    lift = LIFT * float(palpate.compute_diagonal(surface.vertices))
    for direction in directions:
        start = middle + lift * direction
        if palpate.find_ray_hit(tree, surface.vertices, start, direction) is None:
            return middle, direction
    return middle, directions[0]


def list_directions(count: int = 64) -> np.ndarray:
    """(count, 3) unit, evenly over the sphere."""
    z = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    turn = np.pi * (3.0 - 5.0**0.5) * np.arange(count)
    across = np.sqrt(1.0 - z**2)
    return np.column_stack([across * np.cos(turn), across * np.sin(turn), z])
