# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with a surface is counted rightly, and what can be repaired is."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from foreign_files import write_obj
from palpate_editor.authoring import (
    find_self_intersecting_faces,
    import_mesh,
    inspect_mesh,
    repair_mesh,
)
from palpate_meshes.generate import ellipsoid, sheet, tube
from small_meshes import CORNERS, CUBE, inside_out, mesh_of, scaled, together


def torus(n: int = 12, m: int = 8) -> palpate.SurfaceMesh:
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    r = 3.0 + np.cos(b)
    points = np.stack([r * np.cos(a), r * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)
    at = np.arange(n * m).reshape(n, m)
    right, up = np.roll(at, -1, axis=0), np.roll(at, -1, axis=1)
    both = np.roll(right, -1, axis=1)
    quads = np.stack([at, right, both, up], axis=-1).reshape(-1, 4)
    return mesh_of(0.01 * points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]))


def moebius(n: int = 12) -> palpate.SurfaceMesh:
    angle = 2 * np.pi * np.arange(n) / n
    points = []
    for a in angle:
        for side in (-0.3, 0.3):
            r = 1.0 + side * np.cos(0.5 * a)
            points.append((r * np.cos(a), r * np.sin(a), side * np.sin(0.5 * a)))
    triangles = []
    for k in range(n):
        i, j = 2 * k, 2 * k + 1
        p, q = (2 * k + 2, 2 * k + 3) if k < n - 1 else (1, 0)
        triangles += [(i, p, j), (j, p, q)]
    return mesh_of(0.05 * np.array(points), triangles)


def test_the_report_of_a_cube_is_what_a_ruler_says():
    report = inspect_mesh(mesh_of(CORNERS, CUBE)).as_dict()

    lengths = report.pop("edge_lengths_mm")
    assert report.pop("angles_deg") == {
        "limits": pytest.approx([10.0 * i for i in range(19)]),
        "counts": [0, 0, 0, 0, 24, 0, 0, 0, 0, 12, *[0] * 8],
    }
    # twelve edges of a centimetre, and the six diagonals
    assert (lengths["counts"][0], lengths["counts"][-1], sum(lengths["counts"])) == (12, 6, 18)
    assert lengths["limits"][0] == pytest.approx(10.0)
    assert lengths["limits"][-1] == pytest.approx(200.0**0.5)
    assert report == {
        "vertices": 8,
        "triangles": 12,
        "shells": 1,
        "euler_number": 2,
        "border_loops": [],
        "border_lengths_mm": [],
        "genus": 0,
        "closed": True,
        "outward": True,
        "non_manifold_edges": 0,
        "non_manifold_vertices": 0,
        "disagreeing_edges": 0,
        "coincident_vertices": 0,
        "duplicate_triangles": 0,
        "degenerate_triangles": 0,
        "self_intersecting_faces": 0,
        "orientable": True,
        "smallest_angle_deg": pytest.approx(45.0),
        "edges_mm": pytest.approx([10.0, 10.0, 200.0**0.5]),
        "thinnest_mm": pytest.approx(10.0),
        "thin_triangles": 0,
        "thickness_looks": 12,
        "size_mm": pytest.approx([10.0, 10.0, 10.0]),
        "volume_ml": pytest.approx(1.0),
    }


def test_a_torus_has_one_handle_and_two_of_them_have_two():
    ring = torus()

    assert inspect_mesh(ring).genus == 1
    both = inspect_mesh(together(ring, mesh_of(np.asarray(ring.vertices) + 1.0, ring.triangles)))
    assert (both.shells, both.genus) == (2, 2)


@pytest.mark.parametrize("make", [tube, sheet])
def test_an_open_surface_has_no_inside_and_no_volume(make):
    mesh = mesh_of(*make(200))

    report = inspect_mesh(mesh)

    assert report.border_loops == [len(palpate.find_border_loops(mesh.triangles)[0])]
    assert (report.closed, report.outward, report.volume_ml) == (False, None, None)
    assert report.genus == 0


def test_a_soup_has_a_report_without_a_number_json_does_not_know():
    soup = mesh_of(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1], [2, 0, 0]],
        [[0, 1, 2], [0, 1, 3], [1, 0, 4], [0, 1, 5]],
    )

    report = inspect_mesh(soup).as_dict()

    json.dumps(report, allow_nan=False)
    assert report["non_manifold_edges"] == 1
    assert (report["genus"], report["volume_ml"], report["outward"]) == (None, None, None)
    assert report["smallest_angle_deg"] == pytest.approx(0.0, abs=1e-9)


def test_one_sided_surfaces_have_no_genus_and_no_outside():
    report = inspect_mesh(moebius())

    assert (report.genus, report.outward) == (None, None)
    assert len(report.border_loops) == 1
    assert not repair_mesh(moebius()).orientable


