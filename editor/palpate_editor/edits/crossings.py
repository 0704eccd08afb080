# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking out where a surface runs through itself, in a process that can be ended."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import palpate

from palpate_editor import authoring
from palpate_editor.document import Organ, Phrase, Surface, phrase
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.inspected import mesh_of
from palpate_editor.edits.repair import find_crowded, find_disagreeing, put_in_place
from palpate_editor.guarded import TIME, GuardedError, run_guarded

PLACES = 3
"""Of crossings that are named."""


@dataclass(frozen=True)
class RemoveCrossings:
    """Take out triangles that cross others and close what that opens, within some time."""

    title: ClassVar[str] = "Remove crossings"

    seconds: float = TIME
    """[s] It may take."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not self.seconds > 0.0:
            raise EditError(
                phrase("The time must be more than 0 s, got {got:g} s.", got=self.seconds)
            )
        if len(find_crowded(surface.triangles)) or len(find_disagreeing(surface.triangles)):
            raise EditError(
                phrase("Crossings are removed once each edge has two triangles that agree.")
            )
        crossing = authoring.find_self_intersecting_faces(mesh_of(surface))
        if crossing is not None and not crossing:
            raise EditError(phrase("The surface does not cross itself."))
        changed = put_in_place(organ, self.remove)
        if changed.surface is surface:
            raise EditError(say_left(surface))
        return changed

    def remove(self, surface: Surface) -> Surface:
        """With as few crossings as was found in the time; the very same where none went."""
        try:
            found = run_guarded("remove_crossings", surface, {}, self.seconds)
        except GuardedError as problem:
            raise EditError(phrase("Crossings stay: {why}", why=str(problem))) from None
        if found is None or np.array_equal(found.surface.triangles, surface.triangles):
            return surface
        return found.surface


def say_left(surface: Surface) -> Phrase:
    """How many crossings there are, and where."""
    faces = authoring.find_self_intersecting_faces(mesh_of(surface))
    if faces is None:
        return phrase(
            "Nothing helped in the time: so many triangles lie on top of each other that they "
            "cannot be counted."
        )
    return phrase(
        "{count} triangles still cross others, at {places} mm; none of them could be replaced "
        "without another crossing, or in the time.",
        count=len(faces),
        places=say_places(surface, np.asarray(faces)),
    )


def say_places(surface: Surface, faces: np.ndarray) -> str:
    """[mm] The middles of the largest groups of triangles that hang together, as text."""
    x, triangles = surface.vertices, surface.triangles[faces]
    group = np.asarray(palpate.find_shells(len(x), triangles))[triangles[:, 0]]
    groups, sizes = np.unique(group, return_counts=True)
    named = []
    for one in groups[np.argsort(-sizes, kind="stable")][:PLACES]:
        middle = 1e3 * x[triangles[group == one]].mean(axis=(0, 1))
        named.append("({:.1f}, {:.1f}, {:.1f})".format(*middle))
    return ", ".join(named)
