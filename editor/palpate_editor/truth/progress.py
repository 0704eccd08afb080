# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a truth is, and how it is stopped."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

EARLY = 0.02
"""[-] Done before what is left is estimated."""


class Stopped(Exception):
    """Whoever asked for a truth wants it no longer."""


class TruthError(ValueError):
    """A truth that cannot be solved, in a sentence."""


@dataclass(frozen=True)
class Progress:
    """Where the work stands."""

    stage: str
    """mesh, stiffness, factor or response."""
    level: int
    """Of the mesh, the coarsest first."""
    fraction: float
    """[-] of all work, were the finest mesh needed."""
    left: float | None
    """[s] it may take yet; None while nobody can know."""


Told = Callable[[Progress], None]
Asked = Callable[[], bool]


class Watch:
    """Tells of progress and stops the work, between stages and inside the long ones."""

    def __init__(self, told: Told | None, cancelled: Asked | None, shares: list[float]):
        """`shares` [-] of the work, of every level of the mesh."""
        self.told, self.cancelled = told, cancelled
        self.starts = [sum(shares[:level]) for level in range(len(shares) + 1)]
        self.start = time.monotonic()

    def tell(self, level: int, stage: str, part: float) -> None:
        """`part` [-] of the level is done. Raises Stopped."""
        if self.cancelled is not None and self.cancelled():
            raise Stopped
        if self.told is None:
            return
        first, last = self.starts[level : level + 2]
        done = (first + part * (last - first)) / self.starts[-1]
        spent = time.monotonic() - self.start
        left = spent * (1.0 - done) / done if done >= EARLY else None
        self.told(Progress(stage, level, done, left))
