# SPDX-License-Identifier: BSD-3-Clause
"""The coefficients of friction of instruments that are taken into another scene, or exchanged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from copy import copy

import palpate


def keep_pairs(
    instruments: Iterable[palpate.Instrument], surfaces: Sequence[int] = ()
) -> list[palpate.Instrument]:
    """Copies with their coefficients on some of a scene's surfaces, in the order of
    Instrument.pair_friction; on none, what the tool has is that on all."""
    kept = []
    for instrument in instruments:
        changed = copy(instrument)
        pairs = instrument.pair_friction
        changed.pair_friction = [pairs[index] for index in surfaces] if pairs else []
        kept.append(changed)
    return kept


def exchange_own(instrument: palpate.Instrument, friction: float) -> list[float]:
    """Instrument.pair_friction where its tool has another coefficient: surfaces on which it rubbed
    with its own take that, others keep theirs. None for a tool that slides on everything."""
    own, pairs = instrument.tool.friction, instrument.pair_friction
    if friction == 0.0:
        return []
    return [friction if on_one == own else on_one for on_one in pairs]
