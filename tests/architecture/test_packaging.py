# SPDX-License-Identifier: BSD-3-Clause
"""The two distributions: their versions, their lock, and what a wheel of them holds."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
import zipfile
from importlib.metadata import version

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from packaging.version import Version
from tree import CHECKOUT, read

SHIPPED = {".obj", ".json", ".organ", ".palpate", ".toml", ".png"}
"""What of meshes/ is no program."""
PROJECTS = ("pyproject.toml", "editor/pyproject.toml")


def read_lock() -> dict[str, Version]:
    """Every package of requirements.lock and its one version."""
    pins = re.findall(r"^([A-Za-z0-9._-]+)==([^\s;]+)", read("requirements.lock"), re.MULTILINE)
    return {canonicalize_name(name): Version(number) for name, number in pins}


def declared() -> list[Requirement]:
    """What distributions, extras, build and the developer's group ask for; ours left out."""
    texts: list[str] = []
    for project in PROJECTS:
        settings = tomllib.loads(read(project))
        texts += settings["project"]["dependencies"] + settings["build-system"]["requires"]
        texts += settings.get("dependency-groups", {}).get("dev", [])
        for extra in settings["project"].get("optional-dependencies", {}).values():
            texts += extra
    return [Requirement(text) for text in texts if not text.startswith("palpate")]


@pytest.mark.parametrize("requirement", sorted(set(map(str, declared()))))
def test_the_lock_satisfies(requirement):
    wanted = Requirement(requirement)

    assert read_lock()[canonicalize_name(wanted.name)] in wanted.specifier


def test_the_lock_has_a_hash_for_every_package():
    blocks = re.split(r"^(?=[A-Za-z0-9])", read("requirements.lock"), flags=re.MULTILINE)

    assert len(blocks) > len(declared()) / 2
    assert [block for block in blocks[1:] if "--hash=sha256:" not in block] == []


def test_what_is_installed_is_what_the_lock_says():
    lock = read_lock()

    assert {name: Version(version(name)) for name in lock} == lock


def test_cmake_and_both_distributions_agree_on_the_version():
    number = re.search(r"project\(palpate VERSION ([0-9.]+)", read("CMakeLists.txt"))[1]
    versions = {tomllib.loads(read(project))["project"]["version"] for project in PROJECTS}

    assert versions == {number}
    assert f"palpate=={number}" in tomllib.loads(read(PROJECTS[1]))["project"]["dependencies"]


def wheel_names(folder: str, into) -> set[str]:
    """The files of a wheel of `folder`, its compiled module left out."""
    subprocess.run(
        [sys.executable, "-m", "pip", "wheel", "-q", "--no-index", "--no-deps",
         "--no-build-isolation", "--config-settings=wheel.cmake=false", "-w", into,
         CHECKOUT / folder],
        check=True,
    )  # fmt: skip
    (wheel,) = into.glob("*.whl")
    return set(zipfile.ZipFile(wheel).namelist())


def test_a_wheel_of_palpate_holds_types_and_its_licence_and_nothing_of_the_editor(tmp_path):
    names = wheel_names(".", tmp_path)

    assert {"palpate/__init__.py", "palpate/_sim.pyi", "palpate/py.typed"} <= names
    instruments = (CHECKOUT / "bindings/palpate/render/instruments").glob("*.obj")
    assert {f"palpate/render/instruments/{path.name}" for path in instruments} <= names
    assert "palpate/scene/instruments.toml" in names
    assert "palpate-0.1.0.dist-info/licenses/LICENSES/BSD-3-Clause.txt" in names
    assert {name.split("/")[0] for name in names} == {"palpate", "palpate-0.1.0.dist-info"}


@pytest.mark.landing
def test_a_wheel_of_palpate_editor_holds_types_its_licence_the_generators_and_all_that_ships(
    tmp_path,
):
    names = wheel_names("editor", tmp_path)
    meshes = CHECKOUT / "meshes"
    shipped = [path for path in meshes.rglob("*") if path.suffix in SHIPPED]

    assert {"palpate_editor/_authoring.pyi", "palpate_editor/py.typed"} <= names
    assert "palpate_meshes/generate/__init__.py" in names
    assert len(shipped) > 40
    assert {f"palpate_meshes/{path.relative_to(meshes)}" for path in shipped} <= names
    assert "palpate_editor-0.1.0.dist-info/licenses/LICENSE" in names
    assert [name for name in names if name.endswith(".so")] == []
