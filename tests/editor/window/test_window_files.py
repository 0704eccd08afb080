# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the window: dropped, recent, missing, foreign, hostile; every refusal is a sentence."""

from __future__ import annotations

import numpy as np
import pytest
from hands import CONTROL, choose_file, click, drop, log_of, press
from patience import settle
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

pytestmark = pytest.mark.window


def test_a_mesh_that_is_dropped_comes_in(qtbot, window, spleen):
    drop(window, spleen)
    settle(qtbot, window)

    assert window.session.organ.source.file == "VH_F_Spleen.glb"
    assert window.welcome.isHidden()
    window.session.history.undo()
    assert not window.welcome.isHidden()


@pytest.mark.landing
def test_a_file_that_is_nothing_to_us_is_refused_with_a_sentence(window, tmp_path):
    stranger = tmp_path / "letter.txt"
    stranger.write_text("Dear surgeon", encoding="utf-8")

    drop(window, stranger)

    assert "letter.txt" in window.messages.text
    assert ".organ" in window.messages.text


def test_a_hostile_mesh_is_a_sentence_in_the_window(qtbot, window, shared_data):
    for name in (
        "assimp_invalid_malformed.obj",
        "assimp_invalid_empty.obj",
        "assimp_OFF_invalid.off",
        "assimp_glTF2_IndexOutOfRange_IndexOutOfRange.gltf",
        "assimp_PLY_points.ply",
    ):
        drop(window, shared_data(f"hostile/{name}"))
        settle(qtbot, window)

        assert name in window.messages.text
        assert "Traceback" not in window.messages.text
        assert window.session.organ.surface is None, name


def test_a_damaged_document_is_a_sentence_and_changes_nothing(qtbot, spleen_window, tmp_path):
    window, organ = spleen_window, spleen_window.session.organ
    window.files.write(tmp_path / "good.organ")
    broken = tmp_path / "broken.organ"
    broken.write_bytes((tmp_path / "good.organ").read_bytes()[:-200])

    window.files.open(broken)
    settle(qtbot, window)

    assert "broken.organ" in window.messages.text
    assert window.session.organ is organ


def test_each_unit_says_how_long_the_organ_would_be_and_what_is_no_organ_is_faint(spleen_window):
    panel = spleen_window.import_panel
    words = [panel.unit.itemText(row) for row in range(panel.unit.count())]
    x = spleen_window.session.organ.imported.vertices
    size = float(np.linalg.norm(np.ptp(x, axis=0)))

    assert words[0] == f"metre (m): {1e3 * size:.0f}\u00a0mm long"
    assert words[2].startswith("millimetre (mm): 0.1") and "ft" in words[5]
    faint = [panel.unit.itemData(row, Qt.ItemDataRole.ForegroundRole) for row in range(6)]
    assert faint[0] is None and all(colour is not None for colour in faint[1:3])


@pytest.mark.landing
def test_another_unit_makes_another_size_and_can_be_undone(qtbot, spleen_window):
    window, panel = spleen_window, spleen_window.import_panel
    window.show_stage("import")
    before = window.session.organ

    panel.unit.setFocus()
    QTest.keyClick(panel.unit, Qt.Key.Key_Down)
    settle(qtbot, window)

    assert window.session.organ.source.unit == "cm"
    assert window.session.organ.surface.vertices.max() == pytest.approx(
        before.surface.vertices.max() / 100
    )
    words = panel.facts.texts()
    assert words["Size"].endswith("mm")
    press(window, Qt.Key.Key_Z, CONTROL)
    assert window.session.organ is before


def test_recent_files_are_listed_and_missing_ones_are_grey(qtbot, window, spleen, tmp_path):
    gone = tmp_path / "gone.organ"
    gone.write_bytes(b"")
    window.settings.add_recent(gone)
    window.settings.add_recent(spleen)
    gone.unlink()

    window.recent.fill()

    first, second = window.recent.menu.actions()[:2]
    assert first.isEnabled() and "VH_F_Spleen.glb" in first.text()
    assert not second.isEnabled() and "gone.organ" in second.text()
    first.trigger()
    settle(qtbot, window)
    assert window.session.organ.vertex_count == 4274


@pytest.mark.landing
def test_the_welcome_offers_recent_files(qtbot, window, spleen):
    window.settings.add_recent(spleen)
    window.welcome.refresh()
    button = next(b for b in window.welcome.findChildren(QPushButton) if b.property("path"))

    click(button)
    settle(qtbot, window)

    assert window.session.organ.vertex_count == 4274


@pytest.mark.landing
def test_a_disk_that_refuses_is_a_sentence(spleen_window, tmp_path):
    window = spleen_window

    window.files.write(tmp_path / "no" / "such" / "folder" / "spleen.organ")

    assert "spleen.organ" in window.messages.text
    assert window.isWindowModified()


@pytest.mark.landing
def test_a_picture_is_what_the_viewport_shows(qtbot, spleen_window, tmp_path):
    window = spleen_window

    press(window, Qt.Key.Key_F12)
    choose_file(qtbot, window, tmp_path / "spleen.png")

    assert (tmp_path / "spleen.png").stat().st_size > 10_000
    assert "palpate render" in log_of(window)


def test_what_nobody_caught_is_a_sentence(editor):
    window = editor.window

    editor.hook.on_exception(ZeroDivisionError, ZeroDivisionError("division by zero"), None)

    assert "division by zero" in window.messages.text
    assert "save it" in window.messages.text


def test_help_says_something_about_every_stage(window):
    for stage in window.stage_bar.steps:
        window.show_stage(stage)
        press(window, Qt.Key.Key_F1)
        assert window.context.stages.by_name[stage].help()[0][:40] in window.help.text.toPlainText()
    window.help.hide()
    press(window, Qt.Key.Key_F1, Qt.KeyboardModifier.ShiftModifier)
    assert "Ctrl+Shift+P" in window.help.text.toPlainText()
