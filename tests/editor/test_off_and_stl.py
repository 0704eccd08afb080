# SPDX-License-Identifier: GPL-3.0-or-later
"""OFF and STL in their binary variants and in text, however programs write them."""

from __future__ import annotations

import struct

import palpate
import pytest
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, write_stl, write_text_stl
from palpate_editor.authoring import join_parts, read_mesh
from test_read_mesh import EXPECTED, corners_of


def write_binary_off(kind: str, *, colours: int = 0, trailing: bool = True) -> bytes:
    """As Geomview has it: four bytes each, the highest first."""
    lines = [f"{kind} BINARY\n".encode(), struct.pack(">3i", 4, 4, 6)]
    for x in TETRAHEDRON:
        lines.append(struct.pack(">3f", *x))
        lines.append(struct.pack(">3f", 0, 0, 1) if "N" in kind else b"")
        lines.append(struct.pack(">4f", 1, 0, 0, 1) if "C" in kind else b"")
    for corners in TETRAHEDRON_FACES:
        lines.append(struct.pack(">4i", 3, *corners))
        lines.append(struct.pack(f">i{colours}f", colours, *[0.5] * colours))
    return b"".join(lines) if trailing else b"".join(lines)[:-4]


@pytest.mark.parametrize(
    "content",
    [
        write_binary_off("OFF"), write_binary_off("COFF", colours=3), write_binary_off("CNOFF"),
        write_binary_off("NOFF", colours=4), write_binary_off("OFF", trailing=False),
    ],
)  # fmt: skip
def test_a_binary_off_is_the_same_surface(content, tmp_path):
    path = tmp_path / "a.off"
    path.write_bytes(content)

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize(
    ("content", "got"),
    [
        (write_binary_off("OFF")[:60], "the end of the file"),
        (b"OFF BINARY\n" + struct.pack(">3i", 2**30, 4, 6), "the end of the file"),
        (b"OFF BINARY\n" + struct.pack(">3i", -1, 4, 6), "-1"),
        (b"OFF BINARY\n" + struct.pack(">4i", 0, 1, 0, 2**30), "1073741824 corners"),
        (b"OFF BINARY\n" + struct.pack(">7i", 0, 1, 0, 3, 0, 1, 2), "vertex 0"),
    ],
)
def test_a_damaged_binary_off_is_refused_with_its_place(content, got, tmp_path):
    path = tmp_path / "a.off"
    path.write_bytes(content)

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert refusal.value.got == got and "after the first line" in refusal.value.where


@pytest.mark.parametrize("trailing", [b"", b"\r\n", b"\0" * 52])
def test_a_binary_stl_may_begin_like_text_and_go_on_behind_its_end(trailing, tmp_path):
    path = tmp_path / "a.stl"
    write_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_bytes(
        b"solid exported by a CAD program".ljust(80) + path.read_bytes()[80:] + trailing
    )

    assert corners_of(join_parts(read_mesh(path)).mesh) == EXPECTED


@pytest.mark.parametrize("stated", [0, 2**32 - 1])
def test_a_binary_stl_of_no_count_has_as_many_triangles_as_are_there(stated, tmp_path):
    path = tmp_path / "a.stl"
    write_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)
    content = path.read_bytes()
    path.write_bytes(content[:80] + struct.pack("<I", stated) + content[84:])

    scene = read_mesh(path)

    assert corners_of(join_parts(scene).mesh) == EXPECTED
    assert scene.notes == [f"states {stated} triangles, and 4 were read"]


def make_capitals(text: str) -> str:
    return text.upper()


def run_together(text: str) -> str:
    """All in one line but for the name of the solid."""
    head, _, rest = text.partition("\n")
    return f"{head}\n{' '.join(rest.split())}"


TEXT_STL = {
    "as it is": lambda text: text,
    "capitals": make_capitals,
    "one line": run_together,
    "a mark of UTF-8": lambda text: "\ufeff" + text,
    "lines of Windows": lambda text: text.replace("\n", "\r\n"),
    "no end": lambda text: text.rpartition("endsolid")[0],
    "normals of nobody": lambda text: text.replace("normal 0 0 0", "normal -1.#IND -1.#IND nan"),
    "facets without a normal": lambda text: text.replace("normal 0 0 0", ""),
    "colours": lambda text: text.replace("facet normal", "color 0.5 0 0\nfacet normal"),
}


@pytest.mark.parametrize("change", TEXT_STL.values(), ids=TEXT_STL)
def test_a_text_stl_is_the_same_surface_however_it_is_written(change, tmp_path):
    path = tmp_path / "a.stl"
    write_text_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_text(change(path.read_text(encoding="utf-8")), encoding="utf-8", newline="")

    scene = read_mesh(path)

    assert corners_of(join_parts(scene).mesh) == EXPECTED
    assert scene.parts[0].name.lower() == "organ"


@pytest.mark.parametrize(
    ("content", "where", "got"),
    [
        ("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nendloop\n", "line 5", "'endloop'"),
        (
            "SOLID a\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n",
            "line 4",
            "the end of the file",
        ),
        ("solid a\nfacett normal 0 0 1\n", "line 2", "'facett'"),
        ("solid a\n  vertex 0 0 zero\n", "line 2", "'zero'"),
        ("solid a\nendsolid a\n", "", "no triangles"),
    ],
)
def test_a_damaged_text_stl_is_refused_with_its_line(content, where, got, tmp_path):
    path = tmp_path / "a.stl"
    path.write_text(content, encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert (refusal.value.where, refusal.value.got) == (where, got)


def test_solids_of_one_name_are_parts_of_their_own(tmp_path):
    path = tmp_path / "a.stl"
    write_text_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_text(
        2 * path.read_text(encoding="utf-8")
        + path.read_text(encoding="utf-8").replace(" organ", ""),
        encoding="utf-8",
    )

    assert [part.name for part in read_mesh(path).parts] == ["organ", "organ (2)", "a"]


def test_a_number_too_near_to_zero_to_be_held_is_zero(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 1e-400\nv 100 -4e-324 0\nv 0 60 0\nf 1 2 3\n", encoding="utf-8")

    assert join_parts(read_mesh(path)).mesh.vertices[0][2] == 0.0

    path.write_text("v 0 0 1e400\nv 100 0 0\nv 0 60 0\nf 1 2 3\n", encoding="utf-8")
    with pytest.raises(palpate.FileError, match="'1e400'"):
        read_mesh(path)
