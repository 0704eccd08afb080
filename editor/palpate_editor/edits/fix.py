# SPDX-License-Identifier: GPL-3.0-or-later
"""Holding vertices at rest: where the organ is attached or lies on a table."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError, check_vertices, find_surface


@dataclass(frozen=True, eq=False)
class FixVertices:
    """Hold some vertices at rest, or let them go."""

    vertices: np.ndarray
    """Vertex numbers, (k,)"""
    fixed: bool = True

    @property
    def title(self) -> str:
        count = int(np.size(self.vertices))
        if self.fixed:
            return phrase("Fix {count} vertices", count=count)
        return phrase("Free {count} vertices", count=count)

    def __call__(self, organ: Organ) -> Organ:
        ids = check_vertices(organ, self.vertices)
        if (organ.fixed[ids] == self.fixed).all():
            raise EditError(
                phrase("They are fixed already.")
                if self.fixed
                else phrase("None of them is fixed.")
            )
        fixed = organ.fixed.copy()
        fixed[ids] = self.fixed
        return replace(organ, fixed=fixed)


def find_lowest(vertices: np.ndarray, share: float) -> np.ndarray:
    """Numbers of the vertices [m] in the lowest `share` of the height: those on the table."""
    height = vertices[:, 2]
    limit = height.min() + share * (height.max() - height.min())
    return np.flatnonzero(height <= limit)


@dataclass(frozen=True)
class FixLowest:
    """Lay the organ on a table: fix the lowest part of its height, beside what is fixed already."""

    share: float
    """[-] of the height, from below"""

    @property
    def title(self) -> str:
        return phrase("Fix the lowest {share:g} %", share=100.0 * self.share)

    def __call__(self, organ: Organ) -> Organ:
        surface = find_surface(organ)
        if not 0.0 < self.share <= 1.0:
            raise EditError(
                phrase(
                    "The share of the height must be more than 0 and at most 1, got {got:g}.",
                    got=self.share,
                )
            )
        return FixVertices(find_lowest(surface.vertices, self.share))(organ)
