# SPDX-License-Identifier: GPL-3.0-or-later
"""What a tick of a solid will cost, before as many tetrahedra as were asked for are made."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil

import palpate
from palpate.scene.scene_parts import FILLED
from palpate.scene.tick_cost import LONGEST_TICK, estimate_tick

from palpate_editor.compile import build_organ
from palpate_editor.document import Organ
from palpate_editor.edits.own_filling import find_own_filling

FORESEEN_FROM = 10_000
"""Tetrahedra: fewer are made and judged in seconds."""
COARSE = 1000
"""Tetrahedra of the filling that many more are judged by, in a second."""


@dataclass(frozen=True)
class TooSlow:
    """A solid that no machine of today would tick in time."""

    substeps: int
    share: float
    """[-] of a tick in touch, on the reference machine."""
    most: int
    """Tetrahedra at which it would be just too slow."""

    @property
    def got(self) -> str:
        return (
            f"about {self.substeps} steps a tick in touch and {self.share:.0%} of the time there "
            f"is, judged by a filling of {COARSE}"
        )


def foresee_too_slow(organ: Organ) -> TooSlow | None:
    """None where it may do, and where it is soon known.

    The longest stable step goes as the size of tetrahedra, and that as one over the cube root of
    their number; in touch there are no fewer steps than at rest. Raises ValueError for what cannot
    be filled.
    """
    kind, asked = organ.model.kind, organ.fill.tetrahedra
    if kind not in FILLED or kind == "linear_solid" or asked < FORESEEN_FROM:
        return None
    if find_own_filling(organ) is not None or organ.model.integrator != "symplectic_euler":
        return None
    coarse = build_organ(replace(organ, fill=replace(organ.fill, tetrahedra=COARSE)))
    finer = (asked / max(1, len(palpate.list_tetrahedra(coarse)))) ** (1.0 / 3.0)
    substeps = ceil(finer / (organ.hand.rate * palpate.stable_step(coarse)))
    tick = estimate_tick(kind, asked, substeps)
    if tick is None or tick * organ.hand.rate <= LONGEST_TICK:
        return None
    share = tick * organ.hand.rate
    return TooSlow(substeps, share, int(asked * (LONGEST_TICK / share) ** 0.75))
