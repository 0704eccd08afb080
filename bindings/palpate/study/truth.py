# SPDX-License-Identifier: BSD-3-Clause
"""What a ball feels of a body of tissue along a path: the truth that models are held against.

Solved by palpate_editor.truth, which owns meshing and the solver. Nothing here solves;
truth_file reads and writes it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
HERTZ = 1.5
"""Exponent of the force of a ball in its depth [Hertz82]."""
TINY = 1e-12
"""[N]"""


@dataclass(frozen=True)
class Truth:
    """Forces at rest over s stations of a path and k depths, on a surface of m points.

    A press has one station; a drag one for every place that was solved, in the order in which the
    tool passes them; a pull one, with negative depths.
    """

    key: str
    """Of all that it depends on: surface, what is held, material, tool, stations, depths."""
    law: str
    """linear or neo_hookean."""
    radius: float
    """[m] of the ball."""
    point: Floats
    """[m] (s, 3) on the surface at rest."""
    direction: Floats
    """Unit (s, 3), outward: the ball goes against it."""
    touch: Floats
    """[m] (s,) Height of the ball's centre over the point at its first touch."""
    thickness: Floats
    """[m] (s,) of the body under the point; a hollow one with its far wall."""
    depth: Floats
    """[m] (k,) of the ball beyond its first touch; rising away from 0."""
    force: Floats
    """[N] (s, k) along the direction."""
    force_error: Floats
    """[-] (s, k) of the force: what the last refinement of the mesh changed."""
    contact_radius: Floats
    """[m] (s, k)"""
    surface: Floats
    """[m] (m, 3) points of the surface at rest, where displacements are compared."""
    displacement: Floats
    """[m] (s, k, m, 3) of them."""
    displacement_error: Floats
    """[-] (s, k) of the depth: root mean square of what the last refinement changed."""
    path: str = "press"
    """press, pull, drag or script."""
    freedoms: int = 0
    """Of the finest mesh."""
    tetrahedra: int = 0
    remarks: tuple[str, ...] = ()
    """What a reader of the numbers should know, in sentences."""

    def find_force(self, station: float, depth: float) -> float:
        """[N] at a depth [m] up to the last, between the solved ones as a power of the depth.

        Args:
            station: Position on the path, 0 to s - 1: between two stations as a line of them.
            depth: [m] of the sign of those that were solved.

        Raises:
            ValueError: where either is beyond what was solved.
        """
        return float(self.interpolate(station, self.scale_forces(depth)))

    def find_displacement(self, station: float, depth: float) -> Floats:
        """[m] (m, 3) of the surface, a line between what was solved; arguments as find_force."""
        self.check_depth(depth)
        depths = np.concatenate([[0.0], np.abs(self.depth)])
        at = min(int(np.searchsorted(depths, abs(depth), side="left")), len(depths) - 1)
        part = min((abs(depth) - depths[at - 1]) / (depths[at] - depths[at - 1]), 1.0)
        before = self.displacement[:, at - 2] if at > 1 else np.zeros_like(self.displacement[:, 0])
        whole = before + part * (self.displacement[:, at - 1] - before)
        return np.asarray(self.interpolate(station, whole))

    def scale_forces(self, depth: float) -> Floats:
        """[N] (s,) at a depth [m]: with the exponent of the two depths around it; below the first
        with that of the first two, which is 1 where a wall bends and 1.5 of a ball on a solid
        [Hertz82], and with no other than of these and between."""
        self.check_depth(depth)
        solved, force, d = np.abs(self.depth), np.abs(self.force), abs(depth)
        if len(solved) == 1:
            return np.asarray(self.force[:, 0] * (d / solved[0]) ** HERTZ)
        at = int(np.clip(np.searchsorted(solved, d) - 1, 0, len(solved) - 2))
        ratio = np.maximum(force[:, at + 1], TINY) / np.maximum(force[:, at], TINY)
        power = np.log(ratio) / np.log(solved[at + 1] / solved[at])
        if d < solved[0]:
            power = np.clip(power, 1.0, HERTZ)
        return np.asarray(self.force[:, at] * (d / solved[at]) ** power)

    def check_depth(self, depth: float) -> None:
        last = float(self.depth[-1])
        if not 0.0 < depth * np.sign(last) <= abs(last) * (1.0 + 1e-6):
            raise ValueError(f"depth: got {1e3 * depth:g} mm, expected up to {1e3 * last:g} mm")

    def interpolate(self, station: float, values: Floats) -> Floats:
        """Of (s, ...) values those at a position on the path."""
        last = len(values) - 1
        if not 0.0 <= station <= last:
            raise ValueError(f"station: got {station:g}, expected 0 to {last}")
        first = min(int(station), max(last - 1, 0))
        part = station - first
        return values[first] + part * (values[min(first + 1, last)] - values[first])
