# SPDX-License-Identifier: GPL-3.0-or-later
"""However another program writes an organ of cells in a file of VTK or Gmsh, it comes in whole."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import cell_files
import numpy as np
import palpate
import pytest
from cell_files import MSH, TETRAHEDRA, TRIANGLES, VTK, msh2
from foreign_files import TETRAHEDRON, TETRAHEDRON_FACES, write_vtk, write_vtp, write_vtu
from palpate_editor.authoring import import_mesh, read_mesh
from palpate_editor.formats_child.gmsh_file import open_gmsh
from palpate_editor.formats_child.read_gmsh import read_gmsh
from palpate_editor.formats_child.scene import Refusal, Scene
from test_read_mesh import EXPECTED, corners_of

READ = """
import json, sys
from palpate_editor.formats_child.read_vtk import read_vtk
for path in sys.argv[1:]:
    scene = read_vtk(path, "VTK")
    part, = scene.parts
    print(json.dumps([part.vertices.tolist(), part.triangles.tolist(),
                      len(scene.filling.tetrahedra), scene.notes]))
"""
VOLUME = abs(
    np.linalg.det(np.diff(cell_files.X[TETRAHEDRA], axis=1)).sum() / 6.0
)  # [mm³] of all tetrahedra: the differences along each one's path span it


def write(content: str | bytes, path: Path) -> Path:
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def check_ball(vertices: np.ndarray, triangles: np.ndarray, is_exact: bool = True) -> None:
    """Closed, each edge once in each direction, as much inside as the cells have."""
    assert len(triangles) == TRIANGLES
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    keys = {tuple(side) for side in sides.tolist()}
    assert len(keys) == len(sides)
    assert all((b, a) in keys for a, b in keys)
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    inside = abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)
    # quadrilaterals are cut along other diagonals than the tetrahedra have
    assert inside == pytest.approx(VOLUME, rel=1e-6 if is_exact else 0.05)


@pytest.fixture(scope="module")
def scenes_of_vtk(tmp_path_factory) -> dict[str, list]:
    """What one process reads of all the files of VTK: to start one for each would take a minute."""
    folder = tmp_path_factory.mktemp("vtk")
    files = [write(make(), folder / f"{i}.vtk") for i, make in enumerate(VTK.values())]
    run = subprocess.run([sys.executable, "-P", "-c", READ, *map(str, files)],
                         capture_output=True, encoding="utf-8", check=False)  # fmt: skip
    assert run.returncode == 0, run.stderr[-2000:]
    return dict(zip(VTK, map(json.loads, run.stdout.splitlines()), strict=True))


QUADS = ("quadrilaterals", "hexahedra", "voxels", "wedges")


@pytest.mark.parametrize("name", VTK)
def test_a_ball_in_a_file_of_vtk_is_whole(name, scenes_of_vtk):
    vertices, triangles, filled, notes = scenes_of_vtk[name]

    check_ball(np.array(vertices), np.array(triangles), not name.startswith(QUADS))
    has_tetrahedra = "tetrahedra" in name or name == "values of no points"
    assert filled == (len(TETRAHEDRA) if has_tetrahedra else 0)
    strange = ("too few", "values of other", "values of an", "values of no", "an unknown")
    assert any("VTK says" in note for note in notes) == name.startswith(strange)


def check_scene(scene: Scene, name: str) -> None:
    points, rows = {}, []
    for part in scene.parts:  # each has vertices of its own
        for triangle in part.vertices[part.triangles].tolist():
            rows.append([points.setdefault(tuple(p), len(points)) for p in triangle])
    check_ball(np.array(list(points)), np.array(rows), not name.startswith(QUADS))


@pytest.mark.parametrize("name", MSH)
def test_a_ball_in_a_file_of_gmsh_is_whole(name, tmp_path):
    scene = read_gmsh(str(write(MSH[name](), tmp_path / "a.msh")))

    check_scene(scene, name)
    has_none = "faces" in name and "tetrahedra" not in name
    filled = 0 if has_none or name.startswith(QUADS) else len(TETRAHEDRA)
    assert len(scene.filling.tetrahedra) == filled
    lost = [note for note in scene.notes if "not there" in note]
    assert len(lost) == (name == "an element without its node")


def test_parts_of_volumes_have_the_names_of_their_groups(tmp_path):
    names = '$PhysicalNames\n2\n3 1 "left lobe"\n3 2 right\n$EndPhysicalNames\n'
    text = cell_files.msh4("4.1", cell_files.entities("1 1", "1 -1", "2 2 1"), names)

    scene = read_gmsh(str(write(text, tmp_path / "a.msh")))

    assert [part.name for part in scene.parts] == ["left lobe", "right"]


TEXT = msh2((4, (1, 1), TETRAHEDRA))
WRONG = {
    "no nodes": (TEXT.replace("$Nodes", "$Points"), "", "no $Nodes"),
    "no elements": (TEXT.replace("$Elements", "$Cells"), "", "no $Elements"),
    "half": (TEXT[: len(TEXT) // 2], "$Elements", "its end"),
    "half of the nodes": (TEXT[:1000], "$Nodes", "its end"),
    "a word": (TEXT.replace("-30 0 0", "thirty 0 0"), "$Nodes, line ", "'thirty'"),
    "a count without end": (TEXT.replace("$Nodes\n125", "$Nodes\n99999999999"), "$Nodes",
                            "its end"),
    "an unknown element": (TEXT.replace("1 4 2 1 1", "1 77 2 1 1", 1), "$Elements", "type 77"),
    "most without nodes": (TEXT.replace("$Nodes\n125\n1 ", "$Nodes\n125\n1000 "), "",
                           "points that are not there"),
    "half a node": (TEXT.replace("1 4 2 1 1 ", "1 4 2 1 1 0.5", 1), "$Elements", "0.5"),
    "no byte order": ("$MeshFormat\n2.2 1 8\nabcd\n$EndMeshFormat\n", "header", "b'abcd'"),
    "version 9": (TEXT.replace("2.2 0 8", "9.1 0 8"), "header", "version 9.1"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_a_damaged_file_of_gmsh_is_refused_with_its_section(name, tmp_path):
    text, where, got = WRONG[name]

    with pytest.raises(Refusal) as refusal:
        read_gmsh(str(write(text, tmp_path / "a.msh")))

    assert refusal.value.where.startswith(where) and (where or not refusal.value.where)
    assert got in refusal.value.got and refusal.value.expected


@pytest.mark.parametrize("name", ["binary", "version 2.2", "version 1", "version 4.1"])
def test_files_of_gmsh_cut_anywhere_are_refused_or_read(name, tmp_path):
    content = MSH[name]()
    content = content if isinstance(content, bytes) else content.encode()
    refused = 0
    for end in np.linspace(1, len(content) - 1, 25).astype(int):
        try:
            open_gmsh(str(write(content[:end], tmp_path / "a.msh")))
        except Refusal as refusal:
            refused += 1
            assert refusal.got and refusal.expected
    assert refused > 15


@pytest.mark.parametrize(
    ("write_it", "named"), [(write_vtp, "a.vtk"), (write_vtk, "a.vtp"), (write_vtu, "a.vtp")]
)
def test_what_a_file_of_vtk_is_its_beginning_tells(write_it, named, tmp_path):
    write_it(tmp_path / named, TETRAHEDRON, TETRAHEDRON_FACES)

    assert corners_of(import_mesh(tmp_path / named).mesh) == EXPECTED


def test_a_volume_of_voxels_is_refused_with_the_verb_for_it(tmp_path):
    head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"
    size = "DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n"

    with pytest.raises(palpate.FileError, match="palpate segment"):
        read_mesh(write(head + size, tmp_path / "a.vtk"))
