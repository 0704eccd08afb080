# SPDX-License-Identifier: GPL-3.0-or-later
"""Themes, layout, stages and colours of the viewport."""

from __future__ import annotations

import numpy as np
import pytest
from hands import CONTROL, action, press
from palpate_editor.views.theme import COLOURS
from patience import PATIENCE, settle
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QApplication, QDockWidget, QLabel, QToolBar

pytestmark = [pytest.mark.window, pytest.mark.landing]


def pixels(widget) -> np.ndarray:
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    flat = np.frombuffer(image.constBits(), np.uint8)
    rows = flat.reshape(image.height(), image.bytesPerLine())[:, : 3 * image.width()]
    return rows.reshape(image.height(), image.width(), 3).astype(int)


def contrast(front: str, back: str) -> float:
    """Of two colours, as the Web Content Accessibility Guidelines 2 define it."""

    def luminance(colour: str) -> float:
        parts = QColor(colour).getRgbF()[:3]
        linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
        return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))

    light, dark = sorted((luminance(front), luminance(back)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.landing
def test_a_theme_changes_window_and_viewport_and_is_kept(qtbot, spleen_window):
    window = spleen_window
    dark, dark_view = pixels(window.stage_dock).mean(), pixels(window.view)[5, 5].mean()

    action(window, "theme_light").trigger()
    qtbot.wait(50)

    assert pixels(window.stage_dock).mean() > dark + 100
    assert pixels(window.view)[5, 5].mean() > dark_view + 80
    assert window.settings.theme == "light"
    assert QApplication.palette().window().color() == QColor(COLOURS["light"].panel)


@pytest.mark.parametrize("theme", sorted(COLOURS))
def test_all_text_can_be_read_on_its_ground(theme):
    colours = COLOURS[theme]

    for front in ("text", "faint", "good", "warning", "bad", "accent_text"):
        for back in ("panel", "field", "window"):
            ratio = contrast(getattr(colours, front), getattr(colours, back))
            assert ratio >= 4.5, (front, back, round(ratio, 2))
    assert contrast("#ffffff", colours.accent) >= 4.5


@pytest.mark.landing
def test_every_dock_and_bar_can_be_kept(window):
    for widget in [*window.findChildren(QDockWidget), *window.findChildren(QToolBar)]:
        assert widget.objectName(), widget


def test_the_layout_comes_back_and_can_be_reset(qtbot, make_editor):
    first = make_editor().window
    first.docks.docks["log"].close()
    first.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, first.docks.docks["stage"])
    first.may_close = True
    first.close()

    second = make_editor().window
    stage = second.docks.docks["stage"]
    assert second.dockWidgetArea(stage) == Qt.DockWidgetArea.LeftDockWidgetArea
    assert not second.docks.docks["log"].isVisible()
    action(second, "reset").trigger()

    assert second.dockWidgetArea(stage) == Qt.DockWidgetArea.RightDockWidgetArea
    assert second.docks.docks["log"].isVisible()


def test_stages_never_lock(window):
    for i, stage in enumerate(window.stage_bar.steps, start=1):
        press(window, Qt.Key(Qt.Key.Key_0 + i), CONTROL)
        assert window.context.stage == stage
        assert window.stage_dock.stack.currentWidget().widget() is window.stage_dock.panels[stage]


def test_the_decimate_stage_shows_the_distance_as_colours(qtbot, spleen_window):
    window = spleen_window
    window.show_stage("material")
    assert not window.view.legend.isVisible()

    window.show_stage("decimate")

    assert window.view.legend.isVisible()
    distances = window.context.assessment.comparison.distances
    decimation = window.session.organ.decimation
    assert distances.min() >= 0.0
    assert 0.2 * decimation.max_distance < distances.max() <= 1.1 * decimation.max_distance
    window.decimate_panel.coloured.click()
    assert not window.view.legend.isVisible()


def test_the_status_bar_says_what_is_under_the_pointer(qtbot, spleen_window):
    window = spleen_window
    middle = window.view.rect().center()

    qtbot.mouseMove(window.view, middle)
    window.status.on_hover(middle.toPointF())

    qtbot.waitUntil(lambda: "triangle" in window.status.place.text())
    assert window.status.place.text().endswith("mm")
    assert "600 vertices" in window.status.counts.text()
    window.status.on_hover(window.view.rect().topLeft().toPointF())
    qtbot.waitUntil(lambda: window.status.place.text() == "")


@pytest.mark.landing
def test_the_tool_strip_gives_the_mouse_and_takes_it_back(qtbot, spleen_window):
    window = spleen_window
    window.show_stage("material")

    window.tools.choices["fix"].trigger()
    assert window.view.tool is window.tools.current is not None
    assert window.stage_dock.options_holder.isVisible()
    assert window.status.hint.text() == window.tools.current.hint()
    press(window, Qt.Key.Key_Escape)

    assert window.view.tool is None
    assert window.tools.choices["orbit"].isChecked()
    assert not window.stage_dock.options_holder.isVisible()


def test_views_look_along_the_axes(spleen_window):
    view = spleen_window.view

    action(spleen_window, "look_0").trigger()
    front = view.camera.basis()[2]
    action(spleen_window, "look_2").trigger()

    assert front == pytest.approx([0.0, 1.0, 0.0], abs=1e-9)
    assert view.camera.basis()[2][2] < -0.99


@pytest.mark.landing
def test_a_click_on_an_end_of_the_axes_looks_from_there(qtbot, spleen_window):
    gizmo, camera = spleen_window.gizmo, spleen_window.view.camera
    _, _, place, _ = next(end for end in gizmo.ends() if end[:2] == ("x", 1))

    qtbot.mouseClick(gizmo, Qt.MouseButton.LeftButton, pos=place.toPoint())

    assert camera.basis()[2] == pytest.approx([-1.0, 0.0, 0.0], abs=1e-9)
    assert gizmo.geometry().right() < spleen_window.view.width()


@pytest.mark.landing
def test_a_material_is_copied_and_pasted(qtbot, spleen_window):
    window, session = spleen_window, spleen_window.session
    window.menu_actions.use_mms()
    wanted = session.organ.model
    action(window, "copy").trigger()
    window.menu_actions.use_mss()
    assert session.organ.model != wanted

    action(window, "paste").trigger()
    settle(qtbot, window)

    assert session.organ.model == wanted
    QApplication.clipboard().setText("a letter")
    action(window, "paste").trigger()
    assert "no material on the clipboard" in window.messages.text


@pytest.mark.landing
def test_a_tool_with_more_options_than_the_one_before_shows_all_of_them(qtbot, window):
    window.files.open_shipped("spleen")
    settle(qtbot, window)
    window.show_stage("material")

    for tool in ("select", "stiffness"):
        window.tools.use(tool)
        settle(qtbot, window)

    area, holder = window.stage_dock.options_area, window.stage_dock.options_holder
    qtbot.waitUntil(lambda: area.height() >= holder.sizeHint().height(), timeout=PATIENCE)


@pytest.mark.landing
def test_the_dock_of_the_stages_grows_with_what_its_panels_have_to_show(qtbot, window):
    dock = window.stage_dock
    window.resizeDocks([window.docks.docks["stage"]], [10], Qt.Orientation.Horizontal)
    wide = QLabel(dock)
    wide.setMinimumWidth(dock.width() + 40)
    dock.panels["material"].layout().addWidget(wide)

    window.files.open_shipped("spleen")
    settle(qtbot, window)
    window.show_stage("material")

    room = dock.stack.currentWidget().viewport()
    qtbot.waitUntil(lambda: room.width() >= wide.minimumWidth(), timeout=PATIENCE)
