# SPDX-License-Identifier: GPL-3.0-or-later
"""No file and no reader can take the program along: all is refused in words."""

from __future__ import annotations

import os
import stat
import struct
from pathlib import Path

import numpy as np
import palpate
import pytest
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, write_obj, write_stl
from palpate_editor.authoring import READER, join_parts, read_mesh


@pytest.mark.parametrize(
    ("name", "content", "found"),
    [
        ("empty.obj", b"", "0 bytes"),
        ("noise.stl", bytes(range(256)) * 4, "triangles in 1024 bytes"),
        ("short.stl", b"\0" * 20, "20 bytes"),
        ("organ.xyz", b"0 0 0", "the extension .xyz"),
        ("organ", b"0 0 0", "no extension"),
        ("points.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", ""),
        ("index.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", ""),
    ],
)
def test_what_is_not_a_mesh_is_refused_in_words(name, content, found, tmp_path):
    path = tmp_path / name
    path.write_bytes(content)

    with pytest.raises(palpate.FileError) as refusal:
        join_parts(read_mesh(path))

    assert refusal.value.file == str(path)
    assert found in refusal.value.got
    assert refusal.value.expected


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    with pytest.raises(palpate.FileError, match="no such file"):
        read_mesh(tmp_path / "organ.obj")
    (tmp_path / "folder.obj").mkdir()
    with pytest.raises(palpate.FileError, match="not a regular file"):
        read_mesh(tmp_path / "folder.obj")


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize(("write", "name"), [(write_stl, "a.stl"), (write_obj, "a.obj")])
def test_a_vertex_that_lies_nowhere_goes_with_its_triangles_and_a_note(
    write, name, wrong, tmp_path
):
    path = tmp_path / name
    points = TETRAHEDRON.copy()
    points[3, 1] = wrong
    write(path, points, TETRAHEDRON_FACES)

    scene = read_mesh(path)

    [part] = scene.parts
    left = [t for t in TETRAHEDRON_FACES if 3 not in t]
    assert len(part.mesh.triangles) == len(left) == 1
    assert np.array_equal(
        sorted(part.mesh.vertices[part.mesh.triangles[0]].tolist()),
        sorted(TETRAHEDRON[left[0]].tolist()),
    )
    of_each = 3 if name.endswith("stl") else 1  # STL has each triangle's corners to itself
    [note] = scene.notes
    assert note.startswith(f"{of_each} vertices without finite coordinates were left out, with 3 ")
    assert "the first is part 'a', vertex " in note


def test_a_file_of_nowhere_is_refused_with_its_place(tmp_path):
    path = tmp_path / "organ.stl"
    write_stl(path, np.full_like(TETRAHEDRON, np.nan), TETRAHEDRON_FACES)

    with pytest.raises(palpate.FileError, match="not a finite number") as refusal:
        read_mesh(path)

    assert refusal.value.where == "part 'organ', vertex 0"


def test_an_stl_that_promises_more_triangles_than_it_has_is_refused(tmp_path):
    path = tmp_path / "organ.stl"
    write_stl(path, TETRAHEDRON, TETRAHEDRON_FACES)
    path.write_bytes(path.read_bytes()[:-30])

    with pytest.raises(palpate.FileError, match="4 triangles in 254 bytes"):
        read_mesh(path)


