# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files that programs write oddly, or that lost their last bytes, open all the same."""

from __future__ import annotations

import base64
import json
import struct
import zipfile
from pathlib import Path

import numpy as np
import palpate
import pytest
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, numbers, write_glb, write_stl
from palpate_editor.authoring import import_mesh, join_parts, read_mesh
from palpate_meshes.generate import ellipsoid
from test_read_mesh import EXPECTED, corners_of

ROUND, ROUND_FACES = ellipsoid(200)
MANY = len(ROUND_FACES)


def write_text(kind: str, x: np.ndarray, faces: np.ndarray, declared: int | None = None) -> str:
    """As OBJ, OFF, STL or PLY."""
    points = [numbers(p) for p in x]
    rows = [" ".join(map(str, face)) for face in faces.tolist()]
    if kind == "obj":
        lines = [f"v {p}" for p in points]
        lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces.tolist()]
    elif kind == "off":
        lines = ["OFF", f"{len(x)} {declared or len(faces)} 0", *points, *(f"3 {r}" for r in rows)]
    elif kind == "stl":
        lines = ["solid a"]
        for face in faces:
            lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {points[i]}" for i in face)]
            lines += ["endloop", "endfacet"]
        lines.append("endsolid a")
    else:
        lines = ["ply", "format ascii 1.0", f"element vertex {len(x)}"]
        lines += [f"property double {axis}" for axis in "xyz"]
        lines += [f"element face {declared or len(faces)}", "property list uchar int vertex_index"]
        lines += ["end_header", *points, *(f"3 {r}" for r in rows)]
    return "\n".join(lines) + "\n"


KINDS = ("obj", "off", "stl", "ply")


