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
from touch_context import THIN, build_organ, click, drag, hover, middle, open_context, turn_wheel

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
RIGHT = QPoint(60, 0)


pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def context(qtbot, settings):
    with open_context(qtbot, build_organ(), settings) as made:
        yield made


def use(tool, radius=0.006):
    tool.activate()
    tool.find_painted()
    tool.set_radius(radius)
    return tool


def test_one_stroke_of_fixing_is_one_step_of_undo(context):
    use(FixTool(context, Brush()))
    before = context.session.organ

    drag(context.view, middle(context.view), middle(context.view) + RIGHT)

    after = context.session.organ
    assert after.fixed.sum() > before.fixed.sum() + 5
    assert context.session.history.count() == 1
    context.session.history.undo()
    assert context.session.organ is before


def test_control_frees_what_is_fixed(context):
    use(FixTool(context, Brush()))
    start = middle(context.view)
    drag(context.view, start, start + RIGHT)
    painted = context.session.organ.fixed.sum()

    drag(context.view, start, start + RIGHT, modifiers=CONTROL)

    assert context.session.organ.fixed.sum() < painted
    assert context.session.history.count() == 2


def test_a_stroke_over_what_is_fixed_already_is_no_edit(context):
    use(FixTool(context, Brush()))
    drag(context.view, middle(context.view), middle(context.view))
    drag(context.view, middle(context.view), middle(context.view))
    assert context.session.history.count() == 1


def test_painting_never_goes_through_a_thin_wall(qtbot, settings):
    with open_context(qtbot, build_organ(THIN, 900), settings) as context:
        use(StiffnessTool(context, Brush(factor=4.0)), radius=0.012)
        drag(context.view, middle(context.view), middle(context.view) + RIGHT)

    painted = context.session.organ.stiffness_scale != 1.0
    height = context.session.organ.surface.vertices[:, 2]
    assert painted.sum() > 20
    # seen from above: nothing of the lower side, though it is nearer than the brush is wide
    assert height[painted].min() > -1e-4


def test_a_stroke_paints_the_factor_in_its_middle_and_fades_to_its_rim(context):
    tool = use(StiffnessTool(context, Brush(factor=5.0)), radius=0.012)
    at = middle(context.view)
    spot = np.array(context.view.pick(at.toPointF()).point)
    click(context.view, at)

    scale = context.session.organ.stiffness_scale
    away = np.linalg.norm(context.session.organ.surface.vertices - spot, axis=1)
    assert scale.max() > 4.0 and scale.max() <= 5.0
    assert scale[away > tool.brush.radius].max() == 1.0
    rim = (away > 0.7 * tool.brush.radius) & (scale != 1.0)
    assert rim.any() and scale[rim].max() < 2.5


def test_going_over_a_place_twice_in_one_stroke_paints_it_once(context):
    use(StiffnessTool(context, Brush(factor=5.0, strength=0.5, soft=False)), radius=0.01)
    start = middle(context.view)
    drag(context.view, start, start, steps=8)
    assert context.session.organ.stiffness_scale.max() == pytest.approx(5.0**0.5)


def test_control_erases_stiffness_and_shift_smooths_it(context):
    use(StiffnessTool(context, Brush(factor=5.0, soft=False)), radius=0.01)
    start = middle(context.view)
    click(context.view, start)
    steep = context.session.organ.stiffness_scale

    drag(context.view, start, start, modifiers=SHIFT)
    smoothed = context.session.organ.stiffness_scale
    assert smoothed.max() <= steep.max() and smoothed.std() < steep.std()

    drag(context.view, start - RIGHT, start + RIGHT, steps=20, modifiers=CONTROL)
    assert context.session.organ.stiffness_scale.max() < smoothed.max()
    assert context.session.history.count() == 3


def test_a_quick_drag_leaves_no_gaps(context):
    use(FixTool(context, Brush()), radius=0.004)
    start = middle(context.view)
    drag(context.view, start - 2 * RIGHT, start + 2 * RIGHT, steps=1)
    quick = context.session.organ.fixed
    context.session.history.undo()
    drag(context.view, start - 2 * RIGHT, start + 2 * RIGHT, steps=60)
    slow = context.session.organ.fixed
    assert (quick & slow).sum() > 0.95 * slow.sum()


