# SPDX-License-Identifier: GPL-3.0-or-later
"""Decimation gives the asked count, good triangles, and the same organ."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor.authoring import decimate, import_mesh, inspect_mesh
from palpate_editor.check import assess
from palpate_editor.compile import surface_of
from palpate_editor.document import EMPTY
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import DecimateTo, EditError, decimate_organ, decimate_within
from palpate_meshes.generate import ellipsoid, sheet, tube

GOOD_ANGLE = 25.0


def mesh_of(made: tuple[np.ndarray, np.ndarray]) -> palpate.SurfaceMesh:
    return palpate.SurfaceMesh(*made)


@pytest.fixture(scope="module")
def spleen() -> palpate.SurfaceMesh:
    return mesh_of(ellipsoid(2400))


@pytest.fixture(scope="module")
def gallbladder() -> palpate.SurfaceMesh:
    return mesh_of(tube(2400))


@pytest.fixture(scope="module")
def flat_sheet() -> palpate.SurfaceMesh:
    return mesh_of(sheet(1200))


def border_of(mesh: palpate.SurfaceMesh) -> np.ndarray:
    (loop,) = palpate.find_border_loops(mesh.triangles)
    return np.asarray(mesh.vertices)[loop]


def distance_to_line(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    """[m] From each point to a closed line."""
    a, along = line, np.roll(line, -1, axis=0) - line
    s = ((points[:, None] - a) * along).sum(axis=2) / (along**2).sum(axis=1)
    nearest = a + np.clip(s, 0.0, 1.0)[:, :, None] * along
    return np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1)


@pytest.mark.parametrize("vertices", [50, 151, 600, 1200, 2399, 2400])
def test_a_closed_organ_has_exactly_the_asked_count_and_stays_closed(vertices, spleen):
    small = decimate(spleen, vertices)

    report = inspect_mesh(small.mesh)
    assert (report.vertices, report.triangles) == (vertices, 2 * vertices - 4)
    assert (report.closed, report.outward, report.genus) == (True, True, 0)
    assert report.self_intersecting_faces == small.self_intersecting_faces == 0
    assert report.smallest_angle_deg == pytest.approx(small.smallest_angle_deg)
    assert small.smallest_angle_deg >= GOOD_ANGLE


@pytest.mark.parametrize("vertices", [100, 600])
def test_a_hole_stays_a_hole_on_the_line_it_was(vertices, gallbladder):
    small = decimate(gallbladder, vertices)

    report = inspect_mesh(small.mesh)
    (border,) = report.border_loops
    assert (report.vertices, report.triangles) == (vertices, 2 * vertices - 2 - border)
    assert border >= 6
    assert small.smallest_angle_deg >= GOOD_ANGLE
    assert distance_to_line(border_of(small.mesh), border_of(gallbladder)).max() < 1e-9


def test_a_sheet_keeps_its_outline(flat_sheet):
    small = decimate(flat_sheet, 200)

    assert distance_to_line(border_of(small.mesh), border_of(flat_sheet)).max() < 1e-9
    assert palpate.compute_area(small.mesh) == pytest.approx(
        palpate.compute_area(flat_sheet), rel=0.01
    )
    size = np.ptp(np.asarray(small.mesh.vertices), axis=0)
    assert size[:2] == pytest.approx([0.072, 0.060], rel=0.02)


def test_the_new_surface_lies_on_the_old_one(spleen):
    small = decimate(spleen, 600)

    # an edge is 6 mm long, and its arc of radius 25 mm stands 0.2 mm above it
    assert small.mean_distance < 0.3e-3
    assert small.mean_distance < small.max_distance < 2.5e-3
    volume = palpate.compute_volume(spleen)
    assert palpate.compute_volume(small.mesh) == pytest.approx(volume, rel=0.03)


def scatter(mesh: palpate.SurfaceMesh, count: int) -> np.ndarray:
    """[m] (count, 3) all over a surface."""
    rng = np.random.default_rng(5)
    x, triangles = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)], len(mesh.triangles)
    areas = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1)
    chosen = x[rng.choice(triangles, count, p=areas / areas.sum())]
    r, s = np.sqrt(rng.random(count)), rng.random(count)
    weights = np.stack([1.0 - r, r * (1.0 - s), r * s], axis=1)
    return (chosen * weights[:, :, None]).sum(axis=1)


def find_furthest(one: palpate.SurfaceMesh, other: palpate.SurfaceMesh) -> float:
    """[m] of many points of a surface from another."""
    x = np.asarray(other.vertices)
    tree = palpate.AabbTree(x, np.asarray(other.triangles))
    points = np.concatenate([scatter(one, 8000), one.vertices])
    return max(palpate.find_closest_point(tree, x, point).distance for point in points)


@pytest.mark.parametrize("vertices", [60, 300, 1200])
@pytest.mark.parametrize("name", ["spleen", "gallbladder", "flat_sheet"])
def test_no_point_is_further_than_the_largest_distance_and_some_nearly_are(name, vertices, request):
    source = request.getfixturevalue(name)
    vertices = min(vertices, len(source.vertices) // 2)

    small = decimate(source, vertices)

    found = max(find_furthest(source, small.mesh), find_furthest(small.mesh, source))
    assert found <= small.max_distance * (1.0 + 1e-12)
    assert small.max_distance < 1.3 * found


def test_a_flat_sheet_stays_in_its_plane_and_is_off_at_its_corners_alone():
    column, row = np.meshgrid(np.arange(12.0), np.arange(12.0))
    x = np.stack([column, row, np.zeros_like(row)], axis=2).reshape(-1, 3)
    first = (np.arange(11)[:, None] * 12 + np.arange(11)).ravel()[:, None]
    triangles = np.concatenate([first + [0, 1, 13], first + [0, 13, 12]])
    flat = palpate.SurfaceMesh(x, triangles)

    small = decimate(flat, 100)
    assert small.mean_distance < 1e-12
    # border vertices slide along the border, and a corner may be cut off
    away = [distance_to_line(np.array([x]), border_of(small.mesh))[0] for x in border_of(flat)]
    assert small.max_distance == pytest.approx(max(away), rel=0.011)


def test_improving_makes_bad_triangles_good(spleen):
    small = decimate(spleen, 600)

    assert small.smallest_angle_before_deg < 15.0 < GOOD_ANGLE <= small.smallest_angle_deg


def test_the_same_mesh_gives_the_same_bits(spleen):
    one, other = decimate(spleen, 300), decimate(spleen, 300)

    assert np.array_equal(one.mesh.vertices, other.mesh.vertices)
    assert np.array_equal(one.mesh.triangles, other.mesh.triangles)


def test_two_shells_stay_two():
    vertices, triangles = ellipsoid(600)
    both = palpate.SurfaceMesh(
        np.concatenate([vertices, vertices + [0.2, 0.0, 0.0]]),
        np.concatenate([triangles, triangles + 600]),
    )

    report = inspect_mesh(decimate(both, 300).mesh)

    assert (report.vertices, report.shells, report.closed) == (300, 2, True)


def test_a_count_that_cannot_be_reached_is_refused_with_how_far_it_goes():
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    two = palpate.SurfaceMesh(
        np.concatenate([corners, corners + 5.0]), np.concatenate([faces, faces + 4])
    )

    with pytest.raises(ValueError, match="at least 8"):
        decimate(two, 5)


@pytest.mark.parametrize("vertices", [-1, 0, 3, 2401])
def test_a_count_the_mesh_does_not_have_is_refused(vertices, spleen):
    with pytest.raises(ValueError, match="4 to 2400"):
        decimate(spleen, vertices)


def test_a_mesh_that_is_not_valid_is_refused():
    fin = palpate.SurfaceMesh(
        np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]]),
        np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]]),
    )

    with pytest.raises(ValueError, match="triangle 2"):
        decimate(fin, 4)


@pytest.mark.parametrize("vertices", [150, 600, 1000])
def test_a_real_spleen_comes_out_clean(vertices, shared_data):
    organ = import_mesh(shared_data("organs/VH_F_Spleen.glb"))

    small = decimate(organ.mesh, vertices)

    report = inspect_mesh(small.mesh)
    assert (report.vertices, report.triangles) == (vertices, 2 * vertices - 4)
    assert (report.closed, report.self_intersecting_faces) == (True, 0)
    assert report.smallest_angle_deg >= GOOD_ANGLE


@pytest.mark.parametrize("vertices", [300, 600, 1000])
def test_a_real_pancreas_keeps_its_one_hole(vertices, shared_data):
    organ = import_mesh(shared_data("organs/VH_F_Pancreas.glb"))

    small = decimate(organ.mesh, vertices)

    report = inspect_mesh(small.mesh)
    (border,) = report.border_loops
    assert (report.vertices, report.triangles) == (vertices, 2 * vertices - 2 - border)
    assert 6 <= border <= 16
    assert (report.shells, report.genus, report.self_intersecting_faces) == (1, 0, 0)
    assert report.smallest_angle_deg >= GOOD_ANGLE


# ---------------------------------------------------------------- to an error


@pytest.fixture(scope="module")
def organ(spleen):
    surface = surface_of(spleen)
    return replace(EMPTY.with_surface(surface), imported=surface)


@pytest.mark.landing
@pytest.mark.parametrize("error", [0.5e-3, 2e-3])
def test_as_few_vertices_as_an_error_allows(organ, error):
    edit = decimate_within(organ, error)

    count = edit.decimation.vertices
    assert edit.decimation.max_distance <= error
    assert decimate_organ(organ, round(0.8 * count)).decimation.max_distance > error
    assert edit.repeat == DecimateTo(count, error)
    assert np.array_equal(edit.repeat(organ).surface.vertices, edit(organ).surface.vertices)


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        (0.0, "more than 0 mm, got 0"),
        (float("nan"), "more than 0 mm, got nan"),
        (1e-7, "No coarser surface is within 0.0001 mm"),
    ],
)
def test_an_error_that_cannot_be_kept_is_refused(organ, error, sentence):
    with pytest.raises(EditError, match=sentence):
        decimate_within(organ, error)


def test_a_count_that_does_not_keep_its_error_is_refused(organ):
    with pytest.raises(EditError, match="100 vertices are .* mm from the source, not within 0.1"):
        DecimateTo(100, 1e-4)(organ)


def test_the_verb_keeps_an_error_and_its_line_says_so(tmp_path, capsys, organ):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, organ)

    words = ["decimate", str(path), "--error", "1mm", "--no-felt", "-o", str(out)]
    assert main([*words, "--json"]) == 0

    report = json.loads(capsys.readouterr().out)
    assert report["max_distance_mm"] <= 1.0 and report["vertices"] < 1200
    (line,) = read_organ(out).history.lines
    assert line.values == {"vertices": report["vertices"], "error": 1e-3, "features": True}
    assert main(["rebuild", str(out)]) == 0
    assert f"Decimate to {report['vertices']} vertices, within 1 mm" in capsys.readouterr().out


def test_a_surface_that_is_far_from_its_source_is_told(organ):
    coarse = DecimateTo(30)(organ)

    problems = {problem.key: problem for problem in assess(coarse).problems}

    assert "mm from the source" in str(problems["far"].got)
    assert "keep more vertices" in str(problems["far"].expected)
    assert "far" not in {problem.key for problem in assess(DecimateTo(600)(organ)).problems}
