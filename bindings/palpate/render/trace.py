# SPDX-License-Identifier: BSD-3-Clause
"""What a record says of force and depth, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

TOUCHING, ATTACHED, NOT_RENDERED = 1, 2, 4
"""Bits of Felt.touched."""


@dataclass(frozen=True)
class Trace:
    """A run as a plot shows it."""

    time: Array
    """[s] (n,)"""
    force: Array
    """[N] (n, 3) what the hand felt: none while the motors of its device were off."""
    press: Array
    """(3,) the unit direction out of the tissue, against which the tool pressed."""
    depth: Array
    """[m] (n,) of the tool below where it first touched; negative outside."""
    touching: NDArray[np.bool_]
    attached: NDArray[np.bool_]
    """(n,)"""

    def magnitude(self) -> Array:
        """[N] (n,)"""
        return np.asarray(np.linalg.norm(self.force, axis=1))

    def along_press(self) -> Array:
        """[N] (n,) positive where the tissue pushes the hand out, negative where it holds it."""
        return self.force @ self.press


def read_trace(record: Any, instrument: int = 0) -> Trace:
    """The trace of an instrument of a palpate.Record.

    A record knows no surface, so depth is measured from the tool itself: from its place in the tick
    of first contact, against the mean force felt while it touched without being attached. Where
    nothing was touched, or no force was felt, there is no direction and the depth is not a number.
    Raises ValueError for a record without ticks.
    """
    hand, felt = (
        rows if rows.ndim == 1 else rows[:, instrument] for rows in (record.hand, record.felt)
    )
    time = np.asarray(hand["time"], dtype=float)
    if len(time) == 0:
        raise ValueError("record: got no ticks, expected at least one to plot")
    place = np.asarray(felt["position"], dtype=float)
    bits = np.asarray(felt["touched"])
    rendered = (bits & NOT_RENDERED) == 0
    force = np.where(rendered[:, None], np.asarray(felt["force"], dtype=float), 0.0)
    attached = (bits & ATTACHED) != 0
    touching = (bits & TOUCHING) != 0
    pressing = touching & ~attached
    push = force[pressing].sum(axis=0)
    size = float(np.linalg.norm(push))
    press, depth = np.zeros(3), np.full(len(time), np.nan)
    if size > 0.0:
        press = push / size
        depth = (place[pressing.argmax()] - place) @ press
    return Trace(time, force, press, depth, touching, attached)


def find_spans(time: Array, on: NDArray[np.bool_]) -> list[tuple[float, float]]:
    """Start and duration [s] of every stretch of ticks in which something is on."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], on, [False]]).astype(int)))
    last = len(time) - 1
    return [
        (float(time[a]), float(time[min(b, last)] - time[a]))
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
