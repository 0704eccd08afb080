# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting and selecting on the organ with real mouse and key events."""

from __future__ import annotations

import numpy as np
import pytest
from palpate_editor.views.touch import (
    FixTool,
    SelectTool,
    StiffnessTool,
    select_tool,
    surface_keeper,
)
from palpate_editor.views.touch.stroke import Brush
from PySide6.QtCore import QPoint, Qt
from touch_desk import THIN, build_organ, click, drag, hover, middle, open_desk, turn_wheel

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
RIGHT = QPoint(60, 0)


pytestmark = pytest.mark.window


@pytest.fixture
def desk(qtbot, settings):
    with open_desk(qtbot, build_organ(), settings) as made:
        yield made


def use(tool, radius=0.006):
    tool.activate()
    tool.find_painted()
    tool.set_radius(radius)
    return tool


def test_one_stroke_of_fixing_is_one_step_of_undo(desk):
    use(FixTool(desk, Brush()))
    before = desk.session.organ

    drag(desk.view, middle(desk.view), middle(desk.view) + RIGHT)

    after = desk.session.organ
    assert after.fixed.sum() > before.fixed.sum() + 5
    assert desk.session.history.count() == 1
    desk.session.history.undo()
    assert desk.session.organ is before


def test_control_frees_what_is_fixed(desk):
    use(FixTool(desk, Brush()))
    start = middle(desk.view)
    drag(desk.view, start, start + RIGHT)
    painted = desk.session.organ.fixed.sum()

    drag(desk.view, start, start + RIGHT, modifiers=CONTROL)

    assert desk.session.organ.fixed.sum() < painted
    assert desk.session.history.count() == 2


def test_a_stroke_over_what_is_fixed_already_is_no_edit(desk):
    use(FixTool(desk, Brush()))
    drag(desk.view, middle(desk.view), middle(desk.view))
    drag(desk.view, middle(desk.view), middle(desk.view))
    assert desk.session.history.count() == 1


def test_painting_never_goes_through_a_thin_wall(qtbot, settings):
    with open_desk(qtbot, build_organ(THIN, 900), settings) as desk:
        use(StiffnessTool(desk, Brush(factor=4.0)), radius=0.012)
        drag(desk.view, middle(desk.view), middle(desk.view) + RIGHT)

    painted = desk.session.organ.stiffness_scale != 1.0
    height = desk.session.organ.surface.vertices[:, 2]
    assert painted.sum() > 20
    # seen from above: nothing of the lower side, though it is nearer than the brush is wide
    assert height[painted].min() > -1e-4


def test_a_stroke_paints_the_factor_in_its_middle_and_fades_to_its_rim(desk):
    tool = use(StiffnessTool(desk, Brush(factor=5.0)), radius=0.012)
    at = middle(desk.view)
    spot = np.array(desk.view.pick(at.toPointF()).point)
    click(desk.view, at)

    scale = desk.session.organ.stiffness_scale
    away = np.linalg.norm(desk.session.organ.surface.vertices - spot, axis=1)
    assert scale.max() > 4.0 and scale.max() <= 5.0
    assert scale[away > tool.brush.radius].max() == 1.0
    rim = (away > 0.7 * tool.brush.radius) & (scale != 1.0)
    assert rim.any() and scale[rim].max() < 2.5


def test_going_over_a_place_twice_in_one_stroke_paints_it_once(desk):
    use(StiffnessTool(desk, Brush(factor=5.0, strength=0.5, soft=False)), radius=0.01)
    start = middle(desk.view)
    drag(desk.view, start, start, steps=8)
    assert desk.session.organ.stiffness_scale.max() == pytest.approx(5.0**0.5)


def test_control_erases_stiffness_and_shift_smooths_it(desk):
    use(StiffnessTool(desk, Brush(factor=5.0, soft=False)), radius=0.01)
    start = middle(desk.view)
    click(desk.view, start)
    steep = desk.session.organ.stiffness_scale

    drag(desk.view, start, start, modifiers=SHIFT)
    smoothed = desk.session.organ.stiffness_scale
    assert smoothed.max() <= steep.max() and smoothed.std() < steep.std()

    drag(desk.view, start - RIGHT, start + RIGHT, steps=20, modifiers=CONTROL)
    assert desk.session.organ.stiffness_scale.max() < smoothed.max()
    assert desk.session.history.count() == 3


