# SPDX-License-Identifier: GPL-3.0-or-later
"""Making places of an organ stiffer or softer than the rest."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError, check_vertices

LEAST, MOST = 0.05, 20.0
"""[-] Beyond these a factor is a mistake: the rest of the organ is then air or stone beside it."""


@dataclass(frozen=True, eq=False)
class PaintStiffness:
    """Set the factor of the stiffness at some vertices: one whole stroke of the brush."""

    title: ClassVar[str] = "Paint stiffness"

    vertices: np.ndarray
    """Vertex numbers, (k,)"""
    values: float | np.ndarray
    """[-] one factor for all, or (k,) one for each"""

    def __call__(self, organ: Organ) -> Organ:
        ids = check_vertices(organ, self.vertices)
        values = np.asarray(self.values, dtype=float)
        if values.shape not in ((), ids.shape):
            raise EditError(
                phrase("{count} factors for {ids} vertices.", count=values.size, ids=ids.size)
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