def program(path: Path, lines: str) -> Path:
    path.write_text(f"#!/bin/sh\n{lines}\n", encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.fixture
def organ(tmp_path: Path) -> Path:
    path = tmp_path / "organ.obj"
    write_obj(path, TETRAHEDRON, TETRAHEDRON_FACES)
    return path


def test_a_reader_that_hangs_is_stopped(organ, tmp_path):
    reader = program(tmp_path / "reader", "echo $$ > pid; exec sleep 600")
    here = Path.cwd()
    os.chdir(tmp_path)
    try:
        with pytest.raises(palpate.FileError, match=r"still being read after 0\.5 s"):
            read_mesh(organ, reader=reader, time_limit=0.5)
    finally:
        os.chdir(here)

    # gone, and waited for
    assert not Path(f"/proc/{(tmp_path / 'pid').read_text(encoding='utf-8').strip()}").exists()


def test_a_reader_that_crashes_is_told_from_one_that_refuses(organ, tmp_path):
    with pytest.raises(palpate.FileError, match="crashes the reader"):
        read_mesh(organ, reader=program(tmp_path / "reader", "kill -SEGV $$"))


MAGIC = struct.pack("<Q", 0x33454E4543534C50)


@pytest.mark.parametrize(
    "stream",
    [
        b"",
        MAGIC,
        b"not a stream at all",
        MAGIC + struct.pack("<III", 0, 0, 0xFFFFFFFF),
        MAGIC + struct.pack("<IIIII", 0, 0, 0, 0, 0xFFFFFFFF),
        MAGIC + struct.pack("<IIIIIII", 0, 0, 0, 0, 1, 0, 0xFFFFFFFF) + b"\0" * 64,
        MAGIC + struct.pack("<IIIII", 0, 0, 0, 0, 0xFFFFFFFF),
        MAGIC + struct.pack("<IIIIII", 0, 0, 0, 0, 0, 0xFFFFFFFF),
        MAGIC + struct.pack("<8I", 0, 0, 0, 0, 0, 0, 0, 0) + MAGIC + b"more",
    ],
)
def test_a_stream_that_lies_about_its_counts_is_refused(stream, organ, tmp_path):
    (tmp_path / "stream").write_bytes(stream)
    reader = program(tmp_path / "reader", f"cat '{tmp_path / 'stream'}'")

    with pytest.raises(palpate.FileError, match="half way"):
        read_mesh(organ, reader=reader)


def test_a_stream_with_an_index_out_of_range_is_refused(organ, tmp_path):
    reader = write_stream(tmp_path, corner=3)

    with pytest.raises(palpate.FileError, match="vertex 3"):
        read_mesh(organ, reader=reader)


def write_stream(tmp_path: Path, corner: int, paint: bytes = struct.pack("<II", 0, 0)) -> Path:
    """A reader that says one triangle, without groups, colour, pictures and tetrahedra."""
    part = struct.pack("<I4sIII9dI3i", 4, b"part", 0, 0, 3, *range(9), 1, 0, 1, corner) + paint
    head, rest = struct.pack("<IIIII", 0, 0, 0, 0, 1), struct.pack("<III", 0, 0, 0)
    (tmp_path / "stream").write_bytes(MAGIC + head + part + rest + MAGIC)
    return program(tmp_path / "reader", f"cat '{tmp_path / 'stream'}'")


@pytest.mark.parametrize(
    ("corners", "pictures"),
    [(2, [-1]), (3, [0]), (3, []), (0, [-1]), (3, [-2])],
    ids=["too few", "no such picture", "none for it", "a picture alone", "below none"],
)
def test_paint_of_other_triangles_or_pictures_is_refused(corners, pictures, organ, tmp_path):
    paint = struct.pack(f"<I{5 * corners}f", corners, *([0.5] * 5 * corners))
    paint += struct.pack(f"<I{len(pictures)}i", len(pictures), *pictures)
    reader = write_stream(tmp_path, 2, paint)

    with pytest.raises(palpate.FileError, match="colours of other triangles"):
        read_mesh(organ, reader=reader)


def test_paint_of_no_numbers_is_left_out(organ, tmp_path):
    paint = struct.pack("<I15fIi", 3, *([np.nan] * 15), 1, -1)

    part = read_mesh(organ, reader=write_stream(tmp_path, 2, paint)).parts[0]

    assert len(part.paint) == 0 and len(part.pictures) == 0


def test_a_missing_reader_is_named(organ, tmp_path):
    with pytest.raises(palpate.FileError, match="palpate-read-mesh"):
        read_mesh(organ, reader=tmp_path / "nowhere")


def test_a_reader_keeps_to_its_memory(tmp_path):
    path = tmp_path / "organ.stl"
    count = 200_000
    path.write_bytes(b" " * 80 + struct.pack("<I", count) + b"\0" * (50 * count))

    with pytest.raises(palpate.FileError):
        read_mesh(path, memory_limit=20_000_000)


@pytest.mark.parametrize("limits", [{"time_limit": 0.0}, {"time_limit": float("nan")}])
def test_limits_that_are_no_limits_are_refused(limits, organ):
    with pytest.raises(ValueError, match="time_limit"):
        read_mesh(organ, **limits)


def test_the_reader_is_found_beside_the_package():
    assert os.access(READER, os.X_OK)
