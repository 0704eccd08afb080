# SPDX-License-Identifier: GPL-3.0-or-later
"""One row in ten of a chart run again: its errors are the same, to rounding."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import palpate
from palpate.command.verb import Report
from palpate.files.refusal import Refusal
from palpate.study.scene_chart import Chart, Row

from palpate_editor.chart import compute_key
from palpate_editor.chart_jobs import Converged, Job, Plan, find_converged
from palpate_editor.chart_pool import Runner

EVERY = 10
SUMMED = 1e-9
"""[-] Of errors: libraries that solve the truth sum otherwise from one machine to the next."""
ROUNDING = 2e-4
"""[-] Of errors, where vector code is other than the chart's. Packed tissue is in single precision:
of the charts of spleen and kidney, of AVX3, rows came to within 7e-5 in AVX2 and SSE4."""


def rerun_chart(
    file: Path, plan: Plan, chart: Chart, runner: Runner, every: int = EVERY
) -> list[Report]:
    """What every tenth row comes to today. Raises Refusal for a chart of something else."""
    key = compute_key(plan)
    if chart.key != key:
        raise Refusal(file, "key", f"{chart.key[:12]}...", f"{key[:12]}..., of this organ and path")
    rows = chart.rows[::every]
    models = dict.fromkeys(find_converged(row.configuration) for row in rows)
    jobs = [Job(i, model, converges=True) for i, model in enumerate(models)]
    converged = {job.configuration: found for job, found in runner(plan, jobs)} if jobs else {}
    again = [
        Job(row.number, row.configuration, row.own, False, pick(converged, row)) for row in rows
    ]
    found = {job.number: result for job, result in runner(plan, again)} if again else {}
    target = (palpate.simd_targets() or ["none"])[0]
    allowed = SUMMED if target == chart.machine.target else ROUNDING
    return [compare(row, found[row.number], allowed) for row in rows]


def pick(converged: dict, row: Row) -> Converged:
    return converged[find_converged(row.configuration)]


def compare(before: Row, after: Row | Converged, allowed: float) -> Report:
    """Whether a row came to the same."""
    assert isinstance(after, Row)
    largest = 0.0 if before.outcome == after.outcome else 1.0
    for part in ("total", "model", "time"):
        one, other = getattr(before, part), getattr(after, part)
        if (one is None) != (other is None):
            largest = 1.0
        elif one is not None and other is not None:
            ours, theirs = asdict(one), asdict(other)
            largest = max(largest, *(abs((ours[n] or 0.0) - (theirs[n] or 0.0)) for n in ours))
    return {
        "number": before.number,
        "name": before.name,
        "outcome": after.outcome,
        "reason": after.reason,
        "largest": largest,
        "same": largest <= allowed,
    }
