# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces from OBJ, STL and PLY files, read by the package itself.

Formats other than these, parts, units that must be guessed and surfaces that must be repaired are
work for `palpate import`, of palpate-editor.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from palpate._sim import SurfaceMesh
from palpate.error import FileError
from palpate.files.read_file import read_file
from palpate.mesh_files.obj import read_obj
from palpate.mesh_files.ply import read_ply
from palpate.mesh_files.stl import read_stl

Surface = tuple[NDArray[np.float64], NDArray[np.int64]]
READERS: dict[str, Callable[[str, bytes], Surface]] = {
    ".obj": read_obj,
    ".stl": read_stl,
    ".ply": read_ply,
}
UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}
"""[m] of the units a file may be in; none of the three formats says which."""


def read_mesh(path: str | os.PathLike[str], unit: str = "m") -> SurfaceMesh:
    """Reads a surface from a .obj, .stl or .ply file.

    Polygons become fans of triangles about their first corner. Of an OBJ only `v` and `f` count:
    materials, normals, textures and groups are passed over, and all objects of the file are one
    surface. STL, which repeats every corner, is welded: corners with the very same numbers become
    one vertex. Nothing else is changed; `validate` says whether the surface is sound.

    Args:
        path: the file; its suffix, in small or capital letters, says which format it is in.
        unit: "m", "cm" or "mm": what the file's numbers are in.

    Returns:
        The surface, vertices [m], shape (n, 3), and triangles, shape (t, 3).

    Raises:
        FileError: for a file that is damaged or no surface, naming line, row or byte, what was
            found there and what was expected; OSError for one that cannot be opened.
        ValueError: for another unit.
    """
    file = Path(path)
    if unit not in UNITS:
        raise ValueError(f"unit: got {unit!r}, expected one of {', '.join(UNITS)}")
    reader = READERS.get(file.suffix.lower())
    if reader is None:
        raise FileError(
            str(file), "", f"the suffix {file.suffix!r}", "one of " + ", ".join(READERS)
        )
    vertices, triangles = reader(str(file), read_file(file))
    if len(triangles) == 0:
        raise FileError(str(file), "", "no faces", "a surface")
    return SurfaceMesh(UNITS[unit] * vertices, triangles)
