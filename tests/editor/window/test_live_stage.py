# SPDX-License-Identifier: GPL-3.0-or-later
"""The Test stage: the real loop, the mouse as the hand, scripted presses and their records."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.runs.press import find_top
from palpate.runs.validated import find_validity
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY
from palpate_editor.edits import FixVertices, PaintStiffness, SetChoice, SetConstant, SetTask
from palpate_editor.views.touch import TestPanel
from palpate_editor.views.touch.press_form import write_command
from palpate_editor.views.translations import count
from PySide6.QtCore import QEvent, QPoint, Qt
from touch_context import build_organ, drag, hover, middle, open_context, send_mouse

pytestmark = pytest.mark.window
LONG = 20000
"""[ms] that a run may take on a busy machine."""


def soft_organ():
    """The demo's constants: 100 N/m under the tip."""
    organ = build_organ()
    model = replace(organ.model, stiffness=150.0, home_stiffness=1e6, drag=8.0)
    return replace(organ, model=model, material=replace(organ.material, damping_ratio=0.3))


@pytest.fixture
def panel(qtbot, settings):
    with open_context(qtbot, soft_organ(), settings) as context:
        made = TestPanel(context)
        for widget in (made, made.plot, made.costs):
            qtbot.addWidget(widget)
        made.show()
        made.plot.show()
        yield made
        made.stop()


def press(panel, qtbot):
    """Runs the scripted press and gives what it felt."""
    with qtbot.waitSignal(panel.runner.ended, timeout=LONG) as ended:
        panel.press()
    return ended.args[0]


def start_hand(panel, qtbot):
    panel.tabs.setCurrentIndex(0)
    panel.toggle()
    qtbot.waitUntil(lambda: panel.running, timeout=LONG)


def wait_force(panel, qtbot, accept):
    """Waits until the newest force of the plot is as it should be."""

    def felt():
        trace = panel.plot.traces[-1]
        return len(trace) > 0 and accept(float(trace.size[-1]))

    qtbot.waitUntil(felt, timeout=LONG)


# ---------------------------------------------------------------- scripted


def test_a_script_that_goes_deeper_than_what_is_validated_is_told_at_once(panel, qtbot):
    def checks():
        return [row.label.text() for row in panel.rows if not row.isHidden()]

    qtbot.waitUntil(lambda: panel.context.assessment is not None, timeout=LONG)
    panel.show_checks()
    assert not any("validated" in text for text in checks())  # by hand nobody knows how deep

    panel.tabs.setCurrentIndex(1)
    panel.press_form._take_depth(20e-3)
    [told] = [text for text in checks() if "validated" in text]
    top = find_top(panel.context.assessment.scene)
    validity = find_validity(panel.context.assessment.scene, top)
    assert f"20.0 mm deep at 0, 0, {1e3 * top.point[2]:.0f} mm" in told
    assert f"Expected: at most {1e3 * validity.depth:.1f} mm" in told

    panel.press_form._take_depth(0.9 * validity.depth)
    [news] = [text for text in checks() if "validated" in text]
    assert news.startswith("The press stays within the ")


def test_a_scripted_press_in_the_window_feels_what_the_command_line_feels(
    panel, qtbot, tmp_path, capsys
):
    panel.press_form.show_place(np.array([0.01, -0.02, 0.02]))
    panel.press_form._take_pull(4e-3)
    outcome = press(panel, qtbot)
    panel.results.save_record(tmp_path / "kept.prec")

    script, place = panel.press_form.script(), panel.press_form.place
    words = write_command(str(tmp_path / "kept.palpate"), script, place)
    assert main([*words[1:], "--json"]) == 0
    felt = json.loads(capsys.readouterr().out)

    # the hand is the same in every run in which no tick is missed
    slack = 1e-9 if felt["missed_ticks"] == outcome.report.missed_ticks == 0 else 0.05
    for name in ("peak_force_N", "patch_stiffness_N_per_m", "pull_force_N"):
        assert outcome.felt[name] == pytest.approx(felt[name], rel=slack), name
    assert outcome.felt["peak_force_N"] > 0.2


