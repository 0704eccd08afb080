# SPDX-License-Identifier: GPL-3.0-or-later
"""How a solid organ gives way beyond the near field, solved on a finer mesh than it ticks on."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from palpate_editor.document.surface import freeze


@dataclass(frozen=True, eq=False)
class FarField:
    """A table bound to the surface, what is held and painted of it, and Poisson's ratio. Neither
    how the organ is simulated nor Young's modulus changes it."""

    key: str
    """Of what it was solved for (compute_key)."""
    patch: float
    """[m] Radius of the pressed discs."""
    tetrahedra: int
    """Of the mesh that it was solved on, quadratic ones."""
    softness: np.ndarray = field(default_factory=lambda: np.empty(0))
    """[1/m] (6 n,) six per vertex of the surface, one vertex after the other: compliance beyond
    that of a half space in every direction (xx, yy, zz, xy, yz, zx), times E / (1 - nu²);
    read-only."""

    @property
    def tensors(self) -> np.ndarray:
        """[1/m] (n, 6)"""
        return self.softness.reshape(-1, 6)

    def __post_init__(self) -> None:
        object.__setattr__(self, "softness", freeze(self.softness, np.float64, (None,)))
