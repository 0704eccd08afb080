# SPDX-License-Identifier: BSD-3-Clause
"""The meshes of the instruments that ship, in the frame of a tool: z from the tip to the hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import palpate
from palpate.render.shapes import Shape, sharpen
from palpate.render.theme import Colour
from palpate.scene.instrument_kinds import KINDS, read_descriptions

DRAWN = Path(__file__).with_name("instruments")
"""Copies of meshes/published/tools, which `./run meshes` writes."""
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class MeshPart:
    """A part of an instrument, its jaws closed."""

    name: str
    colour: Colour
    turns: float = 0.0
    """[-] The sense in which it opens about the hinge's x: 1, -1, or 0 for what stays."""


@dataclass(frozen=True)
class Optics:
    """Of a rigid laparoscope, in the frame of a tool, from the tip of the mesh."""

    at: Vector
    """[m] Of the lens."""
    axis: Vector
    up: Vector
    """Unit vectors, where it looks and what it shows above."""
    field_of_view: float
    """[rad]"""


@dataclass(frozen=True)
class InstrumentMesh:
    """What stands in `instruments`, and how it lies against what touches."""

    parts: tuple[MeshPart, ...]
    radius: float
    """[m] Of what is as wide as that which touches: its shaft or its needle."""
    tip: float
    """[m] From the tip of the mesh to the end of the axis of what touches first."""
    hinge: float = 0.0
    """[m] From the tip of the mesh to the axis of its jaws; 0: none."""
    jaw_radius: float = 0.0
    """[m] Of the capsules that stand for its jaws."""
    needle: float = 0.0
    """[m] How long it is; 0: none."""
    optics: Optics | None = None


def turn_round(vector: Vector) -> Vector:
    """From the frame of a mesh, whose shaft goes along -z, into that of a tool."""
    x, y, z = vector
    return x, -y, -z


def read_instrument(name: str, table: Mapping[str, Any]) -> InstrumentMesh:
    """By its description (palpate.scene.instrument_kinds)."""
    jaws, needle, camera = (table.get(key, {}) for key in ("jaws", "needle", "camera"))
    turns, first = jaws.get("turns", {}), table["shapes"][0]
    shaft = next((shape for shape in table["shapes"] if shape["part"] == "shaft"), first)
    return InstrumentMesh(
        parts=tuple(
            MeshPart(f"{name}_{part}", tuple(table["colours"][part]), turns.get(part, 0.0))
            for part in table["parts"]
        ),
        radius=shaft["radius"],
        tip=-first["a"][2],
        hinge=-jaws["hinge"][2] if jaws else 0.0,
        jaw_radius=KINDS[name].radius if jaws else 0.0,
        needle=needle.get("length", 0.0),
        optics=Optics(
            *(turn_round(camera[key]) for key in ("at", "axis", "up")), camera["field_of_view"]
        )
        if camera
        else None,
    )


MESHES = {
    name: read_instrument(name, table)
    for name, table in read_descriptions().items()
    if "parts" in table
}


@cache
def read_part(name: str) -> Shape:
    """A mesh of `instruments`, turned so that its shaft goes along z; its edges are sharp."""
    mesh = palpate.read_mesh(DRAWN / f"{name}.obj")
    vertices = np.asarray(mesh.vertices) * np.array([1.0, -1.0, -1.0])
    return sharpen(vertices, np.asarray(mesh.triangles))
