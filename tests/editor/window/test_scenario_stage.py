# SPDX-License-Identifier: GPL-3.0-or-later
"""The Scenario stage, driven as a designer drives it: steps, places, limits, texts, hands."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from hands import choose_file
from palpate import scenario
from palpate.cli.main import main
from palpate.runs.felt import read_force
from palpate.runs.hand_record import find_bands
from palpate.runs.press import PressScript, find_top
from palpate.runs.run import run_script
from palpate.viewport import FboView, GLView, PointerHands
from palpate_editor.document import Organ
from palpate_editor.open_organ import open_organ
from palpate_editor.surface_path import SPACING, follow_surface
from palpate_editor.views.scenario import ScenarioPanel
from palpate_editor.views.scenario.tool_list import ToolRow
from palpate_editor.views.touch.runner import HandRequest
from patience import PATIENCE, settle
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu, QPushButton, QTableWidget
from touch_context import middle

PUBLISHED = Path(__file__).resolve().parents[3] / "meshes" / "published"
LEFT = Qt.MouseButton.LeftButton
MOST_CLICKS = 30

pytestmark = pytest.mark.window


class Designer:
    """Clicks, and counts it."""

    def __init__(self, qtbot, window, organ: Organ):
        self.qtbot, self.window, self.clicks = qtbot, window, 0
        window.session.restore(organ, None)
        settle(qtbot, window)

    @property
    def panel(self) -> ScenarioPanel:
        return self.window.scenario_panel

    @property
    def assessment(self) -> dict:
        return json.loads(self.window.session.organ.assessment)

    def click(self, widget, at: QPoint | None = None) -> None:
        self.clicks += 1
        assert widget.isVisible() and widget.isEnabled(), widget.objectName()
        QTest.mouseClick(widget, LEFT, Qt.KeyboardModifier.NoModifier, at or widget.rect().center())

    def button(self, name: str) -> None:
        self.click(self.panel.findChild(QPushButton, name))

    def choose(self, button: QPushButton, menu: QMenu, name: str) -> None:
        """Opens a menu and takes a row of it: two clicks."""
        action = next(each for each in menu.actions() if each.objectName() == name)

        def take() -> None:
            if not menu.isVisible():
                QTimer.singleShot(50, take)
                return
            self.click(menu, menu.actionGeometry(action).center())

        QTimer.singleShot(50, take)
        self.click(button)
        self.qtbot.waitUntil(lambda: not menu.isVisible(), timeout=PATIENCE)

    def add_step(self, verb: str) -> None:
        self.choose(self.panel.list.add, self.panel.list.menu, f"add_{verb}")

    def slide(self, name: str, share: float) -> None:
        """Where the slider's groove is clicked it goes, a page at a time: dragged instead."""
        slider = self.panel.findChild(object, name)
        self.clicks += 1
        slider.setSliderDown(True)
        slider.setValue(round(share * slider.maximum()))
        slider.setSliderDown(False)
        slider.sliderReleased.emit()

    def wait(self, condition) -> None:
        self.qtbot.waitUntil(condition, timeout=PATIENCE)

    def picture(self, checkout: Path, name: str) -> None:
        kind = {FboView: "offscreen", GLView: "x11"}[type(self.window.view)]
        folder = checkout / "build" / "screenshots" / kind
        folder.mkdir(parents=True, exist_ok=True)
        self.qtbot.wait(300)
        assert self.window.grab().save(str(folder / f"scenario_{name}.png"))


@pytest.fixture
def designer(qtbot, window) -> Designer:
    made = Designer(qtbot, window, open_organ(PUBLISHED / "simple_tissue.organ"))
    made.click(window.stage_bar.steps["scenario"])
    return made


def test_steps_are_added_ordered_duplicated_muted_and_taken_back(designer):
    panel = designer.panel
    designer.button("new_scenario")
    designer.add_step("touch")
    designer.add_step("hold")
    assert [step["do"] for step in designer.assessment["steps"]] == ["touch", "hold"]

    rows = panel.list.list
    rows.model().moveRow(rows.rootIndex(), 1, rows.rootIndex(), 0)
    assert [step["do"] for step in designer.assessment["steps"]] == ["hold", "touch"]
    designer.button("duplicate_step")
    designer.button("mute_step")
    # the copy stands behind its step and is the chosen one
    muted = [step.get("muted", False) for step in designer.assessment["steps"]]
    assert [step["do"] for step in designer.assessment["steps"]] == ["hold", "hold", "touch"]
    assert muted == [False, True, False]

    history, titles = designer.window.session.history, []
    while history.canUndo():
        titles.append(history.undoText())
        history.undo()
    assert len(titles) == 6
    assert not designer.window.session.organ.assessment
    while history.canRedo():
        history.redo()
    assert len(designer.assessment["steps"]) == 3