def test_escape_drops_the_stroke_and_then_leaves_the_tool(context, qtbot):
    tool = use(FixTool(context, Brush()))
    before = context.session.organ
    drag(context.view, middle(context.view), middle(context.view) + RIGHT, let_go=False)
    qtbot.keyClick(context.view, Qt.Key.Key_Escape)
    assert context.session.organ is before and context.session.history.count() == 0

    with qtbot.waitSignal(tool.left):
        qtbot.keyClick(context.view, Qt.Key.Key_Escape)


def test_brackets_and_control_wheel_change_the_size_and_the_plain_wheel_zooms(context, qtbot):
    tool = use(FixTool(context, Brush()), radius=0.005)
    hover(context.view, middle(context.view))
    qtbot.keyClicks(context.view, "]]")
    assert tool.brush.radius == pytest.approx(0.005 * 1.15**2)
    qtbot.keyClicks(context.view, "[")
    turn_wheel(context.view, middle(context.view), -1, CONTROL)
    assert tool.brush.radius == pytest.approx(0.005)

    distance = context.view.camera.distance
    turn_wheel(context.view, middle(context.view), 1)
    assert context.view.camera.distance < distance
    assert tool.brush.radius == pytest.approx(0.005)


def test_the_hint_says_the_size_in_millimetres_and_pixels(context):
    tool = use(FixTool(context, Brush()), radius=0.005)
    said = []
    context.hinted.connect(said.append)
    hover(context.view, middle(context.view))
    spot = np.array(context.view.pick(middle(context.view).toPointF()).point)
    pixels = round(tool.brush.radius / context.view.pixel_size_at(spot))
    assert said[-1].startswith(f"brush 5.0 mm ({pixels} px)")


def test_a_drag_beside_the_organ_turns_the_view_and_paints_nothing(context):
    use(FixTool(context, Brush()))
    azimuth = context.view.camera.azimuth
    drag(context.view, QPoint(5, 5), QPoint(80, 5))
    assert context.view.camera.azimuth != azimuth
    assert context.session.history.count() == 0


def test_the_preview_is_seen_before_the_mouse_is_let_go(context):
    use(StiffnessTool(context, Brush(factor=5.0)), radius=0.01)
    before = context.view.grab_picture()
    drag(context.view, middle(context.view), middle(context.view) + RIGHT, let_go=False)
    assert context.session.history.count() == 0
    assert context.view.grab_picture() != before


def test_the_options_and_the_brush_tell_each_other(context, qtbot):
    tool = use(StiffnessTool(context, Brush()), radius=0.005)
    options = tool.options()
    qtbot.addWidget(options)
    box = options.radius.row.box
    assert box.lineEdit().text() == "5"

    box.lineEdit().setText("12.5")
    box.enter()
    assert tool.brush.radius == pytest.approx(0.0125)
    tool.grow()
    assert float(box.lineEdit().text()) == pytest.approx(12.5 * 1.15, rel=1e-3)

    click(context.view, middle(context.view))
    assert options.count.text().startswith(f"{(tool.count_painted()[0])} of 600")
    qtbot.mouseClick(options.erase, Qt.MouseButton.LeftButton)
    assert (context.session.organ.stiffness_scale == 1.0).all()
    assert context.session.history.count() == 2


# ---------------------------------------------------------------- selecting


def test_clicks_select_add_and_remove(context):
    tool = SelectTool(context)
    tool.activate()
    start = middle(context.view)
    click(context.view, start)
    first = np.flatnonzero(tool.selected)
    assert len(first) == 1

    click(context.view, start + RIGHT, CONTROL)
    assert tool.selected.sum() == 2
    click(context.view, start, ALT)
    assert tool.selected.sum() == 1 and not tool.selected[first[0]]
    click(context.view, QPoint(3, 3))
    assert not tool.selected.any()


