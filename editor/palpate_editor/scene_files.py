# SPDX-License-Identifier: GPL-3.0-or-later
"""Scene files, for those who work with a text editor: organs out of them and into them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from palpate.files.refusal import Refusal
from palpate.scene.scene_file import hash_file, read_scene_and_mesh, write_scene_file
from palpate.scene.scene_parts import OrganPart

from palpate_editor import authoring
from palpate_editor.compile import mesh_of, parts_of, surface_of
from palpate_editor.document import Organ
from palpate_editor.edits.name import MOST_NAME_BYTES


def read_scene(path: Path) -> Organ:
    """The organ of a scene file and its mesh, which is taken to be used as it was imported."""
    scene, mesh = read_scene_and_mesh(path)
    surface = surface_of(mesh)
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


def name_mesh(scene: Path) -> Path:
    """The mesh that is written beside a scene file."""
    return scene.with_name(scene.name.removesuffix(".json").removesuffix(".scene") + ".obj")


def write_scene(path: Path, organ: Organ, mesh: Path | None) -> None:
    """A scene file, and its mesh beside it where that is not there already.

    Args:
        path: Of the scene file.
        organ: What it shall say.
        mesh: The OBJ file that has the organ's surface, if there is one.
    """
    assert organ.surface is not None
    if mesh is None:
        mesh = name_mesh(path)
        authoring.write_mesh(mesh, mesh_of(organ.surface))
    if mesh.resolve().parent != path.resolve().parent:
        raise Refusal(
            path,
            "",
            "a scene file in another folder than its mesh",
            "the same folder, so that both move together",
        )
    part = OrganPart(organ.name, mesh.name, hash_file(mesh))
    write_scene_file(path, replace(parts_of(organ), organ=part))
