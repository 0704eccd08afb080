# SPDX-License-Identifier: BSD-3-Clause
"""Generated organs: exact counts, sound surfaces, well-shaped triangles, the same every time."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.scene.mesh_file import read_mesh_file
from palpate_meshes.generate import ellipsoid, sheet, tube, write_obj
from palpate_meshes.generate.field import draw_spline, rod, tube_field
from palpate_meshes.generate.relax import compute_angles

SMALLEST_ANGLE = 20.0
"""[degree] Well above the 15 below which a model gets stiff needles."""

ORGANS = {"ellipsoid": ellipsoid, "sheet": sheet, "tube": tube}


def surface(name: str, **parameters: object) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(*ORGANS[name](**parameters))


@pytest.mark.parametrize("name", ORGANS)
@pytest.mark.parametrize(
    "vertices", [150, 300, *(pytest.param(n, marks=pytest.mark.verify) for n in (600, 2000))]
)
def test_an_organ_has_exactly_the_vertices_asked_for_and_is_sound(name, vertices):
    mesh = surface(name, vertices=vertices)

    palpate.validate(mesh)
    assert len(mesh.vertices) == vertices
    assert palpate.count_non_manifold_edges(mesh.triangles) == 0
    angles = np.degrees(compute_angles(np.asarray(mesh.vertices), np.asarray(mesh.triangles)))
    assert angles.min() > SMALLEST_ANGLE


def test_the_ellipsoid_is_closed_turned_outward_and_as_large_as_a_spleen():
    mesh = surface("ellipsoid", vertices=600)

    assert len(mesh.triangles) == 1196
    assert palpate.is_closed(mesh.triangles)
    assert palpate.compute_euler_number(mesh.triangles) == 2
    assert 100e-6 < palpate.compute_volume(mesh) < 350e-6  # 191 to 344 ml in large real ones


def test_the_tube_has_one_border_loop_of_the_count_asked_for():
    mesh = surface("tube", vertices=600, border=12)

    loops = palpate.find_border_loops(mesh.triangles)
    assert [len(loop) for loop in loops] == [12]
    assert len(mesh.triangles) == 2 * 600 - 2 - 12


def test_the_sheet_faces_up_and_has_one_border_loop():
    mesh = surface("sheet", vertices=200)

    normals = np.asarray(palpate.compute_vertex_normals(mesh.vertices, mesh.triangles))
    assert np.all(normals[:, 2] > 0.9)
    assert len(palpate.find_border_loops(mesh.triangles)) == 1


@pytest.mark.parametrize("name", ORGANS)
def test_the_same_seed_gives_the_same_bits_and_another_seed_another_mesh(name):
    one, again = ORGANS[name](vertices=120, seed=3), ORGANS[name](vertices=120, seed=3)
    other = ORGANS[name](vertices=120, seed=4)

    assert all(np.array_equal(a, b) for a, b in zip(one, again, strict=True))
    assert not np.array_equal(one[0], other[0])


@pytest.mark.parametrize("name", ORGANS)
def test_too_few_vertices_are_refused_with_the_least_there_may_be(name):
    with pytest.raises(ValueError, match="at least"):
        ORGANS[name](vertices=5)


def test_a_written_organ_is_read_back_to_the_same_bits(tmp_path):
    vertices, triangles = tube(vertices=200)

    write_obj(tmp_path / "tube.obj", vertices, triangles)

    mesh = read_mesh_file(tmp_path / "tube.obj")
    assert np.array_equal(np.asarray(mesh.vertices), vertices)
    assert np.array_equal(np.asarray(mesh.triangles), triangles)


def test_a_rod_is_as_far_as_its_axis_less_its_radius_there():
    points = np.array([[5.0, 3.0, 0.0], [-4.0, 0.0, 3.0], [13.0, 0.0, 4.0]])

    found = rod(points, (0.0, 0.0, 0.0), (10.0, 0.0, 0.0), 1.0, 2.0)

    # beside its middle, where it is 1.5 wide; before its first end; behind its last
    assert found.tolist() == [3.0 - 1.5, 5.0 - 1.0, 5.0 - 2.0]


def test_what_a_tube_leaves_out_changes_no_bit_of_its_field():
    nodes = tuple((9.0 * k, 4.0 * (-1.0) ** k, 0.3 * k * k, 2.0 + 0.1 * k) for k in range(7))
    points = np.random.default_rng(5).uniform(-20.0, 60.0, (400, 3))

    spine = draw_spline(nodes, 6)
    each = [rod(points, a[:3], b[:3], a[3], b[3]) for a, b in zip(spine, spine[1:], strict=False)]
    assert tube_field(points, nodes, 6).tobytes() == np.min(each, axis=0).tobytes()
