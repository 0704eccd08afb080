# SPDX-License-Identifier: BSD-3-Clause
"""What a laparoscope sees: where its camera stands, its lamp, and its picture in a view."""

from __future__ import annotations

import math

import numpy as np
import palpate
import pytest
from palpate.render import Appearance, Camera, Renderer, has_camera, place_scope
from palpate.render.context import open_context
from palpate.render.instrument_meshes import MESHES
from palpate.render.scope_camera import HEADLIGHT
from palpate.viewport import SeenInstrument
from palpate.viewport.scope_inset import Shows
from palpate_meshes.tools import read_tool
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def laparoscope(radius: float = 5e-3) -> palpate.Tool:
    return palpate.Tool(
        radius=radius, capsules=[palpate.Capsule(from_=(0.0, 0.0, 0.0), to=(0.0, 0.0, 0.1))]
    )


def turned_about_x(angle: float) -> tuple[float, float, float, float]:
    return math.sin(angle / 2), 0.0, 0.0, math.cos(angle / 2)


def test_instruments_to_see_with_are_wide_shafts():
    assert has_camera(laparoscope()) and has_camera(laparoscope(3.5e-3))
    assert not has_camera(laparoscope(2.5e-3))
    assert not has_camera(palpate.Tool(radius=5e-3))
    with pytest.raises(ValueError, match="got a ball, expected a laparoscope"):
        place_scope(palpate.Tool(radius=5e-3), (0, 0, 0), UPRIGHT)


def test_an_upright_laparoscope_looks_30_degrees_off_its_shaft_from_its_lens():
    camera = place_scope(laparoscope(), (0.1, 0.2, 0.3), UPRIGHT)

    right, up, forward = camera.basis()
    assert forward == pytest.approx([0.0, 0.5, -math.cos(math.radians(30))])
    assert up == pytest.approx([0.0, -math.cos(math.radians(30)), -0.5])
    assert np.cross(right, forward) == pytest.approx(up)
    # the mesh ends 8.8 mm before the axis of what touches, and the lens lies 2.9 mm behind that
    assert camera.eye() == pytest.approx([0.1, 0.2, 0.3 - 8.8e-3 + 2.9e-3])


def test_its_optics_are_those_of_the_shipped_mesh():
    shipped, optics = read_tool("laparoscope").camera, MESHES["laparoscope"].optics

    # the mesh has its shaft along -z
    for name in ("at", "axis", "up"):
        turned = np.array(getattr(shipped, name)) * [1.0, -1.0, -1.0]
        assert getattr(optics, name) == pytest.approx(turned)
    assert optics.field_of_view == shipped.field_of_view


def test_it_turns_and_moves_with_the_instrument():
    tool, turn = laparoscope(), turned_about_x(math.radians(30))

    camera = place_scope(tool, (0.0, 0.0, 0.1), turn)

    # turned by 30 degrees about x, towards -y, its optics look straight down
    assert camera.basis()[2] == pytest.approx([0.0, 0.5 + 0.366025, -0.5], abs=1e-5)
    back = place_scope(tool, (0.0, 0.0, 0.1), turned_about_x(math.radians(-30)))
    assert back.basis()[2] == pytest.approx([0.0, 0.0, -1.0], abs=1e-6)
    assert back.describe() != camera.describe()


def draw_wall(camera: Camera, away: float) -> np.ndarray:
    """(h, w, 3) of a grey wall `away` [m] in front of a camera that looks along -z."""
    side = 1.0
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * side
    corners[:, 2] = -away
    size = (64, 64)
    with open_context() as context:
        renderer = Renderer(context)
        renderer.use_bounds((0.0, 0.0, -away), 2.0)
        part = renderer.add(
            4, [[0, 1, 2], [0, 2, 3]], Appearance((0.5, 0.5, 0.5), gloss=0.0, subsurface=0.0)
        )
        part.update(
            position=np.float32(corners),
            normal=np.float32([[0, 0, 1]] * 4),
            openness=np.ones(4, np.float32),
        )
        target = context.simple_framebuffer(size)
        target.use()
        renderer.draw(camera, size)
        pixels = np.frombuffer(target.read(), np.uint8).reshape(64, 64, 3)
        renderer.release()
    return pixels.astype(float)


def looking_down() -> Camera:
    back = place_scope(laparoscope(), (0.0, 0.0, 0.0), turned_about_x(math.radians(-30)))
    back.target = np.asarray(back.target) - back.eye()  # the lens at the origin
    return back


def test_its_lamp_lights_by_the_inverse_square():
    camera = looking_down()

    near, far = (
        draw_wall(camera, away)[32, 32].mean() / 255.0 for away in (2 * HEADLIGHT, 4 * HEADLIGHT)
    )

    # what a screen shows is the light to the power of 1/2.2
    assert (near / far) ** 2.2 == pytest.approx(4.0, rel=0.1)
    assert camera.headlight == HEADLIGHT


def test_where_its_lamp_does_not_reach_it_is_dark():
    camera = looking_down()
    # the other way, from the same place
    camera.axes = camera.axes * [[1], [-1], [-1]]
    camera.target = -np.asarray(camera.target)

    assert draw_wall(camera, 0.1).max() == 0.0


def hold(tool: palpate.Tool) -> SeenInstrument:
    return SeenInstrument(tool, (0.0, 0.0, 0.06), turned_about_x(math.radians(-30)))


def test_a_view_with_a_laparoscope_has_its_picture_in_a_corner(view):
    view.show_instruments([hold(laparoscope())])
    picture = view.grab_picture()

    assert view.scope.isVisible() and view.scope.camera is not None
    middle = view.scope.geometry().center()
    seen = picture.pixelColor(middle)
    # the organ, straight below its lens
    assert seen.red() > 60 and seen.red() > 1.5 * seen.blue()
    view.show_instruments([hold(laparoscope(2e-3))])
    assert not view.scope.isVisible() and view.scope.camera is None


def test_v_changes_the_pictures(view):
    view.show_instruments([hold(laparoscope())])
    assert view.seen_from is view.camera
    view.setFocus()

    QTest.keyClick(view, Qt.Key.Key_V)
    assert view.scope.shows is Shows.scope
    assert view.seen_from is view.scope.camera
    before = view.camera.describe()
    view.orbit(30, 0)
    view.zoom(2.0)
    assert view.camera.describe() == before
    large = view.grab_picture()
    assert large.pixelColor(4, 4).lightness() < 40

    QTest.keyClick(view, Qt.Key.Key_V)
    assert view.scope.shows is Shows.room_alone
    assert not view.scope.isVisible() and view.seen_from is view.camera
    QTest.keyClick(view, Qt.Key.Key_V)
    assert view.scope.shows is Shows.room and view.scope.isVisible()


def test_v_is_not_taken_where_there_is_no_laparoscope(view):
    assert not view.change_scope()


def test_its_picture_is_drawn_again_only_where_something_changed(view):
    view.show_instruments([hold(laparoscope())])
    view.grab_picture()
    canvas = view._canvas
    camera = view.scope.camera
    side = view.scope.width()
    with view.in_context():
        assert canvas.draw_inset(view.scenery, camera, (side, side), 1.0) is None
        view.show_instruments([hold(laparoscope())])
        assert canvas.draw_inset(view.scenery, camera, (side, side), 1.0) is not None
