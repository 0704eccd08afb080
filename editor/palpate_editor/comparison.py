# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds that no shipped organ is of: they stand below a line, each with its error."""

from __future__ import annotations

import palpate
from palpate.scene.scene_parts import FINITE, KINDS
from palpate.scene.tick_cost import SUBSTEP_COST
from palpate.study.findings import find_span

from palpate_editor.document.phrase import Phrase, phrase

FRONT_KINDS = ("solid", "shell")
"""Those of the shipped organs that give way."""
COMPARED_KINDS = tuple(kind for kind in KINDS if kind not in FRONT_KINDS)
SOLIDS, WALLS = ("spleen", "kidney", "liver"), ("gallbladder", "stomach")
"""Bodies of the accuracy study: shipped organs of two to three thousand tetrahedra, and walls."""
STUDIED = {
    "mass_spring": "surface springs (MSS)",
    "molecular": "surface molecules (MMS), exact",
    "linear_solid": "linear solid, 0.9 nodal",
}
"""Model kind -> what the accuracy study calls it."""


def say_error(kind: str) -> Phrase | None:
    """What is wrong with a kind that is for comparison; None for the others."""
    if kind in FRONT_KINDS:
        return None
    if kind in FINITE:
        return phrase(
            "not yet among the kinds that the accuracy study holds against finite elements, and "
            "{times:.0f} times the time of springs and volumes",
            times=SUBSTEP_COST[kind] / SUBSTEP_COST["solid"],
        )
    solid = find_span(STUDIED[kind], SOLIDS, (None,))
    if kind == "linear_solid":
        return phrase(
            "for presses of up to {share:.0%} of the thickness alone, and {least:.0f} to "
            "{most:.0f} % too stiff under a small patch",
            share=palpate.SHALLOW,
            least=100.0 * (solid.least_mean - 1.0),
            most=100.0 * (solid.most_mean - 1.0),
        )
    wall = find_span(STUDIED[kind], WALLS, (None,))
    return phrase(
        "a surface by itself has {solid_least:.0f} to {solid_most:.0f} % of a solid organ's force "
        "and {wall_least:.0f} to {wall_most:.0f} % of a hollow one's, unless home springs or "
        "constants are chosen to hold it up",
        solid_least=100.0 * solid.least_mean,
        solid_most=100.0 * solid.most_mean,
        wall_least=100.0 * wall.least_mean,
        wall_most=100.0 * wall.most_mean,
    )
