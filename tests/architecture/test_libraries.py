# SPDX-License-Identifier: BSD-3-Clause
"""Folder = target = licence: what each built library really links."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import palpate._sim
import pytest
from palpate_editor import _authoring
from tree import CHECKOUT

SYSTEM = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2",
          "ld-linux-aarch64.so.1", "libpthread.so.0"}  # fmt: skip
ZIPPED = {"libz.so.1"}
RECORDS = ZIPPED | {"libcrypto.so.3"}
VECTORS = {"libhwy.so.1"}
SCENARIO = {"libzip.so.4"}
OPENMESH = {"libOpenMeshCore.so.9.0", "libOpenMeshTools.so.9.0"}
EXACT_NUMBERS = {"libgmp.so.10", "libmpfr.so.6"}

SIM = Path(palpate._sim.__file__)
AUTHORING = Path(_authoring.__file__)
READER = AUTHORING.parent / "palpate-read-mesh"
ARCHIVE = CHECKOUT / "build/release/core/libpalpate_sim.a"

ALLOWED = {
    SIM: SYSTEM | RECORDS | VECTORS | SCENARIO,
    AUTHORING: SYSTEM | RECORDS | VECTORS | OPENMESH | EXACT_NUMBERS,
    READER: SYSTEM | ZIPPED | {"libassimp.so.5"},
}


def run(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout


@pytest.mark.parametrize("built", ALLOWED, ids=lambda path: path.name.split(".")[0])
def test_a_built_file_links_only_what_its_licence_covers(built):
    linked = set(re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", built)))

    assert linked
    assert linked - ALLOWED[built] == set()


@pytest.mark.parametrize("built", [SIM, ARCHIVE], ids=["_sim", "libpalpate_sim"])
def test_no_code_of_the_authoring_side_is_inside_the_simulation(built):
    """CGAL and OpenMesh are headers in part: what they compile to needs no library to be named."""
    names = run("nm", "--demangle", built) if built == ARCHIVE else run("strings", built)

    assert "palpate" in names
    assert re.findall(r"\b(?:CGAL|OpenMesh|Assimp|boost|palpate::authoring)::\w+", names) == []
