# SPDX-License-Identifier: GPL-3.0-or-later
"""Which configurations a chart tries of an organ: by counts alone, the same on every machine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import palpate
from palpate.scene.scene_parts import FILLED, FINITE, INTEGRATORS
from palpate.study.scene_chart import Configuration

from palpate_editor.configuration import find_configuration
from palpate_editor.document import Organ
from palpate_editor.document.constants import SURFACES
from palpate_editor.document.defaults import MODEL

TETRAHEDRA = (300, 1000, 3000, 6000)
"""That are asked for, of a solid; those of finite strain, in plain code, to the third."""
VERTICES = (300, 600, 1200, 2400)
"""Of a surface."""
COARSE = 2
"""Meshes of each ladder, from the coarsest, on which every integrator is tried."""
STEPS = (1, 4)
"""Substeps of an implicit integrator, whose steps may be as long as a tick."""
LADDER = 2
"""A second row of the usual integrator has so many times the substeps, to see what they change."""


def list_configurations(organ: Organ) -> list[Configuration]:
    """The organ's own first, then every other once."""
    own = find_configuration(organ)
    if own.kind in SURFACES and own.constants == "chosen":
        chosen = own
    else:
        names = ("stiffness", "bend_stiffness", "stretch_coupling", "home_stiffness")
        chosen = replace(own, **{name: getattr(MODEL, name) for name in names})
    base = replace(chosen, integrator=INTEGRATORS[0], substeps=0, vertices=0, tetrahedra=0)
    hollow = organ.material.wall_thickness is not None
    first, second = (list_surfaces, list_solids) if hollow else (list_solids, list_surfaces)
    return list(dict.fromkeys([own, *first(base, organ, True), *second(base, organ, False)]))


def list_solids(base: Configuration, organ: Organ, fitting: bool) -> Iterator[Configuration]:
    """Solids; of a hollow organ, which they fill, the near field alone."""
    for kind in FILLED:
        ladder = TETRAHEDRA[:3] if kind in FINITE else TETRAHEDRA
        for count in ladder if fitting else ladder[1:3]:
            for law in ("near_field", "hard") if fitting else ("near_field",):
                yield replace(
                    base, kind=kind, constants="tissue", contact_law=law, tetrahedra=count
                )
    if fitting:
        for count in TETRAHEDRA[:COARSE]:
            solid = replace(base, kind="solid", constants="tissue", tetrahedra=count)
            yield from list_steps(replace(solid, contact_law="near_field"))
        linear = replace(base, kind="linear_solid", constants="tissue", contact_law="near_field")
        for count in TETRAHEDRA[:COARSE]:
            yield replace(linear, tetrahedra=count, integrator="runge_kutta_4")


def list_surfaces(base: Configuration, organ: Organ, fitting: bool) -> Iterator[Configuration]:
    """Springs, molecules and prisms; those with constants from tissue need a wall, and are refused
    without one, so they are tried once."""
    surface = replace(base, contact_law="hard")
    for kind in ("shell", *SURFACES):
        for count in VERTICES if fitting else VERTICES[1:2]:
            yield replace(surface, kind=kind, constants="tissue", vertices=count)
    for kind in SURFACES:
        for count in VERTICES:
            yield replace(surface, kind=kind, constants="chosen", vertices=count)
    coarse = VERTICES[:COARSE]
    for count in coarse:
        kinds = ("shell", "mass_spring") if fitting else ("mass_spring",)
        for kind in kinds:
            constants = "tissue" if fitting else "chosen"
            yield from list_steps(replace(surface, kind=kind, constants=constants, vertices=count))


def list_steps(configuration: Configuration) -> Iterator[Configuration]:
    """One configuration under every integrator that there is; an implicit one at several steps."""
    for name, integrator in palpate.Integrator.__members__.items():
        if name == INTEGRATORS[0]:
            continue
        for substeps in STEPS if palpate.is_implicit(integrator) else (0,):
            yield replace(configuration, integrator=name, substeps=substeps)
