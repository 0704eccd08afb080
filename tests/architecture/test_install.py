# SPDX-License-Identifier: BSD-3-Clause
"""palpate::sim on its own: built with Eigen alone, installed, found and used by a stranger."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from tree import CHECKOUT

ABSENT = ("ZLIB", "OpenSSL", "hwy", "CGAL", "assimp", "OpenMesh", "doctest", "pybind11", "Python")
OFF = ("RECORD_FILES", "SIMD", "SERIAL", "SCENARIO", "AUTHORING", "BINDINGS", "TESTS")


def run(*command: str | Path, **options) -> str:
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where palpate::sim was installed. Its build folder stays, so a second run is quick."""
    build = CHECKOUT / "build" / "eigen-alone"
    target = tmp_path_factory.mktemp("prefix")
    run("cmake", "-S", CHECKOUT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        *(f"-DPALPATE_{option}=OFF" for option in OFF),
        *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ABSENT))  # fmt: skip
    run("cmake", "--build", build)
    run("cmake", "--install", build, "--prefix", target)
    return target


def test_an_installed_header_is_all_a_program_needs(prefix):
    headers = {str(path.relative_to(prefix)) for path in prefix.rglob("*.h")}

    assert "include/palpate/sim/haptics/tick.h" in headers
    assert not any("authoring" in name or "bench" in name for name in headers)


def test_a_program_of_thirty_lines_presses_an_organ_and_prints_forces(prefix, tmp_path):
    source = CHECKOUT / "tests/examples/press_an_organ"
    run("cmake", "-S", source, "-B", tmp_path, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={prefix}",
        *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ABSENT))  # fmt: skip
    run("cmake", "--build", tmp_path)

    words = run(tmp_path / "press_an_organ", env={"PATH": os.environ["PATH"]})

    forces = [float(force) for force in re.findall(r"mm: +(\S+) N", words)]
    assert len(forces) == 11
    assert forces[:5] == [0.0] * 5
    assert forces[6:] == sorted(forces[6:])
    assert forces[-1] > forces[6] > 0.0
