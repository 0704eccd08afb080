# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of tissue that a material can be built as, and what each cannot represent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from math import ceil
from pathlib import Path

import numpy as np
import palpate
from palpate.command.verb import Report
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import MaterialPart
from palpate.study.findings import find_span

from palpate_editor.check import compare_with_wall, split_refusal
from palpate_editor.comparison import SOLIDS, STUDIED, say_error
from palpate_editor.compile import build_organ
from palpate_editor.document import Organ
from palpate_editor.document.constants import SURFACES
from palpate_editor.document.problems import WallFit

EXACT = 1e-6
"""[-] An error below this is rounding."""
LINE = "--- for comparison: kinds of no organ that ships ---"
PRESSES = (0.03, 0.08, 0.15)
"""Of the thickness: its deep presses."""
SURFACE_KINDS = {kind: STUDIED[kind] for kind in SURFACES} | {"shell": "shell of prisms"}
"""Model kind -> what the study calls it."""
VOLUME_KINDS = {
    0.0: "springs + volumes, each",
    0.9: "springs + volumes, 0.9 nodal",
    1.0: "springs + volumes, nodal",
}
"""Nodal share -> what the study calls it; the last was not pressed deep."""
LINEAR_KIND, LINEAR_SHARE = STUDIED["linear_solid"], 0.9


@dataclass(frozen=True)
class Kind:
    """One way to build a tissue from a material."""

    name: str
    title: str
    model: dict[str, str]
    """What stands in the model part."""
    find_limits: Callable[[Organ, palpate.TissueModel, WallFit | None], Iterator[str]]


def compute_bending(material: MaterialPart) -> float:
    """[N·m] D = E h³/(12 (1 - nu²)) of the wall."""
    assert material.wall_thickness is not None
    nu = material.poisson_ratio
    return material.young_modulus * material.wall_thickness**3 / (12.0 * (1.0 - nu**2))


def find_stretch_limits(organ: Organ, wall: WallFit | None) -> Iterator[str]:
    if wall is None or wall.error < EXACT:
        return
    yield (
        f"stretching: behaves like nu = {wall.poisson_ratio:.3f} and E = "
        f"{1e-3 * wall.young_modulus:.4g} kPa, not nu = {organ.material.poisson_ratio:g} and E = "
        f"{1e-3 * organ.material.young_modulus:g} kPa; by direction and place "
        f"{wall.least:.2f} to {wall.most:.2f} times as stiff; error {100.0 * wall.error:.2g} %"
    )


def find_membrane_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    yield from find_stretch_limits(organ, wall)
    bending = 1e3 * compute_bending(organ.material)
    home = float(np.sum(tissue.home)) if len(tissue.home) else 0.0
    instead = f"home springs of {home:.3g} N/m in all stand for it" if home else "nothing does"
    yield f"bending: the wall's {bending:.3g} mN·m are missing; {instead}"
    yield "what is inside: contents are a pressure that does not know their volume"


def find_spring_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    yield from find_membrane_limits(organ, tissue, wall)
    yield "being turned inside out: lengths are the same in the mirror"


def find_molecular_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    yield from find_membrane_limits(organ, tissue, wall)
    negative = int((np.asarray(tissue.bonds.stiffness) < 0.0).sum())
    note = f" ({negative} of {len(tissue.bonds.ends)} bonds negative)" if negative else ""
    exact = (
        "exact at rest, linear in lengths" if wall is not None and wall.error < EXACT else "near"
    )
    yield f"large stretches: {exact}{note}; tissue stiffens, this does not"
    yield "being turned inside out: lengths and angles are the same in the mirror"


def find_shell_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    del tissue
    yield from find_stretch_limits(organ, wall)
    yield "what is inside: contents are a pressure that does not know their volume"
    yield "being pressed thin: the wall's thickness resists as springs, without Poisson's ratio"


def find_solid_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    del wall
    share = organ.fill.nodal_share
    near = min(VOLUME_KINDS, key=lambda measured: abs(measured - share))
    yield say_mesh_error(len(tissue.volumes.corners), share, near, VOLUME_KINDS[near])
    near = min((0.0, 0.9), key=lambda measured: abs(measured - share))
    yield say_softening(share, near, VOLUME_KINDS[near])
    yield "a Poisson's ratio below 0.25 or above 0.49"


