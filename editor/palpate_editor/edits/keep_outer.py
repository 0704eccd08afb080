# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping of an atlas's organ, which is a soup of nested parts, what is seen from outside."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.dropped import Dropped, list_dropped, measure_dropped
from palpate_editor.edits.edit import EditError, find_surface

SEEN = 0.05
"""[-] of a piece's triangles that are seen from outside, where it is kept."""


@dataclass(frozen=True)
class Piece(Dropped):
    """A piece that lies within others."""

    exposed: float
    """[-] of its triangles: seen from outside past all others."""


@dataclass(frozen=True, eq=False)
class Outer:
    """What is seen from outside, and what lies within."""

    surface: Surface
    """The very same where nothing lies within."""
    dropped: tuple[Piece, ...]
    """The largest first."""


def find_shells(surface: Surface) -> tuple[np.ndarray, np.ndarray]:
    """(t,) the piece of each triangle, and of each piece [-] what is seen of it from outside."""
    x, triangles = surface.vertices, surface.triangles
    shells = np.asarray(palpate.find_shells(len(x), triangles))[triangles[:, 0]]
    return shells, np.array(authoring.measure_exposure(palpate.SurfaceMesh(x, triangles)))


def find_outer(surface: Surface) -> np.ndarray:
    """(t,) bool: triangles of pieces of which more than a few are seen from outside."""
    shells, exposed = find_shells(surface)
    return exposed[shells] > SEEN


def keep_outer(surface: Surface) -> Outer:
    """The pieces of which more than a few triangles are seen from outside."""
    x, triangles = surface.vertices, surface.triangles
    shells, exposed = find_shells(surface)
    kept = exposed[shells] > SEEN
    if kept.all():
        return Outer(surface, ())
    pieces = [
        Piece(**vars(measure_dropped(x[triangles[shells == shell]])), exposed=float(exposed[shell]))
        for shell in np.unique(shells[~kept])
    ]
    pieces.sort(key=lambda piece: -piece.size)
    used, numbers = np.unique(triangles[kept], return_inverse=True)
    return Outer(Surface(x[used], numbers.reshape(-1, 3)), tuple(pieces))


@dataclass(frozen=True)
class KeepOuter:
    """Throw away the pieces of the surface that are not seen from outside."""

    title: ClassVar[str] = "Keep what is seen from outside"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        outer = keep_outer(surface)
        if outer.surface is surface:
            raise EditError(phrase("No piece of the surface lies inside of others."))
        imported = outer.surface
        if organ.imported is not None and organ.imported is not surface:
            imported = keep_outer(organ.imported).surface
        decimation = organ.decimation and replace(
            organ.decimation,
            vertices=len(outer.surface.vertices),
            triangles=len(outer.surface.triangles),
        )
        source = organ.source and replace(
            organ.source, notes=(*organ.source.notes, list_dropped(outer.dropped, "inner {piece}"))
        )
        changed = carry_paint(organ, outer.surface)
        return replace(changed, imported=imported, decimation=decimation, source=source)
