# SPDX-License-Identifier: BSD-3-Clause
"""Writes a generated mesh as an OBJ file in metres."""

from __future__ import annotations

import os

import numpy as np
from palpate.files.whole_file import write_whole

MARK = "# palpate: unit m, up z"
"""Tells the importer unit and up axis, so that it need not guess."""


def write_obj(path: str | os.PathLike[str], vertices: np.ndarray, triangles: np.ndarray) -> None:
    """Writes v and f lines with the fewest digits that give the same bits when read back.

    The file is there whole or not at all.
    """
    lines = [MARK]
    lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(vertices, float).tolist()]
    lines += [f"f {i} {j} {k}" for i, j, k in np.asarray(triangles) + 1]
    write_whole(path, ("\n".join(lines) + "\n").encode("ascii"))
