# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a chart on a Dask cluster that is there already; the extra `cluster` has its client."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from palpate.files.refusal import Refusal

from palpate_editor.chart_jobs import Job, Plan, run_job
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
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as problem:
        raise Refusal(
            None, "--scheduler", f"{address!r}: {problem}", "the address of a Dask scheduler"
        ) from None

    if not client.scheduler_info()["workers"]:
        client.close()
        raise Refusal(None, "--scheduler", f"{address!r} without a worker", "one at least")

    def run(plan: Plan, jobs: Sequence[Job]) -> Iterator[Result]:
        from distributed import as_completed

        # a job is tried once: it may be what ended its worker
        shared = client.scatter(plan, broadcast=True)
        futures = {client.submit(run_job, shared, job, pure=False, retries=0): job for job in jobs}
        try:
            for future in as_completed(futures):
                job = futures[future]
                if future.status == "finished":
                    yield job, future.result()
                else:
                    yield job, lose(plan, job, f"the cluster lost it: {future.exception()}")
        finally:
            client.cancel(list(futures))

    return run
