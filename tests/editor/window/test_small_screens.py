# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor on small screens: it fits, its docks come back, and Enter does what a field is for."""

from __future__ import annotations

import functools
import json
import subprocess
import sys

import pytest
from hands import child, type_into
from palpate_editor.views import window as window_module
from patience import PATIENCE, settle
from PySide6.QtCore import QSize, Qt
from PySide6.QtTest import QTest
from small_screen import list_environment

pytestmark = [pytest.mark.window, pytest.mark.landing]

OPEN_ON_A_SCREEN = """
import json, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from palpate.viewport.application import open_application
from palpate_editor.app.settings import Settings
from palpate_editor.views.editor import Editor
VISIT
app, _ = open_application("en")
folder = Path(sys.argv[1])
found = {}
for language in sys.argv[2:]:
    own = folder / language
    own.mkdir()
    settings = Settings(QSettings(str(own / "s.ini"), QSettings.Format.IniFormat))
    editor = Editor(app, settings, language=language, recovery_folder=own)
    window = editor.window
    editor.show()
    sizes, counts, missed = [], {}, []
    for stage in window.stage_bar.steps:
        window.show_stage(stage)
        app.processEvents()
        sizes.append([window.frameGeometry().width(), window.frameGeometry().height()])
    free = window.screen().availableGeometry()
    if language in REACHED:
        visit()
    window.may_close = True
    window.close()
    found[language] = [[free.width(), free.height()], sizes, counts, missed]
print(json.dumps(found))
"""
LANGUAGES = ("en", "tr")
SCREENS = [((1280, 720), 1), ((1920, 1080), 2), ((1280, 720), 2), ((1366, 768), 1.5)]
SAMPLE_OR_ALL = [
    SCREENS[0], pytest.param(*SCREENS[2], marks=pytest.mark.landing),
    *(pytest.param(*screen, marks=pytest.mark.verify) for screen in SCREENS[1::2]),
]  # fmt: skip
SMALLEST = SCREENS[2]


REACH_EVERYTHING = """
import time
from PySide6.QtWidgets import (
    QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit,
    QPlainTextEdit, QScrollArea, QScrollBar, QWidget,
)
CONTROLS = (QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox,
            QLineEdit, QPlainTextEdit)

def reach(widget):
    # scrolls all areas around it, then says whether it can be seen, as far as the areas are large
    areas = []
    parent = widget.parentWidget()
    while parent is not None:
        if isinstance(parent, QScrollArea) and parent.widget().isAncestorOf(widget):
            areas.append(parent)
            spot = widget.mapTo(parent.widget(), widget.rect().center())
            parent.ensureVisible(spot.x(), spot.y(), widget.width() // 2, widget.height() // 2)
            app.processEvents()
        parent = parent.parentWidget()
    seen, room = widget.rect(), areas[0].viewport().size() if areas else widget.size()
    part = widget
    while part is not window:
        seen = seen.translated(part.pos())
        part = part.parentWidget()
        seen = seen.intersected(part.rect())
    wide, high = min(widget.width(), room.width()) - 8, min(widget.height(), room.height()) - 8
    if seen.width() < wide or seen.height() < high:
        return [widget.metaObject().className(), widget.objectName(), seen.getRect(), [wide, high]]

def miss(holder, where):
    controls = [part for part in holder.findChildren(QWidget) if isinstance(part, CONTROLS)]
    controls = [part for part in controls if part.isVisibleTo(holder) and part.width() > 8
                and not isinstance(part, QScrollBar) and not part.objectName().startswith("qt_")]
    counts[where] = len(controls)
    return [[where, *found] for part in controls if (found := reach(part))]

def visit():
    missed.extend(miss(window.welcome, "welcome"))
    window.files.open_shipped("spleen")
    until = time.monotonic() + 120
    while window.session.organ.surface is None or not window.context.assessor.is_current:
        app.processEvents()
        assert time.monotonic() < until
    for stage in window.stage_bar.steps:
        window.show_stage(stage)
        app.processEvents()
        missed.extend(miss(window.stage_dock, stage))
        missed.extend(miss(window.stage_bar, "stages"))
    for tool in window.tools.choices:
        window.tools.use(tool)
        app.processEvents()
        missed.extend(miss(window.stage_dock, tool))
        missed.extend(miss(window.tools, "tools"))
        sizes.append([window.frameGeometry().width(), window.frameGeometry().height()])
    for name, dock in window.docks.docks.items():
        window.docks.show(name)
        app.processEvents()
        missed.extend(miss(dock.widget(), name))
    published = window.material_panel.published
    for show in (window.show_palette, window.show_help, published.show_values):
        show()
        app.processEvents()
        shown = [top for top in app.topLevelWidgets() if top.isVisible() and top is not window]
        for dialog in shown:
            sizes.append([dialog.frameGeometry().width(), dialog.frameGeometry().height()])
            dialog.close()
        counts["dialogs"] = counts.get("dialogs", 0) + 1
    least = window.minimumSizeHint()
    sizes.append([least.width(), least.height()])
"""


