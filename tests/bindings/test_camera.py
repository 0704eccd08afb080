# SPDX-License-Identifier: BSD-3-Clause
import math

import numpy as np
import pytest
from palpate.render import Camera

SIZE = (640, 360)


def some_points(count=200, spread=0.05):
    return np.random.default_rng(7).uniform(-spread, spread, (count, 3)) + [0.3, -0.2, 0.1]


def some_camera():
    return Camera(azimuth=0.7, elevation=-0.3, distance=0.6, target=np.array([0.3, -0.2, 0.1]))


def test_a_camera_from_the_side_sees_z_up_and_the_world_right_handed():
    camera = Camera(azimuth=-math.pi / 2, elevation=0.0)  # the eye stands at -y

    right, up, forward = camera.basis()

    assert np.allclose([right, up, forward], [[1, 0, 0], [0, 0, 1], [0, 1, 0]])
    assert np.allclose(camera.eye(), [0, -1, 0])


@pytest.mark.parametrize("elevation", [-math.pi / 2, -0.4, 0.0, 1.1, math.pi / 2])
def test_the_axes_of_a_camera_are_orthonormal_from_everywhere(elevation):
    axes = np.array(Camera(azimuth=2.0, elevation=elevation).basis())

    assert np.allclose(axes @ axes.T, np.eye(3))
    assert np.allclose(np.cross(axes[0], axes[1]), -axes[2])


def test_the_ray_through_the_pixel_of_a_point_meets_that_point():
    camera, points = some_camera(), some_points()
    pixels, _ = camera.project(points, SIZE)

    for point, (x, y) in zip(points, pixels, strict=True):
        eye, direction = camera.ray(x, y, SIZE)
        miss = np.linalg.norm(np.cross(direction, point - eye))
        assert miss < 1e-12
        assert direction @ (point - eye) > 0.0


def test_matrices_and_project_put_points_on_the_same_pixels():
    camera, points = some_camera(), some_points()
    matrix = camera.projection(SIZE[0] / SIZE[1], 0.1, 2.0) @ camera.view()

    clip = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    screen = clip[:, :2] / clip[:, 3:]
    expected, depth = camera.project(points, SIZE)

    assert np.allclose((0.5 + 0.5 * screen[:, 0]) * SIZE[0], expected[:, 0])
    assert np.allclose((0.5 - 0.5 * screen[:, 1]) * SIZE[1], expected[:, 1])
    assert np.allclose(clip[:, 3], depth)


def test_the_near_and_the_far_plane_are_minus_one_and_one():
    matrix = Camera().projection(1.5, 0.1, 2.0)

    near, far = matrix @ [0, 0, -0.1, 1], matrix @ [0, 0, -2.0, 1]

    assert near[2] / near[3] == pytest.approx(-1.0)
    assert far[2] / far[3] == pytest.approx(1.0)


@pytest.mark.parametrize("frame", [None, (100, 50, 600, 340), (300, 20, 340, 350)])
def test_fit_shows_all_points_inside_the_frame_and_touches_it(frame):
    camera, points = some_camera(), some_points()

    camera.fit(points, SIZE, frame)
    pixels, depth = camera.project(points, SIZE)

    left, top, right, bottom = frame or (0, 0, *SIZE)
    slack = 1e-6
    assert depth.min() > 0.0
    assert pixels[:, 0].min() >= left - slack and pixels[:, 0].max() <= right + slack
    assert pixels[:, 1].min() >= top - slack and pixels[:, 1].max() <= bottom + slack
    full_width = np.isclose(np.ptp(pixels[:, 0]), right - left, atol=slack)
    full_height = np.isclose(np.ptp(pixels[:, 1]), bottom - top, atol=slack)
    assert full_width or full_height


def test_fit_keeps_the_direction_of_view_and_refuses_an_empty_frame():
    camera = some_camera()
    before = np.array(camera.basis())

    camera.fit(some_points(), SIZE)

    assert np.array_equal(np.array(camera.basis()), before)
    with pytest.raises(ValueError, match="frame"):
        camera.fit(some_points(), SIZE, (300, 0, 300, 100))


def test_a_single_point_can_be_fitted():
    camera = Camera()

    camera.fit([[0.1, 0.2, 0.3]], SIZE)
    pixels, depth = camera.project([[0.1, 0.2, 0.3]], SIZE)

    assert np.allclose(pixels, [[320, 180]])
    assert depth[0] > 0.0


def test_the_depths_hold_the_ball():
    camera = some_camera()

    near, far = camera.depths(camera.target, 0.1)

    assert 0.0 < near <= 0.5
    assert far >= 0.7


def test_orbiting_keeps_the_target_in_the_middle_and_stops_at_the_poles():
    camera = some_camera()

    camera.orbit(0.5, 9.0)
    pixels, depth = camera.project([camera.target], SIZE)

    assert camera.elevation == math.pi / 2
    assert np.allclose(pixels, [[320, 180]])
    assert depth[0] == pytest.approx(0.6)


def test_panning_moves_what_lies_at_the_target_with_the_pointer():
    camera = some_camera()
    point = np.array(camera.target)

    camera.pan(40.0, -25.0, SIZE)
    pixels, _ = camera.project([point], SIZE)

    assert np.allclose(pixels, [[360, 155]])


def test_zooming_by_two_halves_the_distance():
    camera = some_camera()

    camera.zoom(2.0)

    assert camera.distance == pytest.approx(0.3)
    with pytest.raises(ValueError, match="factor"):
        camera.zoom(0.0)