def say_mesh_error(tetrahedra: int, share: float, measured: float, kind: str) -> str:
    found = find_span(kind, SOLIDS, (None,))
    return (
        f"what is smaller than its {tetrahedra} tetrahedra: it is as much too stiff as they are "
        f"too coarse, {say_percents(found.least - 1.0, found.most - 1.0)} under a small patch "
        f"where there are two to three thousand{say_measured(share, measured)} (core/ACCURACY.md)"
    )


def say_softening(share: float, measured: float, kind: str) -> str:
    found = find_span(kind, SOLIDS, PRESSES)
    # elements on the same mesh lock, so that what is averaged looks softer beside them than it is
    lock = ", which lock where the nodal average does not" if measured > 0.0 else ""
    return (
        f"large strains: {say_percents(1.0 - found.most, 1.0 - found.least)} softer than "
        f"neo-Hookean elements of the same mesh{lock}, in a press by up to {max(PRESSES):.0%} of "
        f"the thickness{say_measured(share, measured)} (core/ACCURACY.md)"
    )


def say_percents(low: float, high: float) -> str:
    return f"{100.0 * low:.0f} to {100.0 * high:.0f} %"


def say_measured(share: float, measured: float) -> str:
    return "" if share == measured else f", measured at a nodal share of {measured:g}"


def find_linear_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    del wall
    size, share = palpate.measure_response(tissue), organ.fill.nodal_share
    deep = find_span(LINEAR_KIND, SOLIDS, PRESSES)
    yield (
        f"presses deeper than {palpate.SHALLOW:.0%} of the thickness at the place: up to there it "
        f"is {say_percents(1.0 - deep.most, 1.0 - deep.least)} softer than neo-Hookean elements of "
        f"the same mesh{say_measured(share, LINEAR_SHARE)}; beyond, an alarm stops it"
    )
    yield "being turned: it is strained by rotation, so only a body that is held is one"
    yield "swinging: it follows its loads in the time of its damping, without inertia"
    yield say_mesh_error(len(tissue.elastic.corners), share, LINEAR_SHARE, LINEAR_KIND)
    if organ.fill.reach:
        yield f"pushes outside of {organ.fill.reach}: there it does not give"
    yield (
        f"more surface than memory: its response is {1e-6 * size.bytes:.1f} MB of at most "
        f"{1e-6 * palpate.MOST_RESPONSE_BYTES:.1f}"
    )
    yield "a Poisson's ratio below 0.25 or above 0.49"


def find_finite_limits(
    organ: Organ, tissue: palpate.TissueModel, wall: WallFit | None
) -> Iterator[str]:
    del wall
    if organ.model.kind == "corotated_solid":
        yield "large strains: it is linear in its principal stretches, and tissue stiffens"
    yield (
        f"what is smaller than its {len(palpate.list_tetrahedra(tissue))} tetrahedra: under a tool "
        "the near field makes up for them, the rest of it is as stiff as its mesh"
    )
    yield "many tetrahedra: it runs in plain code, at many times the cost of springs"
    yield "a Poisson's ratio below 0.25 or above 0.49"


TISSUE_KINDS = (
    Kind("solid", "solid, springs and volumes", {"kind": "solid"}, find_solid_limits),
    Kind("shell", "shell of prisms", {"kind": "shell"}, find_shell_limits),
    Kind(
        "mass_spring van_gelder",
        "springs, Van Gelder",
        {"kind": "mass_spring", "constants": "tissue", "spring_rule": "van_gelder"},
        find_spring_limits,
    ),
    Kind(
        "mass_spring lloyd",
        "springs, Lloyd",
        {"kind": "mass_spring", "constants": "tissue", "spring_rule": "lloyd"},
        find_spring_limits,
    ),
    Kind(
        "molecular gradient",
        "molecular, exact membrane",
        {"kind": "molecular", "constants": "tissue", "angle_law": "gradient"},
        find_molecular_limits,
    ),
    Kind(
        "molecular eq10",
        "molecular, Eq 10",
        {"kind": "molecular", "constants": "tissue", "angle_law": "eq10"},
        find_molecular_limits,
    ),
    Kind("linear_solid", "linear solid", {"kind": "linear_solid"}, find_linear_limits),
    Kind("corotated_solid", "corotated solid", {"kind": "corotated_solid"}, find_finite_limits),
    Kind(
        "neo_hookean_solid", "neo-Hookean solid", {"kind": "neo_hookean_solid"}, find_finite_limits
    ),
)
"""Every kind whose constants come from tissue, those of shipped organs first."""


