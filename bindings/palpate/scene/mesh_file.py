# SPDX-License-Identifier: BSD-3-Clause
"""The mesh of a scene file: an OBJ in metres, and sound.

Other files come in through `palpate import`, which writes this.
"""

from __future__ import annotations

from pathlib import Path

import palpate
from palpate.files.refusal import Refusal


def read_mesh_file(path: Path) -> palpate.SurfaceMesh:
    """Reads a surface in metres that a model can be built on.

    Raises Refusal, naming the line, or OSError.
    """
    try:
        mesh = palpate.read_mesh(path)
    except palpate.FileError as problem:
        raise Refusal(path, problem.where, problem.got, problem.expected) from None
    try:
        palpate.validate(mesh)
    except ValueError as problem:
        raise Refusal(
            path, "", str(problem), "a clean surface: `palpate import` repairs it"
        ) from None
    return mesh
