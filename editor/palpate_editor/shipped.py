# SPDX-License-Identifier: GPL-3.0-or-later
"""The organs that come with Palpate, as documents: mesh, named regions, tissue, task."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from palpate.scene.scene_parts import FillPart, MaterialPart, ModelPart
from palpate_meshes.catalogue import (
    PICTURES,
    Entry,
    Tissue,
    find_entry,
    read_catalogue,
    read_organ_mesh,
    read_regions,
    read_tissues,
)

from palpate_editor.document import EMPTY, Organ, Source, Surface
from palpate_editor.document.far_compliance import wants_far_field
from palpate_editor.document.files import write_organ
from palpate_editor.edits import DecimateTo, Edit, SetConstant, SetFarField, SetMaterial, SetTask
from palpate_editor.far_field_tables import read_table
from palpate_editor.publish import publish

HOW = "ships with Palpate"


def find_mesh(name: str) -> Path:
    """The OBJ in metres of a shipped organ. Raises ValueError for a name there is not."""
    return find_entry(name).mesh


def find_picture(name: str, theme: str) -> Path:
    """A small picture of a shipped organ, dark or light."""
    return PICTURES / f"{name}_{theme}.png"


def make_organ(name: str, vertices: int | None = None) -> Organ:
    """A shipped organ ready to be edited, held where the body holds it.

    Args:
        name: Of the catalogue.
        vertices: Another resolution, generated now; None for the published one.

    Raises ValueError for a name there is not or a number of vertices the shape cannot have.
    """
    # loads SciPy, which every other command does without
    from palpate_meshes.anatomy import ATTACHMENT, find_regions, generate

    entry = find_entry(name)
    if vertices is None or vertices == entry.vertices:
        x, triangles = read_organ_mesh(name)
        regions = read_regions(name)
        source = describe_source(entry)
    else:
        x, triangles = generate(entry.generator, **entry.parameters | {"vertices": vertices})
        regions = find_regions(entry.generator, x, triangles, entry.parameters["size"])
        source = None
    surface = Surface(x, triangles)
    organ = replace(
        EMPTY.with_surface(surface),
        name=entry.name.replace("_", " "),
        fill=organ_fill(entry),
        imported=surface,
        source=source,
    )
    fixed = np.zeros(len(x), bool)
    fixed[regions[ATTACHMENT]] = True
    tissue = read_tissues()[entry.tissue]
    organ = replace(organ, fixed=fixed, regions=regions, appearance=tissue.appearance)
    if vertices is None and entry.wall_vertices is not None:
        organ = DecimateTo(entry.wall_vertices)(organ)
    for edit in list_edits(entry, tissue):
        organ = edit(organ)
    table = read_table(name) if vertices is None and wants_far_field(organ) else None
    return organ if table is None else SetFarField(table)(organ)


def organ_fill(entry: Entry) -> FillPart:
    """As the published solids, which carry it, were filled."""
    if entry.tetrahedra is None:
        return EMPTY.fill
    return FillPart(entry.tetrahedra, sizing="estimated")


def list_edits(entry: Entry, tissue: Tissue) -> Iterator[Edit]:
    """What makes of the bare surface the organ that ships."""
    yield SetMaterial(MaterialPart(**tissue.material), ModelPart(**tissue.model), tissue.name)
    yield SetConstant("tool", "radius", entry.tip_radius)
    yield SetTask(entry.title, entry.task)
    for code, words in entry.languages.items():
        yield SetTask(words.get("title", ""), words.get("task", ""), code)


def describe_source(entry: Entry) -> Source:
    return Source(
        file=entry.mesh.name,
        folder="",
        sha256=entry.sha256,
        format="obj",
        parts_available=(entry.name,),
        parts=(entry.name,),
        unit="m",
        unit_guessed=False,
        unit_reason=HOW,
        up="z",
        up_guessed=False,
        up_reason=HOW,
    )


def write_files(folder: Path, names: list[str]) -> Iterator[tuple[str, Path, Path]]:
    """Each organ as a working file to edit and as a scenario to play; yields name and both paths.

    Raises OSError, and PublishError where an organ would not pass the checks.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        organ = make_organ(name)
        working, scenario = folder / f"{name}.organ", folder / f"{name}.palpate"
        write_organ(working, organ)
        publish(organ, scenario)
        yield name, working, scenario


def list_tissues() -> list[Tissue]:
    """What the shipped organs are made of, with what has been published about it."""
    return list(read_tissues().values())


def list_organs() -> list[tuple[Entry, Tissue]]:
    """The catalogue, every organ with what it is made of."""
    tissues = read_tissues()
    return [(entry, tissues[entry.tissue]) for entry in read_catalogue().values()]
