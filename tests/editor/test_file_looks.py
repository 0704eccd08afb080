# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of a file come along as the organ's appearance; what cannot come along is said once."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
import pytest
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, numbers, write_glb, write_obj, write_stl
from palpate_editor.appearance import read_styles
from palpate_editor.authoring import read_mesh
from palpate_editor.document import EMPTY
from palpate_editor.edits import import_file

LINEAR = (0.5, 0.1, 0.02)
SEEN = tuple(12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in LINEAR)
"""The same as sRGB, by its formula."""


def colour_glb(path: Path, **pbr: object) -> Path:
    """A glTF whose material says something."""
    write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES)
    content = path.read_bytes()
    size = struct.unpack("<I", content[12:16])[0]
    head = json.loads(content[20 : 20 + size])
    head["materials"] = [{"name": "tissue", "pbrMetallicRoughness": pbr}]
    head["meshes"][0]["primitives"][0]["material"] = 0
    if "baseColorTexture" in pbr:
        head["textures"] = [{"source": 0}]
        head["images"] = [{"uri": "skin.png"}]
    text = json.dumps(head).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + content[20 + size :]
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return path


def test_the_base_colour_of_gltf_is_turned_from_linear_to_srgb(tmp_path):
    path = colour_glb(tmp_path / "liver.glb", baseColorFactor=[*LINEAR, 1.0])

    assert read_mesh(path).parts[0].colour == pytest.approx(SEEN, abs=1e-5)
    organ = import_file(path)(EMPTY)
    assert organ.appearance.colour == pytest.approx(SEEN, abs=1e-5)
    # all else is that of the style its name asks for
    assert organ.appearance.gloss == read_styles()["liver"].appearance.gloss


@pytest.mark.parametrize("white", [True, False])
def test_a_file_that_says_no_colour_leaves_the_style_its_own(white, tmp_path):
    path = tmp_path / "liver.glb"
    if white:  # which is what glTF says where nobody chose one
        colour_glb(path, baseColorFactor=[1.0, 1.0, 1.0, 1.0])
    else:
        write_glb(path, TETRAHEDRON, TETRAHEDRON_FACES)

    assert read_mesh(path).parts[0].colour is None
    assert import_file(path)(EMPTY).appearance == read_styles()["liver"].appearance


def test_a_format_without_colours_says_none(tmp_path):
    write_stl(tmp_path / "liver.stl", TETRAHEDRON, TETRAHEDRON_FACES)

    assert read_mesh(tmp_path / "liver.stl").parts[0].colour is None


def test_an_organ_that_has_an_appearance_keeps_it(tmp_path):
    path = colour_glb(tmp_path / "liver.glb", baseColorFactor=[*LINEAR, 1.0])
    edit = import_file(path)
    stone = read_styles()["stone"].appearance
    from dataclasses import replace

    assert edit(replace(EMPTY, appearance=stone)).appearance == stone


def test_a_picture_that_is_not_there_is_said_once(tmp_path):
    path = colour_glb(
        tmp_path / "liver.glb", baseColorFactor=[*LINEAR, 1.0], baseColorTexture={"index": 0}
    )

    scene = read_mesh(path)

    assert scene.notes == ["the picture skin.png is not beside it or below its folder"]
    assert scene.parts[0].colour == pytest.approx(SEEN, abs=1e-5)


def test_materials_of_an_obj_colour_its_parts_by_area(tmp_path):
    path = tmp_path / "organ.obj"
    lines = [f"v {numbers(x)}" for x in TETRAHEDRON]
    faces = [f"f {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES + 1]
    lines += ["mtllib looks.mtl", "o one", "usemtl red", *faces[:2], "usemtl blue", *faces[2:]]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (tmp_path / "looks.mtl").write_text(
        "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0.1 0.1 0.8\nmap_Kd skin.png\n",
        encoding="utf-8",
    )
    x = TETRAHEDRON[TETRAHEDRON_FACES]
    area = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1)
    share = area[:2].sum() / area.sum()

    scene = read_mesh(path)

    expected = share * np.array([0.8, 0.1, 0.1]) + (1 - share) * np.array([0.1, 0.1, 0.8])
    assert scene.parts[0].colour == pytest.approx(expected)
    corners = np.asarray(scene.parts[0].paint)[:, 2:].reshape(-1, 3, 3)
    expected = np.repeat([(0.8, 0.1, 0.1), (0.1, 0.1, 0.8)], 2, axis=0)[:, None]
    assert np.allclose(corners, expected)


