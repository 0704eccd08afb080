# SPDX-License-Identifier: BSD-3-Clause
"""The dent that is drawn under a ball: on the ball where it touches, the surface itself around."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.viewport.appearance import PLAIN
from palpate.viewport.dent_patch import MOST_POINTS, REACH, build_dent, cut_triangle, run_out
from palpate.viewport.drawn_dent import DrawnDent
from palpate.viewport.thing import Thing
from surfaces import ellipsoid

EDGE, R = 10e-3, 4e-3


def plane(cells: int = 8):
    """Of squares of EDGE [m] at height 0, facing up, each cut in two."""
    side = EDGE * np.arange(cells + 1)
    x, y = np.meshgrid(side, side, indexing="ij")
    number = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (
        part.ravel()
        for part in (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:])
    )
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    triangles = np.vstack([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return vertices, np.tile([0.0, 0.0, 1.0], (x.size, 1)), triangles


def make(vertices, normals, triangles, centre, radius):
    edges = vertices[triangles] - vertices[np.roll(triangles, 1, axis=1)]
    edge = float(np.linalg.norm(edges, axis=2).max())
    return build_dent(vertices, normals, triangles, np.array(centre), radius, edge)


def dent_at(depth: float, x: float = 0.043, y: float = 0.038):
    return make(*plane(), [x, y, R - depth], R)


@pytest.mark.parametrize("depth", [0.1 * R, 0.75 * R, 1.5 * R])
def test_no_point_of_a_dent_lies_in_the_ball_and_its_middle_lies_on_it(depth):
    centre = np.array([0.043, 0.038, R - depth])

    dent = make(*plane(), centre, R)

    away = np.linalg.norm(dent.position - centre, axis=1)
    under = np.linalg.norm(dent.position[:, :2] - centre[:2], axis=1) < 0.2 * R
    assert away.min() > R * (1.0 - 1e-9)
    assert under.any() and away[under] == pytest.approx(R, rel=0.01)
    assert dent.position[:, 2].min() == pytest.approx(-depth, rel=0.05)


def test_far_from_the_ball_the_surface_is_as_it_was():
    dent = dent_at(0.5 * R)

    away = np.linalg.norm(dent.position[:, :2] - [0.043, 0.038], axis=1)
    assert (away > REACH * R).any()
    assert np.all(dent.position[away > REACH * R, 2] == 0.0)
    assert dent.normal[away > (REACH + 0.1) * R] == pytest.approx(
        np.tile([0.0, 0.0, 1.0], (int((away > (REACH + 0.1) * R).sum()), 1))
    )


def test_around_the_ball_it_sinks_as_a_half_space_beside_a_sphere():
    # [Johnson85]: a quarter of the radius of contact farther out, and 4/(3 pi rho) far away
    assert run_out(np.array([1.0])) == pytest.approx(1.0)
    far = np.array([20.0])
    assert run_out(far) == pytest.approx(8.0 / (3.0 * np.pi * far), rel=1e-3)
    dent = dent_at(0.02 * R)
    away = np.linalg.norm(dent.position[:, :2] - [0.043, 0.038], axis=1)
    beside = (away > 0.9 * R) & (away < 1.1 * R)
    touched = R * np.sqrt(0.02 / 1.02)
    expected = -0.01 * R * run_out(away[beside] / touched)
    assert dent.position[beside, 2] == pytest.approx(expected, rel=0.05)


def test_normals_are_those_of_what_is_drawn():
    dent = dent_at(0.5 * R)

    a, b, c = (dent.position[dent.triangles[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    mean = dent.normal[dent.triangles].mean(axis=1)
    middle = (a + b + c) / 3.0 - [0.043, 0.038, 0.0]
    # off the rim of what is touched, where the surface bends within one piece
    smooth = np.abs(np.linalg.norm(middle[:, :2], axis=1) - R * np.sqrt(1 / 3)) > 0.35 * R
    cosine = np.einsum("ij,ij->i", across, mean)[smooth]
    assert cosine.min() > 0.95 and np.median(cosine) > 0.999


def test_what_does_not_touch_makes_no_dent():
    vertices, normals, triangles = plane()
    for height in (1.001 * R, 3.0 * R):
        assert make(vertices, normals, triangles, [0.04, 0.04, height], R) is None
    assert dent_at(5.0 * R) is None
    # beyond the edge of all
    assert make(vertices, normals, triangles, [0.2, 0.2, 0.0], R) is None


def test_a_dent_stays_on_its_side_of_a_thin_body():
    body = ellipsoid((0.03, 0.02, 0.008), 3)
    x, faces = np.asarray(body.vertices), np.asarray(body.triangles)
    normals = np.asarray(palpate.compute_vertex_normals(x, faces))
    top = int(np.argmax(x[:, 2]))
    radius = 0.2 * float(np.ptp(x[:, 2]))
    centre = x[top] + np.array([0.0, 0.0, 0.6 * radius])

    dent = make(x, normals, faces, centre, radius)

    assert np.all(normals[faces[dent.hidden]].mean(axis=1)[:, 2] > 0.0)


def test_pieces_are_no_more_than_can_be_drawn():
    vertices, normals, triangles = plane(60)
    dent = make(vertices, normals, triangles, [0.3, 0.3, 0.019], 0.02)
    assert len(dent.position) <= MOST_POINTS
    tiny = make(vertices, normals, triangles, [0.3, 0.3, 1e-4], 2e-4)
    assert len(tiny.position) <= MOST_POINTS


@pytest.mark.parametrize("pieces", [1, 2, 7])
def test_a_triangle_is_cut_into_the_square_of_its_pieces(pieces):
    weights, rows = cut_triangle(pieces)

    assert len(rows) == pieces**2 and weights.sum(axis=1) == pytest.approx(1.0)
    assert sorted(np.unique(rows)) == list(range(len(weights)))


def test_the_surface_is_whole_again_when_the_ball_has_gone():
    vertices, normals, triangles = plane()
    surface = Thing(len(vertices), triangles, PLAIN)
    surface.write("position", vertices)
    surface.write("normal", normals)
    surface.write("value", vertices[:, 0])
    drawn = DrawnDent()
    drawn.take_surface(vertices, triangles)

    assert drawn.show(surface, vertices, triangles, ([0.043, 0.038, 0.5 * R], R))
    gone = np.flatnonzero(surface.triangles[:, 0] == surface.triangles[:, 1])
    assert 0 < len(gone) < len(triangles) and drawn.thing.visible
    # pieces have what their triangles have
    used = np.unique(drawn.thing.triangles)
    streams = drawn.thing.streams
    assert streams["value"][used] == pytest.approx(streams["position"][used, 0], abs=1e-6)

    assert not drawn.show(surface, vertices, triangles, ([0.043, 0.038, 2.0 * R], R))
    assert np.array_equal(surface.triangles, triangles) and not drawn.thing.visible
