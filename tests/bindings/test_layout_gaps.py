# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a layout: how far apart they are, what parts them, what lays one on another."""

from __future__ import annotations

import numpy as np
import pytest
from palpate.layout.document import PlacedBody
from palpate.layout.gaps import Surface
from palpate.layout.separate import Neighbour, find_least_step, separate
from palpate.layout.snap import measure_patch, snap
from scipy.spatial.transform import Rotation
from surfaces import ellipsoid

TAU = 4e-4
RADII = (0.03, 0.025, 0.02)


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> Surface:
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    x = np.array(low) + np.array(corners) * (np.array(high) - np.array(low))
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]
    return Surface(x, np.array(triangles, dtype=np.int32))


def test_the_least_step_is_the_one_of_the_geometry():
    eye = np.eye(3)
    np.testing.assert_allclose(find_least_step(eye[:1], np.array([2e-3])), (2e-3, 0.0, 0.0))
    np.testing.assert_allclose(
        find_least_step(eye[:2], np.array([1e-3, 2e-3])), (1e-3, 2e-3, 0.0), atol=1e-12
    )
    slanted = np.array([(1.0, 0.0, 0.0), (np.sqrt(0.5), np.sqrt(0.5), 0.0)])
    np.testing.assert_allclose(  # the second asks for more than the first, which is then kept
        find_least_step(slanted, np.array([1e-3, 4e-3])), 4e-3 * slanted[1], atol=1e-12
    )
    assert find_least_step(np.array([eye[0], -eye[0]]), np.array([1e-3, 1e-3])) is None


@pytest.mark.parametrize("depth", [0.0, 1e-3])
def test_surfaces_that_coincide_or_overlap_are_moved_apart_by_the_thickness(depth):
    still = box((0.0, 0.0, 0.0), (0.02, 0.02, 0.01))
    moved = box((0.002, 0.002, 0.01 - depth), (0.018, 0.018, 0.02))

    found = separate(1, moved, [Neighbour(0, still, TAU)])

    assert found.gap == pytest.approx(-depth, abs=1e-12)
    np.testing.assert_allclose(found.shift, (0.0, 0.0, depth + TAU), atol=2e-6)


def test_an_arch_over_a_body_has_no_inside():
    """An open sheet: below it, far away, is not in it."""
    angle = np.linspace(0.0, np.pi, 13)
    rows = [(0.02 * np.cos(a), y, 0.02 * np.sin(a)) for a in angle for y in (-0.02, 0.0, 0.02)]
    cells = [(3 * i + k, 3 * i + k + 1) for i in range(12) for k in range(2)]
    triangles = [t for a, b in cells for t in ((a, b, a + 3), (b, b + 3, a + 3))]
    arch = Surface(np.array(rows), np.array(triangles, dtype=np.int32))
    below = box((-0.005, -0.01, 0.0), (0.005, 0.01, 0.006))

    for still, moved in ((below, arch), (arch, below)):
        assert separate(1, moved, [Neighbour(0, still, TAU)]) is None


def test_what_is_apart_by_half_the_thickness_stays():
    still = box((0.0, 0.0, 0.0), (0.02, 0.02, 0.01))
    moved = box((0.002, 0.002, 0.01 + 0.51 * TAU), (0.018, 0.018, 0.02))
    assert separate(1, moved, [Neighbour(0, still, TAU)]) is None


def test_a_body_between_two_that_leave_it_no_room_is_not_moved():
    walls = [box((-0.02, -0.02, -0.02), (0.02, 0.02, 1e-4)), box((-0.02, -0.02, 0.0099),
             (0.02, 0.02, 0.02))]  # fmt: skip
    held = box((-0.01, -0.01, 0.0), (0.01, 0.01, 0.01))
    found = separate(2, held, [Neighbour(i, wall, TAU) for i, wall in enumerate(walls)])
    assert found.shift is None


