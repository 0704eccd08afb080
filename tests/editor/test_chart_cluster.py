# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a chart on a cluster of Dask: the same errors, and a dead worker loses its own run."""

from __future__ import annotations

import os
import signal

import pytest
from charted import list_few, make_plan
from palpate.files.refusal import Refusal
from palpate.study.scene_chart import LOST, RAN, REFUSED
from palpate_editor.chart import draw_chart
from palpate_editor.chart_cluster import run_on_cluster
from palpate_editor.chart_jobs import Job, find_converged, open_document, run_job
from palpate_editor.chart_pool import run_here

distributed = pytest.importorskip("distributed", reason="Dask's client cannot be had here")
pytestmark = pytest.mark.landing


@pytest.fixture(scope="module")
def cluster():
    """Two workers, each a process of its own, as on two machines."""
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
    ):
        yield cluster


def test_errors_are_the_same_as_in_this_process(cluster):
    plan = make_plan()
    few = list_few(open_document(plan.organ))[:3]
    jobs = [Job(i, c, i == 0) for i, c in enumerate(few)]
    jobs.append(Job(0, find_converged(few[0]), converges=True))

    there = {job: found for job, found in run_on_cluster(cluster.scheduler_address)(plan, jobs)}

    assert there == dict(run_here(plan, jobs))


def test_a_whole_chart_is_drawn_there(cluster):
    plan = make_plan()
    few = list_few(open_document(plan.organ))

    chart = draw_chart(plan, configurations=few, runner=run_on_cluster(cluster.scheduler_address))

    assert chart.complete
    assert [row.outcome for row in chart.rows] == [RAN] * 5 + [REFUSED]


def die(plan, job):
    """A run that ends its process, however often it is tried."""
    if job.number == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return run_job(plan, job)


def test_a_worker_that_dies_loses_its_own_run(cluster, monkeypatch):
    plan = make_plan()
    jobs = [Job(i, c, i == 0) for i, c in enumerate(list_few(open_document(plan.organ))[:3])]
    monkeypatch.setattr("palpate_editor.chart_cluster.run_job", die)

    found = {job.number: row for job, row in run_on_cluster(cluster.scheduler_address)(plan, jobs)}

    assert found[1].outcome == LOST and "cluster lost it" in found[1].reason
    assert [found[i] for i in (0, 2)] == [run_job(plan, jobs[i]) for i in (0, 2)]


def test_nobody_at_an_address_is_said():
    with pytest.raises(Refusal, match="--scheduler.*expected the address of a Dask scheduler"):
        run_on_cluster("tcp://127.0.0.1:9")
