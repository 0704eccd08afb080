# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces of a surface that an edit has thrown away, and the note that lists them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

LISTED = 12
"""Dropped pieces that a note names, the largest first."""


@dataclass(frozen=True)
class Dropped:
    """A piece of a surface: what hangs together."""

    triangles: int
    size: float
    """[m] from corner to corner."""
    middle: tuple[float, float, float]
    """[m] of its box."""


def measure_dropped(corners: np.ndarray) -> Dropped:
    """Of the corners (t, 3, 3) [m] of its triangles."""
    points = corners.reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    x, y, z = (float(c) for c in 0.5 * (low + high))
    return Dropped(len(corners), float(np.linalg.norm(high - low)), (x, y, z))


def list_dropped(dropped: Sequence[Dropped], which: str) -> str:
    """In a sentence, for people; `which` has {piece} in it, such as "inner {piece}"."""
    named = [
        f"{piece.triangles} triangles, {1e3 * piece.size:.3g} mm long at "
        f"({', '.join(f'{1e3 * c:.3g}' for c in piece.middle)}) mm"
        for piece in dropped[:LISTED]
    ]
    rest = len(dropped) - len(named)
    more = [f"{rest} smaller ones"] if rest else []
    what = which.format(piece="pieces" if len(dropped) > 1 else "piece")
    return f"{len(dropped)} {what} dropped: {'; '.join([*named, *more])}"
