# SPDX-License-Identifier: GPL-3.0-or-later
"""Closing an open organ so that it can be filled; where it was open stays known."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
import palpate
from palpate.scene.scene_parts import LATER

from palpate_editor.document import Organ, Surface, phrase
from palpate_editor.edits.edit import EditError, find_surface
from palpate_editor.edits.fill_holes import FillHoles
from palpate_editor.edits.regions import MOST_REGIONS

CAP = "cap"
"""Region of the first cap; the next are cap 2, cap 3 ..."""


@dataclass(frozen=True)
class CapHoles:
    """Close every hole, as a solid must be, and keep each cap as a region with the rim of its hole.

    So it can be held where the organ went on, and told from tissue. The organ is no longer a wall.
    """

    title: ClassVar[str] = "Close for filling"
    even: bool = field(default=False, metadata={LATER: True})
    """See FillHoles."""
    bent: bool = field(default=False, metadata={LATER: True})
    """See FillHoles."""

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        closed = FillHoles(even=self.even, bent=self.bent)(organ)
        assert closed.surface is not None
        left = len(palpate.find_border_loops(closed.surface.triangles))
        if left:
            raise EditError(
                phrase(
                    "{count} holes stay open: no patch fits them, so there is nothing to fill.",
                    count=left,
                )
            )
        regions = dict(closed.regions)
        for ids in list_caps(surface, closed.surface):
            regions[find_name(regions)] = ids
        if len(regions) > MOST_REGIONS:
            raise EditError(phrase("An organ has at most {most} regions.", most=MOST_REGIONS))
        material = replace(closed.material, wall_thickness=None)
        return replace(closed, regions=regions, material=material)


def list_caps(surface: Surface, closed: Surface) -> list[np.ndarray]:
    """The vertices of each patch, with its rim, ascending: triangles of the surface come first."""
    new = closed.triangles[len(surface.triangles) :]
    piece = np.asarray(palpate.find_shells(len(closed.vertices), new))[new[:, 0]]
    return [np.unique(new[piece == number]) for number in np.unique(piece)]


def find_name(regions: dict[str, np.ndarray]) -> str:
    """The first that is not taken."""
    number = 1
    while (name := CAP if number == 1 else f"{CAP} {number}") in regions:
        number += 1
    return name


def find_caps(organ: Organ) -> list[str]:
    """The regions that are caps, in the order in which they were closed."""
    return [n for n in organ.regions if n == CAP or n.removeprefix(f"{CAP} ").isdecimal()]
