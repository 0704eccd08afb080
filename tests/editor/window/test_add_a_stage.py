# SPDX-License-Identifier: GPL-3.0-or-later
"""A stage is one panel and one entry: the example of tests/examples/add_a_stage in the window."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest
from hands import CONTROL, SHIFT, click, press
from palpate_editor import check
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Problem
from palpate_editor.views.stages import panels
from patience import settle
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from touch_context import build_organ

EXAMPLE = Path(__file__).resolve().parents[2] / "examples/add_a_stage/measure_panel.py"
ORDER = ["import", "repair", "decimate", "measure", "material", "test", "scenario", "publish"]

pytestmark = pytest.mark.window


@pytest.fixture
def panel_class(monkeypatch):
    """The panel of the example, with its entry among the others."""
    panel = runpy.run_path(str(EXAMPLE))["MeasurePanel"]
    before, after = panels.PANELS[:3], panels.PANELS[3:]
    monkeypatch.setattr(panels, "PANELS", (*before, panel, *after))
    return panel


@pytest.fixture
def measuring(panel_class, make_editor):
    """A window that has the stage."""
    return make_editor(theme="dark", language="en").window


def find_row(window, text):
    """The names in the palette after a few letters."""
    press(window, Qt.Key.Key_P, CONTROL | SHIFT)
    palette = window.palette_dialog
    QTest.keyClicks(palette.query, text)
    return palette


def test_a_stage_is_added_by_one_panel_and_one_entry(qtbot, measuring, panel_class, checkout):
    window = measuring
    window.session.restore(build_organ(), None)
    settle(qtbot, window)
    assert list(window.stage_bar.steps) == ORDER

    press(window, Qt.Key.Key_4, CONTROL)

    assert window.context.stage == "measure"
    step = window.stage_bar.steps["measure"]
    assert step.text() == "Measure" and step.isChecked()
    assert step.toolTip().splitlines()[0] == "Measure (Ctrl+4)"
    panel = window.stage_dock.stack.currentWidget().widget()
    assert isinstance(panel, panel_class)
    assert panel.facts.texts()["x"] == "59.8\N{NO-BREAK SPACE}mm"  # a sphere of 600 vertices
    assert panel.good_news() == ["It encloses 112\N{NO-BREAK SPACE}mL."]
    assert panel.rows[0].label.text() == panel.good_news()[0]
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    qtbot.wait(600)  # the view refines its picture while nothing moves
    assert window.grab().save(str(folder / "editor_added_stage.png"))


def test_help_and_palette_know_an_added_stage(measuring):
    window = measuring
    palette = find_row(window, "measure")
    assert palette.list.item(0).text() == "Measure"
    QTest.keyClick(palette.query, Qt.Key.Key_Return)
    assert window.context.stage == "measure"

    press(window, Qt.Key.Key_F1)

    shown = window.help.text.toPlainText()
    assert shown.startswith("Measure") and "Only a closed surface has a volume." in shown


def test_buttons_lead_to_an_added_stage_and_on_from_it(measuring):
    window = measuring
    window.show_stage("decimate")
    button = window.decimate_panel.next_button
    assert button.text().startswith("Next: Measure")

    click(button)
    assert window.context.stage == "measure"
    click(window.stage_dock.panels["measure"].next_button)

    assert window.context.stage == "material"


@pytest.mark.landing
def test_a_problem_of_an_added_stage_stands_in_bar_panel_and_log(qtbot, measuring, monkeypatch):
    found = Problem("size", "warning", "measure", "x", phrase("too wide"), phrase("less"))
    rules = check.find_problems
    monkeypatch.setattr(check, "find_problems", lambda *given: [*rules(*given), found])
    window = measuring
    window.session.restore(build_organ(), None)
    settle(qtbot, window)

    assert window.stage_bar.steps["measure"].verdict.warnings == 1
    assert "Too wide" in window.stage_dock.panels["measure"].rows[0].label.text()
    rows = [
        window.log.problems.topLevelItem(i) for i in range(window.log.problems.topLevelItemCount())
    ]
    assert ("Measure", "Too wide", "less") in {tuple(row.text(i) for i in range(3)) for row in rows}


def test_without_its_entry_the_stage_is_gone(window):
    assert list(window.stage_bar.steps) == [name for name in ORDER if name != "measure"]
    assert "stage_measure" not in window.actions_by_name.actions
