# SPDX-License-Identifier: GPL-3.0-or-later
"""From foreign mesh files to surfaces a tissue can be built on.

    scene = read_mesh("spleen.glb")            # what the file holds, in its own units
    joined = join_parts(scene)                 # one surface, welded, metres, z up
    report = inspect_mesh(joined.mesh)         # what is good and bad about it
    organ = import_mesh("spleen.glb")          # all of that, repaired: whatever can be drawn
    small = decimate(organ.mesh, 600)          # exactly 600 vertices, well-shaped triangles
    closed = fill_holes(organ.mesh, [0, 1])    # the first two holes closed
    write_mesh("spleen.obj", small.mesh)
    solid = fill_interior(small.mesh, 8e-3)    # tetrahedra of about 8 mm inside
    solid = fill_to_count(small.mesh, 3000)    # 3000 of them, to a tenth

A file that is refused raises `palpate.FileError` with file, where, found, expected; a wrong
argument raises `ValueError`.
"""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from pathlib import Path

from palpate import FileError

from palpate_editor import _authoring
from palpate_editor._authoring import (
    CombinedParts,
    DecimatedMesh,
    FilledHoles,
    Histogram,
    ImportedMesh,
    ImportedPart,
    ImportedScene,
    JoinedSurface,
    MeshReport,
    PartPlace,
    Picture,
    RepairedMesh,
    StitchedMesh,
    SurfaceDistance,
    UncrossedMesh,
    WrappedMesh,
    choose_cell_size,
    cut_crowded_edges,
    decimate,
    fill_holes,
    fill_interior,
    fill_to_count,
    find_crossing_groups,
    find_places,
    find_self_intersecting_faces,
    import_scene,
    inspect_mesh,
    join_parts,
    measure_distance,
    measure_exposure,
    measure_seen_distance,
    remesh_surface,
    remove_crossings,
    repair_mesh,
    smooth_surface,
    stitch_borders,
    unite_shells,
    wrap_surface,
    write_mesh,
)
from palpate_editor.formats import (
    MEMORY_LIMIT,
    TIME_LIMIT,
    build_words,
    find_format,
    find_missing,
    open_plain,
)

__all__ = [
    "MEMORY_LIMIT",
    "READER",
    "TIME_LIMIT",
    "CombinedParts",
    "DecimatedMesh",
    "FilledHoles",
    "Histogram",
    "ImportedMesh",
    "ImportedPart",
    "ImportedScene",
    "JoinedSurface",
    "MeshReport",
    "PartPlace",
    "Picture",
    "RepairedMesh",
    "StitchedMesh",
    "SurfaceDistance",
    "UncrossedMesh",
    "WrappedMesh",
    "choose_cell_size",
    "cut_crowded_edges",
    "decimate",
    "fill_holes",
    "fill_interior",
    "find_crossing_groups",
    "find_places",
    "fill_to_count",
    "find_self_intersecting_faces",
    "import_mesh",
    "import_scene",
    "inspect_mesh",
    "join_parts",
    "measure_distance",
    "measure_exposure",
    "measure_seen_distance",
    "read_mesh",
    "remesh_surface",
    "remove_crossings",
    "repair_mesh",
    "smooth_surface",
    "stitch_borders",
    "unite_shells",
    "wrap_surface",
    "write_mesh",
]

READER = Path(_authoring.__file__).with_name("palpate-read-mesh")
"""The program that reads foreign files, in a process of its own so that none can do harm."""


def read_mesh(
    path: str | PathLike[str],
    *,
    time_limit: float = TIME_LIMIT,
    memory_limit: int = MEMORY_LIMIT,
    reader: str | PathLike[str] = READER,
) -> ImportedScene:
    """Reads a mesh file in a child process.

    Which format it is, its extension tells, or its content: see palpate_editor.formats. Some are
    read by `reader`, the others by an isolated Python. A file that was packed by gzip is unpacked.
    """
    with open_plain(Path(path)) as plain:
        form = find_format(plain)
        missing = find_missing(form)
        if missing is not None:
            raise FileError(
                str(path),
                "",
                f"a {plain.suffix} file, which the package {missing} reads, and it is not there",
                "that package: pip install palpate-editor[formats]",
            )
        program, *words = build_words(form) or [reader]
        limits = {"time_limit": time_limit, "memory_limit": memory_limit}
        return _authoring.read_mesh(plain, format=form or "", reader=program, words=words, **limits)


def import_mesh(
    path: str | PathLike[str],
    *,
    parts: Sequence[str] = (),
    unit: str | None = None,
    up: str | None = None,
    weld: float | None = None,
    unite: bool = False,
    subtract: Sequence[str] = (),
    time_limit: float = TIME_LIMIT,
    memory_limit: int = MEMORY_LIMIT,
    reader: str | PathLike[str] = READER,
) -> ImportedMesh:
    """Reads, joins, repairs, orients outward and measures: whatever can be drawn.

    Whether a tissue can be built on it is told by its report and by palpate.validate. Raises
    FileError for what cannot be read or has nothing to draw.

    Args:
        path: The mesh file.
        parts: Names of the scene's parts, or of groups of them, to use; all when empty.
        unit: "m", "cm", "mm" or "in"; what the file states, else a guess by size, when None.
        up: "x", "y", "z", "-x", "-y" or "-z"; what the file states, else "z", when None.
        weld: [m] Vertices of different parts that are closer become one.
        unite: The parts are solids, and become one.
        subtract: Names of parts or groups whose inside is taken away from the others.
        time_limit: [s] for the reader.
        memory_limit: [bytes] for the reader.
        reader: The reading program.
    """
    scene = read_mesh(path, time_limit=time_limit, memory_limit=memory_limit, reader=reader)
    return import_scene(
        scene, parts=parts, unit=unit, up=up, weld=weld, unite=unite, subtract=subtract
    )
