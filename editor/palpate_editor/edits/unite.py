# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that lie inside each other or cross, as the one solid that they fill together."""

from __future__ import annotations

from dataclasses import dataclass
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
        return put_in_place(organ, unite)


def is_one_piece(surface: Surface) -> bool:
    shell = palpate.find_shells(len(surface.vertices), surface.triangles)
    return bool(np.max(shell) < 1)


def unite(surface: Surface) -> Surface:
    """The very same surface where it is one piece. Raises EditError."""
    if is_one_piece(surface):
        return surface
    try:
        mesh = authoring.unite_shells(palpate.SurfaceMesh(surface.vertices, surface.triangles))
    except ValueError as problem:
        raise EditError(
            phrase("The pieces cannot be united: {problem}.", problem=str(problem))
        ) from None
    return Surface(np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def can_be_united(surface: Surface) -> bool:
    """Whether there are pieces, all of them closed, of which none crosses itself."""
    shell = np.asarray(palpate.find_shells(len(surface.vertices), surface.triangles))
    if np.max(shell, initial=0) < 1 or not palpate.is_closed(surface.triangles):
        return False
    mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    found = authoring.find_crossing_groups(mesh, shell[surface.triangles[:, 0]].tolist())
    return found is not None and not found[1]
