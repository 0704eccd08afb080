# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces, models and queries as Python calls them, with numbers the reader can check."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from surfaces import MEMBRANE, ellipsoid, sheet, tube

TETRAHEDRON = palpate.SurfaceMesh(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
)


def test_the_corner_of_a_cube_has_a_sixth_of_its_volume():
    palpate.validate(TETRAHEDRON)

    assert palpate.compute_volume(TETRAHEDRON) == pytest.approx(1 / 6)
    assert palpate.compute_area(TETRAHEDRON) == pytest.approx(1.5 + 3**0.5 / 2)
    assert palpate.compute_vertex_areas(TETRAHEDRON).sum() == pytest.approx(1.5 + 3**0.5 / 2)
    assert palpate.compute_smallest_angle(TETRAHEDRON) == pytest.approx(np.pi / 4)
    low, high = palpate.compute_bounds(TETRAHEDRON.vertices)
    assert low.tolist() == [0, 0, 0]
    assert high.tolist() == [1, 1, 1]
    assert palpate.compute_diagonal(TETRAHEDRON.vertices) == pytest.approx(3**0.5)


def test_a_tetrahedron_is_closed_and_has_six_edges():
    t = TETRAHEDRON.triangles

    assert palpate.is_closed(t)
    assert palpate.compute_euler_number(t) == 2
    assert palpate.build_topology(t).edges.tolist() == [
        [0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]  # fmt: skip
    assert palpate.count_non_manifold_edges(t) == 0
    assert palpate.find_border_loops(t) == []
    assert palpate.find_shells(4, t).tolist() == [0, 0, 0, 0]


def test_a_tube_has_two_border_loops():
    loops = palpate.find_border_loops(tube(0.01, 0.05, 8, 5).triangles)

    assert sorted(set(loop.tolist()) == set(range(8)) for loop in loops) == [False, True]
    assert [len(loop) for loop in loops] == [8, 8]


def test_normals_of_a_sheet_point_up():
    mesh = sheet(4, 0.03)

    normals = palpate.compute_vertex_normals(mesh.vertices, mesh.triangles)

    assert normals == pytest.approx(np.tile([0.0, 0.0, 1.0], (16, 1)))


def test_the_mass_of_a_hollow_organ_is_density_thickness_area():
    mesh = ellipsoid((0.03, 0.025, 0.02), 2)

    model = palpate.build_mass_spring(mesh, MEMBRANE, 50.0)

    expected = 1060.0 * 2e-3 * palpate.compute_area(mesh)
    assert palpate.compute_total_mass(model) == pytest.approx(expected)
    assert palpate.compute_lumped_mass(mesh, MEMBRANE).sum() == pytest.approx(expected)
    assert palpate.particle_count(model) == len(mesh.vertices)
    assert (model.springs.stiffness == 50.0).all()
    assert len(model.springs.ends) == len(palpate.build_topology(mesh.triangles).edges)


def test_a_molecular_model_has_bonds_and_angles_where_the_other_has_springs():
    mesh = ellipsoid((0.03, 0.025, 0.02), 1)
    constants = palpate.MolecularConstants(bond_stiffness=50.0, bend_stiffness=2e-5)

    model = palpate.build_molecular(mesh, MEMBRANE, constants)

    assert len(model.springs.ends) == 0
    assert len(model.bonds.ends) == 120
    assert model.angles.corners.shape == (80, 3)
    assert (model.angles.bend_stiffness == 2e-5).all()


def test_constants_that_make_a_triangle_give_way_are_refused():
    mesh = ellipsoid((0.03, 0.025, 0.02), 1)
    constants = palpate.MolecularConstants(bond_stiffness=50.0, stretch_coupling=-5.0)

    with pytest.raises(ValueError, match="K_btheta -5 N"):
        palpate.build_molecular(mesh, MEMBRANE, constants)


def test_the_closest_point_is_the_nearest_of_all_triangles():
    mesh = ellipsoid((0.03, 0.025, 0.02), 2)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)
    generator = np.random.default_rng(3)

    for p in generator.uniform(-0.05, 0.05, (50, 3)):
        found = palpate.find_closest_point(tree, mesh.vertices, p)
        each = [
            palpate.find_closest_on_triangle(p, *mesh.vertices[t]).distance for t in mesh.triangles
        ]
        assert found.distance == min(each)
        assert found.triangle == int(np.argmin(each))
        corners = mesh.vertices[mesh.triangles[found.triangle]]
        assert found.weights @ corners == pytest.approx(found.point)


def test_a_way_that_crosses_finds_where_and_one_that_does_not_finds_nothing():
    mesh = sheet(4, 0.03)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)
    x = mesh.vertices

    hit = palpate.find_segment_hit(tree, x, (0.012, 0.013, 0.02), (0.012, 0.013, -0.02))
    ray = palpate.find_ray_hit(tree, x, (0.012, 0.013, 0.02), (0, 0, -5))

    assert hit.point == pytest.approx([0.012, 0.013, 0.0])
    assert hit.distance == pytest.approx(0.02)
    assert ray.triangle == hit.triangle
    assert palpate.find_segment_hit(tree, x, (0.012, 0.013, 0.02), (0.012, 0.013, 0.001)) is None
    assert palpate.find_ray_hit(tree, x, (0.012, 0.013, 0.02), (0, 0, 1)) is None
    assert palpate.find_closest_point(tree, x, (0.0, 0.0, 0.5), max_distance=0.1) is None


def test_a_ball_finds_its_triangles_in_ascending_order():
    mesh = sheet(5, 0.04)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)
    out = np.full(len(mesh.triangles), -1, dtype=np.int32)

    count = palpate.find_in_sphere(tree, mesh.vertices, (0.0, 0.0, 0.0), 0.004, out)
    near = palpate.find_near_segment(
        tree, mesh.vertices, (0.0, 0.0, 0.0), (0.04, 0.0, 0.0), 0.001, out[:2]
    )

    # the corner of the sheet belongs to its first two triangles
    assert count == 2
    assert near >= 5
    assert out[0] == 0
    assert out[1] == 1


def test_the_tree_follows_the_surface():
    mesh = sheet(4, 0.03)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)
    moved = mesh.vertices + (0.0, 0.0, 0.1)

    tree.refit(moved)

    assert palpate.find_closest_point(tree, moved, (0.01, 0.01, 0.11)).distance == pytest.approx(
        0.01
    )
    assert tree.low() == pytest.approx([0.0, 0.0, 0.1])
    assert tree.nodes()["low"][0].min(axis=1) == pytest.approx([0.0, 0.0, 0.1])


def test_a_query_of_one_triangle_visits_a_node_and_a_leaf():
    tree = palpate.AabbTree([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])

    assert palpate.compute_query_cost(tree) == pytest.approx(2.0)


def test_inside_and_outside_are_told_by_the_winding_number():
    mesh = ellipsoid((0.03, 0.025, 0.02), 2)

    inside = palpate.compute_winding_number(mesh.triangles, mesh.vertices, (0.0, 0.0, 0.0))
    outside = palpate.compute_winding_number(mesh.triangles, mesh.vertices, (0.0, 0.0, 0.1))

    assert inside == pytest.approx(1.0)
    assert outside == pytest.approx(0.0, abs=1e-12)
