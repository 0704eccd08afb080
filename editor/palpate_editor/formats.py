# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of VTK and Gmsh, read in a process of its own; those of VTK by its own library.

A reader of these formats is a Python that imports nothing from where the user stands, limits its
memory and time, opens nothing but the one file, and writes what it found in the words of
palpate-read-mesh (core/authoring/scene_stream.h). This module only says how it is started: nothing
of VTK is ever imported by a program that opens windows.
"""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path

from palpate.system.isolated import build_isolated

NEEDED = {
    ".vtk": "vtkmodules",
    ".vtp": "vtkmodules",
    ".vtu": "vtkmodules",
    ".msh": "numpy",
}
"""Extension -> the module that is needed to read such files."""

PACKAGES = {"vtkmodules": "vtk", "numpy": "numpy"}
"""Module -> the package that has it."""

CHILD = Path(__file__).parent / "formats_child" / "child.py"


def find_missing(path: Path) -> str | None:
    """The package that is missing to read a file; None where nothing is, or none is needed."""
    module = NEEDED.get(path.suffix.lower())
    if module is None or find_spec(module) is not None:
        return None
    return PACKAGES[module]


def build_words(path: Path) -> list[str] | None:
    """What starts a reader of such a file, up to its name; None where palpate-read-mesh reads it.

    The interpreter is isolated (-I); the folders its modules are in are told it, as a user may have
    installed some of them for himself alone.
    """
    module = NEEDED.get(path.suffix.lower())
    if module is None:
        return None
    folders = []
    for name in ("palpate_editor", module, "numpy"):
        found = find_spec(name)
        if found is not None and found.origin is not None:
            folders.append(str(Path(found.origin).parent.parent))
    return build_isolated(CHILD, os.pathsep.join(dict.fromkeys(folders)))
