# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed pieces that lie inside of others and face outwards too: what both enclose counts twice."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.clean import measure_pieces, put_in_place, take
from palpate_editor.edits.dropped import list_dropped, measure_dropped
from palpate_editor.edits.edit import EditError, find_surface

INSIDE = 0.75
"""[-] Windings: a point on a surface has one of a half."""
ASKED = 9
"""Vertices of a piece that are asked whether they lie inside."""


def compute_winding(corners: np.ndarray, point: np.ndarray) -> float:
    """How often triangles (t, 3, 3) wind around a point: the solid angle over 4 pi."""
    a, b, c = (corners[:, i] - point for i in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    above = np.einsum("ij,ij->i", a, np.cross(b, c))
    below = la * lb * lc + np.einsum("ij,ij->i", a, b) * lc
    below += np.einsum("ij,ij->i", b, c) * la + np.einsum("ij,ij->i", c, a) * lb
    return float(np.arctan2(above, below).sum() / (2.0 * np.pi))


def find_doubled(surface: Surface) -> np.ndarray:
    """(t,) bool: of closed pieces that enclose what others enclose, and face outwards as they do.
    A piece that faces inwards is the wall of a cavity, and what lies in a cavity encloses its own.
    """
    pieces = measure_pieces(surface)
    corners = surface.vertices[surface.triangles]
    of = pieces.of_triangle
    doubled = np.zeros(len(pieces.areas), bool)
    sixths = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    outwards = np.bincount(of, sixths, len(pieces.areas)) > 0.0
    if np.count_nonzero(pieces.closed) < 2:
        return doubled[of]
    by_piece = [corners[of == piece] for piece in range(len(pieces.areas))]
    low = np.array([own.min(axis=(0, 1)) for own in by_piece])
    high = np.array([own.max(axis=(0, 1)) for own in by_piece])
    for piece in np.flatnonzero(pieces.closed & outwards):
        around = pieces.closed & (low <= low[piece]).all(axis=1) & (high >= high[piece]).all(axis=1)
        around[piece] = False
        if not (around & outwards).any():
            continue
        points = np.unique(by_piece[piece].reshape(-1, 3), axis=0)
        others = corners[around[of]]
        asked = points[:: max(1, len(points) // ASKED)]
        doubled[piece] = np.median([compute_winding(others, p) for p in asked]) > INSIDE
    return doubled[of]


@dataclass(frozen=True)
class DropDoubled:
    """Drop closed pieces inside of others that face outwards as well."""

    title: ClassVar[str] = "Drop pieces that are counted twice"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        doubled = find_doubled(surface)
        if not doubled.any():
            raise EditError(phrase("No piece of the surface lies inside of others."))
        shells = np.asarray(palpate.find_shells(len(surface.vertices), surface.triangles))
        shells = shells[surface.triangles[:, 0]]
        dropped = [
            measure_dropped(surface.vertices[surface.triangles[shells == shell]])
            for shell in np.unique(shells[doubled])
        ]
        dropped.sort(key=lambda piece: -piece.size)
        changed = put_in_place(organ, drop)
        said = list_dropped(dropped, "inner {piece}")
        source = changed.source and replace(changed.source, notes=(*changed.source.notes, said))
        return replace(changed, source=source)


def drop(surface: Surface) -> Surface:
    doubled = find_doubled(surface)
    return take(surface, ~doubled) if doubled.any() else surface
