# SPDX-License-Identifier: BSD-3-Clause
"""The arrow of a force is always seen whole, whatever the force and the camera."""

from __future__ import annotations

import numpy as np
import pytest
from palpate.render import Camera, build_arrow
from palpate.viewport import make_view
from palpate.viewport.force_arrow import choose_radius, keep_in_sight
from viewports import FACES, X, redness
from windows import grab

SIZE = (1280, 800)
FRAME = (60.0, 14.0, 1100.0, 760.0)
DIRECTIONS = [
    np.array(direction, float) for direction in np.ndindex(3, 3, 3) if direction != (1, 1, 1)
]


def arrow_pixels(camera: Camera, tail, point) -> tuple[np.ndarray, np.ndarray]:
    radius = choose_radius(camera, SIZE[1], tail, 1e-3)
    return camera.project(build_arrow(tail, point, radius).vertices, SIZE)


@pytest.mark.parametrize("distance", [0.02, 0.1, 0.6])
@pytest.mark.parametrize("length", [1e-4, 0.02, 1.0])
@pytest.mark.parametrize("start", [(0.0, 0.0, 0.0), (0.04, -0.03, 0.02), (-0.5, 0.3, -0.2)])
def test_every_arrow_lies_in_the_frame_and_before_the_eye(distance, length, start):
    camera = Camera(target=np.array([0.0, -0.02, 0.0]), distance=distance)
    left, top, right, bottom = FRAME
    for direction in DIRECTIONS:
        vector = length * (direction - 1.0) / np.linalg.norm(direction - 1.0)

        tail, point = keep_in_sight(camera, SIZE, FRAME, np.array(start), vector)

        pixels, depths = arrow_pixels(camera, tail, point)
        assert depths.min() > 0.0
        assert pixels[:, 0].min() > left - 20 and pixels[:, 0].max() < right + 20
        assert pixels[:, 1].min() > top - 20 and pixels[:, 1].max() < bottom + 20
        along = (point - tail) / np.linalg.norm(point - tail)
        assert along @ vector == pytest.approx(length)
        assert np.linalg.norm(point - tail) <= length * (1 + 1e-9)


def test_an_arrow_that_is_in_sight_stays_as_it_is():
    camera = Camera(target=np.zeros(3), distance=0.3)
    start, vector = np.array([0.01, 0.0, 0.01]), np.array([0.0, 0.01, 0.02])

    tail, point = keep_in_sight(camera, SIZE, FRAME, start, vector)

    assert np.allclose(tail, start, atol=1e-12)
    assert np.allclose(point, start + vector, atol=1e-12)


def test_an_arrow_at_the_side_that_points_outwards_is_moved_inwards_not_cut_to_nothing():
    camera = Camera(target=np.zeros(3), distance=0.3)
    right = camera.basis()[0]
    reach = 0.3 * np.tan(camera.field_of_view / 2) * SIZE[0] / SIZE[1]
    start = right * reach * 0.71  # beside the frame's right side, which ends before the view does

    tail, point = keep_in_sight(camera, SIZE, FRAME, start, 0.05 * right)

    pixels, _ = camera.project([tail, point], SIZE)
    assert pixels[1, 0] - pixels[0, 0] == pytest.approx(48.0, abs=0.5)
    assert pixels[1, 0] == pytest.approx(FRAME[2], abs=0.5)


def test_the_shaft_is_neither_a_thread_nor_a_beam():
    for distance in (0.01, 0.3, 5.0):
        camera = Camera(target=np.zeros(3), distance=distance)
        pixel = 2.0 * distance * np.tan(camera.field_of_view / 2) / 800
        shaft = choose_radius(camera, 800, np.zeros(3), 1e-3) / pixel
        assert 2.0 * (1 - 1e-9) <= shaft <= 6.0 * (1 + 1e-9)


@pytest.mark.parametrize("zoom", [1.0, 6.0])
@pytest.mark.parametrize("newtons", [0.5, 50.0])
def test_the_arrow_is_drawn_near_and_far_for_small_and_large_forces(qtbot, zoom, newtons):
    view = make_view()
    qtbot.addWidget(view)
    view.resize(640, 400)
    view.show_surface(X, FACES)
    view.show()
    qtbot.waitExposed(view)
    view.zoom(zoom)
    plain = grab(view)
    view.show_force((0.0, -0.026, 0.0), (0.0, -newtons, 0.0))
    seen = grab(view)

    changed = np.abs(seen - plain).sum(axis=-1) > 60
    rows, columns = np.nonzero(changed)
    assert len(rows) > 150
    assert rows.min() > 1 and rows.max() < 398 and columns.min() > 1 and columns.max() < 638
    assert (redness(seen)[changed] > 60).mean() > 0.5
    view.zoom(0.2)  # the camera moves, and the arrow with it
    assert (redness(grab(view)) > 100).sum() > 60
