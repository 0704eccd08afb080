# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job by mouse and keys, from a mesh file to a published scenario."""

from __future__ import annotations

import numpy as np
import pytest
from hands import CONTROL, SHIFT, action, child, choose_file, click, drop, log_of, press, type_into
from palpate import scenario
from palpate_editor.document import cost_rules
from palpate_editor.document.files import read_organ
from patience import PATIENCE, settle
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox

pytestmark = pytest.mark.window


def test_a_mesh_becomes_a_published_scenario_by_mouse_and_keys(qtbot, window, spleen, tmp_path):
    session = window.session

    press(window, Qt.Key.Key_I, CONTROL | SHIFT)
    choose_file(qtbot, window, spleen)
    settle(qtbot, window)
    assert session.organ.vertex_count == 4274
    assert f"palpate import {spleen} -o VH_F_Spleen.organ" in log_of(window)

    press(window, Qt.Key.Key_3, CONTROL)
    type_into(child(window, "target_vertices"), "600")  # Return does what the button does
    settle(qtbot, window)
    assert session.organ.vertex_count == 600
    assert "palpate decimate VH_F_Spleen.organ --vertices 600 -o VH" in log_of(window)

    press(window, Qt.Key.Key_4, CONTROL)
    click(child(window, "fix_lowest"))
    type_into(child(window, "model.stiffness"), "175")
    settle(qtbot, window)
    assert session.organ.model.stiffness == 175.0
    assert session.organ.fixed.any()
    assert "palpate material VH_F_Spleen.organ --stiffness=175N/m" in log_of(window)

    press(window, Qt.Key.Key_7, CONTROL)
    type_into(child(window, "title"), "Palpate the spleen")
    settle(qtbot, window)
    assert window.stage_dock.verdict("publish").errors == 0

    press(window, Qt.Key.Key_S, CONTROL)
    choose_file(qtbot, window, tmp_path / "spleen.organ")
    assert window.windowTitle() == "spleen.organ[*] - Palpate Editor"
    assert not window.isWindowModified()
    assert np.array_equal(read_organ(tmp_path / "spleen.organ").fixed, session.organ.fixed)

    click(child(window, "publish"))
    choose_file(qtbot, window, tmp_path / "spleen.palpate")
    settle(qtbot, window)
    published = scenario.read(str(tmp_path / "spleen.palpate"))
    assert published.title == "Palpate the spleen"
    assert len(published.scene.bodies[0].tissue.mass) == 600
    assert "palpate publish" in log_of(window)


@pytest.mark.landing
def test_what_was_saved_comes_back_when_it_is_opened(qtbot, spleen_window, tmp_path):
    window, organ = spleen_window, spleen_window.session.organ
    window.files.write(tmp_path / "kept.organ")

    press(window, Qt.Key.Key_N, CONTROL)
    assert window.session.organ.surface is None
    press(window, Qt.Key.Key_O, CONTROL)
    choose_file(qtbot, window, tmp_path / "kept.organ")
    settle(qtbot, window)

    back = window.session.organ
    assert np.array_equal(back.surface.vertices, organ.surface.vertices)
    assert np.array_equal(back.fixed, organ.fixed)
    assert back.model == organ.model


def test_a_published_file_opens_again_as_the_document_it_was_made_from(
    qtbot, spleen_window, tmp_path
):
    window, organ = spleen_window, spleen_window.session.organ
    type_into_title(window, "A spleen")
    settle(qtbot, window)
    window.publishing.publish(tmp_path / "spleen.palpate")
    settle(qtbot, window)
    window.files.write(tmp_path / "spleen.organ")

    drop(window, tmp_path / "spleen.palpate")
    settle(qtbot, window)

    assert np.array_equal(window.session.organ.fixed, organ.fixed)
    press(window, Qt.Key.Key_S, CONTROL)  # a published file is not overwritten by a document
    choose_file(qtbot, window, tmp_path / "again.organ")
    assert (tmp_path / "again.organ").is_file()


def type_into_title(window, title):
    window.show_stage("publish")
    type_into(child(window, "title"), title)


@pytest.mark.parametrize(
    "redo",
    [
        (Qt.Key.Key_Z, CONTROL | SHIFT),
        pytest.param((Qt.Key.Key_Y, CONTROL), marks=pytest.mark.landing),
    ],
)
def test_undo_and_redo_give_back_the_very_same_organs(qtbot, spleen_window, redo):
    window, session = spleen_window, spleen_window.session
    before = session.organ
    window.show_stage("material")
    type_into(child(window, "material.density"), "1030")
    after = session.organ

    press(window, Qt.Key.Key_Z, CONTROL)
    assert session.organ is before
    assert child(window, "material.density").lineEdit().text() == "1060"
    press(window, *redo)

    assert session.organ is after
    assert after.material.density == 1030.0


