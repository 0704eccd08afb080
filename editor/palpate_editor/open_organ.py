# SPDX-License-Identifier: GPL-3.0-or-later
"""Organs out of every file that has one: working files, published ones, scene files."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
from palpate import FileError, scenario
from palpate.mesh_file import read_mesh_file
from palpate.scene_file import hash_file, read_scene_file
from palpate.verb import Refusal

from palpate_editor.compile import surface_of
from palpate_editor.document import Organ
from palpate_editor.document.files import FORMAT, VERSION, read_organ, unpack_organ
from palpate_editor.edits.name import MOST_NAME_BYTES


def open_organ(path: Path) -> Organ:
    """Reads an .organ, a .palpate with its designer's document inside, or a scene file.

    Raises FileError, Refusal or OSError.
    """
    if path.suffix == ".organ":
        return read_organ(path)
    if path.suffix == ".palpate":
        return read_authored(path)
    if path.suffix == ".json":
        return read_scene(path)
    raise Refusal(
        path,
        "",
        f"a name ending in {path.suffix!r}",
        ".organ, .palpate or .scene.json; foreign meshes come in by `palpate import`",
    )


def read_authored(path: Path) -> Organ:
    """The document a published file was made from. Raises FileError."""
    found = scenario.read(os.fspath(path))
    authored = json.loads(found.authored)
    if authored.get("format") != FORMAT:
        raise FileError(
            str(path), "authored", "no document of an editor", "a file that `palpate publish` wrote"
        )
    version = authored.get("version")
    if type(version) is not int or not 1 <= version <= VERSION:  # true is no version
        raise FileError(
            str(path),
            "authored.version",
            f"{version}",
            f"at most {VERSION}, what this editor knows",
        )
    return unpack_organ(authored.get("content"), found.authored_arrays, version, str(path))


def read_scene(path: Path) -> Organ:
    """The organ of a scene file and its mesh, which is taken to be used as it was imported."""
    scene = read_scene_file(path)
    mesh_path = path.parent / scene.organ.mesh
    if mesh_path.is_file() and hash_file(mesh_path) != scene.organ.sha256:
        raise Refusal(
            path,
            "organ.sha256",
            f"{mesh_path.name} with another SHA-256",
            "the mesh the scene was made with",
        )
    surface = surface_of(read_mesh_file(mesh_path))
    count = len(surface.vertices)
    fixed = np.zeros(count, bool)
    ids = scene.model.fixed
    if ids and not (min(ids) >= 0 and max(ids) < count):
        found, expected = f"{min(ids)} to {max(ids)}", f"vertices 0 to {count - 1}"
        raise Refusal(path, "model.fixed", found, expected)
    fixed[list(ids)] = True
    scale = np.array(scene.model.stiffness_scale or (1.0,) * count)
    if len(scale) != count:
        raise Refusal(path, "model.stiffness_scale", f"{len(scale)} numbers", f"{count} or none")
    return Organ(
        name=scene.organ.name.encode()[:MOST_NAME_BYTES].decode(errors="ignore"),
        imported=surface,
        surface=surface,
        material=scene.material,
        model=replace(scene.model, fixed=(), stiffness_scale=()),
        fixed=fixed,
        stiffness_scale=scale,
        tool=scene.tool,
        hand=scene.hand,
    )
