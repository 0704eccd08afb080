# SPDX-License-Identifier: BSD-3-Clause
"""read_mesh: surfaces from OBJ, STL and PLY, and sentences for what is none."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import palpate
import pytest
from surfaces import ellipsoid

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def made(name: str, content: str | bytes) -> Path:
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return made


TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def is_sound(mesh: palpate.SurfaceMesh, volume: float) -> bool:
    palpate.validate(mesh)
    return abs(palpate.compute_volume(mesh) - volume) < 1e-9


# --- OBJ -----------------------------------------------------------------------------------------


def test_an_obj_with_everything_other_programs_write_is_read_as_its_surface(write):
    path = write(
        "organ.obj",
        "# by some program\nmtllib organ.mtl\no organ\n"
        + TETRAHEDRON.replace("1\n", "1 0.5 0.5 0.5\n")
        + "vn 0 0 1\nvn 0 1 0\nvt 0 0\ng wall\nusemtl red\ns 1\n"
        "f 1//1 3//1 2//2\nf 1/1 2/1 4/1\nf 2/1/1 3/1/2 \\\n 4/1/1\ns off\nf 1 4 3  # the last\n",
    )  # fmt: skip

    mesh = palpate.read_mesh(path)

    assert mesh.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert [tuple(row) for row in mesh.triangles] == FACES
    assert is_sound(mesh, 1 / 6)


def test_negative_numbers_of_an_obj_count_back_from_where_they_stand(write):
    path = write(
        "back.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -4 -5\n"
    )

    mesh = palpate.read_mesh(path)

    assert mesh.triangles.tolist() == [[1, 2, 3], [4, 1, 0]]


def test_polygons_of_an_obj_become_fans_about_their_first_corner(write):
    path = write("pentagon.obj", "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n")

    mesh = palpate.read_mesh(path)

    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]


def test_a_face_of_an_obj_may_stand_before_its_vertices(write):
    path = write("early.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")

    assert palpate.read_mesh(path).triangles.tolist() == [[0, 1, 2]]


@pytest.mark.parametrize(
    ("line", "found", "expected"),
    [
        ("v 1 2", "'v 1 2'", "v and three finite numbers"),
        ("v 1 2 x", "'v 1 2 x'", "v and three finite numbers"),
        ("v 1 2 nan", "'v 1 2 nan'", "v and three finite numbers"),
        ("f 1 2", "'f 1 2'", "f and three corners or more"),
        ("f 1 2 9", "vertex 9", "1 to 4"),
        ("f 1 2 0", "vertex 0", "1 and up, or -1 to -4 counting back"),
        ("f 1 2 -5", "vertex -5", "1 and up, or -1 to -4 counting back"),
        ("f 1 2 3.5", "'3.5'", "a corner: i, i/t, i//n or i/t/n"),
        ("f 1 2 3/1/1/1", "'3/1/1/1'", "a corner: i, i/t, i//n or i/t/n"),
        ("surf 0 1 0 1 1", "'surf 0 1 0 1 1'", "v, f or another word of polygons in an OBJ"),
    ],
)
def test_a_damaged_obj_is_refused_with_the_line_and_what_was_expected(write, line, found, expected):
    path = write("bad.obj", TETRAHEDRON + line + "\nf 1 2 3\n")

    with pytest.raises(palpate.FileError) as caught:
        palpate.read_mesh(path)

    assert str(caught.value) == f"{path}: line 5: got {found}, expected {expected}"


# --- STL -----------------------------------------------------------------------------------------


def binary_stl(mesh: palpate.SurfaceMesh, header: bytes = b"made by a test") -> bytes:
    rows = np.zeros(
        len(mesh.triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("a", "<u2")]
    )
    rows["corners"] = mesh.vertices[mesh.triangles]
    return header.ljust(80, b"\0") + struct.pack("<I", len(rows)) + rows.tobytes()


def text_stl(mesh: palpate.SurfaceMesh) -> str:
    lines = ["solid organ"]
    for corners in mesh.vertices[mesh.triangles]:
        lines += [" facet normal 0 0 0", "  outer loop"]
        lines += [f"   vertex {x!r} {y!r} {z!r}" for x, y, z in corners.tolist()]
        lines += ["  endloop", " endfacet"]
    return "\n".join([*lines, "endsolid organ", ""])


@pytest.mark.parametrize("header", [b"made by a test", b"solid, but binary all the same"])
def test_a_binary_stl_is_welded_to_a_closed_surface(write, header):
    mesh = ellipsoid((0.03, 0.02, 0.01), 2)

    read = palpate.read_mesh(write("organ.stl", binary_stl(mesh, header)))

    assert len(read.vertices) == len(mesh.vertices)
    assert palpate.is_closed(read.triangles)
    np.testing.assert_array_equal(
        read.vertices[read.triangles], np.float32(mesh.vertices[mesh.triangles])
    )


def test_an_stl_as_text_is_welded_to_the_same_surface_to_the_bit(write):
    mesh = ellipsoid((0.03, 0.02, 0.01), 1)

    read = palpate.read_mesh(write("organ.STL", text_stl(mesh)))

    assert len(read.vertices) == len(mesh.vertices)
    np.testing.assert_array_equal(read.vertices[read.triangles], mesh.vertices[mesh.triangles])


def test_welding_takes_minus_zero_for_zero(write):
    text = text_stl(palpate.SurfaceMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], FACES))

    read = palpate.read_mesh(write("zero.stl", text.replace("0.0 0.0 0.0", "-0.0 0.0 -0.0", 1)))

    assert len(read.vertices) == 4


def test_a_damaged_stl_is_refused_with_its_place(write):
    mesh = ellipsoid((0.03, 0.02, 0.01), 0)
    whole = binary_stl(mesh)
    text = text_stl(mesh).splitlines()
    wrong = bytearray(whole)
    wrong[84 + 12 : 84 + 16] = struct.pack("<f", float("nan"))

    for name, content, words in (
        ("short.stl", whole[:-30], "byte 80: got 1054 bytes, expected 1084 for its 20 triangles"),
        ("tiny.stl", b"abc", "got 3 bytes, expected text, or at least 84 bytes"),
        ("nan.stl", bytes(wrong), "corner 1: got [nan, "),
        ("word.stl", "\n".join([*text[:4], "vortex 1", *text[5:]]), "line 5: got 'vortex 1'"),
        ("two.stl", "\n".join([*text[:5], *text[6:]]), "line 7: got 2 corners, expected 3"),
        ("cut.stl", "\n".join(text[:5]), "line 5: got the end within a facet"),
        ("number.stl", "\n".join([*text[:4], "vertex 1 2 inf"]), "line 5: got 'vertex 1 2 inf'"),
    ):  # fmt: skip
        with pytest.raises(palpate.FileError) as caught:
            palpate.read_mesh(write(name, content))
        assert words in str(caught.value)


# --- PLY -----------------------------------------------------------------------------------------

PLY = """ply
format {format} 1.0
comment by a test
element vertex 4
property {real} x
property {real} y
property uchar red
property {real} z
element face {faces}
property list uchar {index} vertex_indices
property short flags
element edge 1
property int a
end_header
"""


def make_ply(order: str, polygons: list[tuple[int, ...]]) -> bytes:
    header = PLY.format(format=order, real="double", index="uint", faces=len(polygons)).encode()
    places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    if order == "ascii":
        lines = [f"{x} {y} 200 {z}" for x, y, z in places]
        lines += [" ".join(map(str, (len(p), *p, 7))) for p in polygons]
        return header + "\n".join([*lines, "5", ""]).encode()
    sign = "<" if "little" in order else ">"
    body = b"".join(struct.pack(sign + "ddBd", x, y, 200, z) for x, y, z in places)
    for polygon in polygons:
        body += struct.pack(f"{sign}B{len(polygon)}Ih", len(polygon), *polygon, 7)
    return header + body + struct.pack(sign + "i", 5)


ORDERS = ["ascii", "binary_little_endian", "binary_big_endian"]


@pytest.mark.parametrize("order", ORDERS)
def test_a_ply_is_read_in_every_order_of_bytes(write, order):
    mesh = palpate.read_mesh(write("organ.ply", make_ply(order, FACES)))

    assert mesh.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert [tuple(row) for row in mesh.triangles] == FACES
    assert is_sound(mesh, 1 / 6)


@pytest.mark.parametrize("order", ORDERS)
def test_polygons_of_a_ply_become_fans(write, order):
    mesh = palpate.read_mesh(write("mixed.ply", make_ply(order, [(0, 1, 2), (0, 1, 3, 2)])))

    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 1, 3], [0, 3, 2]]


@pytest.mark.parametrize("order", ORDERS)
def test_a_ply_that_ends_early_is_refused_with_the_place(write, order):
    whole = make_ply(order, [(0, 1, 2), (0, 1, 3, 2)])
    header = whole.index(b"end_header\n") + len(b"end_header\n")

    for length in range(header, len(whole) - 1, 3):
        with pytest.raises(palpate.FileError, match=r"got .*, expected .*(vertex|face|edge)"):
            palpate.read_mesh(write("cut.ply", whole[:length]))


def test_a_damaged_ply_is_refused_with_the_line(write):
    whole = make_ply("ascii", FACES).decode()

    for old, new, words in (
        ("ply\n", "plx\n", "line 1: got 'plx', expected ply"),
        (
            "property double x",
            "property real x",
            "line 5: got 'property real x', expected format",
        ),
        ("end_header", "end_of_header", "line 14: got 'end_of_header'"),
        ("format ascii 1.0\n", "", "header: got no format, expected format ascii"),
        ("double z", "double height", "expected an element vertex with x, y, z"),
        ("vertex_indices", "corners", "expected an element face with vertex_indices, vertex_index"),
        ("1 0 200 0", "1 zero 200 0", "line 16: got '1 zero 200 0', expected a row of vertex"),
        ("1 0 200 0", "1 nan 200 0", "vertex 2: got [1.0, nan, 0.0], expected three finite"),
        ("3 0 3 2 7", "3 0 4 2 7", "face 4: got vertex [0, 4, 2], expected 0 to 3"),
        ("3 0 3 2 7", "2 0 3 7", "face 4: got 2 corners, expected three or more"),
    ):
        assert old in whole
        with pytest.raises(palpate.FileError) as caught:
            palpate.read_mesh(write("bad.ply", whole.replace(old, new, 1)))
        assert words in str(caught.value)


def test_a_ply_that_promises_more_than_it_has_takes_no_memory_for_it(write):
    whole = make_ply("binary_little_endian", FACES)

    for old in (b"vertex 4", b"face 4"):
        huge = whole.replace(old, old[:-1] + b"4000000000000")
        with pytest.raises(palpate.FileError, match="the end of the file"):
            palpate.read_mesh(write("huge.ply", huge))


# --- all -----------------------------------------------------------------------------------------


def test_the_unit_says_what_the_numbers_are_in(write):
    path = write("mm.obj", TETRAHEDRON + "f 1 3 2\n")

    assert palpate.read_mesh(path, unit="mm").vertices.max() == 1e-3
    with pytest.raises(ValueError, match="unit: got 'inch', expected one of m, cm, mm"):
        palpate.read_mesh(path, unit="inch")


def test_other_files_and_files_without_a_surface_are_refused(write, tmp_path):
    with pytest.raises(palpate.FileError, match="got the suffix '.glb', expected one of .obj"):
        palpate.read_mesh(write("organ.glb", b"glTF"))
    with pytest.raises(palpate.FileError, match="got no faces, expected a surface"):
        palpate.read_mesh(write("points.obj", TETRAHEDRON))
    with pytest.raises(FileNotFoundError):
        palpate.read_mesh(tmp_path / "none.stl")


def test_a_surface_that_was_read_can_be_felt(write):
    mesh = palpate.read_mesh(write("organ.stl", binary_stl(ellipsoid((0.03, 0.02, 0.02), 1))))
    wall = palpate.Material(damping_ratio=0.2, wall_thickness=2e-3)

    scene = palpate.build_scene(palpate.make_scene(palpate.build_membrane_springs(mesh, wall)))

    assert palpate.World(scene).tick_count == 0