def test_a_quick_drag_leaves_no_gaps(desk):
    use(FixTool(desk, Brush()), radius=0.004)
    start = middle(desk.view)
    drag(desk.view, start - 2 * RIGHT, start + 2 * RIGHT, steps=1)
    quick = desk.session.organ.fixed
    desk.session.history.undo()
    drag(desk.view, start - 2 * RIGHT, start + 2 * RIGHT, steps=60)
    slow = desk.session.organ.fixed
    assert (quick & slow).sum() > 0.95 * slow.sum()


def test_escape_drops_the_stroke_and_then_leaves_the_tool(desk, qtbot):
    tool = use(FixTool(desk, Brush()))
    before = desk.session.organ
    drag(desk.view, middle(desk.view), middle(desk.view) + RIGHT, let_go=False)
    qtbot.keyClick(desk.view, Qt.Key.Key_Escape)
    assert desk.session.organ is before and desk.session.history.count() == 0

    with qtbot.waitSignal(tool.left, timeout=1000):
        qtbot.keyClick(desk.view, Qt.Key.Key_Escape)


def test_brackets_and_control_wheel_change_the_size_and_the_plain_wheel_zooms(desk, qtbot):
    tool = use(FixTool(desk, Brush()), radius=0.005)
    hover(desk.view, middle(desk.view))
    qtbot.keyClicks(desk.view, "]]")
    assert tool.brush.radius == pytest.approx(0.005 * 1.15**2)
    qtbot.keyClicks(desk.view, "[")
    turn_wheel(desk.view, middle(desk.view), -1, CONTROL)
    assert tool.brush.radius == pytest.approx(0.005)

    distance = desk.view.camera.distance
    turn_wheel(desk.view, middle(desk.view), 1)
    assert desk.view.camera.distance < distance
    assert tool.brush.radius == pytest.approx(0.005)


def test_the_hint_says_the_size_in_millimetres_and_pixels(desk):
    tool = use(FixTool(desk, Brush()), radius=0.005)
    said = []
    desk.hinted.connect(said.append)
    hover(desk.view, middle(desk.view))
    spot = np.array(desk.view.pick(middle(desk.view).toPointF()).point)
    pixels = round(tool.brush.radius / desk.view.pixel_size_at(spot))
    assert said[-1].startswith(f"brush 5.0 mm ({pixels} px)")


def test_a_drag_beside_the_organ_turns_the_view_and_paints_nothing(desk):
    use(FixTool(desk, Brush()))
    azimuth = desk.view.camera.azimuth
    drag(desk.view, QPoint(5, 5), QPoint(80, 5))
    assert desk.view.camera.azimuth != azimuth
    assert desk.session.history.count() == 0


def test_the_preview_is_seen_before_the_mouse_is_let_go(desk):
    use(StiffnessTool(desk, Brush(factor=5.0)), radius=0.01)
    before = desk.view.grab_picture()
    drag(desk.view, middle(desk.view), middle(desk.view) + RIGHT, let_go=False)
    assert desk.session.history.count() == 0
    assert desk.view.grab_picture() != before


def test_the_options_and_the_brush_tell_each_other(desk, qtbot):
    tool = use(StiffnessTool(desk, Brush()), radius=0.005)
    options = tool.options()
    qtbot.addWidget(options)
    box = options.radius.row.box
    assert box.lineEdit().text() == "5"

    box.lineEdit().setText("12.5")
    box.enter()
    assert tool.brush.radius == pytest.approx(0.0125)
    tool.grow()
    assert float(box.lineEdit().text()) == pytest.approx(12.5 * 1.15, rel=1e-3)

    click(desk.view, middle(desk.view))
    assert options.count.text().startswith(f"{(tool.count_painted()[0])} of 600")
    qtbot.mouseClick(options.erase, Qt.MouseButton.LeftButton)
    assert (desk.session.organ.stiffness_scale == 1.0).all()
    assert desk.session.history.count() == 2


# ---------------------------------------------------------------- selecting


