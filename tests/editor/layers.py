# SPDX-License-Identifier: GPL-3.0-or-later
"""A round layer on a rigid base, filled with tetrahedra: what indenters are pressed into."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from math import pi

import numpy as np
import palpate
from organs import make_organ
from palpate.scene.scene_parts import FillPart, HandPart, MaterialPart, ModelPart, ToolPart
from palpate_editor import authoring
from palpate_editor.document import Organ, Surface

RADIUS, THICKNESS = 0.04, 0.02
"""[m] Twice as wide as thick: its side is not felt in the middle."""


@dataclass(frozen=True)
class Layer:
    x: np.ndarray
    tetrahedra: np.ndarray
    top: np.ndarray
    """Vertices of the surface that is pressed."""
    share: np.ndarray
    """[m²] (n,) of that surface, by vertex."""
    base: np.ndarray
    border: np.ndarray
    """Vertices of the side and the base."""

    def distance(self) -> np.ndarray:
        return np.hypot(self.x[:, 0], self.x[:, 1])


@cache
def fill_layer(cell: float) -> Layer:
    around = 2.0 * pi * np.arange(64) / 64
    rim = RADIUS * np.column_stack([np.cos(around), np.sin(around)])
    x = np.vstack(
        [np.column_stack([rim, 0 * around]), np.column_stack([rim, 0 * around - THICKNESS])]
    )
    x = np.vstack([x, [[0.0, 0.0, 0.0], [0.0, 0.0, -THICKNESS]]])
    i, j = np.arange(64), np.roll(np.arange(64), -1)
    sides = [
        (i, i + 64, j + 64),
        (i, j + 64, j),
        (0 * i + 128, i, j),
        (0 * i + 129, j + 64, i + 64),
    ]
    triangles = np.vstack([np.column_stack(corners) for corners in sides]).astype(np.int32)
    solid = authoring.fill_interior(palpate.SurfaceMesh(x, triangles), cell)
    x, faces = np.asarray(solid.vertices), np.asarray(palpate.find_boundary(solid))
    flat = (x[faces][:, :, 2] > -1e-6).all(axis=1)
    a, b, c = (x[faces[flat, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    share = np.bincount(faces[flat].ravel(), np.repeat(area / 3.0, 3), minlength=len(x))
    surface = np.unique(faces)
    return Layer(
        x=x,
        tetrahedra=np.asarray(solid.tetrahedra),
        top=np.unique(faces[flat]),
        share=share,
        # filling rounds the edge of the base off
        base=surface[x[surface, 2] < -THICKNESS + 0.3 * cell],
        border=np.unique(faces[~flat]),
    )


def make_layer_organ(cell: float, sphere: float) -> Organ:
    """A solid organ of 5 kPa with the surface of a filled layer, and a sphere [m] to press it."""
    layer = fill_layer(cell)
    faces = palpate.find_boundary(palpate.SolidMesh(layer.x, layer.tetrahedra))
    used, corners = np.unique(faces, return_inverse=True)
    surface = Surface(layer.x[used], corners.reshape(-1, 3).astype(np.int32))
    return replace(
        make_organ(imported=None),
        name="layer",
        fill=FillPart(),
        far_field=None,
        surface=surface,
        material=MaterialPart(),
        model=ModelPart(kind="solid", constants="tissue", drag=60.0),
        tool=ToolPart(radius=sphere),
        hand=HandPart(),
        fixed=surface.vertices[:, 2] < 1e-3 - THICKNESS,
        stiffness_scale=np.ones(len(used)),
    )
