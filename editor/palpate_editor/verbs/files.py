# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that verbs take and make: what one writes the next can read."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from palpate.mesh_file import read_mesh_file
from palpate.scene_file import hash_file, write_scene_file
from palpate.scene_parts import OrganPart
from palpate.verb import Refusal

from palpate_editor import authoring
from palpate_editor.compile import mesh_of, parts_of, surface_of
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import Edit, EditError
from palpate_editor.open_organ import open_organ


def open_any(path: Path) -> Organ:
    """Every file that open_organ takes, and OBJ files of ours, whose organ is a bare surface."""
    if path.suffix != ".obj":
        return open_organ(path)
    surface = surface_of(read_mesh_file(path))
    return replace(EMPTY.with_surface(surface), name=path.stem, imported=surface)


def write_any(path: Path, organ: Organ) -> None:
    """A working file where the name ends in .organ, else the surface alone."""
    if path.suffix == ".organ":
        write_organ(path, organ)
        return
    assert organ.surface is not None
    authoring.write_mesh(path, mesh_of(organ.surface))


def write_scene(path: Path, organ: Organ, mesh: Path | None) -> None:
    """A scene file, and its mesh beside it where that is not there already.

    Args:
        path: Of the scene file.
        organ: What it shall say.
        mesh: The OBJ file that has the organ's surface, if there is one.
    """
    assert organ.surface is not None
    if mesh is None:
        mesh = path.with_name(path.name.removesuffix(".json").removesuffix(".scene") + ".obj")
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


def apply(edit: Edit, organ: Organ, file: Path, where: str) -> Organ:
    """The edit done, or refused as a verb refuses."""
    try:
        return edit(organ)
    except EditError as refused:
        raise Refusal(file, where, str(refused), "an edit that can be done") from None
