# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of VTK and Gmsh, and OFF in its variants, come in as other files do, or are refused."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from foreign_files import (
    LIBRARY_WRITERS,
    TETRAHEDRON,
    TETRAHEDRON_FACES,
    numbers,
    write_msh,
    write_msh4,
    write_vtk,
    write_vtu,
)
from palpate.cli.doctor import find_landlock
from palpate_editor import authoring, formats
from palpate_editor.authoring import import_mesh, join_parts, read_mesh
from palpate_meshes.generate import ellipsoid
from test_read_mesh import EXPECTED, corners_of

TWO = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
"""Tetrahedra that share a face."""
POINTS = np.vstack([TETRAHEDRON, [[60.0, 60, 60]]])


@pytest.mark.parametrize("binary", [False, True], ids=["text", "binary"])
@pytest.mark.parametrize(
    ("name", "write"), [("a.vtk", write_vtk), ("a.msh", write_msh), ("b.msh", write_msh4)]
)
def test_text_and_binary_files_are_the_same(name, write, binary, tmp_path):
    write(tmp_path / name, TETRAHEDRON, TETRAHEDRON_FACES, binary=binary)

    assert corners_of(join_parts(read_mesh(tmp_path / name)).mesh) == EXPECTED


@pytest.mark.parametrize(
    ("name", "write"), [("a.vtu", write_vtu), ("a.msh", write_msh), ("b.msh", write_msh4)]
)
def test_of_tetrahedra_the_outer_faces_are_the_surface(name, write, tmp_path):
    write(tmp_path / name, POINTS, TWO)

    organ = import_mesh(tmp_path / name)
    scene = read_mesh(tmp_path / name)

    assert (organ.report.triangles, organ.report.closed, organ.report.outward) == (6, True, True)
    # |det|/6 of each by hand: 100*60*40/6 mm³, and 504000/6 mm³
    assert organ.report.volume_ml == pytest.approx(40.0 + 84.0)
    assert any(note.startswith("2 tetrahedra fill it") for note in scene.notes)


@pytest.mark.parametrize("write", [write_msh, write_msh4])
def test_a_physical_group_names_its_part(write, tmp_path):
    write(tmp_path / "a.msh", POINTS, TWO)

    assert [part.name for part in read_mesh(tmp_path / "a.msh").parts] == ["organ"]


def test_strips_and_polygons_of_a_vtk_file_are_triangles(tmp_path):
    path = tmp_path / "a.vtk"
    head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n"
    square = "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0\n"
    path.write_text(
        head + square + "POLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 1 4 2 5\n",
        encoding="utf-8",
    )

    mesh = join_parts(read_mesh(path)).mesh

    assert len(mesh.triangles) == 4
    assert np.ptp(mesh.vertices, axis=0).tolist() == pytest.approx([0.02, 0.01, 0.0])