@pytest.mark.landing
def test_every_edit_has_a_line_in_the_history(spleen_window):
    history = spleen_window.session.history

    assert [history.text(i) for i in range(history.count())] == [
        "Import",
        "Decimate to 600 vertices",
        "Fix the lowest 10 %",
    ]


def test_closing_asks_while_something_is_unsaved(qtbot, spleen_window):
    window = spleen_window

    window.close()

    box = window.files.question
    assert window.isVisible()
    assert "not saved" in box.text()
    QTest.mouseClick(box.button(QMessageBox.StandardButton.Cancel), Qt.MouseButton.LeftButton)
    assert window.isVisible()
    window.close()
    discard = window.files.question.button(QMessageBox.StandardButton.Discard)
    QTest.mouseClick(discard, Qt.MouseButton.LeftButton)
    assert not window.isVisible()


@pytest.mark.landing
def test_saving_when_asked_goes_on_to_what_was_wanted(qtbot, spleen_window, tmp_path):
    window = spleen_window
    window.files.write(tmp_path / "mine.organ")
    window.menu_actions.use_mms()
    assert window.isWindowModified()

    press(window, Qt.Key.Key_N, CONTROL)
    save = window.files.question.button(QMessageBox.StandardButton.Save)
    QTest.mouseClick(save, Qt.MouseButton.LeftButton)

    assert window.session.organ.surface is None
    assert read_organ(tmp_path / "mine.organ").model.kind == "molecular"


@pytest.mark.landing
def test_play_starts_the_player_in_a_process_of_its_own(qtbot, spleen_window, tmp_path):
    window = spleen_window
    type_into_title(window, "A spleen")
    settle(qtbot, window)
    assert not child(window, "play").isEnabled()
    window.publishing.publish(tmp_path / "spleen.palpate")
    settle(qtbot, window)

    click(child(window, "play"))

    player = window.publishing.child_processes.running[0]
    assert player.waitForStarted(PATIENCE)
    assert player.processId() != 0
    assert f"palpate play {tmp_path / 'spleen.palpate'}" in log_of(window)
    player.kill()
    qtbot.waitUntil(lambda: "The window ended" in window.messages.text, timeout=PATIENCE)
    assert window.publishing.child_processes.running == []


@pytest.mark.landing
def test_the_device_window_opens_from_the_menu_and_ends_with_the_editor(qtbot, spleen_window):
    window = spleen_window

    action(window, "device").trigger()

    child_processes = window.publishing.child_processes
    process = child_processes.running[0]
    assert process.waitForStarted(PATIENCE)
    assert "palpate device --theme" in log_of(window)
    assert process.arguments()[3:5] == ["device", "--theme"]
    child_processes.finish()
    assert child_processes.running == []


def test_publishing_is_refused_with_the_red_checks(qtbot, spleen_window):
    window = spleen_window

    action(window, "publish").trigger()

    assert "Not published: 1 error to fix" in window.messages.text
    assert window.context.stage == "publish"
    rows = [row.label.text() for row in window.publish_panel.rows if not row.isHidden()]
    assert any(row.startswith("No title.") for row in rows)


@pytest.mark.landing
def test_a_fix_button_solves_what_its_check_found(qtbot, spleen_window):
    window = spleen_window
    press(window, Qt.Key.Key_7, CONTROL)
    row = next(r for r in window.publish_panel.rows if r.label.text().startswith("No title."))

    click(row.button)
    settle(qtbot, window)

    assert window.session.organ.title == "VH_F_Spleen"
    assert window.stage_dock.verdict("publish").errors == 0


@pytest.mark.landing
def test_ticks_follow_the_problems(qtbot, window, spleen, monkeypatch):
    monkeypatch.setattr(cost_rules, "TICK_SHARE", 0.05)  # so that 4274 vertices are too many
    assert not window.stage_bar.steps["import"].verdict.known

    window.files.open(spleen)
    settle(qtbot, window)

    assert window.stage_bar.steps["import"].verdict.good
    assert window.stage_bar.steps["repair"].verdict.good
    assert window.stage_bar.steps["decimate"].verdict.warnings == 1
    window.tasks.decimate(600)
    settle(qtbot, window)
    assert window.stage_bar.steps["decimate"].verdict.good
