# SPDX-License-Identifier: BSD-3-Clause
"""The 3D view as a window shows it and a mouse moves it; with a display and without one."""

from __future__ import annotations

import math

import numpy as np
import palpate
import pytest
from palpate.render import RenderError
from palpate.viewport import FboView, GLView, fbo_view, make_view
from palpate.viewport.make_view import has_window_gl
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget
from surfaces import ellipsoid, sheet
from viewports import (
    CORNER,
    FACES,
    MIDDLE_OF_VIEW,
    SIZE,
    X,
    count_orange,
    redness,
    silhouette,
)
from windows import grab, read_pixels

# ---------------------------------------------------------------- hosts and pictures


def test_the_platform_decides_which_host_draws(view):
    on_desktop = QApplication.platformName() == "xcb"
    assert has_window_gl() == on_desktop
    assert isinstance(view, GLView if on_desktop else FboView)


def test_a_surface_stands_in_the_middle_before_the_backdrop(view):
    pixels = read_pixels(view.grab_picture())

    assert redness(pixels)[SIZE[1] // 2, SIZE[0] // 2] > 50
    assert abs(redness(pixels)[4, 4]) < 20
    left, top, right, bottom = silhouette(pixels)
    # as large as it can be with a margin, in the one direction or the other
    assert left >= 5 and top >= 5 and right <= SIZE[0] - 6 and bottom <= SIZE[1] - 6
    assert right - left > 0.7 * SIZE[0] or bottom - top > 0.7 * SIZE[1]


def test_pictures_are_opaque(view):
    image = view.grab_picture()
    assert image.pixelColor(3, 3).alpha() == 255
    assert image.pixelColor(SIZE[0] // 2, SIZE[1] // 2).alpha() == 255


def test_the_fine_picture_differs_from_the_quick_one_only_a_little(view):
    view.orbit(20, 0)
    quick = grab(view)
    fine = read_pixels(view.grab_picture())

    assert np.abs(quick - fine).mean() < 25
    assert np.array_equal(grab(view), fine)


def test_values_are_painted_with_a_legend_and_taken_away_again(view):
    plain = read_pixels(view.grab_picture())
    view.show_values(1e3 * X[:, 2], "height [mm]")
    painted = read_pixels(view.grab_picture())

    assert view.legend.isVisible()
    assert view.legend.title == "height [mm]"
    assert np.abs(painted - plain)[100:140, 140:180].mean() > 20
    view.show_values(None)
    assert not view.legend.isVisible()
    assert redness(grab(view))[SIZE[1] // 2, SIZE[0] // 2] > 50


def test_what_is_selected_is_orange(view):
    before = count_orange(grab(view))
    view.show_selection((X[:, 1] < -0.01).astype(float))
    during = count_orange(grab(view))
    view.show_selection(None)

    assert during > before + 500
    assert count_orange(grab(view)) == before


def test_what_has_torn_is_dark_until_the_organ_is_whole_again(view):
    whole = grab(view)
    version = view.scenery.version
    view.show_torn(None)
    assert view.scenery.version == version, "drawn again for nothing"
    view.show_torn((X[:, 1] < -0.01).astype(float))
    torn = grab(view)
    view.show_torn(None)

    darker = (torn.sum(axis=2) < 0.7 * whole.sum(axis=2)).sum()
    assert 500 < darker < 0.5 * SIZE[0] * SIZE[1]
    assert np.array_equal(grab(view), whole)


def test_tool_arrow_and_ring_come_and_go(view):
    plain = grab(view)
    view.show_tool((0.0, -0.028, 0.0), 0.003)
    view.show_force((0.0, -0.028, 0.0), (0.0, 0.0, 1.0))
    view.show_ring((0.0, -0.025, 0.0), (0, -1, 0), 0.008)
    shown = grab(view)

    assert (np.abs(shown - plain).sum(axis=-1) > 30).sum() > 300
    view.show_tool(None)
    view.show_force(None)
    view.show_ring(None)
    assert np.array_equal(grab(view), plain)


def test_a_force_of_nothing_is_no_arrow(view):
    plain = grab(view)
    view.show_force((0.0, -0.028, 0.0), (0.0, 0.0, 0.0))
    assert np.array_equal(grab(view), plain)


def test_the_surface_follows_its_new_positions(view):
    left, *_ = silhouette(grab(view))
    view.move_surface(X + [0.01, 0.0, 0.0])

    assert silhouette(grab(view))[0] != left
    with pytest.raises(ValueError, match="shape of the surface shown"):
        view.move_surface(X[:-1])


def test_another_surface_takes_the_place_of_the_first(view):
    flat = sheet(9, 0.04)
    view.show_surface(flat.vertices, flat.triangles)
    view.show_surface(X, FACES)
    view.show_surface(flat.vertices, flat.triangles)
    view.frame_all()

    assert view.pick(view.world_to_pixel((0.02, 0.02, 0.0)).toPoint().toPointF()) is not None


def test_surfaces_that_cannot_be_drawn_are_refused_and_the_old_one_stays(view):
    for vertices, faces in (
        (X[:, :2], FACES),
        (np.full_like(X, np.nan), FACES),
        (X, FACES + len(X)),
        (X, FACES[:, :2]),
    ):
        with pytest.raises(ValueError):
            view.show_surface(vertices, faces)
    assert redness(grab(view))[SIZE[1] // 2, SIZE[0] // 2] > 50


def test_edges_are_drawn_where_they_are_wanted(view):
    view.wireframe = False
    without = grab(view)
    view.wireframe = True

    assert view.wireframe
    assert not np.array_equal(grab(view), without)


def test_the_theme_turns_the_backdrop_light(view):
    dark = grab(view)[4, 4].mean()
    view.use_theme("light")

    assert grab(view)[4, 4].mean() > dark + 100


def test_text_over_the_picture_is_readable_after_a_frame(view):
    view.hud.show_rows([("Force", "1.23 N"), ("Time", "0:12")])
    view.hud.move(0, 0)
    pixels = grab(view)

    assert view.hud.isVisible()
    bright = pixels[: view.hud.height(), : view.hud.width()].min(axis=-1) > 200
    assert 30 < bright.sum() < 2000
    view.hud.show_rows([])
    assert not view.hud.isVisible()


# ---------------------------------------------------------------- where things are


def test_picking_and_projecting_are_each_others_inverse(view):
    for pixel in (QPointF(160, 120), QPointF(120, 100), QPointF(200, 140)):
        hit = view.pick(pixel)
        assert hit is not None
        back = view.world_to_pixel(hit.point)
        assert math.hypot(back.x() - pixel.x(), back.y() - pixel.y()) < 1e-6
    assert view.pick(QPointF(CORNER)) is None


def test_picking_sees_where_the_surface_is_now(view):
    before = view.pick(QPointF(160, 120))
    towards = -view.ray_at(QPointF(160, 120))[1]
    view.move_surface(X + 0.01 * towards)

    assert view.pick(QPointF(160, 120)).distance == pytest.approx(before.distance - 0.01)


def test_only_the_outer_side_can_be_picked(view):
    flat = sheet(5, 0.04)
    view.show_surface(flat.vertices, flat.triangles)
    view.look_from(-1.0, 0.8)
    view.frame_all()
    middle = view.world_to_pixel((0.02, 0.02, 0.0))
    assert view.pick(middle) is not None
    view.look_from(-1.0, -0.8)
    view.frame_all()

    assert view.pick(view.world_to_pixel((0.02, 0.02, 0.0))) is None


def test_a_pixel_has_the_size_it_has_in_the_world(view):
    hit = view.pick(QPointF(160, 120))
    right = view.camera.basis()[0]
    one = view.world_to_pixel(hit.point + right * view.pixel_size_at(hit.point))

    assert one.x() - 160.0 == pytest.approx(1.0, abs=1e-6)


# ---------------------------------------------------------------- contexts


def test_nothing_is_lost_with_the_graphics_context(view, qtbot):
    view.show_values(X[:, 2], "height [m]")
    view.show_tool((0.0, -0.028, 0.0), 0.003)
    before = read_pixels(view.grab_picture())
    if isinstance(view, FboView):
        view.close_context()
    else:  # another window has another context
        window = QMainWindow()
        qtbot.addWidget(window)
        window.setCentralWidget(view)
        window.resize(*SIZE)
        window.show()
        qtbot.waitExposed(window)
        window.centralWidget().setFixedSize(*SIZE)

    after = read_pixels(view.grab_picture())

    assert after.shape == before.shape
    assert np.abs(after - before).mean() < 1.0
    view.setParent(None)


def test_two_views_draw_beside_each_other(view, qtbot):
    other = make_view()
    qtbot.addWidget(other)
    other.resize(*SIZE)
    other.show_surface(X * 0.5, FACES)
    other.use_theme("light")
    other.show()
    qtbot.waitExposed(other)

    for _ in range(3):
        view.orbit(1, 0)
        other.orbit(1, 0)
        first, second = grab(view), grab(other)
    assert second[4, 4].mean() > first[4, 4].mean() + 100
    other.deleteLater()
    QApplication.sendPostedEvents(None, 52)
    view.orbit(1, 0)
    assert redness(grab(view))[SIZE[1] // 2, SIZE[0] // 2] > 50


def test_a_machine_without_opengl_says_so_in_the_window(qtbot, monkeypatch):
    def refuse():
        raise RenderError("no OpenGL 3.3 context: install libegl1")

    monkeypatch.setattr(fbo_view, "create_context", refuse)
    window = QWidget()
    qtbot.addWidget(window)
    view = FboView(window)
    view.resize(*SIZE)
    view.show_surface(X, FACES)
    pixels = grab(view)

    assert view.problem == "no OpenGL 3.3 context: install libegl1"
    text = QColor.fromRgbF(*view.scenery.theme.text)
    close = np.abs(pixels - [text.red(), text.green(), text.blue()]).sum(axis=-1) < 60
    assert close.sum() > 100
    assert view.pick(QPointF(MIDDLE_OF_VIEW)) is not None


def test_updates_at_screen_rate_leave_no_memory_behind(view):
    import tracemalloc

    mesh = ellipsoid((0.03, 0.025, 0.02), 4)
    x = np.array(mesh.vertices)
    view.show_surface(x, mesh.triangles)
    normals = palpate.compute_vertex_normals(x, mesh.triangles)
    grab(view)
    view.move_surface(x, normals)
    tracemalloc.start()
    for _ in range(20):
        view.move_surface(x, normals)
        view.show_tool((0.0, -0.028, 0.0), 0.003)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()

    # less than the surface itself takes: nothing of its size is made again
    assert peak < x.nbytes + 2**17


def test_numbers_stay_in_their_corner_however_wide_they_are(view):
    view.keep_free(right=40)
    view.hud.show_rows([("Force", "0 N")])
    right = view.hud.geometry().right()
    view.hud.show_rows([("Instrument 1", "0.00 N"), ("Instrument 2", "12.00 N")])
    assert view.hud.geometry().right() == right < view.width() - 40
