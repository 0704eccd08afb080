# SPDX-License-Identifier: BSD-3-Clause
"""The lines of the README that put a scene together do what they say, one after the other."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate.cli.main import main
from palpate.scene.mesh_file import read_mesh_file
from palpate_meshes.stone_scene import make_tray

README = Path(__file__).parents[2] / "README.md"
PUBLISHED = Path(palpate_meshes.__file__).parent / "published"
SCENES = PUBLISHED.parent / "scenes"
ROWS = (
    "put several organs into one scene",
    "add a stone that rolls",
    "have what is done in a scene judged",
)


def list_commands() -> list[list[str]]:
    """The words after `palpate` of every command in these rows, where later ones leave it out."""
    text = README.read_text(encoding="utf-8")
    commands = []
    for title in ROWS:
        [row] = re.findall(rf"^\| {title}.*$", text, re.MULTILINE)
        said = re.findall(r"`(?:palpate )?((?:scene|scenario) [^`]+)`", row)
        assert len(said) >= 4
        commands += [shlex.split(words) for words in said]
    return commands


def write_in_mm(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    lines = ["v {:.6f} {:.6f} {:.6f}".format(*(1e3 * vertex)) for vertex in vertices]
    lines += ["f {} {} {}".format(*(triangle + 1)) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


@pytest.mark.landing
def test_the_scene_of_the_readme_is_put_together_by_its_lines(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for name in ("liver", "gallbladder"):
        shutil.copy(PUBLISHED / f"{name}.palpate", tmp_path)
    stone = read_mesh_file(SCENES / "stone.obj")
    write_in_mm(tmp_path / "stone.obj", stone.vertices, stone.triangles)
    write_in_mm(tmp_path / "table.obj", *make_tray())

    for words in list_commands():
        code = main(words)
        said = capsys.readouterr()
        assert code == 0, (words, said.out, said.err)

    made = palpate.scenario.read(tmp_path / "two.palpate")
    scene = made.scene
    assert [len(scene.bodies), len(scene.rigid), len(scene.scenery)] == [2, 1, 1]
    assert scene.bodies[0].weightless and not scene.bodies[1].weightless
    assert scene.instruments[0].tool.jaws is not None and made.assessment
