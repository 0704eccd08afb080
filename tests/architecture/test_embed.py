# SPDX-License-Identifier: BSD-3-Clause
"""palpate::sim within another project: as a part of its build, fetched, shared, by component."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from tree import CHECKOUT, install

# the whole library is compiled once more after every change of it
library_is_compiled = pytest.mark.verify
EXAMPLE = CHECKOUT / "tests/examples/embed_palpate"
ABSENT = ("ZLIB", "OpenSSL", "hwy", "CGAL", "assimp", "OpenMesh", "doctest", "pybind11", "Python")


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, encoding="utf-8")


def require(*command: str | Path) -> str:
    done = run(*command)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def configure(build: Path, *options: str) -> None:
    """The embedding program, with nothing but Eigen to be found; optimised little, to be quick."""
    require("cmake", "-S", EXAMPLE, "-B", build, "-G", "Ninja", f"-DPALPATE_SOURCE={CHECKOUT}",
            "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O1",
            *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ABSENT),
            *options)  # fmt: skip


def presses(build: Path) -> None:
    words = require(build / "press_an_organ")
    forces = [float(force) for force in re.findall(r"mm: +(\S+) N", words)]
    assert len(forces) == 11
    assert forces[:5] == [0.0] * 5
    assert forces[-1] > forces[6] > 0.0


@pytest.fixture(scope="module")
def shared() -> Path:
    """The subproject as a shared library; its build folder stays, so a second run is quick."""
    build = CHECKOUT / "build" / "embed-shared"
    configure(build, "-DEMBED_BY=subproject", "-DBUILD_SHARED_LIBS=ON", "-DPALPATE_INSTALL=ON",
              "-DPALPATE_PRECOMPILED=ON")  # fmt: skip
    require("cmake", "--build", build)
    return build


@library_is_compiled
def test_a_subproject_and_a_shared_library_press_an_organ_with_eigen_alone(shared):
    assert list(shared.glob("palpate/core/libpalpate_sim.so*"))
    presses(shared)


@library_is_compiled
def test_a_project_that_fetches_palpate_configures_with_eigen_alone_and_compiles_its_own_file(
    shared,
):
    # what FetchContent adds is the folder that the subproject has compiled already
    build = CHECKOUT / "build" / "embed-fetch"
    configure(build, "-DEMBED_BY=fetch")

    targets = require("ninja", "-C", build, "-t", "targets", "all")
    (own,) = re.findall(
        r"^(CMakeFiles/press_an_organ\.dir/\S*main\.cpp\.o):", targets, re.MULTILINE
    )
    require("cmake", "--build", build, "--target", own)


@library_is_compiled
def test_an_embedding_project_gets_no_option_that_needs_more_than_eigen(shared):
    cache = (shared / "CMakeCache.txt").read_text(encoding="utf-8")
    options = dict(re.findall(r"^(PALPATE_\w+):BOOL=(\w+)$", cache, re.MULTILINE))

    needing = ("RECORD_FILES", "SIMD", "SERIAL", "SCENARIO", "AUTHORING", "BINDINGS", "TESTS")
    assert {f"PALPATE_{name}" for name in needing} <= set(options)
    assert {options[f"PALPATE_{name}"] for name in needing} == {"OFF"}


def find_package(folder: Path, prefix: Path, wanted: str) -> subprocess.CompletedProcess[str]:
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(seek LANGUAGES CXX)\n"
        f"find_package(palpate {wanted})\n"
        'message(STATUS "sim ${palpate_sim_FOUND} scenario ${palpate_scenario_FOUND}")\n',
        encoding="utf-8",
    )
    return run("cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja",
               f"-DCMAKE_PREFIX_PATH={prefix}")  # fmt: skip


@pytest.fixture(scope="module")
def prefix(shared) -> Path:
    return install(shared, "embed-prefix")


@library_is_compiled
def test_a_shared_installation_is_found_by_its_part_and_its_version(prefix, tmp_path):
    for number, wanted in enumerate(("REQUIRED", "REQUIRED COMPONENTS sim", "0.1 REQUIRED")):
        found = find_package(tmp_path / str(number), prefix, wanted)
        assert found.returncode == 0, found.stderr
        assert "sim TRUE" in found.stdout


@library_is_compiled
def test_a_part_that_was_not_built_or_does_not_exist_is_refused_in_a_sentence(prefix, tmp_path):
    absent = find_package(tmp_path / "absent", prefix, "REQUIRED COMPONENTS sim scenario")
    unknown = find_package(tmp_path / "unknown", prefix, "REQUIRED COMPONENTS feelings")

    assert absent.returncode != 0
    assert "PALPATE_SCENARIO=OFF and has no scenario" in " ".join(absent.stderr.split())
    assert unknown.returncode != 0
    assert "got component feelings, expected sim or scenario" in " ".join(unknown.stderr.split())


@library_is_compiled
def test_a_program_linked_with_the_shared_installation_presses_an_organ(prefix):
    source, build = CHECKOUT / "tests/examples/press_an_organ", CHECKOUT / "build/embed-linked"
    require("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
            *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ABSENT))  # fmt: skip
    require("cmake", "--build", build)

    presses(build)


@pytest.mark.landing
def test_the_commands_of_the_guide_for_devices_name_targets_and_files_that_exist():
    guide = (CHECKOUT / "tests/examples/add_a_device/README.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"```sh\n(.*?)```", guide, re.DOTALL)

    target = re.search(r"cmake --build build/release --target (\w+) && (\S+)", block)
    assert target, block
    done = run(CHECKOUT / target[2])
    assert done.returncode == 0, done.stdout + done.stderr
    assert "FAILED" not in done.stdout
    assert re.search(r"^# ", guide)
    prose = re.sub(r"^```.*?^```$", "", guide, flags=re.DOTALL | re.MULTILINE)
    assert not re.search(r"^ {4,}\S", prose, re.MULTILINE)
    assert "my_device.h" in guide
