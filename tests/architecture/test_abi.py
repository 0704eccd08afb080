# SPDX-License-Identifier: BSD-3-Clause
"""A program compiled with other flags than the library still means the same by every struct."""

from __future__ import annotations

import hashlib
import re
import subprocess
from pathlib import Path

import numpy as np
import palpate
import palpate.scenario
import pytest
from palpate.files.whole_file import write_whole
from test_play_example import TICKS, build_player, make_scene
from tree import CHECKOUT

INCLUDE = CHECKOUT / "build/release/include"
GENERATED = CHECKOUT / "build/release/generated"
EIGEN = "/usr/include/eigen3"
KEPT = CHECKOUT / "build/layouts"
WIDER = ("-mavx2", "-mavx2 -mfma", "-march=skylake-avx512", "-march=native -O3")
"""What makes Eigen align more than the library's own flags do."""

LAYOUT = re.compile(r"^Class (palpate::\S+)\n +size=(\d+) align=(\d+)", re.MULTILINE)


def require(*command: str | Path, cwd: Path | None = None) -> str:
    done = subprocess.run(command, capture_output=True, encoding="utf-8", cwd=cwd)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def lay_out(folder: Path, *flags: str) -> dict[str, tuple[str, str]]:
    """Size and alignment [byte] of every struct of the public headers, as a program sees them."""
    folder.mkdir()
    (folder / "all.cpp").write_text('#include "palpate/sim.h"\n', encoding="utf-8")
    command = ["g++", "-std=c++20", *flags, "-I", INCLUDE, "-I", GENERATED, "-isystem", EIGEN,
               "-DPALPATE_RECORD_FILES", "-DPALPATE_SERIAL", "all.cpp"]  # fmt: skip
    # kept as a compiler's cache keeps objects: by all that the compiler reads, and itself
    source = require(*command, "-E", cwd=folder)
    key = hashlib.sha256("\n".join([require("g++", "--version"), *flags, source]).encode())
    kept = KEPT / f"{key.hexdigest()}.class"
    if not kept.exists():
        require(*command, "-fsyntax-only", "-fdump-lang-class", cwd=folder)
        (dump,) = folder.glob("*.class")
        KEPT.mkdir(exist_ok=True)
        write_whole(kept, dump.read_bytes())
    found = LAYOUT.findall(kept.read_text(encoding="utf-8"))
    return {name: (size, alignment) for name, size, alignment in found}


@pytest.mark.parametrize(
    "flags", [WIDER[2], *(pytest.param(flags, marks=pytest.mark.verify) for flags in WIDER[:2])]
)
@pytest.mark.landing
def test_every_public_struct_has_one_layout_whatever_vectors_a_program_may_use(flags, tmp_path):
    plain = lay_out(tmp_path / "plain")
    assert {"palpate::HapticSample", "palpate::World", "palpate::Scene"} <= set(plain)

    assert lay_out(tmp_path / "wider", *flags.split()) == plain


def play(flags: str, path: Path) -> np.ndarray:
    """Forces [N] of the example that plays a published file, compiled with these flags."""
    words = require(build_player(flags), path)
    return np.array([[float.fromhex(word) for word in line.split()]
                     for line in words.splitlines()])  # fmt: skip


@pytest.mark.parametrize(
    "flags",
    [
        pytest.param("-march=native -O3", marks=pytest.mark.landing),
        pytest.param("-mavx2", marks=pytest.mark.verify),
    ],
)
def test_a_program_compiled_for_a_wider_machine_feels_the_forces_of_a_plain_one(flags, tmp_path):
    path = tmp_path / "dome.palpate"
    made = palpate.scenario.Scenario(scene=make_scene(), title="Kubbe", task="Press the dome.")
    palpate.scenario.write(path, made)
    plain = play("", path)
    assert plain.shape == (TICKS, 3)
    assert plain[-1, 2] > 0.01

    other = play(flags, path)
    # an inline function of a header may be compiled with other roundings
    np.testing.assert_allclose(other, plain, rtol=0.0, atol=1e-9 * plain.max())
