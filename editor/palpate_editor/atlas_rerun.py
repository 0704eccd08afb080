# SPDX-License-Identifier: GPL-3.0-or-later
"""A random tenth of an atlas run again: its limits are the same."""

from __future__ import annotations

import random
from pathlib import Path

from palpate.command.verb import Report
from palpate.files.refusal import Refusal
from palpate.study.atlas import Atlas, Row, Spot

from palpate_editor.atlas import compute_key
from palpate_editor.atlas_jobs import Job, Plan
from palpate_editor.job_pool import Runner

PART, SEED = 0.1, 17
ALLOWED = 0.02
"""[-] of a limit, and of a share of energy: two of the steps between which it was searched."""


def rerun_atlas(
    file: Path, plan: Plan, atlas: Atlas, runner: Runner, part: float = PART, seed: int = SEED
) -> list[Report]:
    """What a random part of the rows comes to today. Raises Refusal for an atlas of something
    else."""
    key = compute_key(plan)
    if atlas.key != key:
        raise Refusal(file, "key", f"{atlas.key[:12]}...", f"{key[:12]}..., of this organ")
    chosen = choose_rows(atlas, part, seed)
    jobs: dict[Spot, list[str]] = {}
    for row in chosen:
        jobs.setdefault(row.spot, []).append(row.integrator)
    found = {}
    for _, rows in runner(plan, [Job(spot, tuple(names)) for spot, names in jobs.items()]):
        found |= {(row.spot, row.integrator): row for row in rows}
    return [compare(row, found[row.spot, row.integrator]) for row in chosen]


def choose_rows(atlas: Atlas, part: float, seed: int) -> list[Row]:
    """The same ones for the same seed, one at least."""
    rows = list(atlas.rows)
    count = min(len(rows), max(1, round(part * len(rows))))
    return sorted(random.Random(seed).sample(rows, count), key=lambda row: row.number)


def compare(before: Row, after: Row) -> Report:
    """Whether a row came to the same."""
    largest = 0.0 if before.outcome == after.outcome else 1.0
    for name in ("predicted", "measured", "held", "failed"):
        one, other = getattr(before, name), getattr(after, name)
        if (one is None) != (other is None):
            largest = 1.0
        elif one is not None:
            largest = max(largest, abs(other - one) / one)
    for name in ("loss", "chatter", "softness"):
        one, other = getattr(before, name), getattr(after, name)
        if (one is None) != (other is None):
            largest = 1.0
        elif one is not None:
            largest = max(largest, abs(other - one) / max(1.0, abs(one)))
    return {
        "number": before.number,
        "name": name_row(before),
        "largest": largest,
        "same": largest <= ALLOWED,
    }


def name_row(row: Row) -> str:
    """On one line, as the verb says it."""
    spot = row.spot
    return (
        f"{spot.kind}, {row.integrator}, {spot.stiffness:g} x stiffness, damping {spot.damping}, "
        f"mesh {spot.mesh}"
    )
