# SPDX-License-Identifier: GPL-3.0-or-later
"""Making places of an organ stiffer or softer than the rest."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError, check_vertices

LEAST, MOST = 0.05, 20.0
"""[-] Beyond these a factor is a mistake: the rest of the organ is then air or stone beside it."""


@dataclass(frozen=True, eq=False)
class PaintStiffness:
    """Set the factor of the stiffness at some vertices: one whole stroke of the brush."""

    vertices: np.ndarray
    """Vertex numbers, (k,)"""
    values: float | np.ndarray
    """[-] one factor for all, or (k,) one for each"""

    @property
    def title(self) -> str:
        count, values = int(np.size(self.vertices)), np.asarray(self.values, dtype=float)
        if not values.size:
            return phrase("Paint stiffness")
        low, high = float(values.min()), float(values.max())
        if low == high:
            return phrase("Stiffness of {count} vertices: {low:.3g} ×", count=count, low=low)
        return phrase(
            "Stiffness of {count} vertices: {low:.3g} to {high:.3g} ×",
            count=count,
            low=low,
            high=high,
        )

    def __call__(self, organ: Organ) -> Organ:
        ids = check_vertices(organ, self.vertices)
        values = np.asarray(self.values, dtype=float)
        if values.shape not in ((), ids.shape):
            raise EditError(
                phrase(
                    "Factors: got {count}, expected {ids}, one for each vertex.",
                    count=values.size,
                    ids=ids.size,
                )
            )
        if not ((values >= LEAST) & (values <= MOST)).all():  # refuses NaN too
            wrong = values[~((values >= LEAST) & (values <= MOST))].flat[0]
            raise EditError(
                phrase(
                    "A factor of stiffness must lie between {least:g} and {most:g}, got {got:g}.",
                    least=LEAST,
                    most=MOST,
                    got=float(wrong),
                )
            )
        scale = organ.stiffness_scale.copy()
        scale[ids] = values
        if np.array_equal(scale, organ.stiffness_scale):
            raise EditError(phrase("They have this stiffness already."))
        return replace(organ, stiffness_scale=scale)