BAD = {
    "noise.vtk": (b"\x00\x01\x02" * 50, "'???"),
    "corner.vtk": (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                   b"0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 9\n", "vertex 9"),
    "count.vtk": (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                  b"POINTS 300000000000 float\n0 0 0\n", "allocate"),
    "volume.vtk": (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"
                   b"DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n", "a volume of voxels"),
    "points.vtk": (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n"
                   b"0 0 0\n", "no polygons"),
    "tag.vtu": (b"<VTKFile type='UnstructuredGrid'><oops></VTKFile>", "mismatched tag"),
    "half.msh": (b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n", "its end"),
    "other.msh": (b"made by another program\n", "no $MeshFormat"),
    "old.msh": (b"$MeshFormat\n1 0 8\n$EndMeshFormat\n", "version 1"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_what_is_unreadable_is_refused_with_what_was_found(name, tmp_path):
    content, found = BAD[name]
    path = tmp_path / name
    path.write_bytes(content)

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert refusal.value.file == str(path)
    assert found in refusal.value.got and refusal.value.expected


@pytest.mark.parametrize("count", [5, pytest.param(60, marks=pytest.mark.verify)])
@pytest.mark.parametrize("extension", LIBRARY_WRITERS)
def test_spoiled_files_are_read_or_refused(extension, count, tmp_path):
    from test_hostile import spoil

    random = np.random.default_rng(sum(extension.encode()))
    path = tmp_path / f"organ.{extension}"
    LIBRARY_WRITERS[extension](path, *ellipsoid(50))
    content = path.read_bytes()

    refused = 0
    for _ in range(count):
        path.write_bytes(spoil(content, random))
        try:
            import_mesh(path)
        except palpate.FileError as refusal:
            refused += 1
            assert refusal.file == str(path)

    assert refused > 0


# ---------------------------------------------------------------- the process that reads


def test_without_the_package_the_sentence_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(formats, "find_spec", lambda name: None)
    write_vtk(tmp_path / "a.vtk", TETRAHEDRON, TETRAHEDRON_FACES)

    with pytest.raises(palpate.FileError, match=r"palpate-editor\[formats\]") as refusal:
        read_mesh(tmp_path / "a.vtk")

    assert "vtk" in refusal.value.got


def test_the_libraries_are_never_loaded_by_a_program_that_opens_windows():
    code = (
        "import sys, palpate_editor.views.editor, palpate_editor.verbs\n"
        "import palpate_editor.edits, palpate_editor.authoring\n"
        "print([name for name in sys.modules if name.split('.')[0] == 'vtkmodules'])"
    )
    run = subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, encoding="utf-8")

    assert run.stdout.strip() == "[]", run.stderr


def test_the_reader_is_isolated_from_the_folder_the_user_stands_in(tmp_path, monkeypatch):
    (tmp_path / "numpy.py").write_text(
        "open('was-run', 'w')\nraise SystemExit(99)\n", encoding="utf-8"
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    write_vtk(tmp_path / "a.vtk", TETRAHEDRON, TETRAHEDRON_FACES)

    assert len(read_mesh(tmp_path / "a.vtk").parts) == 1
    assert not (tmp_path / "was-run").exists()
    assert formats.build_words("VTK")[1] == "-I"


def run_confined(tmp_path: Path, code: str) -> str:
    """What comes of `code` in a process that has confined itself to a file."""
    write_vtk(tmp_path / "a.vtk", TETRAHEDRON, TETRAHEDRON_FACES)
    lines = (
        "import socket\n"
        "from palpate_editor.formats_child.confine import confine\n"
        f"confine({str(tmp_path / 'a.vtk')!r}, [], 2_000_000_000, 5)\n"
        f"try:\n    {code}\n    print('allowed')\n"
        "except (OSError, MemoryError) as refused:\n    print(type(refused).__name__)\n"
    )
    run = subprocess.run([sys.executable, "-P", "-c", lines], capture_output=True, encoding="utf-8")
    return run.stdout.strip() or run.stderr


def test_the_reader_may_open_its_file_and_no_other(tmp_path):
    if find_landlock() is None:
        pytest.skip("Landlock cannot be had here")
    (tmp_path / "secret").write_text("a secret", encoding="utf-8")

    assert run_confined(tmp_path, f"open({str(tmp_path / 'a.vtk')!r}, 'rb')") == "allowed"
    assert run_confined(tmp_path, f"open({str(tmp_path / 'secret')!r})") == "PermissionError"
    assert run_confined(tmp_path, f"open({str(tmp_path / 'new')!r}, 'w')") == "PermissionError"


def test_the_reader_keeps_to_its_memory(tmp_path):
    assert run_confined(tmp_path, "bytearray(3_000_000_000)") == "MemoryError"


def test_a_reader_that_is_out_of_time_is_stopped(tmp_path):
    write_vtk(tmp_path / "a.vtk", TETRAHEDRON, TETRAHEDRON_FACES)

    with pytest.raises(palpate.FileError, match="still being read after 0.01 s"):
        read_mesh(tmp_path / "a.vtk", time_limit=0.01)


# ---------------------------------------------------------------- the organs that are shared


@pytest.mark.parametrize(
    ("name", "triangles"),
    [("gca_EdinGCA_3D_00020_small-intestine.vtk", 29013), ("vtkdata_Torso.vtp", 23762)],
)
def test_organs_of_other_collections_open(name, triangles, shared_data):
    organ = import_mesh(shared_data(f"organs/{name}"))

    assert organ.report.triangles == triangles
    assert organ.joined.unit == "mm"


# ---------------------------------------------------------------- OFF


def lines_of(extra: str = "", weight: str = "") -> str:
    vertices = [f"{numbers(x)}{weight}{extra}" for x in TETRAHEDRON]
    return "\n".join([*vertices, *(f"3 {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES), ""])


OFFS = {
    "plain": "OFF\n4 4 6\n" + lines_of(),
    "no word": "4 4 0\n" + lines_of(),
    "on one line": "OFF 4 4 0\n" + lines_of(),
    "two counts": "OFF\n4 4\n" + lines_of(),
    "comments": "# made\nOFF # here\n\n4 4 0\n# vertices\n" + lines_of(" # a corner"),
    "colours": "COFF\n4 4 0\n" + lines_of(" 255 0 0 255"),
    "few colours": "COFF\n4 4 0\n" + lines_of(" 0.5 0.5 0.5"),
    "normals": "NOFF\n4 4 0\n" + lines_of(" 0 0 1"),
    "both": "CNOFF\n4 4 0\n" + lines_of(" 0 0 1 1 1 1 1"),
    "texture": "STOFF\n4 4 0\n" + lines_of(" 0.5 0.5"),
    "all": "STCNOFF\n4 4 0\n" + lines_of(" 0 0 1 1 1 1 1 0 0"),
    "weights": "4OFF\n4 4 0\n" + lines_of(weight=" 1"),
    "carriage returns": ("OFF\n4 4 0\n" + lines_of()).replace("\n", "\r\n"),
    "coloured faces": "OFF\n4 4 0\n" + lines_of().replace("3 0 2 1", "3 0 2 1 255 0 0"),
}


@pytest.mark.parametrize("name", OFFS)
def test_every_variant_of_off_is_the_same_surface(name, tmp_path):
    path = tmp_path / "a.off"
    path.write_bytes(OFFS[name].encode())

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize(
    ("text", "where", "got"),
    [
        ("OFF\n353535235358 6 0\n0 0 0\n", "line 3", "the end of the file"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "line 5", "'0 1'"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6", "vertex 3"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9 0 1 2\n", "line 6", "'9 0 1 2'"),
        ("OFF BINARY\n", "number 0 after the first line", "the end of the file"),
        ("GOFF\n3 1 0\n", "line 1", "'GOFF'"),
        ("OFF\nmany\n", "line 2", "'many'"),
    ],
)
def test_an_off_is_refused_with_its_line(text, where, got, tmp_path):
    path = tmp_path / "a.off"
    path.write_text(text, encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert (refusal.value.where, refusal.value.got) == (where, got)


# ---------------------------------------------------------------- OBJ


def test_an_obj_with_a_normal_of_index_zero_is_read(tmp_path):
    path = tmp_path / "a.obj"
    vertices = "".join(f"v {numbers(x)}\n" for x in TETRAHEDRON)
    faces = "".join(f"f {i}//0 {j}//7 {k}//x\n" for i, j, k in TETRAHEDRON_FACES + 1)
    path.write_text(vertices + "vn nonsense\n" + faces, encoding="utf-8")

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


def test_lines_of_an_obj_may_go_on_and_be_coloured(tmp_path):
    path = tmp_path / "a.obj"
    vertices = "".join(f"v {numbers(x)} 1 0 0\n" for x in TETRAHEDRON)
    faces = "".join(
        f"f {i - 5} \\\n {j - 5}/1/1 {k - 5} # of\n" for i, j, k in TETRAHEDRON_FACES + 1
    )
    path.write_text(vertices + faces, encoding="utf-8")

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize(
    ("last", "where", "got"),
    [("f 1 2 9", "line 5", "vertex 9"), ("f 0 1 3", "line 5", "vertex 3"),
     ("v 1 2", "line 5", "a vertex of 2 numbers"), ("v 1 b 2", "line 5", "'b'"),
     ("f 1 two 3", "line 5", "'two'"), ("f -9 2 3", "line 5", "vertex -9")],
)  # fmt: skip
def test_an_obj_is_refused_with_its_line(last, where, got, tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\n" + last + "\n", encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert (refusal.value.where, refusal.value.got) == (where, got)


def test_faces_of_two_corners_are_left_out_with_a_note(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\ncurv 0 1 1 2\n", encoding="utf-8")

    scene = read_mesh(path)

    assert len(scene.parts[0].mesh.triangles) == 1
    assert scene.notes == [
        "1 faces of fewer than three corners were left out",
        "1 free-form curves or surfaces were left out",
    ]


def test_the_three_bytes_that_some_editors_begin_a_text_with_are_passed_over(tmp_path):
    obj = "".join(f"v {numbers(x)}\n" for x in TETRAHEDRON)
    obj += "".join(f"f {i} {j} {k}\n" for i, j, k in TETRAHEDRON_FACES + 1)
    for name, text in (("a.obj", obj), ("a.off", OFFS["plain"])):
        (tmp_path / name).write_bytes(text.encode("utf-8-sig"))

        assert corners_of(join_parts(read_mesh(tmp_path / name)).mesh) == EXPECTED


def star(points: int) -> np.ndarray:
    """(2 points, 3) corners of a flat star, which is hollow at every other one."""
    angle = np.pi * np.arange(2 * points) / points
    radius = np.where(np.arange(2 * points) % 2 == 0, 50.0, 20.0)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), 0.0 * angle])


@pytest.mark.parametrize("extension", ["obj", "off"])
@pytest.mark.parametrize("points", [5, 100])
def test_a_hollow_polygon_keeps_its_shape(points, extension, tmp_path):
    corners = star(points)
    path = tmp_path / f"a.{extension}"
    many = len(corners)
    if extension == "obj":
        lines = [f"v {numbers(x)}" for x in corners]
        lines.append("f " + " ".join(str(i + 1) for i in range(many)))
    else:
        lines = ["OFF", f"{many} 1 0", *(numbers(x) for x in corners)]
        lines.append(f"{many} " + " ".join(map(str, range(many))))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    mesh = join_parts(read_mesh(path)).mesh

    assert len(mesh.triangles) == many - 2
    x = 1e3 * np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]
    areas = 0.5 * np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])[:, 2]
    # 2 n triangles from the middle: r R sin(pi/n) / 2 each; none of them turned over
    assert areas.min() > 0.0
    assert areas.sum() == pytest.approx(points * 50.0 * 20.0 * np.sin(np.pi / points))
    assert authoring.find_self_intersecting_faces(mesh) == []
