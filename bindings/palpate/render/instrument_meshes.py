# SPDX-License-Identifier: BSD-3-Clause
"""The meshes of the instruments that ship, in the frame of a tool: z from the tip to the hand."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.render.shapes import Shape

DRAWN = Path(__file__).with_name("instruments")
"""Copies of meshes/published/tools, which `./run meshes` writes."""
SHARP = math.radians(35.0)
"""Between two triangles: a larger angle is drawn as an edge."""
ROUND = 1e-4
"""[-] Normals that differ by less are one."""


@dataclass(frozen=True)
class MeshPart:
    """A part of an instrument, its jaws closed."""

    name: str
    turns: float = 0.0
    """[-] The sense in which it opens about the hinge's x: 1, -1, or 0 for what stays."""
    dark: bool = False
    """Whether it is insulated, as shafts are."""


@dataclass(frozen=True)
class InstrumentMesh:
    """What stands in `instruments`, and how it lies against what touches (meshes/tools.toml)."""

    parts: tuple[MeshPart, ...]
    radius: float
    """[m] Of its shaft."""
    tip: float
    """[m] From the tip of the mesh to the end of the axis of what touches first."""
    hinge: float = 0.0
    """[m] From the tip of the mesh to the axis of its jaws."""
    jaw_radius: float = 0.0
    """[m] Of the capsules that stand for its jaws."""


MESHES = {
    "grasper": InstrumentMesh(
        (
            MeshPart("grasper_shaft", dark=True),
            MeshPart("grasper_upper_jaw", -1.0),
            MeshPart("grasper_lower_jaw", 1.0),
        ),
        radius=2.5e-3,
        tip=0.8e-3,
        hinge=22.5e-3,
        jaw_radius=1.2e-3,
    ),
    "laparoscope": InstrumentMesh((MeshPart("laparoscope_shaft"),), radius=5e-3, tip=8.8e-3),
}


@cache
def read_part(name: str) -> Shape:
    """A mesh of `instruments`, turned so that its shaft goes along z; its edges are sharp."""
    mesh = palpate.read_mesh(DRAWN / f"{name}.obj")
    vertices = np.asarray(mesh.vertices) * np.array([1.0, -1.0, -1.0])
    return sharpen(vertices, np.asarray(mesh.triangles))


def sharpen(x: NDArray[np.float64], triangles: NDArray[np.integer]) -> Shape:
    """Normals that are smooth where a surface is round, and not across its edges.

    A corner's normal is the mean, by area, of the triangles round its vertex that are turned by
    less than SHARP from its own.
    """
    a, b, c = (x[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    unit = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-30)
    corner_vertex, corner_face = triangles.ravel(), np.repeat(np.arange(len(triangles)), 3)
    order = np.argsort(corner_vertex, kind="stable")
    starts = np.searchsorted(corner_vertex[order], np.arange(len(x) + 1))
    normals = np.zeros((len(corner_vertex), 3))
    for vertex in range(len(x)):
        corners = order[starts[vertex] : starts[vertex + 1]]
        faces = corner_face[corners]
        alike = unit[faces] @ unit[faces].T > math.cos(SHARP)
        normals[corners] = alike @ area[faces]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    rows = np.column_stack([corner_vertex, np.round(normals / ROUND)])
    kept, first, inverse = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    del kept
    return Shape(
        x[corner_vertex[first]].astype(np.float32),
        normals[first].astype(np.float32),
        inverse.reshape(-1, 3).astype(np.uint32),
    )
