# SPDX-License-Identifier: GPL-3.0-or-later
"""Force against time as it comes in: a growing table, its peak, and its text. Knows no Qt."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

FIRST_ROOM = 1024
"""[rows] a trace begins with."""
SMALLEST_PEAK = 0.01
"""[N] Below this nothing was felt, and there is no peak to mark."""


class ForceTrace:
    """What one run felt, row by row in the order of time."""

    def __init__(self, name: str):
        self.name = name
        self._rows = np.empty((FIRST_ROOM, 4))
        self._size = np.empty(FIRST_ROOM)
        self._count = 0

    def __len__(self) -> int:
        return self._count

    @property
    def time(self) -> Array:
        """[s] (n,) since the run began."""
        return self._rows[: self._count, 0]

    @property
    def force(self) -> Array:
        """[N] (n, 3)"""
        return self._rows[: self._count, 1:]

    @property
    def size(self) -> Array:
        """[N] (n,) the force's magnitude."""
        return self._size[: self._count]

    def add(self, time: float, force: ArrayLike) -> None:
        """A row [s] [N]; one that is not later than the last says nothing new and is left out."""
        if self._count and time <= self._rows[self._count - 1, 0]:
            return
        if self._count == len(self._rows):
            self._rows = np.concatenate([self._rows, np.empty_like(self._rows)])
            self._size = np.concatenate([self._size, np.empty_like(self._size)])
        self._rows[self._count, 0] = time
        self._rows[self._count, 1:] = force
        self._size[self._count] = np.linalg.norm(self._rows[self._count, 1:])
        self._count += 1

    def replace(self, time: ArrayLike, force: ArrayLike) -> None:
        """All rows again, from a record of the same run: every tick instead of every picture."""
        t, f = np.asarray(time, dtype=float), np.asarray(force, dtype=float)
        if t.ndim != 1 or f.shape != (len(t), 3):
            raise ValueError(f"a trace is (n,) and (n, 3), got {t.shape} and {f.shape}")
        self._rows = np.column_stack([t, f])
        self._size = np.linalg.norm(f, axis=1)
        self._count = len(t)

    def find_peak(self) -> tuple[float, float] | None:
        """When [s] and how hard [N] the force was greatest; None where nothing was felt."""
        if not self._count:
            return None
        top = int(self.size.argmax())
        if not self.size[top] >= SMALLEST_PEAK:
            return None
        return float(self.time[top]), float(self.size[top])


def write_csv(traces: Sequence[ForceTrace]) -> str:
    """All rows of all traces as text, one run after the other."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["run", "time_s", "force_x_N", "force_y_N", "force_z_N", "force_N"])
    for trace in traces:
        for time, force, size in zip(trace.time, trace.force, trace.size, strict=True):
            numbers = (f"{time:.4f}", *(f"{part:.6g}" for part in force), f"{size:.6g}")
            table.writerow([trace.name, *numbers])
    return text.getvalue()
