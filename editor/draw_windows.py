# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the editor, its window of scenes and the trainee's window.

export QT_QPA_PLATFORM=offscreen
.venv/bin/python editor/draw_windows.py editor/pictures [editor] [scene] [player]
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.play import Play, open_play
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
PULLED = 0.38
"""[-] of the way that the player's grasper draws the fundus out."""
LOOK, ZOOM, PAN = (0.6, 0.1), 0.78, (-150.0, -110.0)
"""[rad] azimuth and elevation, [-] and [px], so that the trocar is in sight."""


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
    """A grasper that draws the fundus of a gallbladder out, as the careful hand does."""
    path = write_task("gallbladder", "gallbladder_grasp", folder)
    play = open_play(path, "script:careful", record=folder / "played.prec")
    half = find_pulled(play)
    window = TraineeWindow(play, "dark", "en")
    window.resize(*PLAYER_SIZE)
    window.show()
    window.view.look_from(*LOOK)
    window.view.zoom(ZOOM)
    window.view.pan(*PAN)
    window.restart()
    wait(app, lambda: window.shown.time > half)
    window.over.warning.tell("")  # how busy this machine is
    save(window, out)
    window.close()


def write_task(organ: str, task: str, folder: Path) -> Path:
    """A scenario that ships, published."""
    path, out = MESHES / "scenarios" / f"{task}.json", folder / f"{task}.palpate"
    made = scenario.read(str(PUBLISHED / f"{organ}.palpate"))
    scenario.write(str(out), with_assessment(path, read_assessment(path), made))
    return out


def find_pulled(play: Play) -> float:
    """[s] when the simulated hand has drawn what it holds so far out."""
    samples = play.play_hand()[0]
    held = [sample for sample in samples if sample.buttons]
    at = np.array([sample.position for sample in held])
    way = np.linalg.norm(at - at[0], axis=1)
    return float(held[int(np.argmax(way > PULLED * way.max()))].time)


DRAWN = {"editor": draw_editor, "scene": draw_scene, "player": draw_player}

if __name__ == "__main__":
    target = Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    application, _ = open_application("en")
    for name in sys.argv[2:] or DRAWN:
        with tempfile.TemporaryDirectory() as made_here:
            DRAWN[name](application, target / f"{name}.png", Path(made_here))
