# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a legacy file of VTK has all the voxels its header says: SimpleITK does not ask."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from palpate_editor.scan_child.refused import Refused

HEADER_TEXT = 4096
"""[bytes] that are looked at."""
HEADER = re.compile(rb"^SCALARS[^\n]*\n(?:LOOKUP_TABLE[^\n]*\n)?", re.M | re.I)
BINARY = re.compile(rb"^BINARY\s*$", re.M | re.I)


def check_vtk(path: Path, size: tuple[int, ...], voxel_bytes: int) -> None:
    """Raises Refused for a file that ends before its voxels do, or has none.

    Args:
        path: Of structured points.
        size: As the header says.
        voxel_bytes: [bytes] of one, in a binary file.
    """
    with path.open("rb") as file:
        head = file.read(HEADER_TEXT)
        found = HEADER.search(head)
        if found is None:
            raise Refused("header", "no SCALARS", "one grey level or label for each point")
        file.seek(found.end())
        rest = file.read()
    wanted = int(np.prod(size))
    is_binary = BINARY.search(head[: found.start()]) is not None
    got = len(rest) // voxel_bytes if is_binary else len(rest.split())
    if got < wanted:
        shown = " x ".join(map(str, size))
        raise Refused("voxels", f"{got} numbers", f"{shown} voxels, as the header says")
