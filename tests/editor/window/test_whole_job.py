# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole main job in the window, with mouse and keys: from a mesh file to a played scenario."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from palpate import scenario
from palpate.cli.main import main
from palpate.player.trainee_window import TraineeWindow
from palpate.runs.play import Play
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.script_file import write_script_file
from palpate.viewport import FboView, GLView
from patience import PATIENCE, settle
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QLineEdit
from touch_context import drag, hover, middle

pytestmark = [pytest.mark.window, pytest.mark.landing]

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
LEFT = Qt.MouseButton.LeftButton
CONSTANTS = {
    "model.stiffness": "150",
    "model.home_stiffness": "0.001",
    "model.drag": "8",
    "material.damping_ratio": "0.3",
}
"""As typed, in the units of the form: those of the demo, 100 N/m under the tip."""


class Job:
    """One person at one window, who takes a picture of each stage."""

    def __init__(self, qtbot, window, folder: Path, theme: str):
        self.qtbot, self.window = qtbot, window
        self.folder, self.theme, self.count = folder, theme, 0

    @property
    def organ(self):
        return self.window.session.organ

    def key(self, key, modifiers=Qt.KeyboardModifier.NoModifier) -> None:
        self.window.view.setFocus()
        self.qtbot.keyClick(self.window, key, modifiers)

    def settle(self) -> None:
        settle(self.qtbot, self.window)

    def type(self, name: str, text: str) -> None:
        """Types into the field of that name and leaves it with Enter."""
        field = self.window.findChild(object, name)
        line = field if isinstance(field, QLineEdit) else field.lineEdit()
        self.qtbot.mouseClick(line, LEFT)
        line.selectAll()
        self.qtbot.keyClicks(line, text)
        self.qtbot.keyClick(field, Qt.Key.Key_Return)
        self.settle()

    def picture(self, name: str, widget=None) -> None:
        """Into the build folder, to be looked at."""
        shown = widget or self.window
        self.qtbot.wait(300)  # the view refines its picture while nothing moves
        self.count += 1
        path = self.folder / f"{self.theme}_{self.count:02d}_{name}.png"
        assert shown.grab().save(str(path))

    def drop(self, path: Path) -> None:
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path))])
        at, copy = QPoint(400, 300), Qt.DropAction.CopyAction
        enter = QDragEnterEvent(at, copy, data, LEFT, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(self.window, enter)
        assert enter.isAccepted()
        drop = QDropEvent(QPointF(at), copy, data, LEFT, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(self.window, drop)

    def wait(self, condition) -> None:
        self.qtbot.waitUntil(condition, timeout=PATIENCE)


@pytest.fixture(params=["dark", pytest.param("light", marks=pytest.mark.verify)])
def job(request, qtbot, make_editor, checkout) -> Job:
    window = make_editor(theme=request.param, language="en").window
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=PATIENCE)
    kind = {FboView: "offscreen", GLView: "x11"}[type(window.view)]
    folder = checkout / "build" / "screenshots" / kind
    folder.mkdir(parents=True, exist_ok=True)
    return Job(qtbot, window, folder, request.param)


@pytest.mark.landing
def test_the_whole_main_job_with_mouse_and_keys(job, spleen, tmp_path, capsys):
    job.picture("empty")
    import_and_decimate(job, spleen)
    choose_material(job)
    paint(job)
    outcome = feel(job)
    take_back_and_redo(job)
    published = publish(job, tmp_path)
    play(job, published, outcome, tmp_path, capsys)


def import_and_decimate(job: Job, spleen: Path) -> None:
    job.drop(spleen)
    job.wait(lambda: job.organ.surface is not None)
    job.settle()
    assert job.organ.vertex_count == 4274
    job.picture("import")
    job.key(Qt.Key.Key_2, CONTROL)
    job.picture("repair")

    job.key(Qt.Key.Key_3, CONTROL)
    job.type("target_vertices", "600")  # Return does what the button does
    job.wait(lambda: job.organ.decimation is not None)
    job.settle()
    assert job.organ.vertex_count == 600
    job.picture("decimate")


def choose_material(job: Job) -> None:
    job.key(Qt.Key.Key_4, CONTROL)
    for name, text in CONSTANTS.items():
        box = job.window.findChild(object, name)
        if not box.isEnabled():
            job.qtbot.mouseClick(box.parentWidget().tick, LEFT)
        job.type(name, text)
    assert job.organ.model.stiffness == 150.0
    assert job.organ.model.home_stiffness == pytest.approx(1e6)
    assert job.organ.material.damping_ratio == 0.3
    job.key(Qt.Key.Key_L, CONTROL)
    job.settle()
    assert 20 < job.organ.fixed.sum() < 200
    job.picture("material")


def paint(job: Job) -> None:
    view, steps = job.window.view, job.window.session.history.count()
    at = middle(view)
    before = job.organ.fixed.sum()
    job.key(Qt.Key.Key_X)
    drag(view, at + QPoint(-20, 0), at + QPoint(20, 0))
    assert job.organ.fixed.sum() > before
    job.picture("fix")

    job.key(Qt.Key.Key_Z, CONTROL)
    assert job.organ.fixed.sum() == before
    job.key(Qt.Key.Key_B)
    drag(view, at + QPoint(-60, -20), at + QPoint(40, 20), steps=12)
    hover(view, at + QPoint(60, 40))
    job.settle()
    assert job.organ.stiffness_scale.max() > 2.5
    assert job.window.session.history.count() == steps + 1
    job.picture("stiffness")
    job.key(Qt.Key.Key_Escape)
    assert view.tool is None


def feel(job: Job):
    panel, view = job.window.test_panel, job.window.view
    job.key(Qt.Key.Key_5, CONTROL)
    job.picture("test")
    job.key(Qt.Key.Key_Space, SHIFT)
    job.wait(lambda: panel.running and force_of(panel) > 0.2)
    job.picture("press")
    job.wait(lambda: not panel.running)
    press = panel.outcome
    assert press.felt["peak_force_N"] > 0.2
    job.picture("pressed")

    panel.tabs.setCurrentIndex(0)
    job.key(Qt.Key.Key_Space)
    job.wait(lambda: panel.running)
    at = middle(view)
    hover(view, at)
    drag(view, at, at, steps=1, let_go=False)
    job.wait(lambda: force_of(panel) > 0.1)
    job.picture("hand")
    job.key(Qt.Key.Key_Space)
    assert panel.runner.paused
    job.qtbot.mouseClick(panel.start_button, LEFT)
    assert not panel.running and job.window.session.is_tested
    job.settle()
    return press


def force_of(panel) -> float:
    trace = panel.plot.traces[-1]
    return float(trace.size[-1]) if len(trace) else 0.0


def take_back_and_redo(job: Job) -> None:
    painted = job.organ
    job.key(Qt.Key.Key_Z, CONTROL)
    assert (job.organ.stiffness_scale == 1.0).all()
    job.key(Qt.Key.Key_Y, CONTROL)
    assert job.organ is painted and job.window.session.is_tested
    job.settle()


def publish(job: Job, folder: Path) -> Path:
    job.key(Qt.Key.Key_7, CONTROL)
    job.type("title", "The spleen")
    task = job.window.publish_panel.task
    job.qtbot.mouseClick(task.viewport(), LEFT)
    job.qtbot.keyClicks(task, "Find the hard place.")
    job.window.view.setFocus()
    job.settle()
    job.picture("publish")
    job.qtbot.mouseClick(job.window.publish_panel.button, LEFT)
    dialog = job.window.findChild(QFileDialog)
    dialog.selectFile(str(folder / "spleen.palpate"))
    box = dialog.findChild(QDialogButtonBox)
    job.qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Save), LEFT)
    job.wait((folder / "spleen.palpate").exists)
    job.settle()
    job.picture("published")
    return folder / "spleen.palpate"