def test_a_rectangle_selects_what_is_seen_and_nothing_behind(context):
    tool = SelectTool(context)
    tool.activate()
    start = middle(context.view)
    drag(context.view, start - QPoint(150, 150), start + QPoint(150, 150))
    organ, eye = context.session.organ, np.asarray(context.view.camera.eye())
    x = organ.surface.vertices[tool.selected]
    assert 20 < len(x) < 300
    # on a ball around the origin the seen side is that of the eye
    assert ((eye - x) * x).sum(axis=1).min() > 0.0


def test_keys_take_all_the_others_and_what_is_linked(context):
    tool = SelectTool(context)
    tool.activate()
    actions = {action.objectName(): action for action in tool.actions()}
    actions["select_all"].trigger()
    assert tool.selected.all()
    actions["invert_selection"].trigger()
    assert not tool.selected.any()
    click(context.view, middle(context.view))
    actions["select_linked"].trigger()
    assert tool.selected.all()


def test_a_selection_is_fixed_freed_and_stiffened_in_one_step_each(context, qtbot):
    tool = SelectTool(context)
    tool.activate()
    options = tool.options()
    qtbot.addWidget(options)
    assert not options.fix.isEnabled()
    start = middle(context.view)
    drag(context.view, start - QPoint(40, 40), start + QPoint(40, 40))
    chosen = tool.selected.copy()

    for button in (options.fix, options.free, options.stiffen):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert context.session.history.count() == 3
    assert not context.session.organ.fixed[chosen].any()
    assert (context.session.organ.stiffness_scale[chosen] == 3.0).all()
    assert (context.session.organ.stiffness_scale[~chosen] == 1.0).all()


def test_a_selection_is_kept_under_a_name_and_taken_up_again(context, qtbot):
    tool = SelectTool(context)
    tool.activate()
    options = tool.options()
    qtbot.addWidget(options)
    row = options.regions
    start = middle(context.view)
    drag(context.view, start - QPoint(40, 40), start + QPoint(40, 40))
    chosen = np.flatnonzero(tool.selected)
    assert not row.keep.isEnabled()

    qtbot.keyClicks(row.names.lineEdit(), "upper pole")
    qtbot.mouseClick(row.keep, Qt.MouseButton.LeftButton)
    assert context.session.organ.regions["upper pole"].tolist() == chosen.tolist()

    tool.select_none()
    row.names.activated.emit(row.names.findText("upper pole"))
    assert np.flatnonzero(tool.selected).tolist() == chosen.tolist()
    qtbot.mouseClick(row.forget, Qt.MouseButton.LeftButton)
    assert not context.session.organ.regions and row.names.count() == 0
    context.session.history.undo()
    assert row.names.itemText(0) == "upper pole"


# ---------------------------------------------------------------- large surfaces


@pytest.mark.landing
def test_a_large_surface_is_painted_and_selected_by_threads_with_the_same_result(
    qtbot, settings, monkeypatch
):
    found = []
    for quick in (10**9, 0):
        monkeypatch.setattr(surface_keeper, "QUICK", quick)
        monkeypatch.setattr(select_tool, "QUICK_TO_SEE", quick)
        with open_context(qtbot, build_organ(vertices=2000), settings) as context:
            fix, select, at = FixTool(context, Brush()), SelectTool(context), middle(context.view)
            fix.activate()
            qtbot.waitUntil(lambda fix=fix: fix.find_painted() is not None)
            drag(context.view, at, at + RIGHT)
            fix.deactivate()
            select.activate()
            with qtbot.waitSignal(select.selection_changed, timeout=20000):
                drag(context.view, at - QPoint(90, 90), at + QPoint(90, 90))
            found.append((context.session.organ.fixed, select.selected))

    (fixed, selected), (late_fixed, late_selected) = found
    assert fixed.sum() > build_organ(vertices=2000).fixed.sum() and selected.sum() > 20
    assert (fixed == late_fixed).all() and (selected == late_selected).all()
