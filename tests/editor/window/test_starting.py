# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `editor`, and taking up what a crash left."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from hands import click
from palpate_editor.app.recovery import find_recoveries
from palpate_editor.document.files import read_organ
from patience import PATIENCE, settle
from PySide6.QtWidgets import QMessageBox

pytestmark = pytest.mark.window

COMMAND = [sys.executable, "-m", "palpate", "editor"]

WORK_AND_DIE = """
import sys
from pathlib import Path
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication
from palpate_editor.app.settings import Settings
from palpate_editor.views.editor import Editor

app = QApplication([])
folder = Path(sys.argv[1])
settings = Settings(QSettings(str(folder / "other.ini"), QSettings.Format.IniFormat))
editor = Editor(app, settings, recovery_folder=folder / "recovery")
editor.show()
editor.autosave.saved.connect(lambda when: print("kept", flush=True))
editor.window.files.open(Path(sys.argv[2]))
app.exec()
"""


def without_display() -> dict[str, str]:
    gone = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    return {name: value for name, value in os.environ.items() if name not in gone}


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="cannot be had here: a display")
def test_without_a_display_the_verb_says_so_and_exits_1():
    done = subprocess.run(COMMAND, env=without_display(), capture_output=True, encoding="utf-8")

    assert done.returncode == 1
    assert "there is no display" in done.stderr
    assert "decimate" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="cannot be had here: a display")
def test_a_display_that_cannot_be_reached_is_a_sentence_too():
    env = without_display() | {"DISPLAY": ":98765"}

    done = subprocess.run(COMMAND, env=env, capture_output=True, encoding="utf-8")

    assert done.returncode == 1
    assert "the display :98765 cannot be reached" in done.stderr


def test_the_verb_opens_a_window_with_the_file_in_it(spleen, tmp_path):
    """It goes on until it is closed; what it had open is there for a recovery."""
    env = os.environ | {"QT_QPA_PLATFORM": "offscreen", "XDG_DATA_HOME": str(tmp_path)}
    env |= {"XDG_CONFIG_HOME": str(tmp_path)}
    started = subprocess.Popen([*COMMAND, str(spleen), "--theme", "light"], env=env)
    folder = tmp_path / "palpate" / "recovery"

    deadline = time.monotonic() + PATIENCE / 1000
    while not list(folder.glob("*.organ")) and time.monotonic() < deadline:
        assert started.poll() is None
        time.sleep(0.05)
    started.kill()
    started.wait()

    (kept,) = find_recoveries(folder)
    assert kept.read().vertex_count == 4274


def test_a_file_that_is_not_there_is_refused_before_a_window_opens(tmp_path):
    missing = tmp_path / "none.organ"

    done = subprocess.run([*COMMAND, str(missing)], capture_output=True, encoding="utf-8")

    assert done.returncode == 1
    assert "no such file" in done.stderr


@pytest.mark.landing
def test_what_a_killed_editor_left_unsaved_is_offered_and_taken_up(
    qtbot, make_editor, spleen, tmp_path
):
    (tmp_path / "recovery").mkdir()
    other = subprocess.Popen(
        [sys.executable, "-c", WORK_AND_DIE, str(tmp_path), str(spleen)],
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert other.stdout.readline() == "kept\n"
    other.send_signal(signal.SIGKILL)
    other.wait()
    kept = find_recoveries(tmp_path / "recovery")
    assert len(kept) == 1

    editor = make_editor()
    qtbot.waitUntil(lambda: editor.question is not None, timeout=PATIENCE)
    assert "VH_F_Spleen" in editor.question.text()
    click(editor.question.button(QMessageBox.StandardButton.Open))
    settle(qtbot, editor.window)

    assert editor.session.organ.vertex_count == 4274
    assert editor.window.isWindowModified()
    editor.window.files.write(tmp_path / "saved.organ")
    assert read_organ(tmp_path / "saved.organ").vertex_count == 4274
    qtbot.waitUntil(lambda: not find_recoveries(tmp_path / "recovery"), timeout=PATIENCE)


@pytest.mark.landing
def test_what_is_thrown_away_is_not_offered_again(qtbot, make_editor, spleen_window, tmp_path):
    from palpate_editor.app.recovery import RecoveryFile

    folder = tmp_path / "recovery"
    left = RecoveryFile(folder)
    left.write(spleen_window.session.organ, None, "left behind")
    left.held.unlock()

    editor = make_editor()
    click(editor.question.button(QMessageBox.StandardButton.Discard))

    assert [found.name for found in find_recoveries(folder)] == []
    assert editor.session.organ.surface is None
    assert np.all(editor.session.organ.fixed == 0)
