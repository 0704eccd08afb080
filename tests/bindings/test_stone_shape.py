# SPDX-License-Identifier: BSD-3-Clause
"""What a stone of a mesh weighs, how it turns, and the spheres by which it touches."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.layout.document import PlacedStone
from palpate.layout.gaps import Surface
from palpate.layout.hard_parts import build_stone
from palpate.layout.stone import FEWEST, MOST, fit_hull, measure_mass
from scipy.spatial.transform import Rotation
from stones import HALF, make_stone_mesh, make_table


def test_mass_and_inertia_of_an_ellipsoid_are_those_of_the_books():
    turn = Rotation.from_rotvec((0.3, -0.8, 0.5)).as_matrix()
    mesh = make_stone_mesh(1e-3, 3)
    moved = np.asarray(mesh.vertices) @ turn.T + (0.1, 0.2, 0.3)
    still, turned = measure_mass(mesh), measure_mass(palpate.SurfaceMesh(moved, mesh.triangles))

    # I = m/5 (b² + c²), ascending; a mesh of chords is a little smaller
    square = (1e-3 * HALF) ** 2
    by_hand = still.volume / 5.0 * (square.sum() - square)
    assert still.volume == pytest.approx(4.0 / 3.0 * np.pi * 1e-9 * HALF.prod(), rel=0.03)
    assert still.inertia == pytest.approx(by_hand, rel=0.03)
    assert turned.volume == pytest.approx(still.volume, rel=1e-9)
    assert turned.inertia == pytest.approx(still.inertia, rel=1e-9)
    assert turned.centre - (0.1, 0.2, 0.3) == pytest.approx(turn @ still.centre, abs=1e-12)
    assert np.abs(turned.axes.T @ turn @ still.axes) == pytest.approx(np.eye(3), abs=1e-6)


def test_the_inertia_of_a_box_is_exact():
    box = measure_mass(make_table(0.05))
    sides = np.array([0.1, 0.1, 0.01])
    assert box.volume == pytest.approx(sides.prod())
    by_hand = box.volume / 12.0 * ((sides**2).sum() - sides**2)
    assert box.inertia == pytest.approx(np.sort(by_hand))


@pytest.mark.parametrize("count", [FEWEST, 14, MOST])
def test_the_spheres_of_a_hull_lie_in_the_mesh_and_touch_it(count):
    mesh = make_stone_mesh(1e-3)
    hull = fit_hull(mesh, count)

    surface = Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    assert len(np.unique(hull.centres, axis=0)) == count
    for centre, radius in zip(hull.centres, hull.radii, strict=True):
        gap = surface.find_near(centre, 0.0, np.zeros(3))
        assert gap is not None and -gap.size == pytest.approx(radius, rel=1e-9)
    gaps = np.linalg.norm(surface.x[:, None] - hull.centres, axis=2) - hull.radii
    assert gaps.min(axis=1).max() == pytest.approx(hull.deepest)
    assert hull.deepest < 0.12 * 2e-3 * HALF.max()


def test_a_stone_is_the_same_however_it_is_turned_in_its_file():
    turn = Rotation.from_rotvec((0.4, 0.2, -0.9))
    mesh = make_stone_mesh(1e-3)
    x = turn.apply(np.asarray(mesh.vertices)) + (0.02, 0.0, 0.0)
    placed = PlacedStone("stone", "stone.obj", "", position=(0.0, 0.1, 0.0))
    a = build_stone(mesh, placed).body
    b = build_stone(palpate.SurfaceMesh(x, mesh.triangles), placed).body

    for body, points in ((a, np.asarray(mesh.vertices)), (b, x)):
        world = Rotation.from_quat(body.orientation).apply(body.mesh.vertices) + body.position
        assert world == pytest.approx(points + (0.0, 0.1, 0.0), abs=1e-9)
    assert b.mass == pytest.approx(a.mass)
    assert b.inertia == pytest.approx(a.inertia)


def test_a_mesh_inside_out_and_one_without_room_are_refused():
    mesh = make_stone_mesh(1e-3)
    turned = palpate.SurfaceMesh(mesh.vertices, np.asarray(mesh.triangles)[:, ::-1])
    with pytest.raises(ValueError, match="counter-clockwise"):
        measure_mass(turned)
    with pytest.raises(ValueError, match="spheres: got 7, expected 8 to 20"):
        fit_hull(mesh, 7)
    with pytest.raises(ValueError, match="no room for spheres"):
        corners = [(0, 0, 0), (0.01, 0, 0), (0, 0.01, 0), (0.003, 0.003, 1e-6)]
        flat = palpate.SurfaceMesh(corners, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
        fit_hull(flat, 8)
