# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about tissue, tool and hand."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from palpate.scene.scene_parts import FILLED, WITH_NEAR_FIELD

from palpate_editor.document.constants import CHOICES, CONSTANTS, SURFACES
from palpate_editor.document.cost_rules import find_least_rate
from palpate_editor.document.fit_rules import find_wrong_constant
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem, TissueFacts
from palpate_editor.document.tissue_rules import find_tissue_problems

EDGES_PER_RADIUS = 0.5
"""[-] A tip much smaller than the triangles it touches feels the mesh, not the tissue."""

RIGID = 1e9
"""[Pa] Stone and bone are stiffer than this and may be held everywhere; no soft tissue is."""


GRAVITY, MOST_GRAVITY = 9.81, 1.1
"""[m/s²] of the Earth, and how many times that is taken without a word."""

MOST_REDUCED = 0.05
"""[-] Of the vertices of a wall that may be nearer to its inner face without a warning."""
POISSON_ERROR = 0.05
"""[-] by which springs may miss a Poisson's ratio."""


def find_material_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    wrong = list(find_constant_problems(organ))
    yield from wrong
    if facts.surface is not None and not facts.surface.is_manifold:
        yield Problem(
            "unsound",
            "error",
            "material",
            "surface",
            phrase("a surface that no tissue can be built on yet"),
            phrase("one without the problems that the Repair stage lists"),
        )
    if facts.surface is None or facts.tissue is None:
        return
    solid = organ.material.wall_thickness is None
    filled = organ.model.kind in FILLED
    if facts.surface.border_loops and (solid or filled):
        yield Problem(
            "open_solid",
            "error",
            "material",
            "material.wall_thickness",
            phrase("a solid with holes"),
            phrase("a closed surface: close it for filling, or make it a wall")
            if filled
            else phrase("a closed surface, or the thickness of its wall"),
        )
    elif facts.tissue.refusal is not None and not wrong and not is_blamed(organ, facts.tissue):
        yield from refuse_tissue(facts.tissue)
    yield from find_tissue_problems(organ)
    yield from find_support_problems(organ)
    yield from find_gravity_problems(organ, facts.tissue)
    yield from find_poisson_problems(organ, facts.tissue)
    yield from find_wall_problems(organ, facts.tissue)
    edge, radius = facts.surface.mean_edge, organ.tool.radius
    near_field = organ.model.kind in WITH_NEAR_FIELD and organ.model.contact_law == "near_field"
    if not near_field and 0.0 < radius < EDGES_PER_RADIUS * edge:
        yield Problem(
            "small_tip",
            "warning",
            "material",
            "tool.radius",
            phrase("{radius:.1f} mm", radius=1e3 * radius),
            phrase("at least half the mean edge of {edge:.1f} mm", edge=1e3 * edge),
        )


def find_constant_problems(organ: Organ) -> Iterator[Problem]:
    for constant in CONSTANTS:
        value = getattr(getattr(organ, constant.part), constant.field)
        if (value is None and constant.optional) or (value is not None and constant.allows(value)):
            continue
        yield Problem(
            "constant",
            "error",
            "material",
            constant.key,
            constant.describe(value),
            constant.describe_range(),
        )
    for key, allowed in CHOICES.items():
        value = getattr(organ.model, key.removeprefix("model."))
        if value not in allowed:
            yield Problem(
                "choice",
                "error",
                "material",
                key,
                phrase("{value}", value=value),
                phrase("one of {allowed}", allowed=", ".join(allowed)),
            )


def is_blamed(organ: Organ, tissue: TissueFacts) -> bool:
    """Whether a constant, or the rate, is told to ask for too many steps."""
    return find_wrong_constant(tissue) is not None or find_least_rate(organ, tissue) is not None


def refuse_tissue(tissue: TissueFacts) -> Iterator[Problem]:
    assert tissue.refusal is not None
    where, found, expected = tissue.refusal
    key = {"fill.reach": "reach", "fill.fine_region": "fine_region"}.get(where, "tissue")
    yield Problem(
        "indefinite" if tissue.coupling_range else key,
        "error",
        "material",
        where,
        phrase("{text}", text=found),
        phrase("{text}", text=expected),
    )


