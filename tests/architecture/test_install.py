# SPDX-License-Identifier: BSD-3-Clause
"""What a build installs, found and used by a stranger; with Eigen alone in `./run verify`."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from tree import CHECKOUT, install

ABSENT = ("ZLIB", "OpenSSL", "hwy", "CGAL", "assimp", "OpenMesh", "doctest", "pybind11", "Python")
OFF = ("RECORD_FILES", "SIMD", "SERIAL", "SCENARIO", "AUTHORING", "BINDINGS", "TESTS")


def run(*command: str | Path, **options) -> str:
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def prefix() -> Path:
    """Where the build of the tests themselves was installed, so that nothing is compiled for it."""
    return install(CHECKOUT / "build" / "release", "installed")


@pytest.mark.landing
def test_an_installed_header_is_all_a_program_needs(prefix):
    headers = {str(path.relative_to(prefix)) for path in prefix.rglob("*.h")}

    assert "include/palpate/sim/tick/tick.h" in headers
    assert not any("authoring" in name or "bench" in name for name in headers)


@pytest.mark.parametrize("part", ["sim", "scenario"])
def test_an_umbrella_header_includes_every_header_of_its_part_and_no_other(prefix, part):
    root = prefix / "include"
    umbrella = (root / f"palpate/{part}.h").read_text(encoding="utf-8")

    installed = {str(path.relative_to(root)) for path in root.glob(f"palpate/{part}/**/*.h")}
    included = re.findall(r'#include "([^"]+)"', umbrella)
    assert installed
    assert set(included) - {"palpate/version.h"} == installed
    assert len(included) == len(set(included))


def test_the_version_header_is_that_of_the_project_and_of_the_library(prefix, tmp_path):
    (version,) = re.findall(
        r"project\(palpate VERSION (\S+)", (CHECKOUT / "CMakeLists.txt").read_text(encoding="utf-8")
    )
    (tmp_path / "main.cpp").write_text(
        '#include <cstdio>\n#include "palpate/version.h"\n'
        "int main() {\n"
        '  std::printf("%d.%d.%d %s %s", PALPATE_VERSION_MAJOR, PALPATE_VERSION_MINOR,\n'
        "              PALPATE_VERSION_PATCH, PALPATE_VERSION_STRING,\n"
        "              palpate::library_version());\n"
        "}\n",
        encoding="utf-8",
    )
    (library,) = prefix.rglob("libpalpate_sim.a")
    run("g++", "-std=c++20", "-I", prefix / "include", tmp_path / "main.cpp", library,
        "-o", tmp_path / "version")  # fmt: skip

    assert run(tmp_path / "version") == f"{version} {version} {version}"


def press_an_organ(prefix: Path, name: str, *options: str) -> None:
    """Compiles the program of thirty lines against what is installed, and runs it."""
    build = CHECKOUT / "build" / name
    run("cmake", "-S", CHECKOUT / "tests/examples/press_an_organ", "-B", build, "-G", "Ninja",
        "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}", *options)  # fmt: skip
    run("cmake", "--build", build)

    words = run(build / "press_an_organ", env={"PATH": os.environ["PATH"]})

    forces = [float(force) for force in re.findall(r"mm: +(\S+) N", words)]
    assert len(forces) == 11
    assert forces[:5] == [0.0] * 5
    assert forces[6:] == sorted(forces[6:])
    assert forces[-1] > forces[6] > 0.0


def test_a_program_of_thirty_lines_presses_an_organ_and_prints_forces(prefix):
    press_an_organ(prefix, "installed-program")


@pytest.mark.verify
def test_so_it_does_with_a_static_library_that_was_built_with_eigen_alone():
    absent = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ABSENT]
    build = CHECKOUT / "build" / "eigen-alone"
    run("cmake", "-S", CHECKOUT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        *(f"-DPALPATE_{option}=OFF" for option in OFF), *absent)  # fmt: skip
    run("cmake", "--build", build)

    press_an_organ(install(build, "eigen-alone-prefix"), "eigen-alone-program", *absent)
