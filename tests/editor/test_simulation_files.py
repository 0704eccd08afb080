# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of simulations, brains and old scenes come in as organs, or are refused in a sentence."""

from __future__ import annotations

import gzip
import re
from pathlib import Path

import numpy as np
import palpate
import pytest
from cell_files import SKIN, SQUARES, TETRAHEDRA, TRIANGLES, X
from palpate_editor.authoring import import_scene, read_mesh
from palpate_editor.formats import EXTENSIONS, find_format, is_mesh
from palpate_editor.formats_child import packed
from palpate_editor.formats_child.child import choose_reader
from palpate_editor.formats_child.scene import Refusal
from simulation_files import FILES
from test_cell_files import check_ball
from tiers import keep_everyday


def write(name: str, folder: Path) -> Path:
    """The file that is opened, with those beside it."""
    paths = []
    for file, content in FILES[name]().items():
        path = folder / file
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        paths.append(path)
    return paths[0]


SPAWNED = ("Medit, tetrahedra", "TetGen from 1", "VRML 2", "packed Abaqus", "LightWave")
"""Read by another process every day, with what lies beside them; the others at a landing."""
VTK_READ = ("XDMF", "VTK, blocks")
"""VTK is imported by no process that runs tests."""
HERE = [name for name in FILES if name not in (*VTK_READ, "LightWave", "packed Abaqus")]


@pytest.mark.parametrize("name", keep_everyday(FILES, SPAWNED))
def test_the_ball_becomes_an_organ_from_every_format(name, tmp_path):
    scene = read_mesh(write(name, tmp_path))
    organ = import_scene(scene, unit=None if scene.unit else "mm")

    assert len(scene.parts) == 1
    assert (organ.report.closed, organ.report.outward) == (True, True)
    check_ball(1e3 * np.asarray(organ.mesh.vertices), np.asarray(organ.mesh.triangles), False)


@pytest.mark.parametrize("name", HERE)
def test_the_ball_is_read_whole_from_every_format(name, tmp_path):
    path = write(name, tmp_path)

    part = choose_reader(find_format(path))(str(path)).parts[0]

    check_size(part.vertices, part.triangles)


def check_size(x: np.ndarray, triangles: np.ndarray) -> None:
    """As many triangles as the outside of the ball has, and its area within a twentieth: squares
    are cut along other diagonals."""
    assert len(triangles) == TRIANGLES
    scale = 1e3 if np.abs(x).max() > 1e3 else 1.0  # openCARP's micrometres
    assert measure_area(x / scale, triangles) == pytest.approx(measure_area(X, SKIN), rel=0.05)


