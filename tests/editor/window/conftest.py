# SPDX-License-Identifier: GPL-3.0-or-later
"""A fresh editor on settings and recovery of its own, driven as a person drives it."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from layouts import wait, write_two
from palpate import translation
from palpate.runs.trial import choose_places
from palpate.viewport.gl_view import build_format
from palpate_editor import trial
from palpate_editor.app.settings import Settings
from palpate_editor.document import EMPTY
from palpate_editor.edits import Decimate, decimate_organ
from palpate_editor.views.editor import Editor
from palpate_editor.views.layout.layout_window import SIZE as SCENE_SIZE
from palpate_editor.views.layout.layout_window import LayoutWindow
from palpate_editor.views.tasks import ImportWork, Reading
from palpate_editor.views.window import SIZE, MainWindow
from patience import settle
from PySide6.QtCore import QEvent, QLocale, QSettings, Qt
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication


@pytest.fixture(scope="session")
def qapp_cls() -> type[QApplication]:
    """Before the application: what its windows are drawn with, and dialogs a test can reach."""
    QSurfaceFormat.setDefaultFormat(build_format())
    QApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    return QApplication


@pytest.fixture(autouse=True)
def end_widgets_in_the_window_thread(
    qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[None]:
    """The cyclic collector may otherwise run in a worker, and end widgets there."""
    # an editor would keep its own window too, and let go of all when it ends
    monkeypatch.setattr(gc, "freeze", lambda: None)
    monkeypatch.setattr(gc, "unfreeze", lambda: None)
    gc.disable()
    yield
    qapp.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    qapp.processEvents()
    gc.collect()


@pytest.fixture(autouse=True)
def draw_roughly(rough_frames: None) -> None:
    """Half of what a window costs is how fine its frames are."""


@pytest.fixture(autouse=True)
def press_one_place(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a window says of an organ is worked out after every edit of every test, mostly by
    pressing it at several places: at one, unless a test is marked `several_places`."""
    if not request.node.get_closest_marker("several_places"):
        monkeypatch.setattr(trial, "choose_places", lambda scene: choose_places(scene, count=1))


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """Of nobody: nothing chosen yet."""
    return Settings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))


@pytest.fixture
def make_editor(
    qtbot, qapp: QApplication, settings: Settings, tmp_path: Path
) -> Iterator[Callable[..., Editor]]:
    """make_editor(theme=..., language=...) shows a window and waits until it is drawn."""
    made: list[Editor] = []

    def make(**wishes: str) -> Editor:
        folder = tmp_path / "recovery"
        folder.mkdir(exist_ok=True)
        editor = Editor(qapp, settings, recovery_folder=folder, **wishes)
        made.append(editor)
        editor.show()
        qtbot.waitExposed(editor.window)
        editor.window.resize(SIZE)
        settle(qtbot, editor.window)
        return editor

    yield make
    for editor in made:
        end(editor)
    translation.install(qapp, "en")
    QLocale.setDefault(QLocale("en"))


def end(editor: Editor) -> None:
    """Closes its window without a question."""
    window = editor.window
    window.may_close = True
    window.close()
    window.deleteLater()
    editor.deleteLater()


@pytest.fixture
def editor(make_editor: Callable[..., Editor]) -> Editor:
    return make_editor(theme="dark", language="en")


@pytest.fixture
def window(editor: Editor) -> MainWindow:
    """An empty main window, shown."""
    return editor.window


@pytest.fixture
def spleen(shared_data: Callable[[str], Path]) -> Path:
    return shared_data("organs/VH_F_Spleen.glb")


@pytest.fixture(scope="session")
def coarse_spleen(shared_data: Callable[[str], Path]) -> tuple[Reading, Decimate]:
    """What the window's workers make of a real organ, made once: both are values."""
    path = shared_data("organs/VH_F_Spleen.glb")
    reading = ImportWork(path)(lambda words, share: None)
    assert reading.edit is not None, reading.problem
    return reading, decimate_organ(reading.edit(EMPTY), 600)


@pytest.fixture
def spleen_window(
    qtbot, window: MainWindow, spleen: Path, coarse_spleen: tuple[Reading, Decimate]
) -> MainWindow:
    """A window with a real organ in it, decimated to 600 vertices and fixed at its lowest part.

    It is given what its workers would make, and assesses what comes of all three edits.
    """
    reading, decimated = coarse_spleen
    window.tasks.on_read(reading)
    window.settings.add_recent(spleen)
    assert window.context.apply(decimated)
    window.menu_actions.fix_lowest()
    settle(qtbot, window)
    return window


@pytest.fixture
def two(tmp_path: Path) -> Path:
    return write_two(tmp_path)


@pytest.fixture
def scene(qtbot, editor, two) -> Iterator[LayoutWindow]:
    editor.window.files.open(two)
    (window,) = editor.layouts
    qtbot.waitExposed(window)
    window.resize(SCENE_SIZE)
    window.arrange()
    wait(qtbot, window)
    window.view.frame_all()
    yield window
    for each in editor.layouts:
        each.may_close = True
        each.close()