def test_clicks_select_add_and_remove(desk):
    tool = SelectTool(desk)
    tool.activate()
    start = middle(desk.view)
    click(desk.view, start)
    first = np.flatnonzero(tool.selected)
    assert len(first) == 1

    click(desk.view, start + RIGHT, CONTROL)
    assert tool.selected.sum() == 2
    click(desk.view, start, ALT)
    assert tool.selected.sum() == 1 and not tool.selected[first[0]]
    click(desk.view, QPoint(3, 3))
    assert not tool.selected.any()


def test_a_rectangle_selects_what_is_seen_and_nothing_behind(desk):
    tool = SelectTool(desk)
    tool.activate()
    start = middle(desk.view)
    drag(desk.view, start - QPoint(150, 150), start + QPoint(150, 150))
    organ, eye = desk.session.organ, np.asarray(desk.view.camera.eye())
    x = organ.surface.vertices[tool.selected]
    assert 20 < len(x) < 300
    # on a ball around the origin the seen side is that of the eye
    assert ((eye - x) * x).sum(axis=1).min() > 0.0


def test_keys_take_all_the_others_and_what_is_linked(desk):
    tool = SelectTool(desk)
    tool.activate()
    actions = {action.objectName(): action for action in tool.actions()}
    actions["select_all"].trigger()
    assert tool.selected.all()
    actions["invert_selection"].trigger()
    assert not tool.selected.any()
    click(desk.view, middle(desk.view))
    actions["select_linked"].trigger()
    assert tool.selected.all()


def test_a_selection_is_fixed_freed_and_stiffened_in_one_step_each(desk, qtbot):
    tool = SelectTool(desk)
    tool.activate()
    options = tool.options()
    qtbot.addWidget(options)
    assert not options.fix.isEnabled()
    start = middle(desk.view)
    drag(desk.view, start - QPoint(40, 40), start + QPoint(40, 40))
    chosen = tool.selected.copy()

    for button in (options.fix, options.free, options.stiffen):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert desk.session.history.count() == 3
    assert not desk.session.organ.fixed[chosen].any()
    assert (desk.session.organ.stiffness_scale[chosen] == 3.0).all()
    assert (desk.session.organ.stiffness_scale[~chosen] == 1.0).all()


def test_a_selection_is_kept_under_a_name_and_taken_up_again(desk, qtbot):
    tool = SelectTool(desk)
    tool.activate()
    options = tool.options()
    qtbot.addWidget(options)
    row = options.regions
    start = middle(desk.view)
    drag(desk.view, start - QPoint(40, 40), start + QPoint(40, 40))
    chosen = np.flatnonzero(tool.selected)
    assert not row.keep.isEnabled()

    qtbot.keyClicks(row.names.lineEdit(), "upper pole")
    qtbot.mouseClick(row.keep, Qt.MouseButton.LeftButton)
    assert desk.session.organ.regions["upper pole"].tolist() == chosen.tolist()

    tool.select_none()
    row.names.activated.emit(row.names.findText("upper pole"))
    assert np.flatnonzero(tool.selected).tolist() == chosen.tolist()
    qtbot.mouseClick(row.forget, Qt.MouseButton.LeftButton)
    assert not desk.session.organ.regions and row.names.count() == 0
    desk.session.history.undo()
    assert row.names.itemText(0) == "upper pole"


# ---------------------------------------------------------------- large surfaces


def test_a_large_surface_is_painted_and_selected_by_threads_with_the_same_result(
    qtbot, settings, monkeypatch
):
    found = []
    for quick in (10**9, 0):
        monkeypatch.setattr(surface_keeper, "QUICK", quick)
        monkeypatch.setattr(select_tool, "QUICK_TO_SEE", quick)
        with open_desk(qtbot, build_organ(vertices=2000), settings) as desk:
            fix, select, at = FixTool(desk, Brush()), SelectTool(desk), middle(desk.view)
            fix.activate()
            qtbot.waitUntil(lambda fix=fix: fix.find_painted() is not None)
            drag(desk.view, at, at + RIGHT)
            fix.deactivate()
            select.activate()
            with qtbot.waitSignal(select.selection_changed, timeout=20000):
                drag(desk.view, at - QPoint(90, 90), at + QPoint(90, 90))
            found.append((desk.session.organ.fixed, select.selected))

    (fixed, selected), (late_fixed, late_selected) = found
    assert fixed.sum() > build_organ(vertices=2000).fixed.sum() and selected.sum() > 20
    assert (fixed == late_fixed).all() and (selected == late_selected).all()
