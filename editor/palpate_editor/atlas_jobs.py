# SPDX-License-Identifier: GPL-3.0-or-later
"""One tissue of an atlas: built, and run under every integrator that is asked for. In any
process."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import palpate
from palpate.scene.scene_parts import INTEGRATORS
from palpate.study.atlas import (
    AT_REST,
    FAILED,
    LIMITED,
    LOST,
    NEVER,
    OWN,
    REFUSED,
    UNLIMITED,
    Row,
    Spot,
)
from palpate.study.step_failure import holds_long_steps, measure_failure
from palpate.study.step_limit import find_scale, foretell_limit, measure_limit

from palpate_editor.atlas_spots import build_tissue
from palpate_editor.chart_jobs import count_elements, open_document
from palpate_editor.document import Organ
from palpate_editor.edits import EditError


@dataclass(frozen=True)
class Plan:
    """What all runs of an atlas share; it can be sent to another machine."""

    organ: bytes
    """The document, as chart_jobs.pack_document packs it."""


@dataclass(frozen=True)
class Job:
    """A tissue, and what to run it under."""

    spot: Spot
    integrators: tuple[str, ...]


def run_job(plan: Plan, job: Job) -> tuple[Row, ...]:
    """Whatever happens to a run stands in its row; numbers are those of the job."""
    organ = open_document(plan.organ)
    try:
        tissue = build_kept(plan.organ, job.spot)
    except (EditError, ValueError) as problem:
        return tuple(start_row(job.spot, name, REFUSED, str(problem)) for name in job.integrators)
    return tuple(run_row(organ, tissue, job.spot, name) for name in job.integrators)


@lru_cache(maxsize=1)
def build_kept(organ: bytes, spot: Spot) -> palpate.TissueModel:
    """Raises EditError or ValueError."""
    return build_tissue(open_document(organ), spot)


def start_row(
    spot: Spot, integrator: str, outcome: str, reason: str = "", **known: float | None
) -> Row:
    values: dict[str, float | None] = dict.fromkeys(
        ("predicted", "held", "failed", "loss", "chatter", "softness")
    )
    sizes = {"particles": 0, "elements": 0}
    return Row(0, spot, integrator, outcome, reason, **sizes, **(values | known))  # type: ignore[arg-type]


def run_row(organ: Organ, tissue: palpate.TissueModel, spot: Spot, name: str) -> Row:
    """One integrator on a built tissue."""
    integrator = palpate.Integrator.__members__[name]
    if name == INTEGRATORS[0] and spot.kind == "linear_solid":
        row = start_row(spot, name, AT_REST)
    else:
        try:
            if palpate.is_implicit(integrator):
                row = run_implicit(tissue, spot, name, 1.0 / organ.hand.rate)
            else:
                row = run_explicit(tissue, spot, name)
        except ValueError as problem:
            row = start_row(spot, name, REFUSED, str(problem))
    return replace(row, particles=len(tissue.mass), elements=count_elements(tissue))


def run_explicit(tissue: palpate.TissueModel, spot: Spot, name: str) -> Row:
    """Its limit as it is foretold, and as it is found."""
    integrator = palpate.Integrator.__members__[name]
    predicted = foretell_limit(tissue, integrator)
    if math.isinf(predicted):
        return start_row(spot, name, UNLIMITED)
    found = measure_limit(tissue, integrator, predicted or find_scale(tissue))
    if predicted == 0.0:
        return start_row(spot, name, NEVER, held=found.held, failed=found.failed)
    return start_row(spot, name, LIMITED, predicted=predicted, held=found.held, failed=found.failed)


def run_implicit(tissue: palpate.TissueModel, spot: Spot, name: str, period: float) -> Row:
    """Whether it holds the longest steps; of the organ's own stiffness also how it errs."""
    integrator = palpate.Integrator.__members__[name]
    outcome = UNLIMITED if holds_long_steps(tissue, integrator) else FAILED
    if spot.stiffness != OWN:
        return start_row(spot, name, outcome)
    failure = measure_failure(tissue, integrator, period)
    return start_row(
        spot, name, outcome,
        loss=failure.loss, chatter=failure.chatter, softness=failure.softness,
    )  # fmt: skip


def lose(plan: Plan, job: Job, reason: str) -> tuple[Row, ...]:
    """What a job came to whose process ended."""
    del plan
    return tuple(start_row(job.spot, name, LOST, reason) for name in job.integrators)
