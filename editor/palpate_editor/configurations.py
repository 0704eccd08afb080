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
from palpate_editor.document.constants import CHOICES, SURFACES
from palpate_editor.document.defaults import MODEL

TETRAHEDRA = (300, 600, 1000, 2000, 3000, 5000)
"""That are asked for, of a solid; a linear one has room for 6000, and a tenth more may come; ..."""
MOST_FINITE = 1000
"""... those of finite strain, which run in plain code, up to here."""
VERTICES = (300, 450, 600, 900, 1200, 2400)
"""Of a surface."""
STEPPED = (300, 1000), (300, 600)
"""Tetrahedra and vertices under every integrator; those that solve Newton's equations on the first
alone, where a path takes a minute and not many."""
ANGLE_LAWS = CHOICES["model.angle_law"]
NEWTON = ("implicit_euler", "implicit_midpoint")
SUBSTEPS = (24, 48)
"""Of a tick at least, under the usual integrator: beyond the tissue's need, to see what it buys."""


def list_configurations(organ: Organ) -> list[Configuration]:
    """The organ's own first, then every other once; of meshes no finer than what was imported."""
    own = find_configuration(organ)
    base = replace(own, integrator=INTEGRATORS[0], substeps=0, vertices=0, tetrahedra=0)
    hollow = organ.material.wall_thickness is not None
    first, second = (list_surfaces, list_solids) if hollow else (list_solids, list_surfaces)
    found = dict.fromkeys([own, *first(base, True), *second(base, False)])
    return [c for c in found if c.vertices <= count_imported(organ)]


def count_imported(organ: Organ) -> int:
    """Vertices that a surface can be decimated from."""
    return 0 if organ.imported is None else len(organ.imported.vertices)


def list_solids(base: Configuration, fitting: bool) -> Iterator[Configuration]:
    """Solids; of a hollow organ, which they fill, the near field alone."""
    for kind in FILLED:
        most = MOST_FINITE if kind in FINITE else TETRAHEDRA[-1]
        for count in [n for n in TETRAHEDRA if n <= most] if fitting else STEPPED[0][1:]:
            one = replace(base, kind=kind, constants="tissue", tetrahedra=count)
            near = replace(one, contact_law="near_field")
            yield near
            if near.far_field == "fine":
                yield replace(near, far_field="mesh")
            if fitting:
                yield replace(one, contact_law="hard", far_field="mesh")
    if not fitting:
        return
    solid = replace(base, kind="solid", constants="tissue", contact_law="near_field")
    for row, count in enumerate(STEPPED[0]):
        yield from list_steps(replace(solid, tetrahedra=count), row == 0)
        linear = replace(solid, kind="linear_solid", tetrahedra=count)
        yield replace(linear, integrator="runge_kutta_4")
    for substeps in SUBSTEPS:
        yield replace(solid, tetrahedra=3000, substeps=substeps)


def list_surfaces(base: Configuration, fitting: bool) -> Iterator[Configuration]:
    """Springs, molecules and prisms; those with constants from tissue need a wall, and are refused
    without one, so they are tried once."""
    surface = replace(base, contact_law="hard", far_field="mesh")
    for kind in ("shell", *SURFACES):
        for count in VERTICES if fitting else STEPPED[1][1:]:
            tissue = replace(surface, kind=kind, constants="tissue", vertices=count)
            yield tissue
            if fitting and kind == "shell":
                yield replace(tissue, contact_law="near_field")
            if fitting and kind == "mass_spring":
                yield replace(tissue, spring_rule="lloyd")
            if fitting and kind == "molecular":
                yield replace(tissue, angle_law="eq10")
    chosen = choose_constants(surface)
    for count in VERTICES:
        yield replace(chosen, kind="mass_spring", vertices=count)
        for law in ANGLE_LAWS:
            molecular = replace(chosen, kind="molecular", angle_law=law, vertices=count)
            # Eq 10 has no stretch-bend force
            yield replace(molecular, stretch_coupling=0.0) if law == "eq10" else molecular
    kinds = {"shell": "tissue", "mass_spring": "tissue"} if fitting else {"mass_spring": "chosen"}
    for kind, constants in kinds.items():
        one = replace(surface if constants == "tissue" else chosen, kind=kind, constants=constants)
        for row, count in enumerate(STEPPED[1]):
            # a shell's Newton takes minutes
            yield from list_steps(replace(one, vertices=count), row == 0 and kind != "shell")
        for substeps in SUBSTEPS:
            yield replace(one, vertices=STEPPED[1][1], substeps=substeps)


def choose_constants(configuration: Configuration) -> Configuration:
    """The organ's own where it has chosen ones, else those of a new organ."""
    if configuration.kind in SURFACES and configuration.constants == "chosen":
        return configuration
    names = ("stiffness", "bend_stiffness", "stretch_coupling", "home_stiffness")
    values = {name: getattr(MODEL, name) for name in names}
    return replace(configuration, constants="chosen", **values)


def list_steps(configuration: Configuration, coarsest: bool) -> Iterator[Configuration]:
    """One configuration under every other integrator that there is."""
    for name in palpate.Integrator.__members__:
        if name != INTEGRATORS[0] and (coarsest or name not in NEWTON):
            yield replace(configuration, integrator=name)
