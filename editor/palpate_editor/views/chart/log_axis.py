# SPDX-License-Identifier: GPL-3.0-or-later
"""An axis of decades, in per cent or in time, whose data are logarithms."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import pyqtgraph as pg

from palpate_editor.views.translations import number, quantity

FEW = 1.6
"""Decades up to which 1, 2 and 5 of each are named; above, 1 and 3, then 1 alone."""
MANY = 3.2


class LogAxis(pg.AxisItem):
    """Its values are logarithms of what it names."""

    def __init__(self, side: str, write: Callable[[float], str]):
        super().__init__(side)
        self.write = write

    def tickValues(self, low: float, high: float, size: float) -> list[tuple[float, list[float]]]:
        del size
        return [(1.0, list(place_ticks(low, high)))]

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        del scale, spacing
        return [self.write(10.0**value) for value in values]


def place_ticks(low: float, high: float) -> Iterator[float]:
    """Logarithms between two of them."""
    if not (math.isfinite(low) and math.isfinite(high)) or high - low > 30.0:
        return
    steps = (1, 2, 5) if high - low <= FEW else (1, 3) if high - low <= MANY else (1,)
    for decade in range(math.floor(low), math.ceil(high) + 1):
        for step in steps:
            value = decade + math.log10(step)
            if low <= value <= high:
                yield value


def write_share(share: float) -> str:
    return f"{number(100.0 * share, 2)} %"


def write_span(seconds: float) -> str:
    """700 µs, 1.2 ms"""
    if seconds < 0.9995e-3:
        return quantity(1e6 * seconds, "µs", 3)
    return quantity(1e3 * seconds, "ms", 3) if seconds < 0.9995 else quantity(seconds, "s", 3)
