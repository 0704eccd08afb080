# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes of a brush: what they would change, while they are drawn. Knows no Qt.

A stroke remembers how far every vertex was reached, the greatest weight of all its stamps, and
takes its values from where the stroke began. So a vertex is not painted twice where stamps
overlap, and the result does not depend on how often the mouse was asked.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from palpate_editor.brush import Neighbours, smooth
from palpate_editor.edits import Edit, FixVertices, PaintStiffness

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

SMALLEST_CHANGE = 1e-3
"""[-] of a stiffness factor below which a vertex counts as left alone."""
SMOOTHING = 0.5
"""[-] towards the mean of its neighbours that a vertex goes in the middle of one stamp."""


@dataclass
class Brush:
    """What the hand holds while painting."""

    radius: float = 0.01
    """[m]"""
    factor: float = 3.0
    """[-] stiffness is multiplied by, in the middle of the brush."""
    strength: float = 1.0
    """[-] 0 to 1: how much of the way to the factor one stroke goes."""
    soft: bool = True
    """Whether the brush fades towards its rim."""
    front_only: bool = True
    connected: bool = True


class Stroke(Protocol):
    """What is being painted."""

    def add(self, ids: Indices, weights: Array) -> None:
        """One stamp of the brush: vertices and how strongly it means them."""

    def edit(self) -> Edit | None:
        """What to apply to the organ; None where nothing changed."""


class FixStroke:
    """Fixes the vertices it goes over, or frees them."""

    def __init__(self, fixed: NDArray[np.bool_], fix: bool):
        self.start, self.fix = fixed, fix
        self.values = np.array(fixed)

    def add(self, ids: Indices, weights: Array) -> None:
        """A fixed vertex does not move at all, so there is no half of it."""
        del weights
        self.values[ids] = self.fix

    def edit(self) -> FixVertices | None:
        """What to apply to the organ; None where nothing changed."""
        changed = np.flatnonzero(self.values != self.start)
        return FixVertices(changed, self.fix) if len(changed) else None


class StiffnessStroke:
    """Takes the stiffness of what it goes over towards a factor; 1 erases."""

    def __init__(self, scale: Array, factor: float, strength: float):
        self.start, self.factor = scale, factor
        self.strength = strength
        self.reach = np.zeros(len(scale))
        self.values = np.array(scale)

    def add(self, ids: Indices, weights: Array) -> None:
        """Half of the way from 1 to 4 is 2: factors are multiplied, so they blend as such."""
        self.reach[ids] = np.maximum(self.reach[ids], self.strength * weights)
        start, reach = self.start[ids], self.reach[ids]
        self.values[ids] = start * (self.factor / start) ** reach

    def edit(self) -> PaintStiffness | None:
        return paint_difference(self.start, self.values)


class SmoothStroke:
    """Evens out the stiffness of what it goes over, more with every stamp."""

    def __init__(self, scale: Array, neighbours: Neighbours):
        self.start = scale
        self.values = np.array(scale)
        self._neighbours = neighbours

    def add(self, ids: Indices, weights: Array) -> None:
        """Half of the way to the mean of the neighbours, where the weight is 1."""
        even = smooth(self.values, ids, self._neighbours, SMOOTHING)
        self.values[ids] += weights * (even - self.values[ids])

    def edit(self) -> PaintStiffness | None:
        return paint_difference(self.start, self.values)


def paint_difference(start: Array, values: Array) -> PaintStiffness | None:
    changed = np.flatnonzero(np.abs(values - start) > SMALLEST_CHANGE * start)
    return PaintStiffness(changed, values[changed]) if len(changed) else None
