# SPDX-License-Identifier: GPL-3.0-or-later
"""One body on meshes from coarse to fine: what is felt of each kind of tissue, and its cost."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import palpate
from palpate.runs.press import Place, find_place
from palpate.runs.trial import DEPTH, LONG_HOLD, LONG_MEAN, press_places
from palpate.scene.scene_parts import FILLED, FillPart, MaterialPart, ModelPart, ToolPart
from palpate.study.felt import HARD, NEAR, CostRow, measure_touch
from palpate_meshes.generate import ellipsoid

from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.edits import FixLowest

RADII = (50e-3, 35e-3, 30e-3)
"""[m]"""
MATERIAL = MaterialPart(young_modulus=10e3, poisson_ratio=0.45)
WALL = 5e-3
"""[m] of springs and prisms, which are walls; a solid is full."""
TIP, HELD = 7e-3, 0.2
"""[m] of the ball; [-] of the height that is held."""
PLACES = {"top": (0.0, 0.0, 1.0), "side": (1.0, 0.0, 0.1), "shoulder": (0.6, 0.5, 0.62)}
VERTICES = (300, 600, 1200, 2400)
PER_VERTEX = 5
"""Tetrahedra of a solid that are asked for."""
MESH_KINDS = (("mass_spring", HARD), ("shell", HARD), ("solid", HARD), ("solid", NEAR))
COST_KINDS = (*MESH_KINDS, ("linear_solid", HARD), ("linear_solid", NEAR))
COST_VERTICES = 600


@dataclass(frozen=True)
class MeshRow:
    """A kind on a mesh; the mean of the places."""

    kind: str
    law: str
    vertices: int
    tetrahedra: int
    felt: float
    """[N] that the hand feels, pressed as a check presses."""


def make_ellipsoid(kind: str, law: str, vertices: int) -> Organ:
    """The same body, constants from its tissue."""
    surface = Surface(*ellipsoid(vertices, RADII, bow=0.0, hollow=0.0, notches=0.0))
    wall = None if kind in FILLED else WALL
    contact = "near_field" if law == NEAR else "hard"
    organ = replace(
        EMPTY.with_surface(surface),
        material=replace(MATERIAL, wall_thickness=wall),
        model=ModelPart(kind=kind, constants="tissue", contact_law=contact),
        fill=FillPart(PER_VERTEX * vertices, sizing="estimated"),
        tool=ToolPart(radius=TIP),
    )
    return FixLowest(HELD)(organ)


def press_meshes(vertices: tuple[int, ...] = VERTICES) -> list[MeshRow]:
    """Every kind on every mesh."""
    return [press_mesh(kind, law, count) for kind, law in MESH_KINDS for count in vertices]


def press_mesh(kind: str, law: str, vertices: int) -> MeshRow:
    scene = compile_organ(make_ellipsoid(kind, law, vertices))
    found = press_places(scene, list_places(scene), LONG_HOLD, DEPTH, LONG_MEAN)
    tetrahedra = len(palpate.list_tetrahedra(scene.bodies[0].tissue))
    felt = float(np.mean([trial.force for trial in found]))
    return MeshRow(kind, law, vertices, tetrahedra, felt)


def list_places(scene: palpate.Scene) -> list[Place]:
    """The same places of the body on every mesh, to the width of a triangle."""
    return [
        find_place(scene, np.array(toward) * RADII / np.linalg.norm(toward))
        for toward in PLACES.values()
    ]


def measure_costs() -> list[CostRow]:
    """A tick in touch over one in the air, of every kind."""
    return [
        measure_touch(kind, compile_organ(make_ellipsoid(kind, law, COST_VERTICES)))
        for kind, law in COST_KINDS
    ]
