# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about what a tick in touch costs: by counts that no machine changes, not by a clock."""

from __future__ import annotations

from collections.abc import Iterator

from palpate_editor.document.constants import MOST_SUBSTEPS
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem, TissueFacts

TICK_SHARE = 0.7
"""[-] of a tick that may be spent on the tissue; the rest is for the hand and the machine."""
LONGEST_TICK = 4.0
"""[-] of a tick. A machine four times as fast as the reference machine is none of today."""
SUBSTEP_COST = {
    "mass_spring": 10e-9,
    "molecular": 16e-9,
    "shell": 65e-9,
    "solid": 18e-9,
    "corotated_solid": 245e-9,
    "neo_hookean_solid": 185e-9,
}
"""[s] per vertex, or per tetrahedron of a solid, and substep of a tick in touch on the reference
machine: medians of pressed ticks of the shipped organs (palpate.runs.costs.press_costs); of the
last two, which run in plain code, by their ratio to the solid in one process, 13.6 and 10.3."""
LINEAR_COST = 4e-6
"""[s] per substep of a linear solid in touch, whatever its size: it costs by what is touched."""
SUBSTEPS_IN_CONTACT = 3
"""A touched tissue takes at least as many (core/sim/tick/tick.cpp)."""


def compute_tick_share(organ: Organ, facts: Facts) -> float | None:
    """[-] of a tick in touch that this tissue takes on the reference machine, None where there is
    none."""
    tissue = facts.tissue
    if tissue is None or not tissue.substeps:
        return None
    tick = estimate_tick(organ, tissue.tetrahedra, count_substeps(tissue))
    return None if tick is None else tick * organ.hand.rate


def estimate_tick(organ: Organ, tetrahedra: int, substeps: int) -> float | None:
    """[s] in touch on the reference machine, of so many substeps; None for a kind there is not."""
    substeps = max(SUBSTEPS_IN_CONTACT, substeps)
    if organ.model.kind == "linear_solid":
        return LINEAR_COST * substeps
    each = SUBSTEP_COST.get(organ.model.kind)
    return None if each is None else each * (tetrahedra or organ.vertex_count) * substeps


def count_substeps(tissue: TissueFacts) -> int:
    """Per tick in touch."""
    return tissue.substeps if tissue.trial is None else tissue.trial.substeps


def find_cost_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a solid has too many tetrahedra for its time."""
    tissue = facts.tissue
    if tissue is None or not tissue.tetrahedra:
        return
    share = compute_tick_share(organ, facts)
    if share is not None and share > TICK_SHARE:
        yield Problem(
            "slow_solid",
            "warning" if share <= LONGEST_TICK else "error",
            "material",
            "fill.tetrahedra",
            phrase(
                "{count}, {substeps} steps a tick in touch: about {share:.0%} of the time there is",
                count=tissue.tetrahedra,
                substeps=count_substeps(tissue),
                share=share,
            ),
            phrase("at most {share:.0%}: fewer tetrahedra, or a softer tissue", share=TICK_SHARE),
        )


def find_surface_cost_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a surface has too many vertices for its time."""
    tissue, share = facts.tissue, compute_tick_share(organ, facts)
    if tissue is None or tissue.tetrahedra or share is None or share <= TICK_SHARE:
        return
    yield Problem(
        "too_slow",
        "warning" if share <= LONGEST_TICK else "error",
        "decimate",
        "vertices",
        phrase(
            "{count} vertices, {substeps} steps a tick in touch: about {share:.0%} of the time "
            "there is",
            count=organ.vertex_count,
            substeps=count_substeps(tissue),
            share=share,
        ),
        phrase("at most {share:.0%}: fewer vertices, softer links or more mass", share=TICK_SHARE),
    )


def find_substep_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a tick has more steps than one can end in time."""
    del organ
    tissue = facts.tissue
    if tissue is None or count_substeps(tissue) <= MOST_SUBSTEPS:
        return
    yield Problem(
        "too_many_substeps",
        "error",
        "material",
        "substeps",
        phrase(
            "{count} steps a tick, of {step:.2g} us at most",
            count=count_substeps(tissue),
            step=1e6 * (tissue.stable_step or 0.0),
        ),
        phrase(
            "at most {most}: a softer or heavier tissue, less damping or larger triangles",
            most=MOST_SUBSTEPS,
        ),
    )
