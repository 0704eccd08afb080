# SPDX-License-Identifier: GPL-3.0-or-later
"""The same surface in the spellings that programs of other people use."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, numbers
from palpate_editor.authoring import join_parts, read_mesh
from test_read_mesh import EXPECTED, corners_of

COUNT = len(TETRAHEDRON)
FACES = np.asarray(TETRAHEDRON_FACES)
POINTS = [f"v {numbers(p)}" for p in TETRAHEDRON]


def spell_obj(corner: str, extra: tuple[str, ...] = ()) -> str:
    """With `corner` for each corner of a face: {i} counts from 1, {n} from the end."""
    rows = [" ".join(corner.format(i=i + 1, n=i - COUNT) for i in face) for face in FACES.tolist()]
    return "\n".join([*POINTS, *extra, *(f"f {row}" for row in rows)]) + "\n"


PLACES = tuple(["vt 0.5 0.5"] * COUNT)
NORMALS = tuple(["vn 0 0 1"] * COUNT)
PLAIN = spell_obj("{i}")
OBJ = {
    "from the end": spell_obj("{n}"),
    "from the end with all three": spell_obj("{n}/{n}/{n}", PLACES + NORMALS),
    "normals": spell_obj("{i}//{i}", NORMALS),
    "places on a picture": spell_obj("{i}/{i}", PLACES),
    "an empty normal": spell_obj("{i}/{i}/", PLACES),
    "two empty": spell_obj("{i}//"),
    "the old word for a face": PLAIN.replace("f ", "fo "),
    "tabs": PLAIN.replace(" ", "\t"),
    "many blanks": PLAIN.replace(" ", "    ").replace("\n", "   \n"),
    "remarks behind": PLAIN.replace("\n", "   # a remark\n"),
    "a weight": PLAIN.replace("\nv ", " 1.0\nv "),
    "other things": "mtllib is not there.mtl\no left lobe\nusemtl a b\ns off\n"
    + PLAIN
    + "l 1 2\np 1\n",
    "no last line end": PLAIN.rstrip("\n"),
    "an old end of file": PLAIN + "\x1a",
    "zeros behind": PLAIN + "\0\0\0",
    "each face behind its points": "".join(
        "".join(f"v {numbers(TETRAHEDRON[i])}\n" for i in face) + "f -3 -2 -1\n"
        for face in FACES.tolist()
    ),
}


@pytest.mark.parametrize("text", OBJ.values(), ids=OBJ)
def test_an_obj_is_read_however_it_is_spelled(text, tmp_path):
    check(tmp_path / "a.obj", text.encode())


def check(path: Path, content: bytes) -> None:
    path.write_bytes(content)

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


SIZES = {"char": "b", "uchar": "B", "ushort": "H", "int": "i", "uint": "I", "float": "f",
         "double": "d", "uint8": "B", "int32": "i", "float32": "f", "float64": "d"}  # fmt: skip


def spell_ply(
    order: str,
    place: str = "float",
    count: str = "uchar",
    index: str = "int",
    *,
    name: str = "vertex_indices",
    vertex: tuple[str, ...] = (),
    before: tuple[str, ...] = (),
    after: tuple[str, ...] = (),
    head: str = "",
) -> bytes:
    """Binary; `vertex`, `before` and `after` are types of other properties, of vertices and around
    the list of faces."""
    lines = [f"property {place} {axis}" for axis in "xyz"]
    lines += [f"property {kind} v{i}" for i, kind in enumerate(vertex)]
    faces = [f"property {kind} b{i}" for i, kind in enumerate(before)]
    faces += [f"property list {count} {index} {name}"]
    faces += [f"property {kind} a{i}" for i, kind in enumerate(after)]
    way = "binary_little_endian" if order == "<" else "binary_big_endian"
    text = f"ply\nformat {way} 1.0\n{head}element vertex {COUNT}\n" + "\n".join(lines)
    text += f"\nelement face {len(FACES)}\n" + "\n".join(faces) + "\nend_header\n"
    row = struct.Struct(order + 3 * SIZES[place] + "".join(SIZES[k] for k in vertex))
    out = text.encode() + b"".join(row.pack(*p, *[1] * len(vertex)) for p in TETRAHEDRON)
    kinds = [*before, count, index, index, index, *after]
    row = struct.Struct(order + "".join(SIZES[k] for k in kinds))
    ones = [1] * len(before), [1] * len(after)
    return out + b"".join(row.pack(*ones[0], 3, *f, *ones[1]) for f in FACES.tolist())


PLY = {
    "small first": spell_ply("<"),
    "large first": spell_ply(">"),
    "doubles": spell_ply("<", "double"),
    "names of sizes": spell_ply("<", "float32", "uint8", "int32"),
    "short numbers": spell_ply(">", index="ushort"),
    "large counts": spell_ply("<", count="int", index="uint"),
    "the other name of the list": spell_ply("<", name="vertex_index"),
    "normals, colours and more": spell_ply("<", vertex=(*["float"] * 3, *["uchar"] * 4, "double")),
    "flags around a face": spell_ply("<", before=("uchar",), after=("int", "float")),
    "remarks": spell_ply("<", head="comment by a scanner\nobj_info num_cols 512\n"),
}  # fmt: skip


@pytest.mark.parametrize("content", PLY.values(), ids=PLY)
def test_a_binary_ply_is_read_whatever_else_it_has(content, tmp_path):
    check(tmp_path / "a.ply", content)


def spell_vtk(version: str) -> str:
    points = "\n".join(numbers(p) for p in TETRAHEDRON)
    rows = "\n".join("3 " + " ".join(map(str, face)) for face in FACES.tolist())
    return (
        f"# vtk DataFile Version {version}\na title\nASCII\nDATASET POLYDATA\n"
        f"POINTS {COUNT} float\n{points}\nPOLYGONS {len(FACES)} {4 * len(FACES)}\n{rows}\n"
    )


VTK = {
    **{version: spell_vtk(version) for version in ("1.0", "2.0", "3.0", "4.2")},
    "of Windows": spell_vtk("2.0").replace("\n", "\r\n"),
    "small letters": spell_vtk("3.0").replace("DATASET POLYDATA", "dataset polydata"),
    "values": spell_vtk("4.1")
    + f"POINT_DATA {COUNT}\nFIELD FieldData 1\na 1 {COUNT} float\n"
    + "0 " * COUNT
    + f"\nCELL_DATA {len(FACES)}\nSCALARS b int 1\nLOOKUP_TABLE default\n"
    + "0\n" * len(FACES),
}


@pytest.mark.parametrize(
    "name",
    [k if k in ("2.0", "values") else pytest.param(k, marks=pytest.mark.landing) for k in VTK],
)
def test_a_legacy_file_of_vtk_is_read_of_every_version(name, tmp_path):
    check(tmp_path / "a.vtk", VTK[name].encode())