def test_a_point_is_inside_by_the_steepest_of_the_faces_that_meet():
    cube = box((0.0, 0.0, 0.0), (0.01, 0.01, 0.01))
    zero = np.zeros(3)
    for point, gap in (
        ((0.005, 0.005, 0.009), -1e-3),
        ((0.005, 0.005, 0.012), 2e-3),
        ((0.011, 0.011, 0.011), np.sqrt(3e-6)),  # beyond a corner
        ((0.0099, 0.005, 0.0101), 1e-4),
    ):
        assert cube.find_near(np.array(point), 5e-3, zero).size == pytest.approx(gap)
    assert cube.find_near(np.array((0.005, 0.005, 0.02)), 5e-3, zero) is None


def test_beside_the_border_of_an_open_surface_nothing_is_inside():
    sheet = Surface(
        np.array([(0.0, 0.0, 0.0), (0.01, 0.0, 0.0), (0.0, 0.01, 0.0)]),
        np.array([(0, 1, 2)], dtype=np.int32),
    )
    behind = sheet.find_near(np.array((-1e-3, -1e-3, -1e-3)), 5e-3, np.zeros(3))
    assert behind.size == pytest.approx(np.sqrt(3e-6))
    assert sheet.find_near(np.array((2e-3, 2e-3, -1e-4)), 5e-3, np.zeros(3)).size < 0.0


def test_ellipsoids_are_parted_along_where_they_are_nearest():
    mesh = ellipsoid(RADII, 3)
    x, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    still = Surface(x, triangles)
    near = Surface(x + 0.97 * np.array((0.06, 0.0, 0.0)), triangles)
    found = separate(1, near, [Neighbour(0, still, TAU)])
    assert found.gap < 0.0
    assert found.shift[0] > 0.9 * np.linalg.norm(found.shift)


def test_a_snapped_body_lies_with_its_region_on_the_other_at_the_gap():
    still = box((0.0, 0.0, 0.0), (0.04, 0.02, 0.01))
    other = box((0.1, 0.0, 0.0), (0.11, 0.03, 0.008))
    onto = measure_patch(still, np.array([4, 5, 6, 7]))  # its upper face, 40 by 20 mm
    patch = measure_patch(other, np.array([1, 3, 5, 7]))  # the face to +x, 30 by 8 mm
    np.testing.assert_allclose(onto.normal, (0.0, 0.0, 1.0), atol=1e-12)
    np.testing.assert_allclose(np.abs(onto.longest), (1.0, 0.0, 0.0), atol=1e-12)

    placed = snap(PlacedBody("b", "", ""), other, patch, still, onto, 3e-4)

    x = Rotation.from_rotvec(placed.rotation).apply(other.x) + placed.position
    low, high = x.min(axis=0), x.max(axis=0)
    np.testing.assert_allclose(high - low, (0.03, 0.008, 0.01), atol=1e-9)
    np.testing.assert_allclose(0.5 * (low + high)[:2], (0.02, 0.01), atol=1e-9)
    assert low[2] == pytest.approx(0.01 + 3e-4, abs=1e-7)


@pytest.mark.parametrize("gap", [0.0, 1e-5])
def test_a_body_snapped_onto_an_open_surface_touches_it_at_most(gap):
    """An open surface has no inside: a vertex behind it is found within reach alone."""
    closed, mesh = box((0.0, 0.0, 0.0), (0.04, 0.02, 0.01)), ellipsoid(RADII, 3)
    is_below = (closed.x[closed.triangles][..., 2] == 0.0).all(axis=1)
    still = Surface(closed.x, closed.triangles[~is_below])
    other = Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    onto = measure_patch(still, np.array([4, 5, 6, 7]))
    patch = measure_patch(other, np.flatnonzero(other.x[:, 2] > 0.7 * other.high[2]))

    placed = snap(PlacedBody("b", "", ""), other, patch, still, onto, gap)

    x = Rotation.from_rotvec(placed.rotation).apply(other.x) + placed.position
    assert 0.0 <= x[:, 2].min() - 0.01 - gap < 1e-6


def test_a_region_that_faces_all_ways_or_is_empty_cannot_be_laid_on_another():
    cube = box((0.0, 0.0, 0.0), (0.01, 0.01, 0.01))
    for vertices, said in ((np.arange(8), "faces all ways"), (np.array([], int), "no|without")):
        with pytest.raises(ValueError, match=said):
            measure_patch(cube, vertices)
