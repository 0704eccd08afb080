# SPDX-License-Identifier: BSD-3-Clause
"""How what a view shows takes the light."""

from __future__ import annotations

from palpate.render import Appearance
from palpate.render.theme import FORCE, STEEL

PLAIN = Appearance(gloss=0.55, subsurface=0.3, receives_instruments=True)
# red light creeping round would be read as a value
PAINTED = Appearance(mapped=True, gloss=0.4, subsurface=0.0, receives_instruments=True)
# its shadow is that of InstrumentShade
TOOL = Appearance(STEEL, gloss=1.0, subsurface=0.0, seen_through=True, casts_shadow=False)
# a force that pushes the hand into the organ is read as well
ARROW = Appearance(
    FORCE, gloss=0.3, subsurface=0.0, seen_through=True, ghost=0.75, casts_shadow=False
)
# light beside dark, so that it is seen on whatever is painted, and on what is selected
RING = Appearance(
    (0.97, 0.98, 1.0), gloss=0.0, subsurface=0.0, seen_through=True, casts_shadow=False
)
RIM = Appearance(
    (0.05, 0.06, 0.08), gloss=0.0, subsurface=0.0, seen_through=True, casts_shadow=False
)