def play(job: Job, published: Path, outcome, folder: Path, capsys) -> None:
    """The file alone, as a trainee has it: by a script without a window, and with the mouse."""
    made = scenario.read(str(published))
    assert (made.title, made.task) == ("The spleen", "Find the hard place.")
    scene = made.scene
    frames, _ = write_script(find_top(scene), scene.instruments[0].tool.radius, PressScript(6e-3))
    write_script_file(folder / "press.json", frames)
    words = ["play", str(published), "--device", f"script:{folder / 'press.json'}", "--headless"]
    assert main([*words, "--record", str(folder / "played.prec"), "--json"]) == 0
    played = json.loads(capsys.readouterr().out)
    assert played["peak_force_N"] == pytest.approx(outcome.felt["peak_force_N"], rel=0.05)
    assert main(["replay", str(folder / "played.prec"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["equal"]

    trainee = TraineeWindow(Play(published, made, record=folder / "hand.prec"), job.theme)
    job.qtbot.addWidget(trainee)
    with job.qtbot.waitExposed(trainee):
        trainee.show()
    trainee.restart()
    at = middle(trainee.view)
    hover(trainee.view, at)
    drag(trainee.view, at, at, steps=1, let_go=False)
    job.wait(lambda: trainee.over.force.peak > 0.1)
    job.picture("trainee", trainee)
    trainee.close()
    assert (folder / "hand.prec").exists()
    assert np.isfinite(trainee.over.force.peak)