def compare_kinds(organ: Organ, file: Path) -> Report:
    """Builds each kind of the organ's material. Raises Refusal where there is no surface."""
    if organ.surface is None:
        raise Refusal(file, "organ", "no surface", "an imported mesh")
    return {
        "material": {
            "young_modulus_Pa": organ.material.young_modulus,
            "poisson_ratio": organ.material.poisson_ratio,
            "density_kg_m3": organ.material.density,
            "damping_ratio": organ.material.damping_ratio,
            "wall_thickness_m": organ.material.wall_thickness,
        },
        "kinds": [build_kind(organ, kind) for kind in TISSUE_KINDS],
    }


def build_kind(organ: Organ, kind: Kind) -> Report:
    built = replace(organ, model=replace(organ.model, **kind.model))
    row: Report = {
        "name": kind.name,
        "title": kind.title,
        "error": say_error(kind.model["kind"]),
        "built": False,
    }
    try:
        tissue = build_organ(built)
    except ValueError as problem:
        where, found, expected = split_refusal(str(problem))
        row["refusal"] = f"{where}: got {found}, expected {expected}"
        row["cannot_represent"] = list(find_refused_limits(built))
        return row
    wall, stable_step = compare_with_wall(built, tissue), palpate.stable_step(tissue)
    return row | {
        "built": True,
        "particles": len(tissue.mass),
        "links": len(tissue.springs.ends) + len(tissue.bonds.ends),
        "substeps": max(1, ceil(1.0 / (organ.hand.rate * stable_step))),
        "stable_step_ms": 1e3 * stable_step,
        "kernel": choose_kernel(tissue),
        "wall": None if wall is None else vars(wall),
        "cannot_represent": list(kind.find_limits(built, tissue, wall)),
    }


def choose_kernel(tissue: palpate.TissueModel) -> str:
    """As build_scene does."""
    if palpate.has_packed_form(tissue):
        return "packed"
    return "response" if len(tissue.elastic.corners) else "reference"


def find_refused_limits(organ: Organ) -> Iterator[str]:
    if organ.material.wall_thickness is None and organ.model.kind in SURFACE_KINDS:
        found = find_span(SURFACE_KINDS[organ.model.kind], SOLIDS, (None,))
        share = say_percents(found.least_mean, found.most_mean)
        yield (
            f"a solid: its surface alone gives {share} of the organ's force, whatever its "
            "constants are (core/ACCURACY.md); a wall needs a thickness"
        )


def describe_kinds(report: Report) -> str:
    front = [row for row in report["kinds"] if row["error"] is None]
    compared = [row for row in report["kinds"] if row["error"] is not None]
    return "\n".join([*map(describe_kind, front), LINE, *map(describe_kind, compared)])


def describe_kind(row: Report) -> str:
    if row["built"] and row["kernel"] == "response":
        head = f"{row['title']}: {row['particles']} particles, from its precomputed response"
    elif row["built"]:
        head = (
            f"{row['title']}: {row['particles']} particles, {row['links']} links, "
            f"{row['substeps']} substeps, stable step {row['stable_step_ms']:.3f} ms, "
            f"{row['kernel']} kernel"
        )
    else:
        head = f"{row['title']}: not built; {row['refusal']}"
    error = [] if row["error"] is None else [f"    its error: {row['error']} (core/ACCURACY.md)"]
    limits = [f"    cannot represent {limit}" for limit in row["cannot_represent"]]
    return "\n".join([head, *error, *limits])