def test_a_slider_is_one_edit_in_newton_and_a_sentence_follows(designer):
    designer.button("new_scenario")
    designer.add_step("hold")
    edits = designer.window.session.history.count()

    designer.slide("force_most", 0.2)

    step = designer.assessment["steps"][0]
    assert step["force_N"] == [0.1, 1.0]
    assert designer.window.session.history.count() == edits + 1
    assert "0.1 to 1 N" in designer.assessment["texts"]["en"][step["say"]]


def test_a_text_that_is_missing_is_red_and_is_written_in_the_table(designer):
    designer.button("new_scenario")
    designer.add_step("touch")
    table = designer.panel.findChild(QTableWidget, "texts")
    row = list(designer.assessment["texts"]["en"]).index(designer.assessment["steps"][0]["say"])

    table.item(row, 1).setText("")

    assert designer.panel.texts.count_missing() == 1
    table.item(row, 1).setText("Ortaya dokunun")
    assert designer.panel.texts.count_missing() == 0
    assert "Ortaya dokunun" in designer.assessment["texts"]["tr"].values()


def test_levels_and_parameters_are_written_and_stand_for_a_bound(designer, checkout):
    values = designer.panel.values
    designer.button("new_scenario")
    designer.add_step("hold")
    for level in ("normal", "hard"):
        designer.choose(values.levels, values.menus["levels"], f"level_{level}")
    designer.choose(values.add, values.menus["add"], "parameter_N")
    assert designer.assessment["levels"] == ["normal", "hard"]
    assert designer.assessment["parameters"] == {"force": {"unit": "N", "value": 1.0}}

    values.table.item(0, 2).setText("0,6")
    values.table.item(0, 4).setText("0.3")
    values.table.item(0, 0).setText("most")
    designer.choose(values.use, values.menus["use"], "use_force_N_1")

    row = {"unit": "N", "value": 0.6, "levels": {"hard": 0.3}}
    assert designer.assessment["parameters"] == {"most": row}
    assert designer.assessment["steps"][0]["force_N"] == [0.1, "$most"]
    values.table.setCurrentCell(0, 0)
    designer.button("remove_parameter")  # it is used: refused, and said why
    assert "most" in designer.assessment["parameters"]
    designer.picture(checkout, "parameters")
    rows = [row for row in designer.panel.step_form.bands.values() if row.isVisible()]
    assert rows
    # the layout follows when the window has time
    designer.wait(lambda: all(row.height() >= row.sizeHint().height() for row in rows))
    values.table.item(0, 2).setText("0.4..0.8")
    assert designer.assessment["parameters"]["most"] == {"unit": "N", "uniform": [0.4, 0.8]}
    values.table.item(0, 2).setText("no number")
    assert values.table.item(0, 2).text() == "0.4..0.8"
    last = designer.window.session.history.undoText()
    assert "parameter" in last


def test_a_line_follows_the_surface_from_corner_to_corner():
    surface = open_organ(PUBLISHED / "kidney.organ").surface
    x = surface.vertices
    corners = x[[int(x[:, 2].argmax()), int(x[:, 2].argmin())]]

    points = follow_surface(surface, corners)

    assert np.array_equal(points[[0, -1]], corners)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert steps.max() < 1.01 * SPACING
    straight = np.linalg.norm(corners[1] - corners[0])
    assert straight < steps.sum() < 2.0 * straight
    near = [min(np.linalg.norm(x - p, axis=1)) for p in points]
    edge = np.linalg.norm(x[surface.triangles[:, 0]] - x[surface.triangles[:, 1]], axis=1).max()
    assert max(near) < edge


def test_a_band_is_what_a_hand_felt_a_fifth_to_both_sides(tmp_path):
    path = PUBLISHED / "simple_tissue.palpate"
    scene = scenario.read(path).scene
    run = run_script(scene, find_top(scene), PressScript(4e-3, hold=1.0), tmp_path / "r.prec", path)
    held = np.linalg.norm(read_force(run.record), axis=1)
    seen = float(np.median(held[held > 0.5 * held.max()]))

    force, depth = (find_bands(scene, run.record, verb) for verb in ("hold", "push"))

    assert force["force_N"] == pytest.approx([0.8 * seen, 1.2 * seen], abs=1e-3)
    assert depth["force_N"] is None
    least, most = depth["depth_m"]
    assert least < 4e-3 < 1.3 * most
    assert most == pytest.approx(1.5 * least, rel=0.05)