def measure_area(x: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = (x[triangles[:, i]] for i in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


LENIENT = ("XDMF", "VTK, blocks")
"""Whose readers take what a number begins with; a file that ends too early they do refuse."""


def spoil(content: bytes, name: str) -> bytes:
    """With a letter in the number that stands at two thirds of a text, else cut off there."""
    found = list(re.finditer(rb"(?<=[\s,])\d\d+(?=[\s,])|\d\.\d\d+", content))
    if name in LENIENT or not found or b"\0" in content:
        return content[: 2 * len(content) // 3]
    at = found[2 * len(found) // 3].end() - 1
    return content[:at] + b"x" + content[at + 1 :]


@pytest.mark.parametrize("name", HERE)
def test_a_damaged_twin_is_refused_in_a_sentence(name, tmp_path):
    path = write(name, tmp_path)
    path.write_bytes(spoil(path.read_bytes(), name))

    with pytest.raises(Refusal) as refusal:
        choose_reader(find_format(path))(str(path))

    assert refusal.value.got and refusal.value.expected


@pytest.mark.parametrize("name", keep_everyday(FILES, ("packed Abaqus", "XDMF")))
def test_a_damaged_twin_is_refused_by_the_process_that_reads(name, tmp_path):
    path = write(name, tmp_path)
    path.write_bytes(spoil(path.read_bytes(), name))

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(path)

    assert refusal.value.file == str(path)
    assert refusal.value.got and refusal.value.expected
    assert "fails on" not in refusal.value.got and "crashes" not in refusal.value.got


def test_what_a_file_is_its_content_tells_where_its_name_does_not(tmp_path):
    told = {}
    for name in FILES:
        folder = tmp_path / str(len(told))
        folder.mkdir()
        path = write(name, folder)
        told[name] = find_format(path)

    assert told["Medit, faces"] == told["no extension, Medit"] == told["Netgen, neutral"] == "MEDIT"
    assert (told["Fluent"], told["AVS UCD"], told["Abaqus"]) == ("FLUENT", "UCD", "ABAQUS")
    assert told["FreeSurfer, a name of its own"] == "FREESURFER"
    (tmp_path / "notes").write_text("solid advice: eat less\n", encoding="utf-8")
    assert find_format(tmp_path / "notes") is None and not is_mesh(tmp_path / "notes")


@pytest.mark.parametrize("extension", ["stl", "obj", "ply", "off", "glb"])
def test_a_mesh_under_a_name_of_its_own_is_read(extension, tmp_path):
    from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, WRITERS

    plain = tmp_path / f"a.{extension}"
    WRITERS[extension](plain, TETRAHEDRON, TETRAHEDRON_FACES)
    for name in ("a", "a.mesh_of_today", "a.bak"):
        plain.with_name(name).write_bytes(plain.read_bytes())

        assert len(read_mesh(plain.with_name(name)).parts[0].mesh.triangles) == 4


def test_every_extension_is_named_where_one_is_refused(tmp_path):
    (tmp_path / "a.doc").write_text("a letter", encoding="utf-8")

    with pytest.raises(palpate.FileError) as refusal:
        read_mesh(tmp_path / "a.doc")

    assert sorted(refusal.value.expected.split(": ")[1].split()) == sorted(
        f".{extension}" for extension in EXTENSIONS
    )


def test_an_instance_of_abaqus_is_moved_and_then_turned(tmp_path):
    x = np.asarray(read_mesh(write("Abaqus, parts", tmp_path)).parts[0].mesh.vertices)

    # (x + 5, y, z), then by 90 degrees about (10, 0): (10 - y, x + 5 - 10, z)
    assert np.sort(x[:, 0]).tolist() == pytest.approx(np.sort(10.0 - used(X)[:, 1]).tolist())
    assert np.sort(x[:, 1]).tolist() == pytest.approx(np.sort(used(X)[:, 0] - 5.0).tolist())


def used(x: np.ndarray) -> np.ndarray:
    """Those on the outside, which alone are kept."""
    return x[np.unique(SQUARES)]


def test_vrml_is_turned_as_its_nodes_say_and_has_its_colour(tmp_path):
    part = read_mesh(write("VRML 2", tmp_path)).parts[0]
    x = np.asarray(part.mesh.vertices)

    # twice the half, by 90 degrees about z, and 100 along x
    assert np.sort(x[:, 0]).tolist() == pytest.approx(np.sort(100.0 - used(X)[:, 1]).tolist())
    assert (part.name, part.colour) == ("Liver", pytest.approx((0.6, 0.2, 0.1)))


def test_tetrahedra_of_a_simulation_fill_the_organ(tmp_path):
    scene = read_mesh(write("FreeSurfer", tmp_path))
    assert (scene.unit, scene.up, len(scene.filling.tetrahedra)) == ("mm", "z", 0)

    scene = read_mesh(write("openCARP", tmp_path))
    assert (scene.unit, len(scene.filling.tetrahedra)) == ("um", len(TETRAHEDRA))


def test_a_part_that_lies_in_no_file_beside_it_is_said(tmp_path):
    path = write("TetGen from 1", tmp_path)
    (tmp_path / "ball.node").unlink()

    with pytest.raises(palpate.FileError, match=r"no ball\.node beside it"):
        read_mesh(path)


def test_a_packed_file_that_grows_beyond_all_measure_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(packed, "MOST_BYTES", 100_000)
    (tmp_path / "a.obj.gz").write_bytes(gzip.compress(b"v 0 0 0\n" * 100_000))

    with pytest.raises(palpate.FileError, match="more than 0 MB once it is unpacked"):
        read_mesh(tmp_path / "a.obj.gz")


def test_the_page_of_the_editor_lists_every_extension():
    page = (Path(__file__).parents[2] / "editor" / "README.md").read_text(encoding="utf-8")
    table = page.split("Mesh files that are read\n")[1].split("\n## ")[0]

    assert set(re.findall(r"`\.([\w]+)`", table)) >= set(EXTENSIONS)