def test_an_organ_inside_out_is_turned():
    organ = mesh_of(*ellipsoid(150))
    turned = inside_out(organ)

    repaired = repair_mesh(turned)

    assert inspect_mesh(turned).outward is False
    assert inspect_mesh(turned).volume_ml == pytest.approx(inspect_mesh(organ).volume_ml)
    assert repaired.turned_triangles == 296
    assert palpate.compute_volume(repaired.mesh) == pytest.approx(palpate.compute_volume(organ))


@pytest.mark.parametrize("seed", range(3))
def test_shuffled_winding_is_made_to_agree(seed):
    vertices, triangles = ellipsoid(150)
    shuffled = triangles.copy()
    flipped = np.random.default_rng(seed).random(len(triangles)) < 0.4
    shuffled[flipped] = shuffled[flipped][:, [0, 2, 1]]

    repaired = repair_mesh(mesh_of(vertices, shuffled))

    palpate.validate(repaired.mesh)
    assert repaired.turned_triangles == flipped.sum()
    assert palpate.compute_volume(repaired.mesh) > 0.0
    assert inspect_mesh(mesh_of(vertices, shuffled)).outward is False


def test_an_open_organ_is_turned_hollow_side_in():
    organ = mesh_of(*tube(200))

    repaired = repair_mesh(inside_out(organ))

    assert repaired.turned_triangles == len(organ.triangles)
    assert repair_mesh(organ).turned_triangles == 0


def test_a_flat_sheet_stays_as_it_lies():
    organ = mesh_of(*sheet(200, dome=0.0))

    assert repair_mesh(organ).turned_triangles == 0
    assert repair_mesh(inside_out(organ)).turned_triangles == 0


def test_the_wall_of_a_cavity_faces_inwards_before_and_after():
    organ = mesh_of(*ellipsoid(150, hollow=0.0, bow=0.0))
    hollow = together(organ, inside_out(scaled(organ, 0.5)))

    assert inspect_mesh(hollow).outward is True
    assert repair_mesh(hollow).turned_triangles == 0
    # all turned inside out, they turn back together
    again = repair_mesh(inside_out(hollow)).mesh
    assert palpate.compute_volume(again) == pytest.approx(palpate.compute_volume(hollow))


def test_shells_beside_each_other_are_each_turned_outwards():
    cube = mesh_of(CORNERS, CUBE)
    aside = inside_out(mesh_of(CORNERS + 0.05, CUBE))

    assert inspect_mesh(together(cube, aside)).outward is False
    repaired = repair_mesh(together(cube, aside))
    assert repaired.turned_triangles == 12
    assert palpate.compute_volume(repaired.mesh) == pytest.approx(2e-6)


def test_double_triangles_and_unused_vertices_are_dropped():
    vertices = np.concatenate([CORNERS, [[0.02, 0.0, 0.0]]])
    triangles = np.concatenate([CUBE, CUBE[3:5], CUBE[:1, [0, 2, 1]]])

    repaired = repair_mesh(mesh_of(vertices, triangles))

    assert repaired.duplicate_triangles == 3
    assert repaired.unused_vertices == 1
    assert inspect_mesh(repaired.mesh).closed
    assert len(repaired.mesh.triangles) == 12


def test_a_flat_triangle_is_flipped_away_and_no_hole_is_left():
    # vertex 8 lies in the middle of the edge 0-1, which only one of its two triangles knows
    vertices = np.concatenate([CORNERS, [0.5 * (CORNERS[0] + CORNERS[1])]])
    triangles = np.concatenate([CUBE[1:4], CUBE[4:], [[0, 2, 8], [8, 2, 1], [0, 8, 1]]])
    mesh = mesh_of(vertices, triangles)
    assert inspect_mesh(mesh).smallest_angle_deg == pytest.approx(0.0, abs=1e-6)

    repaired = repair_mesh(mesh)

    assert repaired.degenerate_triangles == 1
    assert len(repaired.mesh.triangles) == 14
    palpate.validate(repaired.mesh)
    report = inspect_mesh(repaired.mesh)
    assert (report.closed, report.outward) == (True, True)
    # the corner between two diagonals to the middle of an edge: atan(1/3)
    assert report.smallest_angle_deg == pytest.approx(18.435, abs=1e-3)


