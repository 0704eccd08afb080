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
from palpate.scene.scene_parts import AppearancePart

from palpate_editor import authoring
from palpate_editor.appearance import choose_appearance, recolour
from palpate_editor.document import (
    Assembly,
    Filling,
    Organ,
    Repairs,
    Segmentation,
    Source,
    Surface,
)
from palpate_editor.document.organ_sizes import find_fitting_unit, find_range, find_word
from palpate_editor.edits.orient import METRES
from palpate_editor.edits.own_filling import take_filling
from palpate_editor.edits.part_regions import find_regions
from palpate_editor.edits.place_parts import find_colour, place_surfaces
from palpate_editor.edits.wall import is_closed, settle_wall
from palpate_editor.pictures import decode_pictures
from palpate_editor.vertex_colours import find_mean, paint_surface

REPAIRS = tuple(f.name for f in fields(Repairs) if f.name != "welded_vertices")
"""Those that are counted after the parts of a file were welded."""


@dataclass(frozen=True)
class Assembling:
    """How the parts of a file become one surface."""

    weld: float | None = None
    """[m] Vertices of different parts that are closer become one; None: those at one place."""
    unite: bool = False
    """As solids, one out of all."""
    subtract: tuple[str, ...] = ()
    """Parts or groups whose inside is taken away from the others; those are united."""
    regions: bool = False
    """Keep each part as a region of its name."""

    def options(self) -> dict[str, Any]:
        """As authoring.join_parts takes them."""
        return {"weld": self.weld, "unite": self.unite, "subtract": self.subtract}


BESIDE = Assembling()
"""Parts lie side by side, welded where they have the same points."""


@dataclass(frozen=True, eq=False)
class ImportMesh:
    """Put a surface that was read in the editor. Constants stay; what was painted goes. An organ
    without an appearance gets the one that fits its name, in the file's colour, an open one without
    a wall the usual wall."""

    title: ClassVar[str] = "Import"
    begins: ClassVar[bool] = True
    """The history of the organ; the surface is the original that it keeps."""

    name: str
    source: Source
    surface: Surface
    segmentation: Segmentation | None = None
    """Of a surface that was cut out of a scan."""
    assembly: Assembly | None = None
    regions: tuple[str, ...] = ()
    """Parts that are kept as regions."""
    region_of: np.ndarray | None = None
    """(n,) Which of them each vertex is in."""
    colour: tuple[float, ...] | None = None
    """sRGB, 0 to 1: of the file."""
    filling_vertices: np.ndarray | None = None
    """[m] (3 n,) Of the file's own tetrahedra, which the surface is the outside of."""
    filling_tetrahedra: np.ndarray | None = None
    """(4 t,)"""

    def __call__(self, organ: Organ) -> Organ:
        fresh = replace(
            organ.with_surface(self.surface),
            source=self.source,
            segmentation=self.segmentation,
            assembly=self.assembly,
            imported=self.surface,
            decimation=None,
            filling=self.build_filling(),
            regions=self.build_regions(),
        )
        if fresh.filling is not None:
            count = len(fresh.filling.tetrahedra)
            fresh = replace(fresh, fill=replace(organ.fill, tetrahedra=count))
        name = organ.name or self.name
        appearance = organ.appearance or self.find_appearance(name)
        return settle_wall(replace(fresh, name=name, appearance=appearance), organ)

    def build_regions(self) -> dict[str, np.ndarray]:
        """Parts without a vertex have none."""
        if self.region_of is None:
            return {}
        found = {name: np.flatnonzero(self.region_of == i) for i, name in enumerate(self.regions)}
        return {name: ids for name, ids in found.items() if ids.size}

    def build_filling(self) -> Filling | None:
        if self.filling_vertices is None or self.filling_tetrahedra is None:
            return None
        return Filling(
            np.reshape(self.filling_vertices, (-1, 3)), np.reshape(self.filling_tetrahedra, (-1, 4))
        )

    def find_appearance(self, name: str) -> AppearancePart:
        appearance = choose_appearance(name, (self.name, *self.source.parts))
        return appearance if self.colour is None else recolour(appearance, self.colour)


