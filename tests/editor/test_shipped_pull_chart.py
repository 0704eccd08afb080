# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of a pull that is kept: of the spleen that ships, and as wrong as the page says."""

from __future__ import annotations

from dataclasses import replace

import pytest
from palpate.study.chart_file import read_chart
from palpate.study.track import SPEED
from palpate_editor.chart_jobs import Plan, pack_document
from palpate_editor.chart_pool import run_in_processes
from palpate_editor.chart_rerun import rerun_chart
from palpate_editor.truth import Pull, solve_truth
from palpate_editor.verbs.files import open_any
from palpate_meshes.catalogue import PUBLISHED

CHART = PUBLISHED.parent / "charts" / "pull" / "spleen.json"


def test_no_configuration_is_within_the_whole_force_of_a_pull():
    chart = read_chart(CHART)

    assert chart.complete and chart.way.kind == "pull"
    ran = chart.list_ran()
    assert len(ran) >= 60
    assert min(row.total.force_rms for row in ran) > 1.0


@pytest.mark.landing
def test_the_row_of_the_spleen_as_it_ships_has_the_same_errors_again():
    document, drawn = open_any(PUBLISHED / "spleen.organ"), read_chart(CHART)
    truth = solve_truth(document, Pull())
    plan = Plan(organ=pack_document(document), truth=truth, path="pull", speed=SPEED)
    own = replace(drawn, rows=tuple(row for row in drawn.rows if row.own))

    [row] = rerun_chart(CHART, plan, own, run_in_processes(1), every=1)

    assert row["same"], row
