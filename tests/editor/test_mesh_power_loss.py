# SPDX-License-Identifier: GPL-3.0-or-later
"""A disk loses power after any step of writing a mesh: what write_mesh acknowledged is kept."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest
from palpate import SurfaceMesh
from palpate_editor.authoring import write_mesh
from simulated_disk import build_shim, list_losses, read_steps, run_traced

TESTS = Path(__file__).resolve().parents[1]
SAMPLE = 150
"""Losses that an ordinary run tries."""
OLDER = b"what stood there before " * 40
CORNERS = ((0.0, 0.0, 0.0), (0.03, 0.0, 0.0), (0.0, 0.03, 0.0), (0.0, 0.0, 0.03))
SIDES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
WRITE_TWICE = f"""
import sys
sys.path.insert(0, {str(TESTS)!r})
from palpate import SurfaceMesh
from palpate_editor.authoring import write_mesh
from simulated_disk import acknowledge
for version, size in (("one", 1.0), ("two", 2.0)):
    corners = [[size * number for number in corner] for corner in {CORNERS}]
    write_mesh(sys.argv[1], SurfaceMesh(corners, {SIDES}))
    acknowledge(version)
"""


def write_tetrahedron(path: Path, size: float) -> bytes:
    corners = [[size * number for number in corner] for corner in CORNERS]
    write_mesh(path, SurfaceMesh(corners, SIDES))
    return path.read_bytes()


@pytest.mark.parametrize(
    "whole", [False, pytest.param(True, marks=pytest.mark.verify)], ids=["sample", "whole"]
)
@pytest.mark.parametrize("older", [True, False], ids=["over-an-older-file", "under-a-new-name"])
@pytest.mark.parametrize("kind", ["obj", "stl"])
def test_a_mesh_that_was_written_is_there_after_a_loss_of_power_and_none_is_half(
    kind, older, whole, tmp_path
):
    folder, name = tmp_path / "disk", f"work.{kind}"
    folder.mkdir()
    before = {name: OLDER} if older else {}
    for file, content in before.items():
        (folder / file).write_bytes(content)
    shim = build_shim(tmp_path)
    done = run_traced(shim, folder, [sys.executable, "-P", "-c", WRITE_TWICE, folder / name])
    assert done.returncode == 0, done.stderr
    versions = [before.get(name)]
    versions += [write_tetrahedron(tmp_path / f"a.{kind}", size) for size in (1.0, 2.0)]
    assert (folder / name).read_bytes() == versions[2]

    losses = list(list_losses(read_steps(folder), before))

    assert {loss.promises for loss in losses} >= {(), ("one",), ("one", "two")}
    some = whole or len(losses) <= SAMPLE
    for loss in losses if some else [*random.Random(16).sample(losses, SAMPLE), losses[-1]]:
        assert loss.folder.get(name) in versions[len(loss.promises) :], loss.after
