# SPDX-License-Identifier: GPL-3.0-or-later
"""The charts of pulls and drags that are kept: as right, and as wrong, as the page says."""

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


def test_every_solid_with_a_fine_far_field_is_within_a_tenth_of_a_pull_whatever_its_mesh():
    chart = read_chart(CHART)

    assert chart.complete and chart.way.kind == "pull"
    ran = chart.list_ran()
    assert len(ran) >= 60
    near = [row for row in ran if row.configuration.far_field == "fine"]
    assert len(near) >= 30
    assert {row.configuration.tetrahedra for row in near} >= {300, 600, 1000, 2000, 4000}
    assert max(row.total.force_rms for row in near) < 0.10
    # what has no near field to be tied to is as wrong as ever
    hard = [row for row in ran if row.configuration.contact_law == "hard"]
    assert min(row.total.force_rms for row in hard) > 1.0


@pytest.mark.landing
def test_the_row_of_the_spleen_held_tied_has_the_same_errors_again():
    document, drawn = open_any(PUBLISHED / "spleen.organ"), read_chart(CHART)
    document = replace(document, model=replace(document.model, contact_hold="tied"))
    truth = solve_truth(document, Pull())
    plan = Plan(organ=pack_document(document), truth=truth, path="pull", speed=SPEED)
    own = replace(drawn, rows=tuple(row for row in drawn.rows if row.own))

    [row] = rerun_chart(CHART, plan, own, run_in_processes(1), every=1)

    assert row["same"], row


def test_a_drag_is_right_on_any_mesh_once_the_far_field_is_fine_as_the_page_says():
    chart = read_chart(PUBLISHED.parent / "charts" / "drag" / "spleen.json")

    assert chart.way.kind == "drag" and chart.way.stations == 7
    near = [row for row in chart.list_ran() if row.configuration.far_field == "fine"]
    assert {row.configuration.tetrahedra for row in near} >= {300, 600, 1000, 2000, 4000}
    assert max(row.total.force_rms for row in near) < 0.02


def test_a_pull_of_a_wall_is_a_third_off_however_it_is_held_as_the_page_says():
    chart = read_chart(PUBLISHED.parent / "charts" / "pull" / "gallbladder.json")

    [own] = [row for row in chart.rows if row.own]
    assert chart.way.kind == "pull" and 0.2 < own.total.force_rms < 0.4
