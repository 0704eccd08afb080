# SPDX-License-Identifier: BSD-3-Clause
"""The meshes of the instruments that ship, in the frame of a tool: z from the tip to the hand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import palpate
from palpate.render.shapes import Shape, sharpen

DRAWN = Path(__file__).with_name("instruments")
"""Copies of meshes/published/tools, which `./run meshes` writes."""


@dataclass(frozen=True)
class MeshPart:
    """A part of an instrument, its jaws closed."""

    name: str
    turns: float = 0.0
    """[-] The sense in which it opens about the hinge's x: 1, -1, or 0 for what stays."""
    dark: bool = False
    """Whether it is insulated, as shafts are."""


@dataclass(frozen=True)
class Optics:
    """Of a rigid laparoscope: 30 degrees off its shaft, in the frame of a tool, from the tip of the
    mesh."""

    at: tuple[float, float, float] = (0.0, 0.0, 2.9e-3)
    """[m] Of the lens."""
    axis: tuple[float, float, float] = (0.0, 0.5, -0.8660254037844386)
    up: tuple[float, float, float] = (0.0, -0.8660254037844386, -0.5)
    """Unit vectors, where it looks and what it shows above."""
    field_of_view: float = 1.22
    """[rad]"""


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
    optics: Optics | None = None


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
    "laparoscope": InstrumentMesh(
        (MeshPart("laparoscope_shaft"),), radius=5e-3, tip=8.8e-3, optics=Optics()
    ),
}


@cache
def read_part(name: str) -> Shape:
    """A mesh of `instruments`, turned so that its shaft goes along z; its edges are sharp."""
    mesh = palpate.read_mesh(DRAWN / f"{name}.obj")
    vertices = np.asarray(mesh.vertices) * np.array([1.0, -1.0, -1.0])
    return sharpen(vertices, np.asarray(mesh.triangles))