def import_file(
    path: Path,
    *,
    parts: Sequence[str] = (),
    unit: str | None = None,
    up: str | None = None,
    assembling: Assembling = BESIDE,
    **limits: Any,
) -> ImportMesh:
    """Reads, joins, repairs and orients a mesh file: seconds for a large one, on any thread.

    Args:
        path: The mesh file.
        parts: Names of its parts, or of groups of them, to use; all when empty.
        unit: See authoring.import_mesh.
        up: See authoring.import_mesh.
        assembling: How the parts become one surface.
        limits: time_limit [s] and memory_limit [bytes] of the reader.

    Raises FileError, ValueError (a wrong part, unit, axis or length) or OSError.
    """
    scene = authoring.read_mesh(path, **limits)
    return import_read(path, scene, parts=parts, unit=unit, up=up, assembling=assembling)


def import_read(
    path: Path,
    scene: authoring.ImportedScene,
    *,
    parts: Sequence[str] = (),
    unit: str | None = None,
    up: str | None = None,
    assembling: Assembling = BESIDE,
) -> ImportMesh:
    """The same of a file that has been read."""
    options = assembling.options()
    imported = authoring.import_scene(scene, parts=parts, unit=unit, up=up, **options)
    mesh = imported.mesh
    surface = Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    source = describe_source(path, scene, imported)
    read = guess_unit_by_name(ImportMesh(make_writable(path.stem), source, surface))
    guessed = read.source.unit
    if assembling.weld is not None and guessed != imported.joined.unit:
        # the tolerance was of another length in the unit that was taken at first
        again = import_read(path, scene, parts=parts, unit=guessed, up=up, assembling=assembling)
        told = replace(again.source, unit_guessed=True, unit_reason=read.source.unit_reason)
        return replace(again, source=told)
    made = add_belongings(read, scene, imported.joined, assembling)
    is_closed(made.surface)  # here, where it may take its time
    return made


def add_belongings(
    read: ImportMesh,
    scene: authoring.ImportedScene,
    joined: authoring.JoinedSurface,
    assembling: Assembling,
) -> ImportMesh:
    """With what comes along beside the surface: regions, colour, filling; and a word of each."""
    source, surface = read.source, read.surface
    unit, ratio = joined.unit, METRES[source.unit] / METRES[joined.unit]
    filling, said = take_filling(scene, unit, source.up, surface, ratio)
    colour = find_colour(scene, source.parts)
    surface, words = colour_surface(surface, scene, source, unit, ratio)
    if surface.colours is not None:
        colour = find_mean(surface)
    notes = [*filter(None, [*source.notes, said]), *words]
    if joined.welded_across:
        notes.append(
            f"{joined.welded_across} vertices were welded across parts, by up to "
            f"{1e3 * joined.largest_move:.3g} mm"
        )
    names: tuple[str, ...] = ()
    region_of = None
    if assembling.regions:
        placed = place_surfaces(scene, unit, source.up, source.parts, ratio)
        names, region_of = find_regions(surface, placed)
    return replace(
        read,
        surface=surface,
        source=replace(source, notes=tuple(notes)),
        assembly=describe_assembly(assembling, joined),
        regions=names,
        region_of=region_of,
        colour=colour,
        filling_vertices=None if filling is None else filling.vertices.ravel(),
        filling_tetrahedra=None if filling is None else filling.tetrahedra.ravel(),
    )


def colour_surface(
    surface: Surface, scene: authoring.ImportedScene, source: Source, unit: str, ratio: float
) -> tuple[Surface, list[str]]:
    """With the colours that the file has for its vertices, and a word of them; of a picture that
    cannot be decoded as well."""
    parts = [part for part in scene.parts if part.name in source.parts]
    used = {int(n) for part in parts for n in np.unique(np.asarray(part.pictures))}
    pictures, notes = decode_pictures(scene.pictures if used - {-1} else [])
    placed = [at for _, at in place_surfaces(scene, unit, source.up, source.parts, ratio)]
    colours = paint_surface(surface, parts, placed, pictures)
    if colours is None:
        return surface, notes
    drawn = sum(picture is not None for picture in pictures)
    if drawn == 0:
        notes.append("its colours come along, one for each vertex")
    elif drawn == 1:
        notes.append("its colours come along, one for each vertex, of its picture")
    else:
        notes.append(f"its colours come along, one for each vertex, of its {drawn} pictures")
    return replace(surface, colours=colours), notes


def describe_assembly(assembling: Assembling, joined: authoring.JoinedSurface) -> Assembly | None:
    if assembling == BESIDE:
        return None
    return Assembly(
        weld=assembling.weld,
        unite=assembling.unite,
        subtracted=tuple(joined.subtracted),
        regions=assembling.regions,
    )


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
        surface=replace(read.surface, vertices=ratio * read.surface.vertices),
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
        notes=(*scene.notes, *joined.notes, *list_changes(repaired)),
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
