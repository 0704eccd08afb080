# SPDX-License-Identifier: BSD-3-Clause
"""How every kind of model responds to the presses of the references, beside the truth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from palpate.study.models import KINDS, SOLID, Built, Kind, compute_volumes, form_of
from palpate.study.reference import Place, Reference, Result
from palpate.study.statics import Unbalanced, follow, respond

REACH = 0.05
"""Of the thickness, from one equilibrium to the next."""


@dataclass(frozen=True)
class Row:
    """One kind at one place."""

    reference: str
    place: str
    kind: str
    depth: float | None
    """Of the thickness, negative for a pull; None for the linear result."""
    force_ratio: float | None
    """[-] to the reference; None where there is no equilibrium."""
    rms: float | None
    """[-] of the displacement of the free surface beside the reference's, of the depth."""
    least_volume: float | None
    """[-] of a tetrahedron, of its volume at rest; None for surfaces and linear results."""
    note: str = ""
    """Why there are no numbers."""


def compare_linear(references: Iterable[Reference], kinds: Iterable[Kind] = KINDS) -> list[Row]:
    """The stiffness at rest of every kind beside linear P2 on the refined mesh."""
    rows = []
    for reference in references:
        built = [(kind, build_or_say(reference, kind)) for kind in kinds]
        for place in reference.places:
            truth = place.find("linear", "P2")
            rows += [same_mesh_row(reference, place, truth), still_row(reference, place, truth)]
            rows += [linear_row(reference, place, kind, organ, truth) for kind, organ in built]
    return rows


def build_or_say(reference: Reference, kind: Kind) -> Built | str:
    """The model, or why this body cannot have one of its kind."""
    try:
        return kind.build(reference)
    except ValueError as problem:
        return str(problem)


def linear_row(
    reference: Reference, place: Place, kind: Kind, organ: Built | str, truth: Result
) -> Row:
    if isinstance(organ, str):
        return Row(reference.name, place.name, kind.name, None, None, None, None, organ)
    unit, stiffness = respond(organ.press(place))
    u = truth.depth * spread(reference, organ, unit)
    return Row(
        reference.name,
        place.name,
        kind.name,
        None,
        stiffness * truth.depth / truth.force,
        find_rms(reference, place, u, truth),
        None,
    )


def spread(reference: Reference, organ: Built, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """Displacements of a model's particles at the rows of a reference; NaN where it has none."""
    rows = organ.particle[reference.surface]
    return np.where(rows[:, None] >= 0, u[rows], np.nan)


def same_mesh_row(reference: Reference, place: Place, truth: Result) -> Row:
    """What is left of linear elasticity itself on a mesh this coarse."""
    plain = place.find("linear", "P1", truth.depth)
    ratio, rms = plain.force / truth.force, find_rms(reference, place, plain.displacement, truth)
    return Row(reference.name, place.name, "finite elements (P1)", None, ratio, rms, None)


def still_row(reference: Reference, place: Place, truth: Result) -> Row:
    """What a surface that does not move at all would score."""
    rms = find_rms(reference, place, np.zeros_like(truth.displacement), truth)
    return Row(reference.name, place.name, "nothing moves", None, 0.0, rms, None)


def find_rms(reference: Reference, place: Place, u: NDArray[np.float64], truth: Result) -> float:
    free = ~np.isin(reference.surface, np.concatenate([reference.held, place.vertices]))
    off = u[free] - truth.displacement[free]
    off = off[np.isfinite(off).all(axis=1)]
    return float(np.sqrt((off**2).sum(axis=1).mean()) / abs(truth.depth))


def compare_deep(references: Iterable[Reference], kinds: Iterable[Kind] = KINDS) -> list[Row]:
    """Kinds at every depth that a reference has, pressed and pulled, beside neo-Hookean elements.

    Solids beside P1 on the same mesh, so that what differs is the law and not the discretisation;
    walls beside P2, because P1 locks where a wall bends.
    """
    return [
        row
        for reference in references
        for kind in kinds
        if kind.deep == form_of(reference)
        for organ in [kind.build(reference)]
        for place in reference.places
        for sign in (1.0, -1.0)
        for row in deep_rows(reference, place, kind, organ, sign)
    ]


def deep_rows(
    reference: Reference, place: Place, kind: Kind, organ: Built, sign: float
) -> list[Row]:
    elements = "P1" if form_of(reference) == SOLID else "P2"
    parts = [p for p in place.list_parts("neo_hookean", elements) if sign * p > 0.0]
    truths = [place.find("neo_hookean", elements, part * place.thickness) for part in parts]
    name = (reference.name, place.name, kind.name)
    depths = [truth.depth for truth in truths]
    found = follow(organ.press(place), depths, REACH * place.thickness)
    rows = []
    for part, truth in zip(parts, truths, strict=True):
        try:
            x, force = next(found)
        except (Unbalanced, StopIteration) as problem:
            note = str(problem) or rows[-1].note
            rows.append(Row(*name, part, None, None, None, note))
            continue
        u = spread(reference, organ, x - np.asarray(organ.model.rest_position))
        rms = find_rms(reference, place, u, truth)
        least = find_least_volume(reference, organ, x)
        rows.append(Row(*name, part, force / truth.force, rms, least))
    return rows


def find_least_volume(reference: Reference, organ: Built, x: NDArray[np.float64]) -> float | None:
    if (organ.particle < 0).any():
        return None
    rest = compute_volumes(reference.vertices, reference.tetrahedra)
    return float((compute_volumes(x[organ.particle], reference.tetrahedra) / rest).min())