def find_support_problems(organ: Organ) -> Iterator[Problem]:
    """What holds the organ in its place?"""
    rigid = organ.material.young_modulus >= RIGID
    if organ.vertex_count and organ.fixed.all() and not rigid:
        yield Problem(
            "all_fixed",
            "error",
            "material",
            "fixed",
            phrase("every vertex fixed"),
            phrase("some that can move"),
        )
    home = organ.model.home_stiffness
    # a builder's own choice is none for a solid, and for a wall that bends
    none_of_its_own = organ.material.wall_thickness is None or organ.model.kind == "shell"
    no_home = home == 0.0 or (home is None and none_of_its_own)
    no_home |= organ.model.kind in FILLED
    if no_home and organ.fixed.any() and organ.model.kind in SURFACES and not rigid:
        yield from find_hollow_problems(organ)
    if no_home and not organ.fixed.any():
        yield Problem(
            "loose",
            "warning",
            "material",
            "fixed",
            phrase("neither home springs nor fixed vertices"),
            phrase("something that holds the organ in its place"),
        )


def find_hollow_problems(organ: Organ) -> Iterator[Problem]:
    """Of a surface without home springs."""
    if organ.model.pressure != 0.0:
        return
    yield Problem(
        "no_home",
        "warning",
        "material",
        "model.home_stiffness",
        phrase(
            "home springs of 0 N/m in all: a surface of springs has no stiffness across itself and "
            "caves in under the tip"
        ),
        phrase("home springs, a pressure inside, a wall that bends, or a solid"),
    )


def find_gravity_problems(organ: Organ, tissue: TissueFacts) -> Iterator[Problem]:
    size = hypot(*organ.hand.gravity)
    if not size > MOST_GRAVITY * GRAVITY:
        return
    mass = tissue.total_mass or 0.0
    yield Problem(
        "gravity",
        "warning",
        "material",
        "hand.gravity",
        phrase(
            "{size:.4g} m/s², {times:.3g} times that of the Earth: {mass:.4g} g of tissue weigh "
            "{weight:.3g} N",
            size=size,
            times=size / GRAVITY,
            mass=1e3 * mass,
            weight=mass * size,
        ),
        phrase("at most {most:g} m/s², turned to where the organ lies", most=GRAVITY),
    )


def find_poisson_problems(organ: Organ, tissue: TissueFacts) -> Iterator[Problem]:
    """Whether springs are to have a Poisson's ratio that is not theirs."""
    model, nu, wall = organ.model, organ.material.poisson_ratio, tissue.wall
    if model.kind != "mass_spring" or model.constants != "tissue" or wall is None:
        return
    if abs(wall.poisson_ratio - nu) <= POISSON_ERROR:
        return
    yield Problem(
        "springs_poisson",
        "warning",
        "material",
        "material.poisson_ratio",
        phrase(
            "{nu:g}, but springs stretch like {like:.2f}: {least:.2f} to {most:.2f} times as stiff "
            "as the wall, by direction and place",
            nu=nu,
            like=wall.poisson_ratio,
            least=wall.least,
            most=wall.most,
        ),
        phrase(
            "about {like:.2f}, or the molecular model, which can have any", like=wall.poisson_ratio
        ),
    )


def find_wall_problems(organ: Organ, tissue: TissueFacts) -> Iterator[Problem]:
    """Where the inner face of a wall had to come nearer to the outer one."""
    wall = organ.material.wall_thickness
    if wall is None or not tissue.reduced:
        return
    share = len(tissue.reduced) / organ.vertex_count
    yield Problem(
        "reduced_wall",
        "note" if share <= MOST_REDUCED else "warning",
        "material",
        "material.wall_thickness",
        phrase(
            "{wall:g} mm, for which {share:.1%} of the surface bends too closely or has the other "
            "side too near: the wall is {least:.0%} as thick there at least, and bends too easily",
            wall=1e3 * wall,
            share=share,
            least=tissue.least_depth,
        ),
        phrase("a thinner wall, or a surface that is smoother there"),
    )
