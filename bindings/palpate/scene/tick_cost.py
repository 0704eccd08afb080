# SPDX-License-Identifier: BSD-3-Clause
"""What a tick in touch costs, and how many substeps it has time for: by counts, not by a clock."""

from __future__ import annotations

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


def estimate_substep(kind: str, count: int) -> float | None:
    """[s] in touch on the reference machine; None for a kind there is not.

    Args:
        kind: As ModelPart has it.
        count: Tetrahedra of a solid, else vertices of the surface.
    """
    if kind == "linear_solid":
        return LINEAR_COST
    each = SUBSTEP_COST.get(kind)
    return None if each is None else each * count


def estimate_tick(kind: str, count: int, substeps: int) -> float | None:
    """[s] in touch on the reference machine, of so many substeps; likewise."""
    each = estimate_substep(kind, count)
    return None if each is None else each * max(SUBSTEPS_IN_CONTACT, substeps)


def count_affordable(kind: str, count: int, rate: float, share: float = TICK_SHARE) -> int:
    """Substeps that take that share of a tick at `rate` [Hz]; 0 for a kind there is not."""
    each = estimate_substep(kind, count)
    return 0 if not each else int(share / (rate * each))