def test_surfaces_that_touch_in_a_vertex_are_taken_apart_there():
    far = 2 * CORNERS[7] - CORNERS
    mesh = mesh_of(
        np.concatenate([CORNERS, far[:7]]),
        np.concatenate([CUBE, np.where(CUBE == 7, 7 - 8, CUBE)[:, ::-1] + 8]),
    )
    assert inspect_mesh(mesh).genus is None

    repaired = repair_mesh(mesh)

    assert repaired.split_vertices == 1
    report = inspect_mesh(repaired.mesh)
    assert (report.vertices, report.shells, report.genus) == (16, 2, 0)
    assert report.volume_ml == pytest.approx(2.0)


def crossing(name: str) -> tuple[list, list]:
    flat = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    return {
        "apart": (flat + [[0, 0, 1], [1, 0, 1], [0, 1, 1]], [[0, 1, 2], [3, 4, 5]]),
        "through": (flat + [[0.2, 0.2, -1], [0.3, 0.2, 1], [0.2, 0.3, 1]], [[0, 1, 2], [3, 4, 5]]),
        "neighbours": (flat + [[1, 1, 0.3]], [[0, 1, 2], [1, 3, 2]]),
        "flat neighbours": (flat + [[1, 1, 0]], [[0, 1, 2], [1, 3, 2]]),
        "folded over": (flat + [[0.2, 0.2, 0]], [[0, 1, 2], [1, 3, 2]]),
        "one corner": (flat + [[-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 3, 4]]),
        "one corner, through": (flat + [[0.5, 0.2, -1], [0.5, 0.2, 1]], [[0, 1, 2], [0, 3, 4]]),
        "twice": (flat, [[0, 1, 2], [0, 2, 1]]),
        "in one plane": (flat + [[0.1, 0.1, 0], [2, 0.1, 0], [0.1, 2, 0]], [[0, 1, 2], [3, 4, 5]]),
    }[name]


@pytest.mark.parametrize(
    ("name", "faces"),
    [
        ("apart", []),
        ("through", [0, 1]),
        ("neighbours", []),
        ("flat neighbours", []),
        ("folded over", [0, 1]),
        ("one corner", []),
        ("one corner, through", [0, 1]),
        ("twice", [0, 1]),
        ("in one plane", [0, 1]),
    ],
)
def test_faces_that_cross_are_found_and_neighbours_are_not(name, faces):
    assert find_self_intersecting_faces(mesh_of(*crossing(name))) == faces


def test_two_spheres_through_each_other_cross_where_their_surfaces_do():
    ball = mesh_of(*ellipsoid(600, radii=(0.02, 0.02, 0.02), bow=0, hollow=0, notches=0))
    aside = mesh_of(np.asarray(ball.vertices) + [0.02, 0.001, 0.002], ball.triangles)
    both = together(ball, aside)

    faces = find_self_intersecting_faces(both)

    middles = np.asarray(both.vertices)[np.asarray(both.triangles)[faces]].mean(axis=1)
    # the circle where both meet lies half way; a triangle is 2.6 mm wide
    assert 40 < len(faces) < 200
    assert np.abs(middles[:, 0] - 0.010).max() < 0.004


@pytest.mark.landing
def test_counting_crossings_gives_up_instead_of_taking_for_ever():
    random = np.random.default_rng(1)
    points = random.normal(size=(3 * 8000, 3))
    # all boxes overlap
    points[0::3] = 10.0
    points[1::3] = -10.0
    mesh = mesh_of(points, np.arange(3 * 8000).reshape(-1, 3))

    assert find_self_intersecting_faces(mesh) is None
    assert inspect_mesh(mesh).self_intersecting_faces is None


FIN = mesh_of(
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]], [[0, 1, 2], [0, 1, 3], [1, 0, 4]]
)
"""Three triangles at one edge."""


@pytest.mark.parametrize(
    ("mesh", "crowded", "crossing", "orientable"),
    [
        (moebius(), 0, 0, False),
        (FIN, 1, 0, True),
        (mesh_of(*crossing("through")), 0, 2, True),
    ],
    ids=["moebius", "fin", "crossing"],
)
def test_what_can_be_drawn_comes_in_with_what_is_wrong_counted(
    mesh, crowded, crossing, orientable, tmp_path
):
    path = tmp_path / "organ.obj"
    write_obj(path, np.asarray(mesh.vertices), np.asarray(mesh.triangles))

    organ = import_mesh(path)

    assert len(organ.mesh.triangles) == len(mesh.triangles)
    found = organ.report
    assert (found.non_manifold_edges, found.self_intersecting_faces) == (crowded, crossing)
    assert found.orientable == orientable
    assert len(found.crossing_faces) == crossing


def test_what_has_no_area_at_all_is_refused(tmp_path):
    path = tmp_path / "organ.obj"
    write_obj(path, np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]]))

    with pytest.raises(palpate.FileError, match="no triangle that has an area") as refusal:
        import_mesh(path)

    assert refusal.value.file == str(path)
