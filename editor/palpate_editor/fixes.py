# SPDX-License-Identifier: GPL-3.0-or-later
"""Edits that fix a problem, for those that one press of a button can fix."""

from __future__ import annotations

import math

from palpate.scene.scene_parts import FILLED

from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.constants import CHOICES
from palpate_editor.document.cost_rules import LATE
from palpate_editor.document.defaults import FIXED_SHARE, WALL_THICKNESS
from palpate_editor.document.fit_rules import find_wrong_constant
from palpate_editor.document.material_rules import EDGES_PER_RADIUS, GRAVITY
from palpate_editor.document.organ_sizes import find_fitting_unit
from palpate_editor.document.problems import Facts, Problem
from palpate_editor.document.rules import find_organ_word
from palpate_editor.edits import (
    CapHoles,
    CutCrowdedEdges,
    CutDisagreement,
    DecimateTo,
    Edit,
    FixLowest,
    KeepLargestShell,
    KeepOuter,
    RemoveCrossings,
    SetChoice,
    SetConstant,
    SetFineRegion,
    SetGravity,
    SetReach,
    SetTask,
    SetUnit,
    SetUp,
    TurnOutward,
    UniteShells,
)
from palpate_editor.edits.orient import METRES
from palpate_editor.far_field import SolveFarField

SIMULATED = 5000
"""Vertices that a surface is decimated to that has more than can be simulated."""
AWAY = 0.1
"""[-] of an admissible range: how far from its end a corrected constant is put."""


def find_fix(problem: Problem, organ: Organ, facts: Facts) -> Edit | None:
    """An edit that fixes the problem, where one is sure to."""
    source, surface = organ.source, facts.surface
    if problem.key == "unit_guessed" and source is not None:
        return SetUnit(source.unit)
    if problem.key == "up_guessed" and source is not None:
        return SetUp(source.up)
    if problem.key == "size" and source is not None and surface is not None:
        diagonal = surface.diagonal / METRES[source.unit]
        unit = find_fitting_unit(diagonal, find_organ_word(organ))
        return None if unit is None else SetUnit(unit)
    if problem.key == "small_tip" and surface is not None:
        # to the next tenth of a millimetre
        radius = 1e-4 * math.ceil(1e4 * EDGES_PER_RADIUS * surface.mean_edge)
        return SetConstant("tool", "radius", radius)
    if problem.key == "open_solid" and organ.model.kind in FILLED:
        return CapHoles(even=True, bent=True)
    if problem.key == "constant":
        part, field = problem.where.split(".")
        return SetConstant(part, field, getattr(getattr(EMPTY, part), field))
    if problem.key == "choice":
        return SetChoice(problem.where.removeprefix("model."), CHOICES[problem.where][0])
    if problem.key == "indefinite" and facts.tissue is not None:
        wanted = move_inside(organ.model.stretch_coupling, *(facts.tissue.coupling_range or (0, 0)))
        return SetConstant("model", "stretch_coupling", wanted)
    if problem.key in ("hard_constant", "blown") and facts.tissue is not None:
        trial = facts.tissue.trial
        found = facts.tissue.nearest if problem.key == "hard_constant" else trial and trial.blown
        return None if not found else SetConstant(*found.key.split("."), found.limit)
    if problem.key == LATE:
        wrong = find_wrong_constant(facts.tissue)
        return None if wrong is None else SetConstant(*wrong.key.split("."), wrong.limit)
    if problem.key == "low_rate":
        return SetConstant("hand", "rate", EMPTY.hand.rate)
    if problem.key == "gravity":
        size = math.hypot(*organ.hand.gravity)
        x, y, z = (GRAVITY * each / size for each in organ.hand.gravity)
        return SetGravity((x, y, z))
    if problem.key == "no_title" and organ.name.strip():
        return SetTask(scenario_title=organ.name)
    if problem.key in ("crossing", "self_intersections") and surface is not None:
        if problem.key == "crossing" and surface.largest_crosses is False:
            return KeepLargestShell()
        if surface.can_be_united:
            return UniteShells(problem.key)
        return RemoveCrossings() if surface.is_manifold else None
    return {
        "non_manifold": CutCrowdedEdges(),
        "one_sided": CutDisagreement(),
        "inward": TurnOutward(),
        "inner": KeepOuter(),
        "too_many": DecimateTo(SIMULATED, features=True),
        "shells": KeepLargestShell(),
        "open_solid": SetConstant("material", "wall_thickness", WALL_THICKNESS),
        "loose": FixLowest(FIXED_SHARE),
        "reach": SetReach(""),
        "fine_region": SetFineRegion(""),
        "far_field": SolveFarField(),
        "locking": SetConstant("fill", "nodal_share", EMPTY.fill.nodal_share),
        "coarse_contact": SetChoice("contact_law", "near_field"),
        "springs_poisson": SetChoice("kind", "molecular"),
    }.get(problem.key)


def move_inside(value: float, low: float, high: float) -> float:
    """The number closest to `value` that keeps away from the ends of an admissible range."""
    width = high - low if math.isfinite(high - low) else abs(high if value >= high else low)
    return high - AWAY * width if value >= high else low + AWAY * width
