# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh file makes its reader open what lies beside or below it, and nothing else."""

from __future__ import annotations

import base64
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.doctor import find_landlock
from palpate_editor.authoring import READER, read_mesh

TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4").tobytes()
SHIM = r"""
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdarg.h>
#include <stdlib.h>
#include <unistd.h>
#ifdef WITHOUT_LANDLOCK
long syscall(long number, ...) {
  (void)number;
  errno = ENOSYS;
  return -1;
}
#endif
size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  const int outside = open(getenv("OUTSIDE"), O_RDONLY);
  if (outside >= 0) _exit(77);
  return ((size_t (*)(const void*, size_t, size_t, FILE*))dlsym(RTLD_NEXT, "fwrite"))(
      data, size, count, file);
}
"""
"""Before it writes its first word the reader tries to open a file that no mesh names."""


def write_gltf(path: Path, uri: str) -> Path:
    """A triangle whose corners are the first bytes of another file."""
    made = {
        "asset": {"version": "2.0"},
        "buffers": [{"uri": uri, "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    path.write_text(json.dumps(made), encoding="utf-8")
    return path


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder for a mesh, in one that holds a secret."""
    (tmp_path / "secret.bin").write_bytes(TRIANGLE)
    (tmp_path / "meshes" / "below").mkdir(parents=True)
    for name in ("corners.bin", "below/corners.bin"):
        (tmp_path / "meshes" / name).write_bytes(TRIANGLE)
    (tmp_path / "meshes" / "link.bin").symlink_to("../secret.bin")
    (tmp_path / "meshes-too").mkdir()
    shutil.copy(tmp_path / "secret.bin", tmp_path / "meshes-too")
    return tmp_path / "meshes"


@pytest.mark.parametrize("uri", ["corners.bin", "below/corners.bin", "below/../corners.bin"])
def test_what_lies_beside_or_below_the_mesh_is_read(uri, place):
    scene = read_mesh(write_gltf(place / "a.gltf", uri))

    assert len(scene.parts[0].mesh.triangles) == 1


def test_what_is_written_into_the_mesh_itself_is_read(place):
    uri = "data:application/octet-stream;base64," + base64.b64encode(TRIANGLE).decode()

    assert len(read_mesh(write_gltf(place / "a.gltf", uri)).parts) == 1


@pytest.mark.parametrize(
    "uri",
    ["../secret.bin", "{above}/secret.bin", "file://{above}/secret.bin", "link.bin"]
    + ["below/../../secret.bin", "%2e%2e/secret.bin", "..%2fsecret.bin"]
    + ["../meshes-too/secret.bin", "/dev/zero", "/etc/hostname"],
)
def test_what_lies_elsewhere_is_not_read_whatever_way_it_is_named(uri, place):
    path = write_gltf(place / "a.gltf", uri.format(above=place.parent))

    with pytest.raises(palpate.FileError) as refused:
        read_mesh(path)

    assert refused.value.file == str(path)


def test_a_reference_out_of_the_folder_is_refused_with_its_name(place):
    with pytest.raises(palpate.FileError, match="a reference to .*secret.bin") as refused:
        read_mesh(write_gltf(place / "a.gltf", "../secret.bin"))

    assert "beside the mesh or below its folder" in refused.value.expected


def test_an_obj_is_read_without_its_materials_wherever_they_are(place):
    (place.parent / "a.mtl").write_text("newmtl red\nKd 1 0 0\n", encoding="utf-8")
    path = place / "a.obj"
    path.write_text(
        "mtllib ../a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n", encoding="utf-8"
    )

    assert len(read_mesh(path).parts[0].mesh.triangles) == 2


def test_a_mesh_that_is_named_by_a_link_is_read(place, tmp_path):
    link = tmp_path / "organ.gltf"
    link.symlink_to(
        write_gltf(place / "a.gltf", "data:;base64," + base64.b64encode(TRIANGLE).decode())
    )

    assert len(read_mesh(link).parts) == 1


@pytest.fixture
def meddle(tmp_path, monkeypatch, place):
    """meddle(...) makes every reader try to open the secret, which no mesh names."""

    def build(*defined: str) -> None:
        (tmp_path / "shim.c").write_text(SHIM, encoding="utf-8")
        shim = tmp_path / "shim.so"
        words = ["cc", "-shared", "-fPIC", *defined, "-o", shim, tmp_path / "shim.c", "-ldl"]
        subprocess.run(words, check=True, capture_output=True)
        monkeypatch.setenv("LD_PRELOAD", str(shim))
        monkeypatch.setenv("OUTSIDE", str(place.parent / "secret.bin"))

    return build


def test_the_kernel_itself_keeps_the_reader_in_the_folder(meddle, place):
    if find_landlock() is None:
        pytest.skip("Landlock cannot be had here")
    meddle()

    assert len(read_mesh(write_gltf(place / "a.gltf", "corners.bin")).parts) == 1


def test_without_the_kernel_s_help_meshes_are_read_all_the_same(meddle, place):
    """And the test above could fail: the reader does open the secret then."""
    meddle("-DWITHOUT_LANDLOCK")

    with pytest.raises(palpate.FileError, match="ended with code 77"):
        read_mesh(write_gltf(place / "a.gltf", "corners.bin"))


def test_the_reader_is_the_one_of_this_installation():
    assert READER.is_absolute()
