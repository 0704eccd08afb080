# SPDX-License-Identifier: GPL-3.0-or-later
"""A small organ to chart, with a truth from theory: a ball on an elastic layer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from palpate.scene.scene_parts import FillPart, MaterialPart, ModelPart, ToolPart
from palpate.study.half_space import compute_sphere_force
from palpate.study.scene_chart import Configuration
from palpate.study.truth import Truth
from palpate_editor.chart_jobs import Plan, pack_document
from palpate_editor.configuration import find_configuration
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.edits import FixLowest
from palpate_meshes.generate import ellipsoid

RADII = (30e-3, 24e-3, 18e-3)
"""[m]"""
YOUNG, POISSON, BALL = 8e3, 0.45, 6e-3
DEPTHS = (0.5e-3, 1e-3, 1.5e-3, 2e-3)


def make_block() -> Organ:
    """An ellipsoid of 300 tetrahedra."""
    surface = Surface(*ellipsoid(300, RADII, bow=0.0, hollow=0.0, notches=0.0))
    organ = replace(
        EMPTY.with_surface(surface),
        name="ellipsoid",
        title="Ellipsoid",
        imported=surface,
        material=MaterialPart(young_modulus=YOUNG, poisson_ratio=POISSON, damping_ratio=0.3),
        model=ModelPart(kind="solid", constants="tissue"),
        fill=FillPart(300),
        tool=ToolPart(radius=BALL),
    )
    return FixLowest(0.3)(organ)


def make_truth() -> Truth:
    """On its top, as if it were a layer of its height; points of the surface that follow as those
    of a half space do, so far as is needed for a number."""
    count = len(DEPTHS)
    top = np.array([[0.0, 0.0, RADII[2]]])
    points = np.array(make_block().surface.vertices[::10])
    fall = 1.0 / (1.0 + np.linalg.norm(points - top, axis=1) / BALL)
    moved = np.zeros((1, count, len(points), 3))
    moved[0, :, :, 2] = -np.outer(DEPTHS, fall)
    forces = [compute_sphere_force(d, BALL, 2.0 * RADII[2], YOUNG, POISSON) for d in DEPTHS]
    return Truth(
        key="a layer", law="linear", radius=BALL, point=top, direction=np.array([[0.0, 0.0, 1.0]]),
        touch=np.array([BALL]), thickness=np.array([2.0 * RADII[2]]), depth=np.array(DEPTHS),
        force=np.array([forces]), force_error=np.full((1, count), 1e-3),
        contact_radius=np.sqrt(BALL * np.array([DEPTHS])), surface=points, displacement=moved,
        displacement_error=np.full((1, count), 1e-2),
    )  # fmt: skip


def make_plan(organ: Organ | None = None) -> Plan:
    return Plan(
        pack_document(make_block() if organ is None else organ), make_truth(), "press", 0.02
    )


def list_few(organ: Organ) -> list[Configuration]:
    """Five that run and one that is refused."""
    own = find_configuration(organ)
    chosen = replace(own, kind="mass_spring", constants="chosen", contact_law="hard", tetrahedra=0)
    return [
        own,
        replace(own, contact_law="hard"),
        replace(chosen, vertices=200),
        replace(own, kind="neo_hookean_solid"),
        replace(own, integrator="runge_kutta_4"),
        replace(chosen, constants="tissue"),
    ]
