# SPDX-License-Identifier: GPL-3.0-or-later
"""Making a surface coarse enough for a thousand ticks a second."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Decimation, Organ, Surface, phrase
from palpate_editor.edits.carry import carry_far_field, carry_paint, number_painted
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.history import LATER
from palpate_editor.edits.repair import find_crowded, find_disagreeing
from palpate_editor.vertex_colours import carry_colours

MOST_TRIES = 16
"""Counts that are tried for an error."""
FINE = 0.02
"""[-] How near the count that is found is to the fewest."""


@dataclass(frozen=True, eq=False)
class Decimate:
    """Use a coarser surface; what was painted is carried over to it."""

    source: Surface
    """What was decimated: the imported surface."""
    surface: Surface
    decimation: Decimation
    error: float | None = None
    """[m] See DecimateTo."""
    features: bool = False
    """See DecimateTo."""
    kept_length: float = 0.0
    """[m] Of ridges and of borders of what is painted that are on their lines."""
    left_out_length: float = 0.0
    """[m] Of those that so few vertices have no room for."""

    @property
    def title(self) -> str:
        return self.repeat.title

    @property
    def repeat(self) -> DecimateTo:
        """What does it again."""
        return DecimateTo(self.decimation.vertices, self.error, self.features)

    def __call__(self, organ: Organ) -> Organ:
        if organ.imported is not self.source:
            raise EditError(
                phrase("The organ has changed since it was decimated: decimate it again.")
            )
        # vertices on the borders of what is painted are in it, all others on either side
        exact = self.features and organ.surface is self.source and not self.left_out_length
        made = replace(carry_paint(organ, self.surface, exact), decimation=self.decimation)
        return carry_far_field(organ, made) if self.features else made


def find_repaired(organ: Organ) -> Surface:
    """The imported surface. Raises EditError where there is none, or one to be repaired."""
    find_surface(organ)
    source = organ.imported
    assert source is not None
    if len(find_crowded(source.triangles)) or len(find_disagreeing(source.triangles)):
        raise EditError(
            phrase("It cannot be decimated before its surface is repaired: see its problems.")
        )
    return source


def decimate_organ(organ: Organ, vertices: int, features: bool = False) -> Decimate:
    """Decimates the imported surface to exactly `vertices`: seconds for a large one, on any thread.

    Always from the imported surface, so that trying several counts costs no quality.
    Raises EditError where there is no organ or the count cannot be reached.

    Args:
        organ: What is decimated.
        vertices: Of the new surface.
        features: See DecimateTo.
    """
    source = find_repaired(organ)
    mesh = palpate.SurfaceMesh(source.vertices, source.triangles)
    numbers = number_painted(organ, source) if features else ()
    try:
        found = authoring.decimate(
            mesh, vertices, *(n.tolist() for n in numbers), features=features
        )
    except ValueError as problem:
        raise EditError(
            phrase(
                "It cannot be decimated to {vertices} vertices: {why}",
                vertices=vertices,
                why=str(problem),
            )
        ) from None
    made = Surface(np.asarray(found.mesh.vertices), np.asarray(found.mesh.triangles))
    surface = carry_colours(made, source)
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
        features=features,
        kept_length=found.kept_length,
        left_out_length=found.left_out_length,
    )


@dataclass(frozen=True)
class DecimateTo:
    """Decimate the imported surface to a number of vertices: seconds for a large one."""

    vertices: int
    error: float | None = None
    """[m] The distance from the imported surface for which so many were found to be needed."""
    features: bool = field(default=False, metadata={LATER: True})
    """Whether ridges and the borders of what is held, stiffer or named stay on their lines, and
    thin parts count for more. Lines of before have nothing of it, and decimate as they did."""

    @property
    def title(self) -> str:
        if self.error is None:
            return phrase("Decimate to {count} vertices", count=self.vertices)
        return phrase(
            "Decimate to {count} vertices, within {error:g} mm",
            count=self.vertices,
            error=1e3 * self.error,
        )

    def __call__(self, organ: Organ) -> Organ:
        edit = decimate_organ(organ, self.vertices, self.features)
        found = edit.decimation.max_distance
        if self.error is not None and found > self.error:
            raise EditError(
                phrase(
                    "{count} vertices are {found:.4g} mm from the source, not within {error:g} mm.",
                    count=self.vertices,
                    found=1e3 * found,
                    error=1e3 * self.error,
                )
            )
        return replace(edit, error=self.error)(organ)


def decimate_within(organ: Organ, error: float, features: bool = False) -> Decimate:
    """Decimates the imported surface to the fewest vertices, within 2 %, that keep every point of
    both surfaces within `error` [m] of the other: some ten times as long as one count takes.

    Raises EditError where there is no organ, or no coarser surface keeps within.
    """
    source = find_repaired(organ)
    if not (math.isfinite(error) and error > 0.0):
        raise EditError(phrase("The error must be more than 0 mm, got {got:g}.", got=1e3 * error))
    low, high = 3, len(source.vertices)
    best: Decimate | None = None
    count = round(math.sqrt(low * high))
    for row in range(MOST_TRIES):
        found = try_count(organ, count, features)
        if found is not None and found.decimation.max_distance <= error:
            best, high = found, count
        else:
            low = count
        if high - low <= max(1, FINE * high):
            break
        count = round(math.sqrt(low * high))
        if found is not None and row % 2 == 0:  # a distance falls nearly as the count grows
            count = round(found.decimation.vertices * found.decimation.max_distance / error)
        count = min(max(count, low + 1), high - 1)
    if best is None:
        raise EditError(
            phrase(
                "No coarser surface is within {error:g} mm of it: use the imported one.",
                error=1e3 * error,
            )
        )
    return replace(best, error=error)


def try_count(organ: Organ, count: int, features: bool) -> Decimate | None:
    """None where it cannot be that coarse."""
    try:
        return decimate_organ(organ, count, features)
    except EditError:
        return None


@dataclass(frozen=True)
class UseImported:
    """Use the imported surface as it is, not a decimated one."""

    title: ClassVar[str] = "Use the imported surface"

    def __call__(self, organ: Organ) -> Organ:
        find_surface(organ)
        if organ.imported is None or organ.imported is organ.surface:
            raise EditError(phrase("The imported surface is in use already."))
        return replace(carry_paint(organ, organ.imported), decimation=None)
