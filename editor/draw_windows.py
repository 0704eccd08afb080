# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the editor, its window of scenes and the trainee's window.

export QT_QPA_PLATFORM=offscreen
.venv/bin/python editor/draw_windows.py editor/pictures
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from palpate import scenario
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.play import TAIL, Play
from palpate.runs.press import PressScript, find_top, write_script
from palpate.viewport.application import open_application
from palpate_editor.app.settings import Settings
from palpate_editor.views.editor import Editor
from palpate_editor.views.layout.layout_window import LayoutWindow
from palpate_editor.views.theme import use_theme
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication, QWidget

MESHES = Path(__file__).resolve().parents[1] / "meshes"
PUBLISHED = MESHES / "published"
SIZE = (1440, 900)
"""[px] of the editor."""
PLAYER_SIZE = (1280, 800)
PATIENCE = 60.0
"""[s]"""
DEEPEST = 0.5
"""[s] after which the press that the panel proposes is held at its depth."""
DEPTH = 6e-3
"""[m] of the player's press."""


def wait(app: QApplication, done: Callable[[], bool]) -> None:
    """Lets the windows live until something has come about. Raises RuntimeError."""
    until = time.monotonic() + PATIENCE
    while not done():
        app.processEvents()
        time.sleep(2e-3)
        if time.monotonic() > until:
            raise RuntimeError("the window did not get there in time")


def live(app: QApplication, seconds: float) -> None:
    until = time.monotonic() + seconds
    wait(app, lambda: time.monotonic() > until)


def save(window: QWidget, out: Path) -> None:
    window.view.grab_picture()
    if not window.grab().save(str(out)):
        raise RuntimeError(f"{out}: cannot be written")


def draw_editor(app: QApplication, out: Path, folder: Path) -> None:
    """Test, at the deepest point of a press of the spleen."""
    settings = Settings(QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat))
    editor = Editor(app, settings, theme="dark", language="en", recovery_folder=folder)
    window = editor.window
    editor.show()
    # the screen of no display is smaller, and the window has fitted itself into it
    window.resize(*SIZE)
    window.files.open(PUBLISHED / "spleen.organ")
    wait(
        app, lambda: window.session.organ.surface is not None and window.context.assessor.is_current
    )
    window.show_stage("test")
    panel = window.test_panel
    panel.tabs.setCurrentIndex(1)
    live(app, 0.5)
    panel.start_button.click()
    wait(app, lambda: find_time(panel) > DEEPEST)
    # nothing moves on between here and the picture: the window lives in wait() only
    save(window, out)
    panel.start_button.click()
    window.may_close = True
    window.close()


def find_time(panel: QWidget) -> float:
    """[s] that the press has run."""
    trace = panel.plot.traces[-1] if panel.plot.traces else ()
    return float(trace.time[-1]) if len(trace) else 0.0


def draw_scene(app: QApplication, out: Path, folder: Path) -> None:
    """A gallbladder that is being laid into its fossa, its handles out."""
    store = QSettings(str(folder / "scene.ini"), QSettings.Format.IniFormat)
    use_theme(app, "dark")
    window = LayoutWindow(Settings(store), "dark")
    before = os.getcwd()
    os.chdir(MESHES / "scenes")  # the log shows what a reader would type there
    window.open(Path("liver_gallbladder.layout.json"))
    window.show()
    window.resize(*SIZE)
    window.arrange()
    wait(app, lambda: bool(window.shapes))
    window.choose("gallbladder")
    window.do(("place", "gallbladder", "--by=0,0,1.5"))
    window.view.look_from(-1.2, -0.1)
    window.view.frame_all()
    wait(app, lambda: window.checked is not None)
    live(app, 2.0)
    os.chdir(before)
    save(window, out)
    window.may_close = True
    window.close()


def draw_player(app: QApplication, out: Path, folder: Path) -> None:
    """A gallbladder, with the tool at its deepest."""
    path = PUBLISHED / "gallbladder.palpate"
    made = scenario.read(str(path))
    script = PressScript(DEPTH, hold=PATIENCE)
    frames, times = write_script(
        find_top(made.scene), made.scene.instruments[0].tool.radius, script
    )
    play = Play(path, made, frames, duration=times.end + TAIL, record=folder / "played.prec")
    window = TraineeWindow(play, "dark", "en")
    window.resize(*PLAYER_SIZE)
    window.show()
    window.restart()
    wait(app, lambda: window.over.force.peak > 0.05)
    live(app, 0.3)
    save(window, out)
    window.close()


if __name__ == "__main__":
    target = Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    application, _ = open_application("en")
    with tempfile.TemporaryDirectory() as made_here:
        draw_editor(application, target / "editor.png", Path(made_here))
        draw_scene(application, target / "scene.png", Path(made_here))
        draw_player(application, target / "player.png", Path(made_here))
