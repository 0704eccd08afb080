# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairing what reading a file could not decide alone."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.edit import EditError, find_surface


@dataclass(frozen=True)
class KeepLargestShell:
    """Throw away every piece of the surface but the one with the most area."""

    title: ClassVar[str] = "Keep the largest piece"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        kept = keep_largest(surface)
        if kept is surface:
            raise EditError(phrase("The surface is one piece already."))
        imported = surface if organ.imported is None else organ.imported
        whole = kept if imported is surface else keep_largest(imported)
        changed = carry_paint(organ, kept)
        decimation = organ.decimation
        if decimation is not None:
            decimation = replace(
                decimation, vertices=len(kept.vertices), triangles=len(kept.triangles)
            )
        return replace(changed, imported=whole, decimation=decimation)


def keep_largest(surface: Surface) -> Surface:
    """The shell of `surface` with the most area; the very same surface where it is the only one."""
    x, triangles = surface.vertices, surface.triangles
    shell = np.asarray(palpate.find_shells(len(x), triangles))
    side = x[triangles[:, 1:]] - x[triangles[:, :1]]
    areas = 0.5 * np.linalg.norm(np.cross(side[:, 0], side[:, 1]), axis=1)
    of_triangle = shell[triangles[:, 0]]
    largest = np.bincount(of_triangle, areas).argmax()
    kept = of_triangle == largest
    if kept.all():
        return surface
    used = np.unique(triangles[kept])
    number = np.full(len(x), -1, np.int32)
    number[used] = np.arange(len(used), dtype=np.int32)
    return Surface(x[used], number[triangles[kept]])


@dataclass(frozen=True)
class TurnOutward:
    """Turn a closed surface inside out, where its triangles face inwards."""

    title: ClassVar[str] = "Turn triangles outward"

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not palpate.is_closed(surface.triangles):
            raise EditError(phrase("A surface with holes has no outside to turn to."))
        mesh = palpate.SurfaceMesh(surface.vertices, surface.triangles)
        if palpate.compute_volume(mesh) > 0.0:
            raise EditError(phrase("The triangles face outwards already."))
        turned = Surface(surface.vertices, surface.triangles[:, ::-1])
        imported = turned if organ.imported is surface else organ.imported
        # the vertices are the same, so what was painted on them is too
        return replace(organ, surface=turned, imported=imported)
