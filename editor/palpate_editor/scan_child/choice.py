# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a scan becomes a surface: the same for who asks and for the child that reads scans."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

USUAL_SMOOTHING = 0.8
"""[voxel] Of labels, whose surface is one of stairs; a range of grey levels lies between voxels."""
MOST_SMOOTHING = 4.0
"""[voxel]"""


@dataclass(frozen=True)
class Choice:
    """Voxels by label or by a range of grey levels, and what is made of them."""

    labels: tuple[int, ...] = ()
    low: float | None = None
    """Least grey level, itself included; None for no least."""
    high: float | None = None
    smooth: float | None = None
    """[voxel] Standard deviation of a Gaussian; None for the usual one."""
    largest: bool = False
    """Its largest piece alone, without cavities."""
    least_volume: float = 0.0
    """[m³] Of a piece or cavity that is kept."""

    def __post_init__(self) -> None:
        by_range = self.low is not None or self.high is not None
        if bool(self.labels) == by_range:
            raise ValueError("choice: got neither or both, expected labels or a range")
        if self.low is not None and self.high is not None and not self.low < self.high:
            raise ValueError(f"range: got {self.low:g}:{self.high:g}, expected the lower end first")
        if not 0.0 <= self.smoothing <= MOST_SMOOTHING:
            raise ValueError(
                f"smooth: got {self.smoothing:g} voxels, expected 0 to {MOST_SMOOTHING:g}"
            )
        if not 0.0 <= self.least_volume < math.inf:
            raise ValueError(f"least_volume: got {self.least_volume:g} m³, expected 0 or more")

    @property
    def smoothing(self) -> float:
        """[voxel]"""
        if self.smooth is not None:
            return self.smooth
        return USUAL_SMOOTHING if self.labels else 0.0


def find_chosen(voxels: np.ndarray, choice: Choice) -> np.ndarray:
    """Which voxels of a volume or of a slice are chosen; bool, of their shape."""
    if choice.labels:
        return np.isin(voxels, choice.labels)
    chosen = np.ones(voxels.shape, bool)
    if choice.low is not None:
        chosen &= voxels >= choice.low
    if choice.high is not None:
        chosen &= voxels <= choice.high
    return chosen


def read_range(text: str) -> tuple[float | None, float | None]:
    """LOW:HIGH, either of which may be left out. Raises ValueError."""
    low, colon, high = text.partition(":")
    try:
        ends = tuple(float(end) if end.strip() else None for end in (low, high))
    except ValueError:
        ends = (None, None)
    known = [end for end in ends if end is not None]
    if not colon or not known or not all(map(math.isfinite, known)):
        raise ValueError(f"got {text!r}, expected LOW:HIGH, LOW: or :HIGH")
    return ends[0], ends[1]


def describe_choice(choice: Choice) -> str:
    """As the command line says it: "label 1", "200:"."""
    if choice.labels:
        return "label " + "+".join(map(str, choice.labels))
    return f"{write_end(choice.low)}:{write_end(choice.high)}"


def write_end(end: float | None) -> str:
    return "" if end is None else f"{end:.12g}"
