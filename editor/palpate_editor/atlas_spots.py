# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tissues an atlas tries of an organ, and how the organ becomes one of them."""

from __future__ import annotations

from dataclasses import replace

import palpate
from palpate.scene.scene_file import relax
from palpate.scene.scene_parts import EXPLICIT, FILLED, INTEGRATORS
from palpate.study.atlas import DAMPINGS, MESHES, OWN, Spot

from palpate_editor.compile import build_organ
from palpate_editor.configuration import apply_configuration, find_configuration
from palpate_editor.configurations import choose_constants, count_imported
from palpate_editor.document import Organ, phrase
from palpate_editor.document.constants import SURFACES
from palpate_editor.edits import EditError

STIFFNESS = (0.01, OWN, 100.0)
"""[-] times the organ's own ..."""
ENDS = (OWN, 100.0)
"""... and on the coarser mesh."""
IMPLICIT = tuple(name for name in INTEGRATORS if name not in EXPLICIT)
SIZES = dict(zip(MESHES, (0.5, 1.0, 2.0), strict=True))
"""[-] times the tetrahedra or vertices that the organ has."""
CRITICAL = 1.0
"""[-] The damping ratio of a link that is damped critically."""


Point = tuple[Spot, tuple[str, ...]]
"""A tissue, and the integrators that it is run under."""


def list_points(organ: Organ) -> list[Point]:
    """The organ as it is, and other stiffness, damping and meshes around it, of every kind.

    What is implicit takes a hundred times longer and never breaks: it is run on the coarser mesh.
    """
    kinds = list_kinds(organ)
    own = kinds[0]
    spots = [Spot(own, s, "own", "own") for s in STIFFNESS]
    spots += [Spot(own, OWN, damping, "own") for damping in DAMPINGS]
    spots += [Spot(own, OWN, "own", mesh) for mesh in MESHES]
    spots += [Spot(kind, OWN, "own", "own") for kind in kinds[1:]]
    spots += [Spot(kind, s, "own", "half") for kind in kinds for s in ENDS]
    spots += [Spot(kind, OWN, damping, "half") for kind in kinds for damping in DAMPINGS]
    ordered = sorted(dict.fromkeys(spots), key=lambda spot: (kinds.index(spot.kind), spot.mesh))
    return [(spot, EXPLICIT + (IMPLICIT if is_solved(spot, own) else ())) for spot in ordered]


def is_solved(spot: Spot, own: str) -> bool:
    """Whether a tissue is run under implicit integrators too: where the organ's own stiffness and
    damping are, and of its own kind also where nothing is damped."""
    as_is = (spot.mesh, spot.stiffness, spot.damping) == ("half", OWN, "own")
    undamped = (spot.mesh, spot.stiffness, spot.damping) == ("half", OWN, "none")
    return as_is or (undamped and spot.kind == own)


def list_kinds(organ: Organ) -> list[str]:
    """That the organ can have, its own first: a wall has prisms, everything can be springs,
    molecules, or filled."""
    wall = () if organ.material.wall_thickness is None else ("shell",)
    return list(dict.fromkeys((organ.model.kind, *wall, *SURFACES, *FILLED)))


def make_organ(organ: Organ, spot: Spot) -> Organ:
    """The organ as a spot says. Raises EditError where it cannot be so."""
    return damp(stiffen(change_kind(resize(organ, spot.mesh, spot.kind), spot.kind), spot), spot)


def resize(organ: Organ, mesh: str, kind: str) -> Organ:
    """With more or fewer tetrahedra, where the kind has any; else vertices. Raises EditError."""
    if SIZES[mesh] == 1.0:
        return organ
    if kind in FILLED:
        if organ.filling is not None:
            raise EditError(phrase("Its tetrahedra came with its file, and stay as they are."))
        count = round(SIZES[mesh] * organ.fill.tetrahedra)
        return replace(organ, fill=replace(organ.fill, tetrahedra=count))
    count = round(SIZES[mesh] * organ.vertex_count)
    most = count_imported(organ)
    if count > most:
        raise EditError(
            phrase("Its surface came with {most} vertices, and {count} cannot be made of them.",
                   most=most, count=count)
        )  # fmt: skip
    # a table is of the surface that it was solved for
    own = replace(find_configuration(organ), vertices=count, far_field="mesh")
    return apply_configuration(organ, own)


def change_kind(organ: Organ, kind: str) -> Organ:
    """With constants from tissue where a wall or a filling gives them, else with chosen ones."""
    if kind == organ.model.kind:
        return organ
    own = find_configuration(organ)
    count = organ.fill.tetrahedra if kind in FILLED else 0
    wanted = replace(own, kind=kind, constants="tissue", tetrahedra=count, far_field="mesh")
    if kind not in FILLED:
        wanted = replace(wanted, contact_law="hard")
        if organ.material.wall_thickness is None:
            wanted = choose_constants(wanted)
    return apply_configuration(replace(organ, far_field=None), wanted)


def stiffen(organ: Organ, spot: Spot) -> Organ:
    """Every constant that says how stiff it is, by the same factor."""
    if spot.stiffness == OWN:
        return organ
    material, model, factor = organ.material, organ.model, spot.stiffness
    home = model.home_stiffness
    return replace(
        organ,
        material=replace(material, young_modulus=factor * material.young_modulus),
        model=replace(
            model,
            stiffness=factor * model.stiffness,
            bend_stiffness=factor * model.bend_stiffness,
            stretch_coupling=factor * model.stretch_coupling,
            home_stiffness=None if home is None else factor * home,
        ),
    )


def damp(organ: Organ, spot: Spot) -> Organ:
    """Without any damping, as it is, or with links that are damped critically."""
    if spot.damping == "own":
        return organ
    ratio = 0.0 if spot.damping == "none" else CRITICAL
    model = organ.model
    if spot.damping == "none":
        model = replace(model, drag=0.0, relaxation=0.0)
    return replace(organ, material=replace(organ.material, damping_ratio=ratio), model=model)


def build_tissue(organ: Organ, spot: Spot) -> palpate.TissueModel:
    """The tissue that a scene of it would have. Raises EditError or ValueError."""
    made = make_organ(organ, spot)
    return relax(build_organ(made), made.model)
