# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of a tool that a truth can be asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import palpate

Point = tuple[float, float, float]
GRIP = 5e-4
"""[m] of the ball beyond its first touch, where a pull takes hold."""


@dataclass(frozen=True)
class Press:
    """A ball at one place, deeper and deeper."""

    near: Point | None = None
    """[m] The place is the closest point of the surface; None for where a check presses first."""


@dataclass(frozen=True)
class Pull:
    """A ball that takes hold at one place, by the hold of the organ's hand, and goes higher and
    higher."""

    near: Point | None = None
    """As that of a press."""
    grip: float = GRIP


@dataclass(frozen=True)
class Drag:
    """A ball that is dragged along the surface, at every depth."""

    near: Point | None = None
    """[m] Where it begins; as that of a press."""
    toward: Point | None = None
    """[m] The point that it heads for; None for where the surface goes on longest and turns least,
    away from what is held."""
    length: float | None = None
    """[m] None for three edges of the surface that is simulated, at least two radii."""


@dataclass(frozen=True, eq=False)
class Script:
    """The way of a hand. Where it goes below the surface, the tool presses."""

    frames: Sequence[palpate.KeyFrame]


Path = Press | Pull | Drag | Script
