# SPDX-License-Identifier: GPL-3.0-or-later
"""Foreign files come in with the right names, places, units and axes, or are refused in words."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from foreign_files import (
    LIBRARY_WRITERS,
    TETRAHEDRON,
    TETRAHEDRON_FACES,
    WRITERS,
    write_glb,
    write_obj,
    write_stl,
    write_text_stl,
)
from palpate_editor.authoring import import_mesh, join_parts, read_mesh, write_mesh
from tiers import keep_everyday


def corners_of(mesh: palpate.SurfaceMesh) -> set[tuple[tuple[float, ...], ...]]:
    """Every triangle as its corners, rounded to 0.1 micrometres, the smallest first."""
    found = set()
    for triangle in np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]:
        points = [tuple(p) for p in (np.round(triangle, 7) + 0.0).tolist()]
        first = points.index(min(points))
        found.add(tuple(points[first:] + points[:first]))
    return found


EXPECTED = corners_of(palpate.SurfaceMesh(1e-3 * TETRAHEDRON, TETRAHEDRON_FACES))


@pytest.mark.parametrize("extension", [*WRITERS, *LIBRARY_WRITERS])
def test_the_same_surface_comes_in_from_every_format(extension, tmp_path):
    path = tmp_path / f"organ.{extension}"
    (WRITERS | LIBRARY_WRITERS)[extension](path, TETRAHEDRON, TETRAHEDRON_FACES)

    joined = join_parts(read_mesh(path))

    assert len(joined.mesh.vertices) == 4
    assert corners_of(joined.mesh) == EXPECTED


@pytest.mark.parametrize(
    ("extension", "unit", "guessed"),
    [("glb", "m", False), ("dae", "m", False), ("fbx", "mm", False), ("stl", "mm", True)],
)
def test_a_stated_unit_is_told_from_a_guessed_one(extension, unit, guessed, tmp_path):
    path = tmp_path / f"organ.{extension}"
    WRITERS[extension](path, TETRAHEDRON, TETRAHEDRON_FACES)

    joined = join_parts(read_mesh(path))

    assert (joined.unit, joined.unit_guessed) == (unit, guessed)
    assert joined.unit_reason


@pytest.mark.parametrize(("scale", "unit"), [(1e-3, "m"), (0.1, "cm"), (1.0, "mm")])
def test_a_unit_is_guessed_by_size(scale, unit, tmp_path):
    path = tmp_path / "organ.obj"
    write_obj(path, scale * TETRAHEDRON, TETRAHEDRON_FACES)

    joined = join_parts(read_mesh(path))

    assert (joined.unit, joined.unit_guessed) == (unit, True)
    assert np.ptp(joined.mesh.vertices, axis=0) == pytest.approx([0.1, 0.06, 0.04])


def test_unit_and_axis_asked_for_go_before_what_the_file_states(tmp_path):
    path = tmp_path / "organ.glb"
    write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES)

    joined = join_parts(read_mesh(path), unit="cm", up="z")

    assert np.ptp(joined.mesh.vertices, axis=0) == pytest.approx([1e-3, 4e-4, 6e-4])
    assert not joined.unit_guessed
    assert not joined.up_guessed


@pytest.mark.parametrize("up", ["x", "y", "z", "-x", "-y", "-z"])
def test_the_asked_axis_comes_to_point_up_and_nothing_is_mirrored(up, tmp_path):
    path = tmp_path / "organ.obj"
    write_obj(path, TETRAHEDRON, TETRAHEDRON_FACES)
    axis = "xyz".index(up[-1])
    sign = -1.0 if up.startswith("-") else 1.0

    mesh = join_parts(read_mesh(path), unit="mm", up=up).mesh

    assert np.asarray(mesh.vertices)[:, 2] == pytest.approx(1e-3 * sign * TETRAHEDRON[:, axis])
    assert palpate.compute_volume(mesh) == pytest.approx(1e-9 * 100 * 60 * 40 / 6)


@pytest.mark.parametrize(("name", "value"), [("unit", "furlong"), ("up", "w")])
def test_a_word_that_is_no_unit_or_axis_is_refused(name, value, tmp_path):
    path = tmp_path / "organ.obj"
    write_obj(path, TETRAHEDRON, TETRAHEDRON_FACES)

    with pytest.raises(ValueError, match=value):
        join_parts(read_mesh(path), **{name: value})


def test_a_mirroring_node_keeps_the_outside_outside(tmp_path):
    path = tmp_path / "organ.glb"
    write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES, matrix=np.diag([-1.0, 1.0, 1.0, 1.0]))

    mesh = join_parts(read_mesh(path)).mesh

    assert palpate.compute_volume(mesh) == pytest.approx(1e-9 * 100 * 60 * 40 / 6)
    assert np.asarray(mesh.vertices)[:, 0].min() == pytest.approx(-0.1)


def test_the_transform_of_a_node_places_its_part(tmp_path):
    path = tmp_path / "organ.glb"
    matrix = np.diag([2.0, 2.0, 2.0, 1.0])
    matrix[:3, 3] = 0.0, 0.5, 0.0
    write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES, matrix=matrix)

    mesh = join_parts(read_mesh(path)).mesh

    assert np.asarray(mesh.vertices).min(axis=0) == pytest.approx([0.0, 0.0, 0.5])
    assert np.asarray(mesh.vertices).max(axis=0) == pytest.approx([0.2, 0.12, 0.58])


def test_a_binary_stl_with_bytes_after_its_end_is_read_with_a_note(tmp_path):
    path = tmp_path / "organ.stl"
    write_stl(path, TETRAHEDRON, TETRAHEDRON_FACES, trailing=52)

    scene = read_mesh(path)

    assert corners_of(join_parts(scene).mesh) == EXPECTED
    assert any("52 bytes" in note for note in scene.notes)


def test_a_text_stl_is_read(tmp_path):
    path = tmp_path / "organ.stl"
    write_text_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


def test_named_parts_of_an_obj_can_be_chosen_and_are_welded(tmp_path):
    path = tmp_path / "organ.obj"
    # the same tetrahedron as two open parts with vertices of their own
    lines = [f"v {x} {y} {z}" for x, y, z in np.concatenate([TETRAHEDRON, TETRAHEDRON])]
    lines += ["o floor", "f 1 3 2", "f 1 2 4", "o walls", "f 5 8 7", "f 6 7 8"]
    path.write_text("\n".join(lines), encoding="utf-8")
    scene = read_mesh(path)

    whole, floor = join_parts(scene), join_parts(scene, parts=["floor"])

    assert [part.name for part in scene.parts] == ["floor", "walls"]
    assert corners_of(whole.mesh) == EXPECTED
    assert whole.welded_vertices == 4
    assert len(floor.mesh.triangles) == 2
    assert floor.parts == ["floor"]


def test_a_part_that_is_not_there_is_refused_with_the_names_that_are(tmp_path):
    path = tmp_path / "organ.glb"
    write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES)

    with pytest.raises(palpate.FileError, match="'organ'") as refusal:
        join_parts(read_mesh(path), parts=["spleen"])

    assert refusal.value.where == "part 'spleen'"
    assert refusal.value.file == str(path)


def chain(spacing: float) -> tuple[np.ndarray, np.ndarray]:
    """Thin triangles that share no vertex number, their tips in a row `spacing` apart."""
    points, faces = [], []
    for k in range(6):
        first = len(points)
        points += [(k * spacing, 0.0, 0.0), (0.0, 1.0, 0.1 * k), (0.5, 1.0, 0.1 * k)]
        faces.append((first, first + 1, first + 2))
    return np.array(points), np.array(faces)


def test_a_chain_of_close_vertices_does_not_pull_all_of_them_together(tmp_path):
    path = tmp_path / "chain.obj"
    points, faces = chain(spacing=0.7e-6)
    write_obj(path, points, faces)

    mesh = join_parts(read_mesh(path), unit="m").mesh

    # the diagonal is 1.2, so 0.7e-6 is within the tolerance and twice that is not: pairs are made
    tips = np.asarray(mesh.vertices)[np.asarray(mesh.vertices)[:, 1] == 0.0]
    assert tips[:, 0] == pytest.approx([0.0, 1.4e-6, 2.8e-6], abs=1e-12)


def test_a_written_obj_reads_back_to_the_same_bits_unit_and_axis(tmp_path):
    random = np.random.default_rng(4)
    vertices = np.pi * TETRAHEDRON / 1000 + random.normal(scale=1e-3, size=(4, 3))
    mesh = palpate.SurfaceMesh(vertices, TETRAHEDRON_FACES)

    write_mesh(tmp_path / "organ.obj", mesh)
    joined = join_parts(read_mesh(tmp_path / "organ.obj"))

    assert np.array_equal(joined.mesh.vertices, vertices)
    assert np.array_equal(joined.mesh.triangles, TETRAHEDRON_FACES)
    assert (joined.unit, joined.unit_guessed) == ("m", False)
    assert (joined.up, joined.up_guessed) == ("z", False)
    assert list(tmp_path.iterdir()) == [tmp_path / "organ.obj"]


def test_a_written_stl_reads_back_to_single_precision(tmp_path):
    mesh = palpate.SurfaceMesh(np.pi * TETRAHEDRON / 1000, TETRAHEDRON_FACES)

    write_mesh(tmp_path / "organ.stl", mesh)
    joined = join_parts(read_mesh(tmp_path / "organ.stl"))

    assert len(joined.mesh.vertices) == 4
    points = np.sort(np.asarray(joined.mesh.vertices), axis=0)
    assert points == pytest.approx(np.sort(np.asarray(mesh.vertices), axis=0), rel=1e-7)
    assert palpate.compute_volume(joined.mesh) == pytest.approx(palpate.compute_volume(mesh))
    assert (joined.unit, joined.unit_guessed) == ("m", False)


def test_a_mesh_cannot_be_written_under_a_name_that_is_no_format(tmp_path):
    mesh = palpate.SurfaceMesh(TETRAHEDRON, TETRAHEDRON_FACES)

    with pytest.raises(ValueError, match=r"\.obj or \.stl"):
        write_mesh(tmp_path / "organ.glb", mesh)
    with pytest.raises(palpate.FileError):
        write_mesh(tmp_path / "no such folder" / "organ.obj", mesh)

    assert list(tmp_path.iterdir()) == []


def test_a_spleen_of_five_open_parts_welds_into_one_closed_surface(shared_data):
    organ = import_mesh(shared_data("organs/VH_F_Spleen.glb"))

    assert len(organ.joined.parts) == 5
    assert (organ.report.vertices, organ.report.triangles) == (4274, 8544)
    assert (organ.report.shells, organ.report.genus) == (1, 0)
    assert organ.report.closed
    assert organ.report.outward
    assert organ.report.volume_ml == pytest.approx(190.74, abs=0.01)
    # the table of the organs says 0.0896 x 0.1023 x 0.0709 with y up
    assert organ.report.size_mm == pytest.approx([89.56, 70.94, 102.3], abs=0.05)


def test_a_pancreas_keeps_its_hole_and_says_so_also_as_stl(shared_data, tmp_path):
    organ = import_mesh(shared_data("organs/VH_F_Pancreas.glb"))
    write_mesh(tmp_path / "pancreas.stl", organ.mesh)
    again = import_mesh(tmp_path / "pancreas.stl")

    for one in (organ, again):
        assert (one.report.vertices, one.report.triangles) == (5749, 11480)
        assert one.report.border_loops == [16]
        assert not one.report.closed
        assert one.report.volume_ml is None
    assert not again.joined.unit_guessed


@pytest.mark.parametrize(
    "name",
    keep_everyday(["VH_F_Kidney_L", "VH_F_Liver", "VH_M_Heart"], ["VH_F_Kidney_L"]),
)
def test_nested_parts_taken_together_open_with_every_crossing_triangle_named(name, shared_data):
    organ = import_mesh(shared_data(f"organs/{name}.glb"))

    assert organ.report.self_intersecting_faces == len(organ.report.crossing_faces) > 5000
    assert max(organ.report.crossing_faces) < organ.report.triangles


@pytest.mark.parametrize(
    ("name", "read"),
    [("dalağı 🫀".encode(), "dalağı 🫀"), (b"dala\xf0\xfd", "dala??"),
     (b"\xc0\xaf\xed\xa0\x80", "?????"), (b"a\xf4\x90\x80\x80\xe0\x9fb", "a??????b"),
     (b"\xe2\x82", "??")],
)  # fmt: skip
def test_a_name_that_is_no_text_gets_a_question_mark_for_every_odd_byte(tmp_path, name, read):
    path = tmp_path / "a.obj"
    path.write_bytes(b"o " + name + b"\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    assert [part.name for part in read_mesh(path).parts] == [read]
