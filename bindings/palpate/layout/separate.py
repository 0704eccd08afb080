# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that begin in each other, or nearer than they may, are moved apart before a scene begins.

A body is moved as a whole, by the shortest way that leaves the thickness of the barrier between it
and all bodies before it that it may touch: the least-distance problem min |t|, n_i . t >= d_i
(Lawson and Hanson, Solving Least Squares Problems, 1995, chapter 23), solved again where it leads
until nothing is missing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from palpate.layout.gaps import Surface, find_gaps

Floats = NDArray[np.float64]
MOST_SHIFT = 5e-3
"""[m] Farther, a body is not where its designer put it."""
AROUND = 2e-3
"""[m] beyond the thickness: gaps that a move might close are looked at with those it opens."""
TURNS = 40
ROUNDING = 1e-6
"""[m] by which a gap may miss the thickness."""


@dataclass(frozen=True)
class Neighbour:
    """A body before, which stays, and how far another must be from it."""

    index: int
    surface: Surface
    thickness: float
    """[m]"""


@dataclass(frozen=True)
class Separation:
    """What had to be done to a body."""

    body: int
    other: int
    """That it was nearest to, or deepest in."""
    gap: float
    """[m] between them before, below 0 where they overlapped."""
    shift: Floats | None
    """[m] (3,) by which it was moved; None where nothing within MOST_SHIFT was enough."""
    place: Floats
    """[m] (3,) where they were nearest, or deepest in each other."""


def separate(body: int, surface: Surface, neighbours: list[Neighbour]) -> Separation | None:
    """None where all gaps are at least half the thickness, as a scene may begin."""
    shift = np.zeros(3)
    near = [(n, find_gaps(n.surface, surface, n.thickness, shift)) for n in neighbours]
    worst = [
        (gap.size, n.index, tuple(gap.vertex))
        for n, gaps in near
        for gap in gaps
        if gap.size < 0.5 * n.thickness
    ]
    if not worst:
        return None
    size, other, place = min(worst)
    return Separation(body, other, size, find_shift(surface, neighbours), np.array(place))


def find_shift(surface: Surface, neighbours: list[Neighbour]) -> Floats | None:
    """The move [m] (3,) after which no gap is below its thickness."""
    shift = np.zeros(3)
    for _ in range(TURNS):
        normals, lacks = [], []
        for neighbour in neighbours:
            reach = neighbour.thickness + AROUND
            gaps = find_gaps(neighbour.surface, surface, reach, shift)
            normals += [gap.normal for gap in gaps]
            lacks += [neighbour.thickness - gap.size for gap in gaps]
        if max(lacks, default=0.0) <= ROUNDING:
            return shift
        step = find_least_step(np.array(normals), np.array(lacks))
        if step is None:
            return None
        shift = shift + step
        if np.linalg.norm(shift) > MOST_SHIFT:
            return None
    return None


def find_least_step(normals: Floats, lacks: Floats) -> Floats | None:
    """The shortest t with normals . t >= lacks; None where there is none."""
    scale = float(np.abs(lacks).max())
    system = np.vstack([normals.T, lacks / scale])
    weights, _ = nnls(system, np.array([0.0, 0.0, 0.0, 1.0]))
    rest = system @ weights - np.array([0.0, 0.0, 0.0, 1.0])
    if abs(rest[3]) < 1e-9:
        return None
    return np.asarray(-scale * rest[:3] / rest[3])
