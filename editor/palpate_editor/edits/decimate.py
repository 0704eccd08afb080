# SPDX-License-Identifier: GPL-3.0-or-later
"""Making a surface coarse enough for a thousand ticks a second."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Decimation, Organ, Surface, phrase
from palpate_editor.edits.carry import carry_paint
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.repair import find_crowded, find_disagreeing


@dataclass(frozen=True, eq=False)
class Decimate:
    """Use a coarser surface; what was painted is carried over to it."""

    source: Surface
    """What was decimated: the imported surface."""
    surface: Surface
    decimation: Decimation

    @property
    def title(self) -> str:
        return phrase("Decimate to {count} vertices", count=self.decimation.vertices)

    @property
    def repeat(self) -> DecimateTo:
        """What does it again."""
        return DecimateTo(self.decimation.vertices)

    def __call__(self, organ: Organ) -> Organ:
        if organ.imported is not self.source:
            raise EditError(
                phrase("The organ has changed since it was decimated: decimate it again.")
            )
        return replace(carry_paint(organ, self.surface), decimation=self.decimation)


def decimate_organ(organ: Organ, vertices: int) -> Decimate:
    """Decimates the imported surface to exactly `vertices`: seconds for a large one, on any thread.

    Always from the imported surface, so that trying several counts costs no quality.
    Raises EditError where there is no organ or the count cannot be reached.
    """
    find_surface(organ)
    source = organ.imported
    assert source is not None
    if len(find_crowded(source.triangles)) or len(find_disagreeing(source.triangles)):
        raise EditError(
            phrase("It cannot be decimated before Repair has mended its surface: see its problems.")
        )
    try:
        found = authoring.decimate(palpate.SurfaceMesh(source.vertices, source.triangles), vertices)
    except ValueError as problem:
        raise EditError(
            phrase(
                "It cannot be decimated to {vertices} vertices: {why}",
                vertices=vertices,
                why=str(problem),
            )
        ) from None
    surface = Surface(np.asarray(found.mesh.vertices), np.asarray(found.mesh.triangles))
    return Decimate(
        source,
        surface,
        Decimation(
            vertices_before=len(source.vertices),
            triangles_before=len(source.triangles),
            vertices=len(surface.vertices),
            triangles=len(surface.triangles),
            smallest_angle_deg=found.smallest_angle_deg,
            mean_distance=found.mean_distance,
            max_distance=found.max_distance,
        ),
    )


@dataclass(frozen=True)
class DecimateTo:
    """Decimate the imported surface to a number of vertices: seconds for a large one."""

    vertices: int

    @property
    def title(self) -> str:
        return phrase("Decimate to {count} vertices", count=self.vertices)

    def __call__(self, organ: Organ) -> Organ:
        return decimate_organ(organ, self.vertices)(organ)


@dataclass(frozen=True)
class UseImported:
    """Use the imported surface as it is, not a decimated one."""

    title: ClassVar[str] = "Use the imported surface"

    def __call__(self, organ: Organ) -> Organ:
        find_surface(organ)
        if organ.imported is None or organ.imported is organ.surface:
            raise EditError(phrase("The imported surface is in use already."))
        return replace(carry_paint(organ, organ.imported), decimation=None)
