# SPDX-License-Identifier: GPL-3.0-or-later
"""An atlas beside the organ on the desk: where the organ is on it now, without a run.

The limit follows from the rows of the atlas: between two of them along their line, in stiffness
and in damping. It is foretold; what the assessment of the organ says once it is there is exact.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from palpate.scene.scene_parts import FILLED, INTEGRATORS
from palpate.study.atlas import LIMITED, OWN, Atlas, Row
from palpate.study.step_limit import LIMIT_SHARE

from palpate_editor.atlas_spots import CRITICAL
from palpate_editor.document import Organ, Phrase, phrase
from palpate_editor.document.constants import VALUE_NAMES

LINE = ("own", "none", "critical")


@dataclass(frozen=True)
class Mark:
    """Where an organ is on an atlas."""

    stiffness: float
    """[-] times that of the organ as the atlas knows it."""
    step: float
    """[s] Of its scene, with nothing in touch."""
    limit: float | None
    """[s] As it is foretold; None where every step holds."""

    @property
    def margin(self) -> float:
        """[-] How many times longer the step could be."""
        return math.inf if self.limit is None else self.limit / self.step


def find_mark(atlas: Atlas, organ: Organ, known: float | None = None) -> Mark | None:
    """None where the atlas has nothing of this model, or no step of its integrator holds.

    Args:
        atlas: Of this organ, at other constants.
        organ: As it is now.
        known: [s] The limit that was foretold for its very tissue, where that was.
    """
    kind, integrator = organ.model.kind, organ.model.integrator
    factor = find_stiffness(atlas, organ)
    row = atlas.find_usual(kind, integrator)
    if row is None or factor is None:
        return None
    rate, least = organ.hand.rate, max(1, organ.hand.substeps)
    if row.outcome != LIMITED:
        return Mark(factor, 1.0 / (rate * least), None) if row.predicted is None else None
    limit = known if known is not None else foretell(atlas, organ, row, factor)
    needed = math.ceil(1.0 / (rate * LIMIT_SHARE * limit))
    return Mark(factor, 1.0 / (rate * max(least, needed)), limit)


def find_stiffness(atlas: Atlas, organ: Organ) -> float | None:
    """[-] By the constant that says how stiff it is; None for one that is not above 0."""
    present, model = atlas.present, organ.model
    chosen = model.kind not in FILLED and model.kind != "shell" and model.constants == "chosen"
    here = model.stiffness if chosen else organ.material.young_modulus
    there = present.stiffness if chosen else present.young_modulus
    return here / there if here > 0.0 and there > 0.0 else None


def foretell(atlas: Atlas, organ: Organ, row: Row, factor: float) -> float:
    """[s] The limit at this stiffness and damping, from the rows beside them."""
    spot = row.spot
    lines = {
        damping: atlas.list_line(spot.kind, row.integrator, damping, spot.mesh) for damping in LINE
    }
    limit = follow(lines["own"] or [row], factor)
    own, now = atlas.present.damping_ratio, organ.material.damping_ratio
    ratios = {"none": 0.0, "own": own, "critical": CRITICAL}
    known = {
        ratios[damping]: found.predicted
        for damping, line in lines.items()
        for found in line
        if found.spot.stiffness == OWN and found.predicted is not None
    }
    if len(known) < 2 or own not in known:
        return limit
    x = sorted(known)
    # what damping takes of a limit adds to what stiffness does: the inverse is nearly straight
    here, there = (float(np.interp(r, x, [1.0 / known[k] for k in x])) for r in (now, own))
    return limit * there / here


def follow(line: Sequence[Row], factor: float) -> float:
    """[s] Along the logarithms of a line, and beyond its ends as the law says: as the root."""
    known = [(row.spot.stiffness, row.predicted) for row in line if row.predicted is not None]
    x = [math.log(stiffness) for stiffness, _ in known]
    y = [math.log(limit) + 0.5 * log for (_, limit), log in zip(known, x, strict=True)]
    return math.exp(float(np.interp(math.log(factor), x, y)) - 0.5 * math.log(factor))


def find_line(atlas: Atlas, organ: Organ) -> list[Row]:
    """What the map shows: the line of the organ's model and integrator, of the mesh that has the
    longest; of the usual integrator where its own has no limit."""
    kind = organ.model.kind
    for integrator in (organ.model.integrator, *INTEGRATORS):
        lines = [atlas.list_line(kind, integrator, "own", mesh) for mesh in ("own", "half")]
        longest = max(lines, key=len)
        if longest and longest[0].outcome == LIMITED:
            return longest
    return []


def say_mark(mark: Mark | None, organ: Organ) -> Phrase:
    """The scene's place and margin in a sentence."""
    step = VALUE_NAMES.get(organ.model.integrator, organ.model.integrator)
    if mark is None:
        return phrase("The atlas has no step of {step} that holds for this model.", step=step)
    if mark.limit is None:
        return phrase("{step} holds every step: this scene takes {used:.3g} ms.",
                      step=step, used=1e3 * mark.step)  # fmt: skip
    return phrase(
        "This scene: {used:.3g} of {limit:.3g} ms used, {count} steps a tick of {step}.",
        used=1e3 * mark.step,
        limit=1e3 * mark.limit,
        count=round(1.0 / (organ.hand.rate * mark.step)),
        step=step,
    )