@pytest.mark.parametrize("end", ["\r\n", "\r"], ids=["of Windows", "of old Macs"])
@pytest.mark.parametrize("kind", KINDS)
def test_lines_may_end_as_anywhere(kind, end, tmp_path):
    path = tmp_path / f"a.{kind}"
    text = write_text(kind, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_bytes(text.replace("\n", end).encode())

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize("code", ["utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("kind", ["obj", "off", "stl"])
def test_text_of_two_bytes_a_letter_is_read(kind, code, tmp_path):
    path = tmp_path / f"a.{kind}"
    text = "\ufeff" + write_text(kind, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_bytes(text.encode(code))

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize("word", ["nan", "-nan(ind)", "1.#QNAN", "-1.#IND00", "inf", "-1.#INF"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_vertex_that_is_no_place_is_left_out_with_a_note(kind, word, tmp_path):
    path = tmp_path / f"a.{kind}"
    x = np.vstack([ROUND, [[7.25, 7.25, 7.25]]])
    faces = np.vstack([ROUND_FACES, [[0, 1, len(ROUND)]]])
    path.write_text(
        write_text(kind, x, faces).replace("7.25 7.25 7.25", f"{word} 0 0"), encoding="utf-8"
    )

    organ, scene = import_mesh(path), read_mesh(path)

    assert (organ.report.triangles, organ.report.closed) == (MANY, True)
    assert [note for note in scene.notes if "without finite coordinates" in note]


@pytest.mark.parametrize("kind", ["obj", "off", "ply"])
def test_one_face_of_many_on_a_vertex_that_is_not_there_is_left_out_with_a_note(kind, tmp_path):
    path = tmp_path / f"a.{kind}"
    path.write_text(
        write_text(kind, ROUND, np.vstack([ROUND_FACES, [[0, 1, 99999]]])), encoding="utf-8"
    )

    scene = read_mesh(path)

    assert len(scene.parts[0].mesh.triangles) == MANY
    [note] = scene.notes
    assert note.startswith(f"1 of {MANY + 1} faces cannot be read") and "line" in note


@pytest.mark.parametrize("kind", ["off", "stl", "ply"])
def test_a_text_that_lost_its_last_lines_opens_with_a_note(kind, tmp_path):
    path = tmp_path / f"a.{kind}"
    path.write_text(
        write_text(kind, ROUND, ROUND_FACES)[: -40 if kind == "stl" else -12], encoding="utf-8"
    )

    scene = read_mesh(path)

    assert len(scene.parts[0].mesh.triangles) == MANY - 1
    assert any(f"1 of {MANY} faces cannot be read" in note for note in scene.notes)


@pytest.mark.parametrize("kind", ["off", "stl", "ply"])
def test_a_text_that_lost_half_is_refused(kind, tmp_path):
    path = tmp_path / f"a.{kind}"
    text = write_text(kind, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_text(text[: -60 if kind == "stl" else -20], encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    last = path.read_text(encoding="utf-8").rpartition("\n")[2]
    assert refusal.value.got in ("the end of the file", f"'{last}'")


def binary_stl(stated: int = MANY, count: int = MANY) -> bytes:
    """Of a round organ, of which the header states another count."""
    corners = ROUND[ROUND_FACES[:count]].astype("<f4")
    records = b"".join(struct.pack("<3f", 0, 0, 1) + c.tobytes() + b"\0\0" for c in corners)
    return b"solid of a program".ljust(80, b"\0") + struct.pack("<I", stated) + records


STLS = {
    "stated too few": (binary_stl(stated=MANY // 2), MANY, f"states {MANY // 2} triangles"),
    "stated one too many": (binary_stl(stated=MANY + 1), MANY, f"1 of {MANY + 1} faces cannot"),
    "cut in the last": (binary_stl()[:-20], MANY - 1, f"1 of {MANY} faces cannot"),
    "much behind it": (binary_stl() + b"\1" * 9999, MANY, "9999 bytes after the last"),
    "a remark first": (b"; by hand\n" + write_text("stl", ROUND, ROUND_FACES).encode(), MANY, ""),
    "no solid first": (write_text("stl", ROUND, ROUND_FACES).encode()[8:], MANY, ""),
}


@pytest.mark.parametrize("name", STLS)
def test_an_odd_stl_opens(name, tmp_path):
    content, triangles, note = STLS[name]
    path = tmp_path / "a.stl"
    path.write_bytes(content)

    scene = read_mesh(path)

    assert [len(part.mesh.triangles) for part in scene.parts] == [triangles]
    assert not note or any(text.startswith(note) for text in scene.notes), scene.notes


def test_two_binary_stl_in_one_file_are_two_parts(tmp_path):
    write_stl(tmp_path / "a.stl", TETRAHEDRON, TETRAHEDRON_FACES)
    write_stl(tmp_path / "b.stl", TETRAHEDRON + 200.0, TETRAHEDRON_FACES)
    both = (tmp_path / "a.stl").read_bytes() + (tmp_path / "b.stl").read_bytes()
    (tmp_path / "both.stl").write_bytes(both)

    assert [p.name for p in read_mesh(tmp_path / "both.stl").parts] == ["both", "both (2)"]


@pytest.mark.parametrize(
    ("content", "got"),
    [
        (b"<!DOCTYPE html>\n<html>not found</html>\n" * 9, "'<!DOCTYPE html>'"),
        (b"version https://git-lfs.github.com/spec/v1\noid 1\nsize 12345\n", "'version https"),
        (binary_stl(stated=2 * MANY), f"{2 * MANY} triangles in"),
    ],
)
def test_what_is_no_stl_is_refused_with_how_it_begins(content, got, tmp_path):
    path = tmp_path / "a.stl"
    path.write_bytes(content)

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert refusal.value.got.startswith(got)


# ---------------------------------------------------------------- PLY


def ply(order: str, kind: str = "float", corner: str = "int", end: str = "\n",
        stretch: bytes = b"") -> bytes:  # fmt: skip
    """A tetrahedron with colours, a list and an element that nobody asked for."""
    head = ["ply", f"format {order} 1.0", "comment TextureFile a.png", "obj_info 1"]
    head += ["element camera 1", "property list uchar short k", f"element vertex {4}"]
    head += [*(f"property {kind} {axis}" for axis in "xyz"), "property uchar red"]
    head += ["property uchar green", "property uchar blue", "element face 4", "property uchar flag"]
    head += [f"property list uchar {corner} vertex_indices", "end_header"]
    sign = "<" if "little" in order else ">"
    letter = {"float": "f", "double": "d"}[kind], {"int": "i", "uint": "I", "ushort": "H"}[corner]
    body = struct.pack(f"{sign}B2h", 2, 7, -1)
    for p in TETRAHEDRON:
        body += struct.pack(f"{sign}3{letter[0]}3B", *p, 255, 102, 0)
    for face in TETRAHEDRON_FACES.tolist():
        body += struct.pack(f"{sign}BB3{letter[1]}", 9, 3, *face)
    return (end.join(head) + end).encode() + body + stretch


LITTLE, BIG = "binary_little_endian", "binary_big_endian"
PLYS = [
    ply(LITTLE), ply(BIG), ply(LITTLE, "double"), ply(BIG, "double", "uint"),
    ply(LITTLE, corner="ushort"), ply(LITTLE, end="\r\n"), ply(BIG, stretch=b"\0\0\0"),
]  # fmt: skip


@pytest.mark.parametrize("content", PLYS)
def test_a_binary_ply_is_the_same_surface_and_has_its_colour(content, tmp_path):
    path = tmp_path / "a.ply"
    path.write_bytes(content)

    scene = read_mesh(path)

    assert corners_of(join_parts(scene).mesh) == EXPECTED
    assert scene.parts[0].colour == pytest.approx((1.0, 0.4, 0.0))
    assert any("pictures of PLY files stay behind" in note for note in scene.notes)


def test_strips_of_a_ply_are_triangles_that_face_one_side(tmp_path):
    path = tmp_path / "a.ply"
    head = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
    head += "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
    points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n"
    path.write_text(f"{head}end_header\n{points}9 0 1 2 3 4 -1 0 1 2\n", encoding="utf-8")

    mesh = read_mesh(path).parts[0].mesh

    x = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]
    up = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])[:, 2]
    assert up.tolist() == [1.0, 1.0, 1.0, 1.0]


@pytest.mark.parametrize(
    ("text", "where", "got"),
    [
        ("plyx\n", "line 1", "'plyx'"),
        ("ply\nformat utf8 1.0\n", "line 2", "'format utf8 1.0'"),
        ("ply\nformat ascii 1.0\nelement vertex many\n", "line 3", "'element vertex many'"),
        ("ply\nelement vertex 1\nproperty complex x\n", "line 3", "'property complex x'"),
        ("ply\nelement vertex 1\nend_header\n", "line 3", "'end_header'"),
        ("ply\nformat ascii 1.0\n", "line 2", "'the end of the file'"),
        ("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "header",
         "vertices without x, y, z"),
        ("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n1 2 b\n", "line 8", "'b'"),
    ],
)  # fmt: skip
def test_a_ply_is_refused_with_its_line(text, where, got, tmp_path):
    path = tmp_path / "a.ply"
    path.write_text(text, encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert (refusal.value.where, refusal.value.got) == (where, got)


def test_a_text_stl_filled_up_with_nuls_is_read(tmp_path):
    path = tmp_path / "a.stl"
    text = write_text("stl", TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_bytes(text.encode() + bytes(200))

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize(
    ("kind", "word"), [("stl", "vertex \x1b[2J\x07 0 0"), ("obj", "f \x1b[2J 1 2")]
)
def test_no_refusal_sends_control_characters(kind, word, tmp_path):
    path = tmp_path / f"a.{kind}"
    path.write_text(("solid a\n" if kind == "stl" else "") + word + "\n", encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert refusal.value.got.isprintable()


def test_a_ply_may_name_its_coordinates_in_capitals(tmp_path):
    path = tmp_path / "a.ply"
    text = write_text("ply", TETRAHEDRON, TETRAHEDRON_FACES)
    for axis in "xyz":
        text = text.replace(f"double {axis}", f"double {axis.upper()}")
    path.write_text(text.replace("vertex_index", "Vertex_Index"), encoding="utf-8")

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


def test_a_ply_may_have_its_faces_first(tmp_path):
    path = tmp_path / "a.ply"
    points = [numbers(p) for p in TETRAHEDRON]
    rows = ["3 " + " ".join(map(str, face)) for face in TETRAHEDRON_FACES.tolist()]
    head = ["ply", "format ascii 1.0", "element face 4", "property list uchar int vertex_index"]
    head += ["element vertex 4", *(f"property double {axis}" for axis in "xyz"), "end_header"]
    path.write_text("\n".join([*head, *rows, *points]) + "\n", encoding="utf-8")

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


def test_an_obj_may_have_its_faces_first(tmp_path):
    path = tmp_path / "a.obj"
    lines = write_text("obj", TETRAHEDRON, TETRAHEDRON_FACES).splitlines()
    path.write_text("\n".join(sorted(lines, key=lambda line: line[0])) + "\n", encoding="utf-8")

    scene = read_mesh(path)

    assert corners_of(join_parts(scene).mesh) == EXPECTED
    assert scene.notes == []


def test_an_obj_that_counts_from_0_is_read_so_with_a_note(tmp_path):
    path = tmp_path / "a.obj"
    lines = [f"v {numbers(p)}" for p in ROUND]
    lines += ["f " + " ".join(f"{i}/{i}" for i in face) for face in ROUND_FACES.tolist()]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    scene = read_mesh(path)

    assert scene.notes == ["its faces count vertices from 0 and were read so"]
    assert np.asarray(scene.parts[0].mesh.triangles).tolist() == ROUND_FACES.tolist()


def test_a_stray_0_in_an_obj_is_left_out(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(write_text("obj", ROUND, ROUND_FACES) + "f 0 1 2\n", encoding="utf-8")

    (note,) = read_mesh(path).notes

    assert note.startswith("1 of ") and "got vertex 0" in note


# ---------------------------------------------------------------- formats of few organs


def list_indices(form: str, between: str = "") -> str:
    return between.join(form % tuple(face) for face in TETRAHEDRON_FACES.tolist())


def list_points(form: str, between: str = "") -> str:
    return between.join(form % tuple(p) for p in TETRAHEDRON.tolist())


def write_x3d(path: Path) -> None:
    path.write_text(
        '<?xml version="1.0"?><X3D version="3.0"><Scene><Shape DEF="organ"><IndexedFaceSet '
        f'coordIndex="{list_indices("%d %d %d -1 ")}"><Coordinate point="{numbers(TETRAHEDRON)}"/>'
        "</IndexedFaceSet></Shape></Scene></X3D>",
        encoding="utf-8",
    )


def write_amf(path: Path, root: str = '<amf unit="millimeter">') -> None:
    corner = "<vertex><coordinates><x>%g</x><y>%g</y><z>%g</z></coordinates></vertex>"
    face = "<triangle><v1>%d</v1><v2>%d</v2><v3>%d</v3></triangle>"
    path.write_text(
        f'<?xml version="1.0"?>{root}<object id="1"><mesh><vertices>'
        f"{list_points(corner)}</vertices><volume>{list_indices(face)}</volume></mesh></object></amf>",
        encoding="utf-8",
    )


def write_3mf(path: Path, root: str = '<model unit="millimeter">') -> None:
    """A zip of XML."""
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    model = (
        f'<?xml version="1.0"?>{root[:-1]} xmlns="{core}"><resources>'
        '<object id="1" type="model" name="organ"><mesh><vertices>'
        + list_points('<vertex x="%g" y="%g" z="%g"/>')
        + "</vertices><triangles>"
        + list_indices('<triangle v1="%d" v2="%d" v3="%d"/>')
        + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
    )
    of = "http://schemas.openxmlformats.org/package/2006/relationships"
    kind = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        link = f'<Relationship Target="/3D/3dmodel.model" Id="r" Type="{kind}"/>'
        links = f'<Relationships xmlns="{of}">{link}</Relationships>'
        file.writestr("_rels/.rels", f'<?xml version="1.0"?>{links}')
        file.writestr("3D/3dmodel.model", model)


def write_ac(path: Path) -> None:
    colour = "rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0"
    head = f'AC3Db\nMATERIAL "" {colour}\nOBJECT world\nkids 1\nOBJECT poly\nname "organ"\n'
    faces = list_indices("SURF 0x0\nmat 0\nrefs 3\n%d 0 0\n%d 0 0\n%d 0 0\n")
    points = list_points("%g %g %g\n")
    path.write_text(f"{head}numvert 4\n{points}numsurf 4\n{faces}kids 0\n", encoding="utf-8")


def write_x(path: Path) -> None:
    points, faces = list_points("%g;%g;%g;", ",\n"), list_indices("3;%d,%d,%d;", ",\n")
    path.write_text(
        f"xof 0303txt 0032\nMesh organ {{\n4;\n{points};\n4;\n{faces};\n}}\n", encoding="utf-8"
    )


@pytest.mark.parametrize("write", [write_x3d, write_3mf, write_amf, write_ac, write_x])
def test_what_assimp_reads_of_other_programs_opens_too(write, tmp_path):
    path = tmp_path / f"a.{write.__name__.removeprefix('write_')}"
    write(path)

    report = import_mesh(path, unit="mm", up="z").report

    assert (report.triangles, report.closed, report.outward) == (4, True, True)
    # |det|/6 by hand, however the format has its axes
    assert report.volume_ml == pytest.approx(100.0 * 60.0 * 40.0 / 6.0 * 1e-3)


@pytest.mark.parametrize(
    ("name", "said", "unit"),
    [
        ("3mf", 'unit="inch"', "in"),
        ("3mf", "unit = 'micron'", "um"),
        ("3mf", 'xml:lang="unit" unit="centimeter"', "cm"),
        ("3mf", 'unit="foot"', "ft"),
        ("3mf", 'unit="meter"', "m"),
        ("3mf", "", "mm"),
        ("amf", 'version="1.1" unit="inch"', "in"),
        ("amf", 'unit="micron"', "um"),
        ("amf", 'unit="feet"', "ft"),
        ("amf", "", "mm"),
    ],
)
def test_3mf_and_amf_say_their_unit(name, said, unit, tmp_path):
    path = tmp_path / f"a.{name}"
    tag = "model" if name == "3mf" else "amf"
    root = f'<!-- <{tag} unit="meter"> -->\n<{tag} {said}>'
    (write_3mf if name == "3mf" else write_amf)(path, root)

    scene = read_mesh(path)
    organ = join_parts(scene)

    assert (scene.unit, scene.notes) == (unit, [])
    assert (organ.unit, organ.unit_guessed) == (unit, False)
    x = np.vstack([np.asarray(part.mesh.vertices) for part in scene.parts])
    assert np.allclose(np.ptp(x, axis=0), np.ptp(TETRAHEDRON, axis=0))  # nothing scales it twice


def test_a_3mf_of_an_unknown_unit_is_guessed_with_a_note(tmp_path):
    write_3mf(tmp_path / "a.3mf", '<model unit="cubit">')

    scene = read_mesh(tmp_path / "a.3mf")

    assert scene.unit is None
    assert scene.notes == ["states a unit of 'cubit', which has no name here"]


@pytest.mark.parametrize("write", [write_x3d, write_3mf, write_amf, write_ac, write_x])
def test_such_a_file_cut_anywhere_is_read_or_refused(write, tmp_path):
    path = tmp_path / f"a.{write.__name__.removeprefix('write_')}"
    write(path)
    content = path.read_bytes()
    for end in np.linspace(1, len(content) - 2, 6).astype(int):
        path.write_bytes(content[:end])
        try:
            read_mesh(path)
        except palpate.FileError as refusal:
            assert refusal.got and refusal.expected and "ended with code" not in refusal.got


# ---------------------------------------------------------------- glTF


def read_glb(path: Path) -> tuple[dict, bytes]:
    content = path.read_bytes()
    (size,) = struct.unpack_from("<I", content, 12)
    return json.loads(content[20 : 20 + size]), content[28 + size :]


def test_a_gltf_that_would_be_misread_is_refused_with_what_it_needs(tmp_path):
    name = "EXT_meshopt_compression"
    write_glb(tmp_path / "a.glb", TETRAHEDRON, TETRAHEDRON_FACES)
    scene, binary = read_glb(tmp_path / "a.glb")
    scene["extensionsRequired"] = [name]
    uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    scene["buffers"][0]["uri"] = uri
    (tmp_path / "a.gltf").write_text(json.dumps(scene), encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(tmp_path / "a.gltf")

    assert (refusal.value.where, refusal.value.got) == ("extensionsRequired", name)


def test_a_gltf_of_version_1_is_refused_with_what_would_do(tmp_path):
    (tmp_path / "a.gltf").write_text(
        json.dumps({"asset": {"version": "1.0"}, "meshes": {}}), encoding="utf-8"
    )

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(tmp_path / "a.gltf")

    assert (refusal.value.where, refusal.value.got) == ("asset", "version 1.0")
    assert "glTF 2.0" in refusal.value.expected


@pytest.mark.parametrize("name", ["a.vti", "a.nii.gz", "a.mha"])
def test_a_volume_is_refused_with_the_verb_that_cuts_a_surface_out_of_it(name, tmp_path):
    (tmp_path / name).write_bytes(b"a scan")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(tmp_path / name)

    assert refusal.value.got == "a volume of voxels"
    assert "palpate segment" in refusal.value.expected


def test_a_gltf_finds_its_buffer_by_a_name_with_a_blank_and_tells_of_other_scenes(tmp_path):
    write_glb(tmp_path / "a.glb", TETRAHEDRON, TETRAHEDRON_FACES)
    scene, binary = read_glb(tmp_path / "a.glb")
    (tmp_path / "my mesh.bin").write_bytes(binary)
    scene["buffers"][0]["uri"] = "my%20mesh.bin"
    scene["scenes"].append({"nodes": []})
    (tmp_path / "a.gltf").write_text(json.dumps(scene), encoding="utf-8")

    read = read_mesh(tmp_path / "a.gltf")

    assert [len(part.mesh.triangles) for part in read.parts] == [4]
    assert "of its 2 scenes the usual one was read" in read.notes
