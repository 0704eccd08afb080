# SPDX-License-Identifier: GPL-3.0-or-later
"""The advisor in the window: asked in the Material stage, at work in a process, shown, applied."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest
from charts_of import make_chart
from hands import action, child, click
from palpate.study.advice import Targets
from palpate.study.scene_chart import Chart
from palpate_editor.advise import advise_organ, compile_choice
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from patience import settle
from PySide6.QtWidgets import QLabel

sys.path.append(str(Path(__file__).resolve().parents[1]))
from charted import list_few, make_block  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]
MINUTES = 900_000
"""[ms] that a truth may take on a machine with much else to do."""


@pytest.fixture
def desk(qtbot, window, tmp_path):
    """A window with a small solid, at its Material stage; what it keeps is kept nowhere else."""
    write_organ(tmp_path / "a.organ", make_block())
    window.files.open(tmp_path / "a.organ")
    settle(qtbot, window)
    window.show_stage("material")
    window.advisor.cache = tmp_path / "cache"
    window.advisor.configurations = tuple(list_few(window.session.organ))
    return window


def make_filled_chart(organ: Organ) -> Chart:
    """Its own row has as many particles as the organ: by them a chart of another is known."""
    chart = make_chart(organ)
    own = chart.rows[0]
    count = len(compile_choice(organ, own.configuration).bodies[0].tissue.mass)
    own = replace(own, counts=replace(own.counts, particles=count))
    return replace(chart, rows=(own, *chart.rows[1:]))


def test_a_choice_is_shown_in_words_and_with_a_ring_and_applied_by_its_button(qtbot, desk):
    organ = desk.session.organ
    chart = make_filled_chart(organ)
    advised = advise_organ(organ, chart, Targets(0.2, 0.1, 1000.0), scored=False)
    number = advised.advice.choice.row.number
    desk.advisor.use_chart(chart)
    desk.chart.show_chart(chart)

    desk.advisor.advised.emit(advised)

    assert child(desk, "advice_words", QLabel).text().startswith("The cheapest that meets every")
    assert desk.chart.plot.advised == desk.chart.plot.selected == number
    assert "binds" in child(desk, "chart_row_words", QLabel).text()
    assert desk.docks.docks["chart"].isVisible()
    click(child(desk, "apply_row"))
    settle(qtbot, desk)
    assert desk.session.history.count() == 1
    assert desk.chart.plot.present == number
    action(desk, "undo").trigger()
    assert desk.session.organ is organ


def test_work_that_is_stopped_ends_at_once_and_the_window_is_free(qtbot, desk):
    click(child(desk, "advise"))
    assert desk.advisor.is_busy and not child(desk, "advise").isEnabled()
    work = desk.advisor.work
    qtbot.waitUntil(lambda: work.process is not None, timeout=MINUTES)
    assert child(desk.material_panel, "stop_chart").isVisibleTo(desk)

    desk.advisor.cancel()

    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)
    assert work.process.poll() is not None
    assert child(desk, "advise").isEnabled()
    assert desk.context.jobs.alive == []


@pytest.mark.landing
def test_a_chart_is_drawn_row_by_row_and_a_choice_made_and_scored(qtbot, desk):
    shown, advised = [], []
    desk.advisor.drawn.connect(shown.append)
    desk.advisor.advised.connect(advised.append)
    child(desk, "target_force").setValue(50.0)
    child(desk, "target_displacement").setValue(50.0)

    click(child(desk, "advise"))
    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)

    counts = [len(chart.rows) for chart in shown]
    assert counts == sorted(counts) and counts[0] == 0 and counts[-1] == len(list_few(make_block()))
    assert shown[-1].complete and desk.chart.chart == shown[-1]
    assert advised[0].score.presses
    assert "of" in child(desk, "advice_words", QLabel).text()

    shown.clear()
    click(child(desk, "advise"))  # from the chart that is shown
    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)
    assert [chart.key for chart in shown] == [desk.chart.chart.key]
    assert len(advised) == 2


@pytest.mark.landing
def test_to_stop_ends_the_processes_that_run_rows_too(qtbot, desk):
    desk.advisor.draw()
    work = desk.advisor.work
    qtbot.waitUntil(lambda: work.process is not None and bool(list_children(work)), timeout=MINUTES)
    rows = list_children(work)

    desk.advisor.cancel()

    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)
    qtbot.waitUntil(lambda: not any(map(is_running, rows)), timeout=MINUTES)


def list_children(work) -> list[int]:
    """Processes that the process of a chart has started [proc(5)]."""
    files = Path(f"/proc/{work.process.pid}/task").glob("*/children")  # of each of its threads
    return [int(word) for file in files for word in file.read_text(encoding="utf-8").split()]


def is_running(process: int) -> bool:
    """Zombies have ended; who began them has not looked yet."""
    file = Path(f"/proc/{process}/stat")
    try:
        return file.read_text(encoding="utf-8").rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


@pytest.mark.landing
def test_a_process_that_dies_is_told_and_the_window_goes_on(qtbot, desk):
    told = []
    desk.context.told.connect(lambda text, severity: told.append((text, severity)))
    desk.advisor.draw()
    work = desk.advisor.work
    qtbot.waitUntil(lambda: work.process is not None, timeout=MINUTES)

    work.process.kill()

    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)
    assert told[-1] == ("The process that draws the chart ended with code -9.", "error")


@pytest.mark.landing
def test_an_organ_that_no_truth_can_be_solved_of_says_why(qtbot, desk):
    told = []
    desk.context.told.connect(lambda text, severity: told.append((text, severity)))
    loose = replace(desk.session.organ, fixed=desk.session.organ.fixed & False)
    desk.session.organ = loose
    desk.advisor.draw()

    qtbot.waitUntil(lambda: not desk.advisor.is_busy, timeout=MINUTES)
    assert "held" in told[-1][0] and told[-1][1] == "error"