@pytest.mark.landing
def test_a_designer_makes_a_scenario_of_the_liver_in_under_30_clicks(
    qtbot, window, checkout, tmp_path, capsys
):
    designer = Designer(qtbot, window, open_organ(PUBLISHED / "liver.organ"))
    designer.click(window.stage_bar.steps["scenario"])
    designer.button("new_scenario")
    designer.add_step("touch")
    designer.button("draw_point")
    designer.click(window.view, middle(window.view))
    assert "ball" in designer.assessment["places"][designer.assessment["steps"][0]["at"]]
    designer.add_step("push")
    designer.slide("depth_least", 0.1)
    designer.slide("depth_most", 0.25)
    designer.add_step("hold")
    designer.choose(designer.panel.limits.add, designer.panel.limits.menu, "add_limit_force")
    settle(qtbot, window)
    designer.wait(lambda: designer.panel.is_known())
    assert designer.panel.found[1] == []
    designer.button("play_careful")
    designer.wait(lambda: designer.panel.line.attempt is not None)
    assert designer.panel.line.attempt.state.outcome is palpate.Outcome.done
    designer.picture(checkout, "liver")

    designer.click(window.stage_bar.steps["publish"])
    designer.click(window.publish_panel.button)
    out = tmp_path / "liver_task.palpate"
    choose_file(qtbot, window, out)
    designer.clicks += 1  # Save
    designer.qtbot.waitUntil(out.exists, timeout=10 * PATIENCE)  # hands play it first
    settle(qtbot, window)

    assert designer.clicks < MOST_CLICKS, designer.clicks
    print(f"{designer.clicks} clicks")
    made = scenario.read(out)
    drawn = scenario.draw_task(made)
    assert drawn.steps == ["touch", "push", "hold"]
    record = tmp_path / "run.prec"
    assert main(["play", str(out), "--headless", "--device", "script:careful",
                 "--record", str(record), "--json"]) == 0  # fmt: skip
    text = capsys.readouterr().out
    report = json.loads(text[text.index("{") :])
    assert report["outcome"] == "done"
    assert report["verdict"]["errors"] == 0
    tried = json.loads(made.assessment)["selfplay"]
    assert {row["hand"] for row in tried["attempts"]} == {"careful", "idle", "jab", "clumsy"}
    assert not [row for row in tried["problems"] if row["severity"] == "error"]


def test_a_laparoscope_looks_at_a_place_and_objects_are_moved_only_where_there_are_some(designer):
    panel, window = designer.panel, designer.window
    designer.button("new_scenario")
    designer.choose(panel.tools.add, panel.tools.add.menu(), "add_tool_laparoscope")
    designer.add_step("look")
    (step,) = designer.assessment["steps"]
    assert (step["do"], step["tool"], step["for_s"]) == ("look", "laparoscope", 1.0)
    settle(designer.qtbot, window)
    designer.wait(lambda: panel.is_known())
    assert panel.context.assessment.scene is not None
    offered = {action.data() for action in panel.list.menu.actions() if action.isVisible()}
    assert "look" in offered and not offered & {"remove", "carry"}


def test_instruments_are_added_shaped_and_driven_in_the_test_stage(designer, checkout):
    panel, window = designer.panel, designer.window
    designer.button("new_scenario")
    designer.add_step("grasp")
    designer.choose(panel.tools.add, panel.tools.add.menu(), "add_tool_grasper")
    assert list(panel.draft.tools) == ["tip", "grasper"]
    assert panel.step_form.tool.isVisible()
    designer.slide("grip_force_N_grasper", 0.4)
    designer.slide("friction_grasper", 0.4)
    said = designer.assessment["tools"]["grasper"]
    assert (said["grip_force_N"], said["friction"]) == (8.0, 0.4)
    panel.step_form.tool.setCurrentIndex(1)
    panel.step_form.tool.activated.emit(1)
    assert designer.assessment["steps"][0]["tool"] == "grasper"
    row = panel.tools.rows[0]
    row.kind.setCurrentIndex(row.kind.findData("laparoscope"))
    row.kind.activated.emit(row.kind.currentIndex())
    # what takes hold of something is a grasper's
    assert designer.assessment["tools"]["tip"]["kind"] == "laparoscope"
    settle(designer.qtbot, window)
    designer.wait(lambda: panel.is_known())
    assert len(panel.context.assessment.scene.instruments) == 2
    designer.picture(checkout, "instruments")

    designer.click(window.stage_bar.steps["test"])
    window.test_panel.runner.start(HandRequest())
    designer.wait(lambda: window.test_panel.runner.running)
    hands = window.view.tool
    assert isinstance(hands, PointerHands) and len(hands.hands) == 2
    QTest.keyClick(window.view, Qt.Key.Key_Tab)
    assert hands.active == 1
    designer.wait(lambda: window.test_panel.budget.budget is not None)
    names = [part.name for part in window.test_panel.budget.budget.parts]
    assert {"tip", "grasper"} <= set(names)
    designer.picture(checkout, "two_tools")
    window.test_panel.runner.stop()


def test_a_kind_that_is_refused_is_not_shown_as_if_it_were_taken(qtbot):
    """As where a step holds with the grasper."""
    asked = []
    draft = SimpleNamespace(
        tools={"left": {}, "right": {}},
        usual_friction=0.0,
        change=lambda *words: asked.append(words[-1]),
    )
    row = ToolRow("left", {"kind": "grasper", "radius_m": 0.0012}, draft)
    qtbot.addWidget(row)
    ball = row.kind.findData("ball")

    row.kind.setCurrentIndex(ball)
    row.kind.activated.emit(ball)

    assert asked == ["ball"] and row.kind.currentData() == "grasper"
