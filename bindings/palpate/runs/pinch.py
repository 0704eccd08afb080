# SPDX-License-Identifier: BSD-3-Clause
"""How hard jaws press on what is between them, for those who watch a run. Knows no Qt."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import palpate
from palpate.assessment.author import LIMIT_BOUNDS
from palpate.runs.live import Frame
from palpate.runs.stretch import TORN, StretchGauge

HARMFUL = LIMIT_BOUNDS["pad_pressure"]
"""[Pa] on a pad above which tissue is taken to be harmed, where no task says otherwise: human bowel
that was pressed for 10 s is safe below 329 to 330 kPa [Khan21]."""
LEAST_PINCH = 0.05
"""[N] Jaws that press less hold nothing, as far as is told."""


@dataclass(frozen=True)
class Pinch:
    """Of the jaws of one instrument."""

    force: float
    """[N] of each jaw."""
    pressure: float
    """[Pa] on what is touched of a pad."""
    bound: float = HARMFUL
    """[Pa] above which it is wrong."""
    stretch: float = 0.0
    """[-] the largest of the tissue about them; 0: it was not measured."""
    stretch_bound: float = TORN
    """[-] above which it is wrong."""

    @property
    def is_wrong(self) -> bool:
        return self.pressure > self.bound

    @property
    def is_overstretched(self) -> bool:
        return self.stretch > self.stretch_bound


def find_pinches(
    frame: Frame, task: palpate.Task | None = None, gauge: StretchGauge | None = None
) -> dict[int, Pinch]:
    """Of the instruments whose jaws press on something, by their index; a task may bear less, or
    more, than HARMFUL. Stretches are measured by a gauge."""
    return {
        index: Pinch(
            one.pinch,
            one.pad_pressure,
            find_bound(task, index),
            *(() if gauge is None else gauge.measure(frame, index)),
        )
        for index, one in enumerate(frame.instruments)
        if one.pinch >= LEAST_PINCH
    }


def find_bound(task: palpate.Task | None, instrument: int) -> float:
    """[Pa] The least that a task calls wrong of an instrument's jaws."""
    bounds = [
        limit.bound
        for limit in ([] if task is None else task.limits)
        if limit.measure is palpate.TaskMeasure.pad_pressure
        and limit.above
        and limit.instrument == instrument
    ]
    return min(bounds, default=HARMFUL)


def tell_pinch(pinch: Pinch) -> str:
    """Force and pressure; where that is wrong, beyond what it is."""
    told = f"{pinch.force:.1f} N, {1e-3 * pinch.pressure:.0f} kPa"
    return f"{told} > {1e-3 * pinch.bound:.0f}" if pinch.is_wrong else told


def tell_stretch(pinch: Pinch) -> str:
    """Of the length at rest; where that is wrong, beyond what it is."""
    told = f"{pinch.stretch:.2f}"
    return f"{told} > {pinch.stretch_bound:.1f}" if pinch.is_overstretched else told


def list_wrong(
    pinches: Mapping[int, Pinch],
    name_jaws: Callable[[int], str],
    name_stretch: Callable[[int], str],
) -> list[str]:
    """The names of the rows whose number is beyond what it may be, by instrument."""
    wrong = [name_jaws(index) for index, one in pinches.items() if one.is_wrong]
    return wrong + [name_stretch(index) for index, one in pinches.items() if one.is_overstretched]


def tell_rows(
    index: int,
    pinches: Mapping[int, Pinch],
    name_jaws: Callable[[int], str],
    name_stretch: Callable[[int], str],
) -> list[tuple[str, str]]:
    """Of the jaws of an instrument; none where they press on nothing."""
    if index not in pinches:
        return []
    rows = [(name_jaws(index), tell_pinch(pinches[index]))]
    if pinches[index].stretch > 0.0:
        rows.append((name_stretch(index), tell_stretch(pinches[index])))
    return rows