@functools.cache
def open_on_a_screen(folder, size, factor, reached) -> dict[str, tuple]:
    """By language: free room, sizes of the window, and in the languages `reached` how many controls
    each part has, and those that cannot be reached; all in pixels. One program opens both."""
    folder.mkdir()
    env = list_environment(folder, size, factor)

    visit = f"REACHED = {reached!r}\n{REACH_EVERYTHING}"
    program = OPEN_ON_A_SCREEN.replace("VISIT", visit)
    words = [sys.executable, "-c", program, str(folder), *LANGUAGES]
    ran = subprocess.run(words, env=env, capture_output=True, encoding="utf-8")
    assert ran.returncode == 0, ran.stderr
    return json.loads(ran.stdout.splitlines()[-1])


@pytest.fixture(scope="module")
def opened(tmp_path_factory):
    """opened(size, factor, language) is what open_on_a_screen found there; on the smallest screen
    every control is reached, in Turkish, whose words are the longer ones, or as it is asked."""
    top = tmp_path_factory.mktemp("screens")

    def find(size, factor, language, reached=("tr",)):
        reached = reached if (size, factor) == SMALLEST else ()
        folder = top / f"{size[0]}_{size[1]}_{factor}_{'_'.join(reached)}"
        return open_on_a_screen(folder, size, factor, reached)[language]

    return find


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("size", "factor"), SAMPLE_OR_ALL)
def test_the_editor_fits_its_screen_in_every_stage(opened, size, factor, language):
    free, sizes, _, _ = opened(size, factor, language)

    assert free == [round(pixels / factor) for pixels in size]
    for width, height in sizes:
        assert width <= free[0] and height <= free[1], (free, sizes)


@pytest.mark.landing
@pytest.mark.parametrize("language", ["tr", pytest.param("en", marks=pytest.mark.verify)])
def test_on_640_by_360_pixels_every_control_is_reached_by_scrolling(opened, language):
    free, sizes, counts, missed = opened(*SMALLEST, language, reached=(language,))

    assert free == [640, 360]
    assert missed == []
    assert counts["welcome"] > 8 and counts["stages"] == 7 and counts["tools"] >= 4
    assert counts["dialogs"] == 3
    assert all(counts[stage] > 3 for stage in ("import", "material", "test", "publish"))
    assert max(width for width, _ in sizes) <= 640 and max(high for _, high in sizes) <= 360


