# SPDX-License-Identifier: GPL-3.0-or-later
"""Bringing a foreign mesh file in. Reading takes long, so it is done before the edit is made."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.appearance import choose_appearance
from palpate_editor.document import Organ, Repairs, Segmentation, Source, Surface
from palpate_editor.document.organ_sizes import find_fitting_unit, find_range, find_word
from palpate_editor.edits.orient import METRES

REPAIRS = tuple(f.name for f in fields(Repairs) if f.name != "welded_vertices")
"""Those that are counted after the parts of a file were welded."""


@dataclass(frozen=True, eq=False)
class ImportMesh:
    """Put a surface that was read in the editor. Constants stay; what was painted goes. An organ
    without an appearance gets the one that fits its name."""

    title: ClassVar[str] = "Import"
    begins: ClassVar[bool] = True
    """The history of the organ; the surface is the original that it keeps."""

    name: str
    source: Source
    surface: Surface
    segmentation: Segmentation | None = None
    """Of a surface that was cut out of a scan."""

    def __call__(self, organ: Organ) -> Organ:
        fresh = replace(
            organ.with_surface(self.surface),
            source=self.source,
            segmentation=self.segmentation,
            imported=self.surface,
            decimation=None,
        )
        name = organ.name or self.name
        appearance = organ.appearance or choose_appearance(name, (self.name, *self.source.parts))
        return replace(fresh, name=name, appearance=appearance)


def import_file(
    path: Path,
    *,
    parts: Sequence[str] = (),
    unit: str | None = None,
    up: str | None = None,
    **limits: Any,
) -> ImportMesh:
    """Reads, joins, repairs and orients a mesh file: seconds for a large one, on any thread.

    Args:
        path: The mesh file.
        parts: Names of its parts to use; all when empty.
        unit: See authoring.import_mesh.
        up: See authoring.import_mesh.
        limits: time_limit [s] and memory_limit [bytes] of the reader.

    Raises FileError, ValueError (a wrong part, unit or axis) or OSError.
    """
    scene = authoring.read_mesh(path, **limits)
    imported = authoring.import_scene(scene, parts=parts, unit=unit, up=up)
    mesh = imported.mesh
    surface = Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    read = ImportMesh(make_writable(path.stem), describe_source(path, scene, imported), surface)
    return guess_unit_by_name(read)


def guess_unit_by_name(read: ImportMesh) -> ImportMesh:
    """The same in another unit where the one that was guessed by size makes no organ of that name
    and just one other does. What a file states is left to the designer, and to the rules."""
    source = read.source
    word = find_word((read.name,)) if source.parts == source.parts_available else None
    least, most = find_range(word)
    size = float(palpate.compute_diagonal(read.surface.vertices))
    unit = find_fitting_unit(size / METRES[source.unit], word)
    if not source.unit_guessed or least <= size <= most or unit is None:
        return read
    ratio = METRES[unit] / METRES[source.unit]
    whose = "any organ" if word is None else f"{word} in its name"
    reason = f"in {source.unit} {1e3 * size:.4g} mm long, in {unit} as long as {whose} can be"
    return replace(
        read,
        source=replace(source, unit=unit, unit_reason=reason),
        surface=Surface(ratio * read.surface.vertices, read.surface.triangles),
    )


def describe_source(
    path: Path, scene: authoring.ImportedScene, imported: authoring.ImportedMesh
) -> Source:
    """Where a surface came from and how its file was understood. Raises OSError."""
    joined, repaired = imported.joined, imported.repaired
    done = {name: getattr(repaired, name) for name in REPAIRS}
    with path.open("rb") as file:
        sha256 = hashlib.file_digest(file, "sha256").hexdigest()
    return Source(
        file=make_writable(path.name),
        folder=make_writable(str(path.resolve().parent)),
        sha256=sha256,
        format=scene.format,
        parts_available=tuple(part.name for part in scene.parts),
        parts=tuple(joined.parts),
        unit=joined.unit,
        unit_guessed=joined.unit_guessed,
        unit_reason=joined.unit_reason,
        up=joined.up,
        up_guessed=joined.up_guessed,
        up_reason=joined.up_reason,
        repairs=Repairs(welded_vertices=joined.welded_vertices, **done),
        notes=(*scene.notes, *list_changes(repaired)),
    )


def list_changes(repaired: authoring.RepairedMesh) -> Iterator[str]:
    """What was done to the surface that nobody would expect."""
    if repaired.parted_edges:
        yield f"{repaired.parted_edges} edges where the surface touched itself were parted"
    if repaired.dropped_islands:
        yield f"{repaired.dropped_islands} pieces smaller than a thousandth of it were dropped"


def make_writable(name: str) -> str:
    """A file's name with a question mark for what is no letter: bytes of another age's alphabet."""
    return name.encode(errors="replace").decode()
