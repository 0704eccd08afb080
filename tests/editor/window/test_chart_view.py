# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of the organ on the desk: points that are clicked on, read and applied."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest
from charts_of import FAILED, drop_costs, make_chart
from hands import action, child, choose_file, click
from palpate.study.chart_file import read_chart, write_chart
from palpate_editor.chart_fit import find_present, find_wanted
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetConstant
from palpate_editor.edits.configure import find_configuration
from patience import settle
from PySide6.QtWidgets import QLabel

sys.path.append(str(Path(__file__).resolve().parents[1]))
from organs import make_organ  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def desk(qtbot, window, tmp_path):
    """A window with a small organ and its chart beside it."""
    organ = replace(make_organ(), title="Spleen")
    write_organ(tmp_path / "a.organ", organ)
    write_chart(tmp_path / "a.chart.json", make_chart(organ))
    window.files.open(tmp_path / "a.organ")
    settle(qtbot, window)
    window.chart.open(tmp_path / "a.chart.json")
    qtbot.waitUntil(lambda: window.chart.chart is not None)
    window.docks.show("chart")
    return window


def words(window) -> str:
    return child(window, "chart_row_words", QLabel).text()


def find(window, **values) -> int:
    """The first row that ran with these."""
    return next(
        row.number
        for row in window.chart.chart.rows
        if row.total is not None
        and all(getattr(row.configuration, name) == value for name, value in values.items())
    )


def test_a_point_is_read_and_applied_as_one_step_that_can_be_undone(qtbot, desk):
    view, before = desk.chart, desk.session.organ
    number = find(desk, kind="linear_solid", integrator="symplectic_euler")
    spot = next(spot for spot in view.plot.points.points() if spot.data() == number)

    view.plot.points.sigClicked.emit(view.plot.points, [spot], None)
    assert "of 1000 µs that it may" in words(desk)
    assert "displacement" in words(desk)
    click(child(desk, "apply_row"))
    settle(qtbot, desk)

    after = desk.session.organ
    assert desk.session.history.count() == 1
    assert after.model.kind == "linear_solid"
    assert find_configuration(after) == view.chart.rows[number].configuration
    assert view.plot.present == number
    assert not child(desk, "apply_row").isEnabled()
    assert words(desk).startswith("So it is simulated now.")
    action(desk, "undo").trigger()
    assert desk.session.organ is before
    assert view.plot.present == 0


def test_what_failed_says_why_and_cannot_be_applied(desk):
    row = desk.chart.chart.list_failed()[0]

    desk.chart.show_row(row.number)

    assert words(desk).startswith(f"An alarm ended it: {FAILED}.")
    assert not child(desk, "apply_row").isEnabled()
    x, y = desk.chart.plot.places[row.number]
    assert y > max(
        place[1] for number, place in desk.chart.plot.places.items()
        if desk.chart.plot.find_row(number).total is not None
    )  # fmt: skip
    assert desk.chart.plot.write_tip(x, y, row.number).endswith(FAILED)


@pytest.mark.landing
def test_a_row_on_another_mesh_decimates_in_the_same_step(qtbot, desk):
    number = find(desk, kind="mass_spring", vertices=0)
    desk.chart.chart = replace(desk.chart.chart, rows=tuple(
        replace(row, configuration=replace(row.configuration, vertices=90))
        if row.number == number else row
        for row in desk.chart.chart.rows
    ))  # fmt: skip
    desk.chart.plot.show_chart(desk.chart.chart)

    desk.chart.apply_row(number)
    settle(qtbot, desk)

    assert desk.session.organ.vertex_count == 90
    assert desk.session.history.count() == 1
    assert desk.chart.plot.present == number


@pytest.mark.landing
def test_rows_without_a_cost_wait_below_those_that_have_one(desk):
    whole = desk.chart.chart
    desk.chart.show_chart(drop_costs(whole, 10))

    plot = desk.chart.plot
    timed = {row.number for row in plot.chart.list_ran()}
    waiting = {row.number for row in whole.list_ran()} - timed
    assert timed and waiting
    lowest = min(plot.places[number][1] for number in timed)
    assert all(plot.places[number][1] < lowest for number in waiting)
    desk.chart.show_row(min(waiting))
    assert "Not timed yet." in words(desk)


@pytest.mark.landing
def test_a_chart_of_another_tissue_says_so_and_is_not_applied(qtbot, desk):
    summary = child(desk, "chart_summary", QLabel)
    assert summary.text().startswith("Spleen: a press of 3 mm with a ball of")

    desk.context.apply(SetConstant("material", "young_modulus", 7e3))
    settle(qtbot, desk)

    assert "Young's modulus of" in summary.text() and "where the organ has 7 kPa" in summary.text()
    assert desk.chart.plot.present is None
    before = desk.session.organ
    desk.chart.apply_row(find(desk, kind="linear_solid"))
    assert desk.session.organ is before


@pytest.mark.landing
def test_a_chart_is_saved_and_opened_through_dialogs(qtbot, desk, tmp_path):
    chart = desk.chart.chart
    click(child(desk, "save_chart"))
    choose_file(qtbot, desk, tmp_path / "b.chart.json")
    assert read_chart(tmp_path / "b.chart.json") == chart

    desk.chart.show_chart(None)
    click(child(desk, "open_chart"))
    choose_file(qtbot, desk, tmp_path / "b.chart.json")
    qtbot.waitUntil(lambda: desk.chart.chart == chart)


@pytest.mark.landing
def test_what_is_no_chart_is_refused_in_a_sentence(qtbot, desk, tmp_path):
    told = []
    desk.context.told.connect(lambda text, severity: told.append((text, severity)))
    (tmp_path / "c.json").write_text("{}", encoding="utf-8")

    desk.chart.open(tmp_path / "c.json")

    qtbot.waitUntil(lambda: bool(told))
    assert "c.json" in told[0][0] and told[0][1] == "error"


def test_the_row_of_the_organ_is_found_on_its_mesh_alone():
    organ = make_organ()
    rows = make_chart(organ).rows

    assert find_present(rows, organ).number == 0
    other = replace(rows[0], configuration=replace(rows[0].configuration, vertices=90))
    assert find_present([other], organ) is None
    elsewhere = replace(rows[0], counts=replace(rows[0].counts, particles=90))
    assert find_present([elsewhere], organ) is None


def test_a_wall_of_prisms_has_two_particles_for_each_vertex_of_its_surface():
    organ = replace(make_organ(), model=replace(make_organ().model, kind="shell"))
    row = make_chart(organ).rows[0]
    row = replace(row, configuration=find_configuration(organ))

    def with_particles(count):
        return replace(row, counts=replace(row.counts, particles=count))

    wall = with_particles(2 * organ.vertex_count)
    assert find_wanted(wall, organ) == find_configuration(organ)
    assert find_present([wall], organ) == wall
    assert find_wanted(with_particles(90), organ).vertices == 45