def test_a_kept_record_replays_to_the_same_bits(panel, qtbot, tmp_path, capsys):
    press(panel, qtbot)
    panel.results.save_record(tmp_path / "kept.prec")
    assert main(["replay", str(tmp_path / "kept.prec"), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["equal"] and report["ticks"] > 500


def test_the_panel_says_what_a_press_felt_and_the_plot_holds_every_tick(panel, qtbot):
    outcome = press(panel, qtbot)
    words = panel.results.facts.texts()
    assert words["Peak force"].startswith(f"{outcome.felt['peak_force_N']:.3g}")
    assert words["Missed ticks"].endswith(f"/ {count(outcome.report.ticks)}")
    trace = panel.plot.traces[-1]
    assert len(trace) == len(outcome.record.hand)
    assert trace.find_peak()[1] == pytest.approx(outcome.felt["peak_force_N"], rel=1e-6)
    assert panel.costs.text("cost") != "–"


@pytest.mark.landing
def test_a_stiffer_place_presses_harder_and_undo_gives_back_the_softer_one(panel, qtbot):
    session = panel.context.session
    soft = press(panel, qtbot).felt["peak_force_N"]
    x = session.organ.surface.vertices
    top = np.flatnonzero(x[:, 2] > 0.02)

    session.apply(PaintStiffness(top, 4.0))
    stiff = press(panel, qtbot).felt["peak_force_N"]
    session.history.undo()
    again = press(panel, qtbot).felt["peak_force_N"]

    assert stiff > 1.5 * soft
    assert again == pytest.approx(soft, rel=0.05)


@pytest.mark.landing
def test_fixed_vertices_do_not_move_while_others_do(panel, qtbot):
    session = panel.context.session
    x = session.organ.surface.vertices
    session.apply(FixVertices(np.flatnonzero(x[:, 0] > 0.0), True))
    moved = np.zeros(len(x))

    def look(frame):
        np.maximum(moved, np.linalg.norm(frame.positions[0] - x, axis=1), out=moved)

    with qtbot.waitSignal(panel.runner.ended, timeout=LONG):
        panel.press()
        qtbot.waitUntil(lambda: panel.running, timeout=LONG)
        panel.runner.trial.framed.connect(look)

    assert moved[session.organ.fixed].max() == 0.0
    assert moved[~session.organ.fixed].max() > 1e-4


@pytest.mark.landing
def test_a_press_marks_the_organ_as_tested_and_an_edit_takes_that_back(panel, qtbot):
    session = panel.context.session
    assert not session.is_tested
    press(panel, qtbot)
    assert session.is_tested
    session.apply(SetConstant("model", "stiffness", 200.0))
    assert not session.is_tested


def test_a_number_out_of_range_is_refused_with_a_sentence(panel, qtbot):
    told = []
    panel.context.told.connect(lambda words, severity: told.append((words, severity)))
    box = panel.press_form._rows["depth"].box
    box.lineEdit().setText("900")
    box.enter()
    assert told == [("Depth must lie between 0.1 and 100 mm, got 900.", "error")]
    assert panel.press_form.script().depth == 6e-3
    assert box.lineEdit().text() == "6"


def test_picking_a_place_with_the_mouse_presses_there(panel, qtbot):
    panel.tabs.setCurrentIndex(1)
    panel.show()
    view = panel.context.view
    qtbot.mouseClick(panel.press_form.pick, Qt.MouseButton.LeftButton)
    at = middle(view) + QPoint(40, 20)
    hover(view, at)
    expected = np.array(view.pick(at.toPointF()).point)
    drag(view, at, at, steps=0)

    assert panel.press_form.place == pytest.approx(expected, abs=1e-6)
    assert view.tool is None
    outcome = press(panel, qtbot)
    felt = np.linalg.norm(outcome.force, axis=1)
    tip = np.asarray(outcome.record.felt["position"])[felt.argmax()]
    assert np.linalg.norm(tip - expected) < 0.01


def test_a_ring_marks_the_place_of_the_press(panel, qtbot, monkeypatch):
    context, rings, show_ring = panel.context, [], panel.context.view.show_ring

    def look(centre, *rest):
        rings.append(centre)
        show_ring(centre, *rest)

    monkeypatch.setattr(context.view, "show_ring", look)
    context.stage = "test"
    qtbot.waitUntil(lambda: context.assessor.is_current, timeout=LONG)
    panel.tabs.setCurrentIndex(1)
    assert rings[-1][2] == pytest.approx(0.03, rel=0.02)  # the top of the ball
    panel.press_form.show_place(np.array([0.0, -0.05, 0.0]))
    assert rings[-1][1] == pytest.approx(-0.03, rel=0.02)
    panel.tabs.setCurrentIndex(0)
    assert rings[-1] is None


# ---------------------------------------------------------------- by hand


def test_the_mouse_presses_the_organ_and_feels_nothing_away_from_it(panel, qtbot):
    view = panel.context.view
    start_hand(panel, qtbot)
    at = middle(view)
    hover(view, at)
    drag(view, at, at, steps=1, let_go=False)
    wait_force(panel, qtbot, lambda force: force > 0.1)
    frame = view.grab_picture()
    assert view.legend.isVisible() and view.hud.isVisible()

    left, nothing = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    send_mouse(view, QEvent.Type.MouseButtonRelease, at, left, nothing)
    wait_force(panel, qtbot, lambda force: force == 0.0)

    panel.stop()
    assert panel.outcome.felt["peak_force_N"] > 0.1
    assert view.tool is None and not view.hud.isVisible() and not view.legend.isVisible()
    assert view.grab_picture() != frame


def test_space_pauses_and_goes_on_and_reset_starts_over(panel, qtbot):
    start_hand(panel, qtbot)
    qtbot.waitUntil(lambda: len(panel.plot.traces[-1]) > 3, timeout=LONG)
    panel.toggle()
    assert panel.runner.paused and panel.running
    panel.toggle()
    assert not panel.runner.paused

    first = panel.runner.trial
    panel.reset()
    qtbot.waitUntil(lambda: panel.runner.trial is not None, timeout=LONG)
    assert panel.runner.trial is not first
    assert len(panel.plot.traces) == 2


def test_editing_the_organ_ends_the_run_with_a_sentence(panel, qtbot):
    told = []
    panel.context.told.connect(lambda words, severity: told.append(words))
    start_hand(panel, qtbot)
    panel.context.session.apply(FixVertices(np.array([0]), True))
    assert not panel.running
    assert told == ["The run was stopped because the organ was changed. Start it again."]


def test_words_about_the_organ_may_change_during_a_run(panel, qtbot):
    start_hand(panel, qtbot)
    panel.context.session.apply(SetTask(scenario_title="The ball"))
    assert panel.running
    panel.stop()
    assert panel.context.session.is_tested


def test_leaving_the_stage_ends_the_run(panel, qtbot):
    start_hand(panel, qtbot)
    panel.context.stage_shown.emit("material")
    assert not panel.running


def test_closing_in_the_middle_of_a_run_neither_hangs_nor_crashes(panel, qtbot):
    start_hand(panel, qtbot)
    trial = panel.runner.trial
    panel.context.view.close()
    panel.close()
    panel.stop()
    assert trial.report is not None and not trial.run.running


def test_without_an_organ_a_sentence_says_what_to_do(qtbot, settings):
    with open_context(qtbot, soft_organ(), settings) as context:
        context.session.restore(EMPTY, None)
        panel = TestPanel(context)
        qtbot.addWidget(panel)
        told = []
        context.told.connect(lambda words, severity: told.append(words))
        panel.toggle()
    assert told == ["There is no organ to test yet: import a mesh file first."]
    assert not panel.running


# ---------------------------------------------------------------- what goes wrong


def test_an_organ_that_cannot_be_compiled_is_refused_with_the_reason(panel, qtbot):
    told = []
    panel.context.told.connect(lambda words, severity: told.append(words))
    panel.context.session.apply(SetChoice("kind", "molecular"))
    panel.context.session.apply(SetConstant("model", "stretch_coupling", 50.0))
    panel.toggle()
    qtbot.waitUntil(lambda: not panel.runner.waiting, timeout=LONG)
    assert not panel.running
    assert len(told) == 1 and told[0].startswith("The organ cannot be tested yet: got ")
    assert "50 N" in told[0] and ", expected " in told[0]


def test_an_organ_that_blows_up_ends_the_run_with_a_sentence(panel, qtbot):
    context, told = panel.context, []
    context.told.connect(lambda words, severity: told.append((words, severity)))
    qtbot.waitUntil(lambda: context.assessor.is_current, timeout=LONG)
    # no organ of the editor blows up by itself: the builder chooses the substeps
    scene = scene_that_blows_up(context.session.organ)
    checked = replace(context.assessment.checked, scene=scene)
    context.assessor.assessment = replace(context.assessment, checked=checked)

    press(panel, qtbot)

    assert len(told) == 1 and told[0][1] == "error"
    assert told[0][0].startswith("The run was stopped after")
    assert "the tissue blew up: " in told[0][0]
    assert not panel.context.session.is_tested
    # what to do about it is found beside the window
    qtbot.waitUntil(lambda: len(told) == 2, timeout=LONG)
    assert told[1][0].startswith(told[0][0]) and len(told[1][0]) > len(told[0][0]) + 10


class HandThatMayFail(palpate.PointerDevice):
    """Goes where the test says, whatever the window wants of it."""

    def post(self, target: palpate.PointerTarget) -> None:
        """Deaf to the mouse."""


def test_a_device_that_fails_ends_the_run_with_a_sentence(panel, qtbot, monkeypatch):
    told = []
    # the window's own hand refuses what is not finite: this one may say it, as a real device may
    monkeypatch.setattr(palpate, "SurfacePointer", lambda *scene: HandThatMayFail())
    panel.context.told.connect(lambda words, severity: told.append((words, severity)))
    start_hand(panel, qtbot)
    with qtbot.waitSignal(panel.runner.ended, timeout=LONG):
        panel.runner.trial.device.set(palpate.HapticSample(position=[np.nan, 0.0, 0.0]))
    assert told == [("The device failed (sample not finite): the run was stopped.", "error")]
    assert not panel.running


def scene_that_blows_up(organ) -> palpate.Scene:
    """The organ with far fewer substeps than it needs."""
    stiff = replace(organ, model=replace(organ.model, stiffness=4000.0))
    scene = compile_organ(stiff)
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 1
    return scene


@pytest.mark.landing
def test_the_plot_exports_every_row_of_every_run(panel, qtbot, tmp_path):
    press(panel, qtbot)
    panel.plot.export_csv(tmp_path / "forces")
    rows = (tmp_path / "forces.csv").read_text(encoding="utf-8").splitlines()
    assert rows[0] == "run,time_s,force_x_N,force_y_N,force_z_N,force_N"
    assert len(rows) == 1 + len(panel.plot.traces[-1])
    assert rows[1].startswith("Press 1,0.0000,")


# ---------------------------------------------------------------- in the main window


def feel(window, qtbot):
    """The mouse is the hand in the main window's Test stage."""
    window.show_stage("test")
    window.test_panel.tabs.setCurrentIndex(0)
    window.test_panel.toggle()
    qtbot.waitUntil(lambda: window.test_panel.running, timeout=LONG)
    return window.test_panel.runner.trial


@pytest.mark.landing
def test_the_main_window_closes_in_the_middle_of_a_run(spleen_window, qtbot):
    trial = feel(spleen_window, qtbot)
    spleen_window.may_close = True
    spleen_window.close()
    assert trial.report is not None and not trial.run.running


@pytest.mark.landing
def test_undo_in_the_middle_of_a_run_ends_it_and_shows_the_organ_of_before(spleen_window, qtbot):
    window = spleen_window
    feel(window, qtbot)
    window.session.history.undo()
    assert not window.test_panel.running
    assert not window.session.organ.fixed.any()
    shown = np.asarray(window.view.scenery.vertices)
    assert np.allclose(shown, window.session.organ.surface.vertices, atol=1e-6)


@pytest.mark.landing
def test_a_new_document_ends_the_run(spleen_window, qtbot):
    trial = feel(spleen_window, qtbot)
    spleen_window.session.clear()
    assert not spleen_window.test_panel.running and not trial.run.running
    assert spleen_window.session.organ.surface is None