def test_docks_are_unfolded_on_a_larger_screen(qtbot, window):
    docks = window.docks
    docks.fit(QSize(640, 360))
    qtbot.wait(20)
    assert docks.folded and window.tabifiedDockWidgets(docks.docks["stage"])
    assert window.tools.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly

    window.resize(640, 360)
    qtbot.wait(20)
    assert docks.folded
    window.resize(1440, 900)
    qtbot.wait(50)

    assert not docks.folded and not window.tabifiedDockWidgets(docks.docks["stage"])
    assert docks.docks["scene"].isVisible() and docks.docks["scene"].titleBarWidget() is None
    assert window.tools.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonTextUnderIcon


def test_docks_that_a_small_window_squeezed_are_as_large_as_before_in_a_large_one(qtbot, window):
    window.resize(1440, 900)
    qtbot.wait(50)
    docks = window.docks.docks
    before = {name: docks[name].size() for name in ("scene", "stage", "log", "history")}

    window.resize(window.minimumSizeHint())
    for name in ("log", "history"):
        qtbot.waitUntil(
            lambda name=name: docks[name].height() < before[name].height(), timeout=PATIENCE
        )
    window.resize(1440, 900)

    # the line between two docks of one column may stand a few pixels off
    for name in ("scene", "stage"):
        qtbot.waitUntil(
            lambda name=name: docks[name].width() == before[name].width(), timeout=PATIENCE
        )
    for name in ("log", "history"):
        qtbot.waitUntil(
            lambda name=name: abs(docks[name].height() - before[name].height()) <= 12,
            timeout=PATIENCE,
        )


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


@pytest.mark.landing
def test_a_layout_that_a_small_screen_folded_comes_back_as_it_was_kept(
    qtbot, make_editor, monkeypatch
):
    small = QSize(800, 760)
    monkeypatch.setattr(window_module, "SIZE", small)
    monkeypatch.setattr(window_module, "find_room", lambda window: small)
    kept = make_editor(theme="dark", language="en").window
    docks = kept.docks.docks
    kept.resizeDocks([docks["log"], docks["force"]], [300, 420], Qt.Orientation.Horizontal)
    qtbot.waitUntil(lambda: docks["force"].width() > docks["log"].width(), timeout=PATIENCE)
    QTest.mouseClick(kept, Qt.MouseButton.LeftButton)  # the line between docks is let go
    widths = {name: dock.width() for name, dock in docks.items()}
    kept.may_close = True
    kept.close()

    # the docks of both were folded, until their windows got the size that make_editor gives them
    second = make_editor(theme="dark", language="en").window
    large = second.size()
    second.resize(small)
    qtbot.wait(50)
    second.resize(large)  # kept geometry may have given it that size before it was folded
    restored = second.docks.docks

    for name, width in widths.items():
        qtbot.waitUntil(
            lambda name=name, width=width: abs(restored[name].width() - width) <= 64,
            timeout=PATIENCE,
        )


@pytest.mark.landing
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

    window.session.clear()
    kidney = welcome.shipped.buttons["kidney_stone"]
    kidney.setFocus()
    QTest.keyClick(kidney, Qt.Key.Key_Enter)
    settle(qtbot, window)
    assert window.session.organ.name == "kidney stone"


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_status_text_with_too_little_room_is_elided_and_its_tooltip_has_all(
    make_editor, qtbot, language
):
    window = make_editor(language=language).window
    window.resize(640, 360)
    status = window.status
    sentence = "Drag to turn, Shift+drag to move, wheel to zoom, and double click to fit the view"
    labels = (status.hint, status.place, status.counts, status.saved, status.busy.label)
    status.busy.show()
    for label in labels:
        label.setText(sentence)
    QTest.qWait(1)

    for label in labels:
        shown = label.shown()
        assert shown != sentence and label.toolTip() == label.text() == sentence
        assert shown.endswith("\N{HORIZONTAL ELLIPSIS}")
        assert label.fontMetrics().horizontalAdvance(shown) <= label.contentsRect().width()
    assert len(status.hint.shown()) > 5

    status.hint.setText("A")
    assert (status.hint.shown(), status.hint.toolTip()) == ("A", "")
