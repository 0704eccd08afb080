# SPDX-License-Identifier: GPL-3.0-or-later
"""A region for each part of a file that became an organ: where to give each its own tissue."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import palpate

from palpate_editor.document import Surface
from palpate_editor.edits.regions import MOST_NAME_BYTES, MOST_REGIONS


def find_regions(
    surface: Surface, parts: Sequence[tuple[str, Surface]]
) -> tuple[tuple[str, ...], np.ndarray]:
    """The names of parts, and which of them each vertex of `surface` (n,) is of: the first of those
    it lies on or, where it is new, the closest.

    Raises ValueError for more parts than an organ can have regions, and for a name too long.
    """
    if len(parts) > MOST_REGIONS:
        raise ValueError(
            f"regions: got {len(parts)} parts, expected at most {MOST_REGIONS}: choose fewer"
        )
    for name, _ in parts:
        if not name.strip() or len(name.encode()) > MOST_NAME_BYTES:
            raise ValueError(
                f"regions: got a part named {name[:40]!r}, expected a name of 1 to "
                f"{MOST_NAME_BYTES} bytes"
            )
    owner = find_owners(surface.vertices, parts).astype(np.int32)
    return tuple(name for name, _ in parts), owner


def find_owners(points: np.ndarray, parts: Sequence[tuple[str, Surface]]) -> np.ndarray:
    """(n,) the part each point is of."""
    known: dict[bytes, int] = {}
    for row, (_, part) in enumerate(parts):
        for key in list_keys(part.vertices):
            known.setdefault(key, row)
    owner = np.array([known.get(key, -1) for key in list_keys(points)], int)
    new = np.flatnonzero(owner < 0)
    if len(new):
        owner[new] = find_closest_parts(points[new], parts)
    return owner


def list_keys(points: np.ndarray) -> list[bytes]:
    """The bits of each point; zero has no sign."""
    return [row.tobytes() for row in np.ascontiguousarray(points) + 0.0]


def find_closest_parts(points: np.ndarray, parts: Sequence[tuple[str, Surface]]) -> np.ndarray:
    """Of points that are no vertex of any part: a cut made them."""
    counts = np.cumsum([0, *(len(part.vertices) for _, part in parts)])
    vertices = np.concatenate([part.vertices for _, part in parts])
    triangles = np.concatenate(
        [part.triangles + first for (_, part), first in zip(parts, counts, strict=False)]
    )
    of_triangle = np.repeat(np.arange(len(parts)), [len(part.triangles) for _, part in parts])
    tree = palpate.AabbTree(vertices, triangles.astype(np.int32))
    found = [palpate.find_closest_point(tree, vertices, point).triangle for point in points]
    return of_triangle[found]
