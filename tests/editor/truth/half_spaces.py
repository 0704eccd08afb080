# SPDX-License-Identifier: GPL-3.0-or-later
"""A half space that is condensed to its surface, for tests of what touches it."""

from __future__ import annotations

from math import pi

import numpy as np
from palpate.study.half_space import plane_modulus
from palpate_editor.truth.contact import Patch
from scipy import sparse

SOFT = (5e3, 0.45)
"""E [Pa] and nu."""


def build_half_space(radius: float, half: float, count: int) -> Patch:
    """Squares of one pressure each on a half space [Boussinesq85], under a paraboloid."""
    side = 2.0 * half / count
    at = (np.arange(count) + 0.5) * side - half
    x = np.stack(np.meshgrid(at, at, indexing="ij"), axis=2).reshape(-1, 2)
    far = np.linalg.norm(x[:, None] - x, axis=2)
    np.fill_diagonal(far, side / (4.0 * np.log(1.0 + np.sqrt(2.0))))
    compliance = 1.0 / (pi * plane_modulus(*SOFT) * far)
    count = len(x)
    gap = (x**2).sum(axis=1) / (2.0 * radius)
    return Patch(compliance, sparse.eye(count, format="csr"), np.full(count, side**2), gap)
