# SPDX-License-Identifier: GPL-3.0-or-later
"""Closing holes of a surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
import palpate
from palpate.scene.scene_parts import LATER

from palpate_editor import authoring
from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.bend_patch import bend_patches
from palpate_editor.edits.carry import find_closest
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.even_patch import even_patches
from palpate_editor.edits.wall import settle_wall


@dataclass(frozen=True)
class FillHoles:
    """Close holes with smooth patches; what is painted around them goes on over them."""

    title: ClassVar[str] = "Fill holes"

    holes: tuple[int, ...] | None = None
    """Numbers in palpate.find_border_loops of the surface in use; None for all."""

    even: bool = field(default=False, metadata={LATER: True})
    """With triangles as long as those of the rim. Histories from before that was done have none."""
    bent: bool = field(default=False, metadata={LATER: True})
    """Even patches go on in the planes of the triangles at the rim, where it allows that
    (bend_patch.py). Histories from before that was done have none."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        loops = palpate.find_border_loops(surface.triangles)
        holes = tuple(range(len(loops))) if self.holes is None else self.holes
        if not loops or not holes:
            raise EditError(phrase("There is no hole to fill."))
        if min(holes) < 0 or max(holes) >= len(loops):
            raise EditError(
                phrase(
                    "Hole: got {got}, expected 0 to {most}.",
                    got=min(holes) if min(holes) < 0 else max(holes),
                    most=len(loops) - 1,
                )
            )
        closed = fill(surface, holes, self.even, self.bent)
        if closed is surface:
            raise EditError(
                phrase(
                    "No patch fits: a hole touches another one, is too large, or would be closed "
                    "through the surface."
                )
            )
        imported = organ.imported
        if imported is surface:
            imported = closed
        elif imported is not None:
            there = match_holes(surface, holes, imported)
            imported = fill(imported, there, self.even, self.bent)
        filled = replace(
            organ,
            surface=closed,
            imported=imported,
            far_field=None,
            decimation=organ.decimation
            and replace(
                organ.decimation, vertices=len(closed.vertices), triangles=len(closed.triangles)
            ),
            fixed=np.append(
                organ.fixed, np.zeros(len(closed.vertices) - len(surface.vertices), bool)
            ),
            stiffness_scale=spread(organ.stiffness_scale, surface, closed),
        )
        return settle_wall(filled, organ)


def fill(surface: Surface, holes: Sequence[int], even: bool, bent: bool = False) -> Surface:
    """The surface with patches, its own vertices first; the very same where none fits."""
    mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
    try:
        found = authoring.fill_holes(mesh, list(holes))
    except ValueError as problem:
        raise EditError(phrase("The holes cannot be filled: {why}", why=str(problem))) from None
    if not found.filled:
        return surface
    closed = Surface(np.asarray(found.mesh.vertices), np.asarray(found.mesh.triangles))
    if not even:
        return closed
    evened = even_patches(closed, len(surface.vertices), len(surface.triangles))
    return bend_patches(evened, surface) if bent else evened


def spread(scale: np.ndarray, surface: Surface, closed: Surface) -> np.ndarray:
    """The factors of stiffness with those of new vertices, each as at the point closest to it."""
    new = closed.vertices[len(surface.vertices) :]
    if not len(new):
        return scale
    corners, weights = find_closest(surface, new)
    return np.append(scale, (scale[corners] * weights).sum(axis=1))


def match_holes(surface: Surface, holes: Sequence[int], other: Surface) -> tuple[int, ...]:
    """The holes of another surface of the same organ whose middles are nearest to those."""
    wanted = find_middles(surface)[list(holes)]
    there = find_middles(other)
    if not len(there):
        return ()
    away = np.linalg.norm(wanted[:, None] - there[None], axis=2)
    return tuple(sorted(set(away.argmin(axis=1).tolist())))


def find_middles(surface: Surface) -> np.ndarray:
    """[m] (h, 3) the mean of the vertices of each hole."""
    loops = palpate.find_border_loops(surface.triangles)
    return np.array([surface.vertices[loop].mean(axis=0) for loop in loops]).reshape(-1, 3)
