# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about what a tick in touch costs: by counts that no machine changes, not by a clock."""

from __future__ import annotations

import math
from collections.abc import Iterator

from palpate.scene.scene_parts import HandPart
from palpate.scene.tick_cost import LONGEST_TICK, TICK_SHARE
from palpate.scene.tick_cost import estimate_tick as estimate_tick_of

from palpate_editor.document.constants import MOST_SUBSTEPS
from palpate_editor.document.fit_rules import find_wrong_constant, say_label, say_limit
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem, TissueFacts

LATE = "late_tick"
"""The problem of an organ that may be published as slow all the same."""
WORKER_SHARE = 0.9
"""[-] of the time that a tissue in a thread of its own may take; the rest is for telling it."""


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
    return estimate_tick_of(organ.model.kind, tetrahedra or organ.vertex_count, substeps)


def count_substeps(tissue: TissueFacts) -> int:
    """Per tick in touch."""
    return tissue.substeps if tissue.trial is None else tissue.trial.substeps


def find_cost_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a solid has too many tetrahedra for its time."""
    tissue = facts.tissue
    if tissue is None or not tissue.tetrahedra or find_wrong_constant(tissue) is not None:
        return
    if organ.hand.exchange_rate:
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
            phrase("at most {share:.0%}: fewer tetrahedra, or a softer tissue", share=TICK_SHARE)
            if tissue.nearest is None
            else phrase(
                "at most {share:.0%}: fewer tetrahedra, or {name}: {limit}",
                share=TICK_SHARE,
                name=say_label(tissue.nearest),
                limit=say_limit(tissue.nearest),
            ),
        )


def find_surface_cost_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a surface has too many vertices for its time."""
    tissue, share = facts.tissue, compute_tick_share(organ, facts)
    if tissue is None or tissue.tetrahedra or share is None or share <= TICK_SHARE:
        return
    if find_wrong_constant(tissue) is not None or organ.hand.exchange_rate:
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
        phrase("at most {share:.0%}: fewer vertices, softer links or more mass", share=TICK_SHARE)
        if tissue.nearest is None
        else phrase(
            "at most {share:.0%}: fewer vertices, or {name}: {limit}",
            share=TICK_SHARE,
            name=say_label(tissue.nearest),
            limit=say_limit(tissue.nearest),
        ),
    )


def find_exchange_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a tissue that is felt by its local stiffness needs to be, and is in time."""
    share, rate = compute_tick_share(organ, facts), organ.hand.exchange_rate
    if not rate or share is None:
        return
    if share <= TICK_SHARE:
        yield Problem(
            "needless_exchange",
            "warning",
            "material",
            "hand.exchange_rate",
            phrase(
                "felt by its local stiffness, told {rate:g} times a second, though the tissue "
                "itself takes about {share:.0%} of a tick",
                rate=rate,
                share=share,
            ),
            phrase("0 Hz: the tissue ticks with the hand where it can"),
        )
    elif share > WORKER_SHARE:
        yield Problem(
            "late_exchange",
            "warning" if share <= LONGEST_TICK else "error",
            "material",
            "hand.exchange_rate",
            phrase(
                "in a thread of its own the tissue takes about {share:.0%} of the time there is: "
                "it would be late, and be felt as nothing where it is later than three exchanges",
                share=share,
            ),
            phrase("at most {share:.0%}", share=WORKER_SHARE),
        )


def find_late_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a trainee would feel it late on the reference machine, though not on every one."""
    share, tissue = compute_tick_share(organ, facts), facts.tissue
    if tissue is None or share is None or not 1.0 < share <= LONGEST_TICK:
        return
    got = phrase(
        "{substeps} steps a tick in touch: about {share:.0%} of the time there is",
        substeps=count_substeps(tissue),
        share=share,
    )
    if organ.hand.exchange_rate:
        expected = phrase(
            "at most {most:.0%}: a coarser or softer organ, or published as slow", most=1.0
        )
    elif tissue.nearest is None:
        expected = phrase(
            "at most {most:.0%}: a coarser or softer organ, an exchange rate, or published as slow",
            most=1.0,
        )
    else:
        expected = phrase(
            "at most {most:.0%}: a coarser organ, {name}: {limit}, an exchange rate, or published "
            "as slow",
            most=1.0,
            name=say_label(tissue.nearest),
            limit=say_limit(tissue.nearest),
        )
    yield Problem(LATE, "error", "publish", "tick", got, expected)


def round_up(value: float) -> float:
    """To two digits that count."""
    digit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.ceil(value / digit) * digit


def find_least_rate(organ: Organ, tissue: TissueFacts) -> float | None:
    """[Hz] with which a tick has not too many steps; None where it has not, or where the usual rate
    would not do either."""
    rate, usual = organ.hand.rate, HandPart().rate
    least = rate * count_substeps(tissue) / MOST_SUBSTEPS
    return least if rate < least <= usual else None


def find_substep_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Whether a tick has more steps than one can end in time: of a rate so low that ticks alone are
    too long, whose steps would fit at the usual one, the rate is told."""
    tissue = facts.tissue
    if tissue is None or count_substeps(tissue) <= MOST_SUBSTEPS:
        return
    rate, usual, least = organ.hand.rate, HandPart().rate, find_least_rate(organ, tissue)
    if least is not None:
        yield Problem(
            "low_rate",
            "error",
            "material",
            "hand.rate",
            phrase(
                "{rate:g} Hz, of which a tick has {count} steps, of {step:.2g} us at most",
                rate=rate,
                count=count_substeps(tissue),
                step=1e6 * (tissue.stable_step or 0.0),
            ),
            phrase(
                "at least {least:g} Hz; a hand is asked at {usual:g} Hz",
                least=round_up(least),
                usual=usual,
            ),
        )
        return
    if find_wrong_constant(tissue) is not None:
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
