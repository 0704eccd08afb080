# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the rows of a chart run: in this process, in others, or on a cluster. Errors are the same.

Each of these takes a plan and jobs and gives what every job came to, in the order in which they
end. A process that dies loses the job that it had, and no other (job_pool).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from palpate.study.scene_chart import LOST, Row

from palpate_editor import job_pool
from palpate_editor.chart_jobs import Converged, Job, Plan, open_document, run_job, start_row

Result = tuple[Job, Row | Converged]
Runner = Callable[[Plan, Sequence[Job]], Iterator[Result]]


def lose(plan: Plan, job: Job, reason: str) -> Row | Converged:
    """What a job came to whose process ended."""
    if job.converges:
        return Converged((), None)
    return start_row(open_document(plan.organ), job, LOST, reason)


run_here: Runner = job_pool.run_here(run_job)
"""In this very process, one after the other."""


def run_in_processes(workers: int) -> Runner:
    """In so many processes at once."""
    return job_pool.run_in_processes(run_job, lose, workers)
