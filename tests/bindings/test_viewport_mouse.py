# SPDX-License-Identifier: BSD-3-Clause
"""What the mouse does to the 3D view, and what a tool takes of it."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from viewports import CORNER, MIDDLE_OF_VIEW, SIZE, silhouette
from windows import LEFT, MIDDLE, RIGHT, at, drag, grab, move, turn_wheel


def test_a_left_drag_turns_and_the_surface_follows_the_mouse(view):
    azimuth, elevation = view.camera.azimuth, view.camera.elevation
    front = view.pick(QPointF(MIDDLE_OF_VIEW)).point

    drag(view, CORNER, QPoint(30, 20))

    assert view.camera.azimuth < azimuth
    assert view.camera.elevation > elevation
    assert view.world_to_pixel(front).x() > MIDDLE_OF_VIEW.x()
    assert view.world_to_pixel(front).y() > MIDDLE_OF_VIEW.y()


@pytest.mark.parametrize(
    ("button", "keys"),
    [(MIDDLE, Qt.KeyboardModifier.NoModifier), (LEFT, Qt.KeyboardModifier.ShiftModifier)],
)
def test_middle_or_shift_moves_what_is_seen_with_the_mouse(view, button, keys):
    view.camera.target = np.zeros(3)
    before = view.world_to_pixel(np.zeros(3))

    drag(view, MIDDLE_OF_VIEW, QPoint(24, -16), button, keys)

    after = view.world_to_pixel(np.zeros(3))
    assert after.x() - before.x() == pytest.approx(24, abs=0.5)
    assert after.y() - before.y() == pytest.approx(-16, abs=0.5)


def test_a_right_drag_turns_too(view):
    azimuth = view.camera.azimuth
    drag(view, MIDDLE_OF_VIEW, QPoint(30, 0), RIGHT)
    assert view.camera.azimuth < azimuth


def test_the_wheel_comes_nearer_to_what_lies_under_the_pointer(view):
    where = QPoint(190, 100)
    hit = view.pick(QPointF(where))
    distance = view.camera.distance

    turn_wheel(view, where, 3)

    assert view.camera.distance < distance
    assert at(view.world_to_pixel(hit.point)) == where
    for _ in range(80):
        turn_wheel(view, where, 5)
    assert view.camera.distance > 0.0
    for _ in range(80):
        turn_wheel(view, where, -5)
    assert view.camera.distance < 10.0


def test_a_view_that_nobody_moved_stays_fitted_when_it_is_resized(view, qtbot):
    view.resize(200, 400)
    qtbot.wait(20)
    left, top, right, bottom = silhouette(grab(view))
    assert left > 0 and right < 199 and right - left > 120

    drag(view, CORNER, QPoint(10, 0))
    distance = view.camera.distance
    view.resize(*SIZE)
    qtbot.wait(20)
    assert view.camera.distance == distance


class Recorder:
    """A tool that notes what it gets and takes what it is told to."""

    def __init__(self, takes: bool):
        self.takes, self.seen = takes, []

    def note(self, name):
        self.seen.append(name)
        return self.takes

    def press(self, view, event):
        return self.note("press")

    def move(self, view, event):
        return self.note("move")

    def release(self, view, event):
        return self.note("release")

    def wheel(self, view, event):
        return self.note("wheel")

    def leave(self, view):
        self.note("leave")

    def key(self, view, event):
        return self.note("key")


def test_a_tool_gets_everything_first_and_keeps_what_it_takes(view):
    camera = (view.camera.azimuth, view.camera.distance)
    view.tool = Recorder(takes=True)

    drag(view, MIDDLE_OF_VIEW, QPoint(20, 20))
    turn_wheel(view, MIDDLE_OF_VIEW, 2)
    QTest.keyClick(view, Qt.Key.Key_A)

    assert view.tool.seen == ["press", *["move"] * 4, "release", "wheel", "key"]
    assert (view.camera.azimuth, view.camera.distance) == camera


def test_what_a_tool_does_not_take_moves_the_camera(view):
    camera = (view.camera.azimuth, view.camera.distance)
    view.tool = Recorder(takes=False)

    drag(view, MIDDLE_OF_VIEW, QPoint(20, 20))
    turn_wheel(view, MIDDLE_OF_VIEW, 2)

    assert view.tool.seen == ["press", "wheel"]
    assert view.camera.azimuth != camera[0]
    assert view.camera.distance < camera[1]


def test_hovering_and_frames_are_told(view, qtbot):
    with qtbot.waitSignal(view.hover) as told:
        move(view, MIDDLE_OF_VIEW)
    assert told.args == [QPointF(MIDDLE_OF_VIEW)]
    with qtbot.waitSignal(view.frame_drawn):
        view.orbit(5, 0)
