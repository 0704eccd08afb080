# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a chart on a Dask cluster that is there already; the extra `cluster` has its client."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from palpate.files.refusal import Refusal
from palpate.study.scene_chart import Row

from palpate_editor.chart_jobs import Converged, Job, Plan, run_job
from palpate_editor.chart_pool import Result, Runner, lose

PATIENCE = 10.0
"""[s] in which a scheduler must answer."""


def run_on_cluster(address: str) -> Runner:
    """Where the scheduler at `address` has workers; they need palpate-editor of this version.

    Raises Refusal where Dask is not installed or nobody answers.
    """
    try:
        from distributed import Client
    except ImportError:
        expected = "Dask's client: pip install 'palpate-editor[cluster]'"
        raise Refusal(None, "--scheduler", "no package distributed", expected) from None
    try:
        with Client(address, timeout=PATIENCE, set_as_default=False) as client:
            workers = client.scheduler_info()["workers"]
    except (OSError, ValueError) as problem:
        raise Refusal(
            None, "--scheduler", f"{address!r}: {problem}", "the address of a Dask scheduler"
        ) from None
    if not workers:
        raise Refusal(None, "--scheduler", f"{address!r} without a worker", "one at least")

    def run(plan: Plan, jobs: Sequence[Job]) -> Iterator[Result]:
        from distributed import as_completed

        with Client(address, timeout=PATIENCE, set_as_default=False) as client:
            # the plan goes with every job: shared data would be lost with the worker that holds it
            futures = {client.submit(run_job, plan, j, pure=False, retries=0): j for j in jobs}
            try:
                for future in as_completed(futures, loop=client.loop):
                    yield futures[future], take_result(plan, futures[future], future.result)
            finally:
                client.cancel(list(futures))

    return run


def take_result(plan: Plan, job: Job, ask: Callable[[], Row | Converged]) -> Row | Converged:
    """What a job found, or that the cluster lost it."""
    try:
        return ask()
    except Exception as problem:  # of the cluster's: run_job lets none out
        return lose(plan, job, f"the cluster lost it: {problem}")
