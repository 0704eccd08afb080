# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that lie inside each other or cross, as the one solid that they fill together."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.repair import put_in_place


@dataclass(frozen=True)
class UniteShells:
    """Make one solid of all closed pieces; what of them lies inside goes."""

    title: ClassVar[str] = "Unite the pieces"

    problem: str = "crossing"
    """That it solves."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if is_one_piece(surface):
            raise EditError(phrase("The surface is one piece already."))
        notes: list[str] = []
        united = put_in_place(organ, lambda surface: unite(surface, notes))
        source = united.source
        if source is None or not notes:
            return united
        # both surfaces of a decimated organ may have crossed alike
        return replace(united, source=replace(source, notes=(*source.notes, *dict.fromkeys(notes))))


def is_one_piece(surface: Surface) -> bool:
    shell = palpate.find_shells(len(surface.vertices), surface.triangles)
    return bool(np.max(shell) < 1)


def unite(surface: Surface, notes: list[str]) -> Surface:
    """The very same surface where it is one piece. What had to be changed in its pieces is added to
    `notes`. Raises EditError."""
    if is_one_piece(surface):
        return surface
    try:
        found = authoring.unite_shells(palpate.SurfaceMesh(surface.vertices, surface.triangles))
    except ValueError as problem:
        raise EditError(
            phrase("The pieces cannot be united: {problem}.", problem=str(problem))
        ) from None
    notes += found.notes
    return Surface(np.asarray(found.mesh.vertices), np.asarray(found.mesh.triangles))


def can_be_united(surface: Surface) -> bool:
    """Whether there are pieces, all of them closed, of which none crosses itself."""
    shell = np.asarray(palpate.find_shells(len(surface.vertices), surface.triangles))
    if np.max(shell, initial=0) < 1 or not palpate.is_closed(surface.triangles):
        return False
    mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    found = authoring.find_crossing_groups(mesh, shell[surface.triangles[:, 0]].tolist())
    return found is not None and not found[1]
