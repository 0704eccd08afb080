# SPDX-License-Identifier: GPL-3.0-or-later
"""Saving a working file: what cannot be written is said, and no kill leaves half of a file."""

from __future__ import annotations

import copy
import json
import os
import random
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ, surface_of
from palpate_editor.document import EMPTY
from palpate_editor.document.files import write_organ

TESTS = Path(__file__).resolve().parents[1]


def test_what_a_file_cannot_hold_is_refused_and_leaves_the_old_one(tmp_path):
    path = tmp_path / "a.organ"
    write_organ(path, make_organ())
    before = path.read_bytes()

    with pytest.raises(palpate.FileError, match="infinite or not a number"):
        write_organ(path, replace(make_organ(), stiffness_scale=np.full(60, np.nan)))
    with pytest.raises(palpate.FileError, match=r"a\.organ"):
        write_organ(path, replace(make_organ(), task="\udcff"))

    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_place_that_cannot_be_written_is_a_sentence(tmp_path):
    with pytest.raises(palpate.FileError, match="nowhere"):
        write_organ(tmp_path / "nowhere" / "a.organ", EMPTY)


@pytest.mark.parametrize("kills", [20, pytest.param(100, marks=pytest.mark.verify)])
def test_a_kill_while_saving_leaves_the_old_or_the_new_file_whole(kills, tmp_path):
    # most of the time is spent in writing, so most kills come in the middle of it
    large = surface_of(60)
    many = np.tile(large.vertices, (5000, 1))
    for name in ("old", "new"):
        organ = replace(make_organ(), name=name, imported=replace_vertices(large, many))
        write_organ(tmp_path / name, organ)
    random.seed(7)
    moments = [str(random.uniform(0.0, 0.1)) for _ in range(kills)]
    folder = tmp_path / "folder"
    folder.mkdir()

    script = TESTS / "bindings" / "save_again_and_again.py"
    command = [sys.executable, script, folder / "a.organ", tmp_path / "old", tmp_path / "new"]
    alone = {"OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run([*map(str, command), *moments], capture_output=True, encoding="utf-8",
                          env=os.environ | alone)  # fmt: skip

    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert len(found) == kills
    assert {words for words, _ in found} == {"old", "new"}
    # some kills came in the middle of a file, or none of this was shown
    assert any(in_the_middle for _, in_the_middle in found)


def replace_vertices(surface, vertices):
    return replace(copy.copy(surface), vertices=vertices)