@pytest.mark.parametrize(
    ("line", "note"),
    [
        ("mtllib missing.mtl", "missing.mtl are not there"),
        ("mtllib ../outside.mtl", "outside.mtl are not there"),
    ],
)
def test_a_material_library_that_cannot_be_read_is_said(line, note, tmp_path):
    (tmp_path / "outside.mtl").write_text("newmtl red\nKd 0.8 0.1 0.1\n", encoding="utf-8")
    folder = tmp_path / "folder"
    folder.mkdir()
    path = folder / "organ.obj"
    write_obj(path, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_text(f"{line}\nusemtl red\n" + path.read_text(encoding="utf-8"), encoding="utf-8")

    scene = read_mesh(path)

    assert scene.parts[0].colour is None
    assert any(note in said for said in scene.notes)


@pytest.mark.parametrize("full", [1.0, 255.0])
def test_vertex_colours_of_an_obj_are_of_one_or_of_255(full, tmp_path):
    path = tmp_path / "organ.obj"
    colour = full * np.array([0.6, 0.4, 0.2])
    lines = [f"v {numbers(x)} {numbers(colour)}" for x in TETRAHEDRON]
    lines += [f"f {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES + 1]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    assert read_mesh(path).parts[0].colour == pytest.approx((0.6, 0.4, 0.2))


def test_a_weight_behind_a_vertex_is_no_colour(tmp_path):
    path = tmp_path / "organ.obj"
    lines = [f"v {numbers(x)} 1.0" for x in TETRAHEDRON]
    lines += [f"f {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES + 1]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    assert read_mesh(path).parts[0].colour is None


def test_vertex_colours_of_a_ply_come_along_as_their_mean(tmp_path):
    path = tmp_path / "organ.ply"
    head = ["ply", "format ascii 1.0", f"element vertex {len(TETRAHEDRON)}"]
    head += [f"property float {axis}" for axis in "xyz"]
    head += [f"property uchar {name}" for name in ("red", "green", "blue")]
    head += [f"element face {len(TETRAHEDRON_FACES)}"]
    head += ["property list uchar int vertex_indices", "end_header"]
    lines = head + [f"{numbers(x)} 153 51 102" for x in TETRAHEDRON]
    lines += [f"3 {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")

    assert read_mesh(path).parts[0].colour == pytest.approx((0.6, 0.2, 0.4), abs=0.003)


def test_colours_of_a_vtk_file_come_along(tmp_path):
    path = tmp_path / "organ.vtk"
    corners = "\n".join(f"3 {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES)
    path.write_text(
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
        f"{numbers(TETRAHEDRON)}\nPOLYGONS 4 16\n{corners}\nPOINT_DATA 4\n"
        "COLOR_SCALARS look 3\n" + "0.6 0.2 0.4\n" * 4,
        encoding="utf-8",
    )

    assert read_mesh(path).parts[0].colour == pytest.approx((0.6, 0.2, 0.4), abs=0.003)


def test_parts_of_different_colours_keep_them_and_the_organ_has_their_mean(tmp_path):
    path = tmp_path / "organ.obj"
    lines = [f"v {numbers(x)}" for x in [*TETRAHEDRON, *(TETRAHEDRON + [300.0, 0, 0])]]
    lines += ["mtllib looks.mtl", "o one", "usemtl red"]
    lines += [f"f {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES + 1]
    lines += ["o two", "usemtl blue", *(f"f {i} {j} {k}" for i, j, k in TETRAHEDRON_FACES + 5)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (tmp_path / "looks.mtl").write_text(
        "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0.2 0.1 0.5\n", encoding="utf-8"
    )

    whole = import_file(path)
    one = import_file(path, parts=["one"])

    # half of each by area, in linear light
    assert whole.colour == pytest.approx((0.60, 0.1, 0.37), abs=0.01)
    far = whole.surface.vertices[:, 0] > 0.2
    assert (whole.surface.colours == np.where(far[:, None], (51, 26, 128), (204, 26, 26))).all()
    assert any("one for each vertex" in note for note in whole.source.notes)
    assert one.colour == pytest.approx((0.8, 0.1, 0.1))
    assert one.surface.colours is None


def test_the_colours_of_real_organs_come_along(shared_data):
    """Its material says 0.4745, 0.2431, 0.2470, linear as glTF is."""
    colour = import_file(shared_data("organs/VH_F_Spleen.glb"))(EMPTY).appearance.colour

    assert colour == pytest.approx((0.7195, 0.5302, 0.5340), abs=2e-3)
