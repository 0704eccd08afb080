# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor on small screens: it fits, its docks come back, and Enter does what a field is for."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from hands import child, type_into
from patience import settle
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

pytestmark = pytest.mark.window

OPEN_ON_A_SCREEN = """
import json, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from palpate.viewport.application import open_application
from palpate_editor.app.settings import Settings
from palpate_editor.views.editor import Editor
app, _ = open_application(sys.argv[2])
folder = Path(sys.argv[1])
settings = Settings(QSettings(str(folder / "s.ini"), QSettings.Format.IniFormat))
editor = Editor(app, settings, language=sys.argv[2], recovery_folder=folder)
window = editor.window
editor.show()
sizes = []
for stage in window.stage_bar.steps:
    window.show_stage(stage)
    app.processEvents()
    sizes.append([window.frameGeometry().width(), window.frameGeometry().height()])
free = window.screen().availableGeometry()
window.may_close = True
window.close()
print(json.dumps([[free.width(), free.height()], sizes]))
"""


@pytest.mark.parametrize("language", ["en", "tr"])
@pytest.mark.parametrize(("size", "factor"), [((1280, 720), 1), ((1920, 1080), 2)])
def test_the_editor_fits_its_screen_in_every_stage(tmp_path, size, factor, language):
    screen = {"name": "small", "x": 0, "y": 0, "width": size[0], "height": size[1]}
    screen |= {"logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}
    config = tmp_path / "screens.json"
    config.write_text(json.dumps({"screens": [screen]}))
    env = os.environ | {
        "QT_QPA_PLATFORM": f"offscreen:configfile={config}",
        "QT_SCALE_FACTOR": str(factor),
    }

    words = [sys.executable, "-c", OPEN_ON_A_SCREEN, str(tmp_path), language]
    ran = subprocess.run(words, env=env, capture_output=True, text=True)

    assert ran.returncode == 0, ran.stderr
    free, sizes = json.loads(ran.stdout.splitlines()[-1])
    assert free == [size[0] // factor, size[1] // factor]
    for width, height in sizes:
        assert width <= free[0] and height <= free[1], (free, sizes)


def test_docks_that_a_small_window_squeezed_are_as_large_as_before_in_a_large_one(qtbot, window):
    window.resize(1440, 900)
    qtbot.wait(50)
    docks = window.docks.docks
    before = {name: docks[name].size() for name in ("scene", "stage", "log", "history")}

    window.resize(window.minimumSizeHint())
    qtbot.wait(50)
    assert docks["log"].height() < before["log"].height()
    assert docks["history"].height() < before["history"].height()
    window.resize(1440, 900)

    qtbot.wait(100)
    # the line between two docks of one column may stand a few pixels off
    for name in ("scene", "stage"):
        assert docks[name].width() == before[name].width(), name
    for name in ("log", "history"):
        assert abs(docks[name].height() - before[name].height()) <= 12, name


def test_a_width_that_a_person_gave_a_dock_is_the_one_that_comes_back(qtbot, window):
    window.resize(1440, 900)
    qtbot.wait(50)
    scene = window.docks.docks["scene"]
    window.resizeDocks([scene], [340], Qt.Orientation.Horizontal)
    qtbot.waitUntil(lambda: scene.width() == 340)
    QTest.mouseClick(window, Qt.MouseButton.LeftButton)  # the line between docks is let go

    window.resize(window.minimumSizeHint())
    qtbot.waitUntil(lambda: scene.width() < 340)
    window.resize(1440, 900)

    qtbot.waitUntil(lambda: scene.width() == 340)


def test_enter_in_the_field_of_vertices_decimates(qtbot, window, spleen):
    window.files.open(spleen)
    settle(qtbot, window)
    window.show_stage("decimate")

    type_into(child(window, "target_vertices"), "700")
    settle(qtbot, window)

    assert window.session.organ.vertex_count == 700
    assert window.session.history.undoText() == "Decimate to 700 vertices"


def test_enter_on_the_welcome_card_opens_the_organ_that_is_chosen(qtbot, window):
    welcome = window.welcome
    welcome.setFocus()
    QTest.keyClick(welcome, Qt.Key.Key_Return)
    settle(qtbot, window)
    assert window.session.organ.name == "simple tissue"

    window.session.start_anew()
    kidney = welcome.shipped.buttons["kidney_stone"]
    kidney.setFocus()
    QTest.keyClick(kidney, Qt.Key.Key_Enter)
    settle(qtbot, window)
    assert window.session.organ.name == "kidney stone"
