# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about constants with which a tissue cannot be felt: each with the nearest that can."""

from __future__ import annotations

from collections.abc import Iterator

from palpate.scene.tick_cost import LONGEST_TICK, estimate_tick

from palpate_editor.document.constants import MOST_SUBSTEPS, Constant, find_constant
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.problems import Facts, NearestFacts, Problem, TissueFacts


def find_wrong_constant(tissue: TissueFacts | None) -> NearestFacts | None:
    """The one that asks for more substeps than there is time for, and is not what tissues have."""
    nearest = None if tissue is None else tissue.nearest
    return nearest if nearest is not None and nearest.excess > 0.0 else None


def find_fit_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Constants that no tick has time for, and those with which a light touch ends the run."""
    wrong, trial = find_wrong_constant(facts.tissue), facts.tissue and facts.tissue.trial
    if wrong is not None and facts.tissue is not None:
        tetrahedra = facts.tissue.tetrahedra or organ.vertex_count
        tick = estimate_tick(organ.model.kind, tetrahedra, wrong.substeps) or 0.0
        share = tick * organ.hand.rate
        too_many = share > LONGEST_TICK or wrong.substeps > MOST_SUBSTEPS
        yield Problem(
            "hard_constant",
            "error" if too_many else "warning",
            "material",
            wrong.key,
            phrase(
                "{value}, which asks for {count} steps a tick, of {step:.2g} us at most: about "
                "{share:.0%} of the time there is",
                value=say_value(wrong.key, wrong.value),
                count=wrong.substeps,
                step=1e6 / (organ.hand.rate * wrong.substeps),
                share=share,
            ),
            say_limit(wrong),
        )
    if trial and trial.blown is not None:
        yield Problem(
            "blown",
            "error",
            "material",
            trial.blown.key,
            phrase(
                "{value}, with which a light touch ends the run",
                value=say_value(trial.blown.key, trial.blown.value),
            ),
            say_limit(trial.blown),
        )


def say_limit(nearest: NearestFacts) -> Phrase:
    limit = say_value(nearest.key, nearest.limit)
    if nearest.limit < nearest.value:
        return phrase("at most {limit}", limit=limit)
    return phrase("at least {limit}", limit=limit)


def say_label(nearest: NearestFacts) -> str:
    return look_up(nearest.key).label


def say_value(key: str, value: float) -> Phrase:
    return look_up(key).describe(value)


def look_up(key: str) -> Constant:
    part, field = key.split(".")
    constant = find_constant(part, field)
    assert constant is not None
    return constant
