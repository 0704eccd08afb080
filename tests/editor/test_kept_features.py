# SPDX-License-Identifier: GPL-3.0-or-later
"""Decimation keeps ridges, thin parts, and the borders of what is painted."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate_editor.authoring import decimate, import_mesh, inspect_mesh
from palpate_editor.check import assess
from palpate_editor.compile import mesh_of, surface_of
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import (
    DecimateTo,
    FixVertices,
    PaintStiffness,
    SetRegion,
    decimate_organ,
    write_line,
)
from palpate_editor.edits.carry import number_painted
from palpate_meshes.generate import ellipsoid

BOX = (0.060, 0.048, 0.032)
"""[m]"""
PLATE = (0.100, 0.076, 0.004)
FAR = 0.03
"""[-] of the diagonal, from which a check speaks."""


def make_box(size: tuple[float, float, float], edge: float) -> palpate.SurfaceMesh:
    """A closed box of a grid on every side, triangles counter-clockwise from outside."""
    n = [max(1, round(length / edge)) for length in size]
    index: dict[tuple[int, ...], int] = {}
    triangles: list[tuple[int, int, int]] = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, n[axis]):
            for i in range(n[u]):
                for j in range(n[v]):
                    corners = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        place = [0, 0, 0]
                        place[axis], place[u], place[v] = end, i + a, j + b
                        corners.append(index.setdefault(tuple(place), len(index)))
                    a, b, c, d = corners if end else corners[::-1]
                    triangles += [(a, b, c), (a, c, d)]
    x = np.array([[p * s / k for p, s, k in zip(q, size, n, strict=True)] for q in index])
    return palpate.SurfaceMesh(x, np.array(triangles))


def measure_ridges(size: tuple[float, float, float]) -> float:
    return 4.0 * sum(size)


def find_diagonal(mesh: palpate.SurfaceMesh) -> float:
    return float(palpate.compute_diagonal(np.asarray(mesh.vertices)))


@pytest.mark.parametrize("vertices", [60, 200])
def test_a_box_keeps_its_edges_and_corners(vertices):
    box = make_box(BOX, 2e-3)

    small = decimate(box, vertices, features=True)

    assert len(small.mesh.vertices) == vertices
    assert small.kept_length == pytest.approx(measure_ridges(BOX), rel=1e-12)
    assert small.left_out_length == 0.0
    assert small.max_distance < 2e-5 * find_diagonal(box)
    assert palpate.compute_volume(small.mesh) == pytest.approx(np.prod(BOX), rel=1e-9)
    assert small.smallest_angle_deg > 25.0
    # without, a corner is cut off
    assert decimate(box, vertices).max_distance > 10.0 * small.max_distance


def test_so_few_vertices_that_ridges_have_no_room_are_reached_and_said():
    box = make_box(BOX, 2e-3)

    small = decimate(box, 20, features=True)

    assert len(small.mesh.vertices) == 20
    assert small.kept_length == 0.0
    assert small.left_out_length == pytest.approx(measure_ridges(BOX), rel=1e-12)


def test_a_thin_plate_keeps_its_rim_and_its_volume():
    plate = make_box(PLATE, 2e-3)

    plain, small = decimate(plate, 150), decimate(plate, 150, features=True)

    assert plain.max_distance > FAR * find_diagonal(plate)
    assert small.max_distance < 1e-3 * find_diagonal(plate)
    assert palpate.compute_volume(small.mesh) == pytest.approx(np.prod(PLATE), rel=1e-3)
    assert inspect_mesh(small.mesh).self_intersecting_faces == 0


def test_a_check_speaks_where_a_thin_organ_lost_its_rim():
    """As decimations of before did, which histories repeat."""
    surface = surface_of(make_box(PLATE, 2e-3))
    organ = replace(EMPTY.with_surface(surface), imported=surface)

    lost, kept = (
        {p.key for p in assess(DecimateTo(150, features=on)(organ)).problems}
        for on in (False, True)
    )

    assert "far" in lost and "far" not in kept


def test_a_turned_and_moved_box_keeps_the_same_lengths():
    box = make_box(BOX, 4e-3)
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    moved = palpate.SurfaceMesh(np.asarray(box.vertices) @ turn.T + 0.5, box.triangles)

    small = decimate(moved, 100, features=True)

    assert small.kept_length == pytest.approx(measure_ridges(BOX), rel=1e-9)
    assert small.max_distance < 2e-5 * find_diagonal(box)


def test_regions_want_a_number_for_every_triangle():
    with pytest.raises(ValueError, match="regions: got 3 numbers, expected one for each of 316"):
        decimate(palpate.SurfaceMesh(*ellipsoid(160)), 80, [1, 2, 3])


# ---------------------------------------------------------------- what is painted


@pytest.fixture(scope="module")
def painted() -> Organ:
    """A spleen with a region of its end, another that is stiffer, and a patch that is held."""
    surface = surface_of(palpate.SurfaceMesh(*ellipsoid(2000)))
    organ = replace(EMPTY.with_surface(surface), imported=surface)
    x = surface.vertices
    across = (x - x.min(axis=0)) / np.ptp(x, axis=0)
    organ = SetRegion("end", np.flatnonzero(across[:, 0] > 0.7))(organ)
    organ = PaintStiffness(np.flatnonzero(across[:, 0] < 0.3), 3.0)(organ)
    return FixVertices(np.flatnonzero(across[:, 2] < 0.1))(organ)


def mark(organ: Organ, ids: np.ndarray) -> np.ndarray:
    inside = np.zeros(organ.vertex_count, bool)
    inside[ids] = True
    return inside


def list_painted(organ: Organ) -> list[np.ndarray]:
    return [mark(organ, organ.regions["end"]), organ.stiffness_scale > 2.9, organ.fixed]


def measure_area(organ: Organ, inside: np.ndarray) -> float:
    """[m²] of the triangles that are all within."""
    surface = organ.surface
    assert surface is not None
    whole = surface.triangles[inside[surface.triangles].all(axis=1)]
    return float(palpate.compute_area(palpate.SurfaceMesh(surface.vertices, whole)))


def find_border(organ: Organ, inside: np.ndarray) -> np.ndarray:
    """[m] (n, 3) the vertices on the border of the triangles that are all within."""
    surface = organ.surface
    assert surface is not None
    within = surface.triangles[inside[surface.triangles].all(axis=1)]
    loops = palpate.find_border_loops(within)
    return np.concatenate([surface.vertices[loop] for loop in loops])


@pytest.mark.parametrize("vertices", [600, 1200])
def test_what_is_painted_keeps_its_border_and_its_area(painted, vertices):
    small = DecimateTo(vertices, features=True)(painted)

    for before, after in zip(list_painted(painted), list_painted(small), strict=True):
        assert measure_area(small, after) == pytest.approx(measure_area(painted, before), rel=0.05)
        line = find_border(painted, before)
        away = [distance_to_line(point, line) for point in find_border(small, after)]
        # a triangle outside, all of whose corners are on the border, counts as within
        assert np.quantile(away, 0.8) < 1e-9 and max(away) < 2e-3


def distance_to_line(point: np.ndarray, ends: np.ndarray) -> float:
    """[m] To the nearest edge between two of the vertices of a line that are neighbours on it."""
    a, along = ends, np.roll(ends, -1, axis=0) - ends
    s = np.clip(((point - a) * along).sum(axis=1) / (along**2).sum(axis=1), 0.0, 1.0)
    return float(np.linalg.norm(point - a - s[:, None] * along, axis=1).min())


def test_borders_are_lines_only_where_they_are_asked_for(painted):
    edit, plain = decimate_organ(painted, 300, True), decimate_organ(painted, 300)

    assert edit.kept_length > 0.1 and plain.kept_length == 0.0
    assert edit.repeat == DecimateTo(300, features=True)
    assert np.array_equal(edit.repeat(painted).surface.vertices, edit.surface.vertices)


def test_triangles_are_numbered_by_all_that_is_painted_at_once(painted):
    held, named = number_painted(painted, painted.imported)

    within = [i[painted.surface.triangles].all(axis=1) for i in list_painted(painted)]
    for number, triangles in zip((named, held, held), within, strict=True):
        assert set(number[triangles]).isdisjoint(number[~triangles])


def test_what_was_painted_on_a_coarser_surface_has_its_border_there_too(painted):
    once = DecimateTo(800, features=True)(painted)

    again = DecimateTo(1200, features=True)(once)

    for before, after in zip(list_painted(painted), list_painted(again), strict=True):
        assert measure_area(again, after) == pytest.approx(measure_area(painted, before), rel=0.15)


# ---------------------------------------------------------------- histories and verbs


def test_a_line_of_before_is_read_done_and_written_as_it_was(painted, tmp_path):
    assert write_line(DecimateTo(300)).values == {"vertices": 300, "error": None}
    assert write_line(DecimateTo(300, features=True)).values["features"] is True
    path = tmp_path / "a.organ"
    write_organ(path, DecimateTo(300)(painted))

    before = path.read_bytes()
    assert main(["rebuild", str(path), "-o", str(path)]) == 0
    assert path.read_bytes() == before


def test_the_verb_keeps_them_and_says_how_much(painted, tmp_path, capsys):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, painted)
    words = ["decimate", str(path), "--vertices", "800", "--no-felt", "-o", str(out)]

    assert main([*words, "--json"]) == 0

    report = json.loads(capsys.readouterr().out)
    assert report["kept_lines_mm"] > 100.0 and report["lines_left_out_mm"] == 0.0
    (*_, line) = read_organ(out).history.lines
    assert line.values["features"] is True
    assert main(["rebuild", str(out)]) == 0
    capsys.readouterr()
    assert main(words) == 0
    kept = f"{report['kept_lines_mm']:.0f} mm stay on their lines"
    assert f"ridges and borders of what is painted: {kept}" in capsys.readouterr().out


@pytest.mark.landing
@pytest.mark.parametrize("vertices", [150, 600])
def test_a_real_bladder_with_its_ureters_is_nearer_than_before(vertices, shared_data):
    mesh = import_mesh(shared_data("organs/hra_VH_F_Urinary_Bladder.glb")).mesh

    plain, small = decimate(mesh, vertices), decimate(mesh, vertices, features=True)

    assert small.max_distance < 0.6 * plain.max_distance
    assert small.smallest_angle_deg > 0.8 * plain.smallest_angle_deg


def test_an_organ_without_ridges_or_paint_has_nothing_to_keep():
    surface = surface_of(palpate.SurfaceMesh(*ellipsoid(600)))

    small = decimate(mesh_of(surface), 300, features=True)

    assert (small.kept_length, small.left_out_length) == (0.0, 0.0)


def test_names_leave_room_for_the_shape(painted):
    """Of so few vertices too many would be on lines: what is only named gives way, and it is
    said."""
    few, enough = decimate_organ(painted, 300, True), decimate_organ(painted, 800, True)

    assert few.left_out_length > 0.1 and enough.left_out_length == 0.0
    assert few.kept_length + few.left_out_length == pytest.approx(enough.kept_length, rel=1e-9)
