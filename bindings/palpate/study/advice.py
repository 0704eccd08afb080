# SPDX-License-Identifier: BSD-3-Clause
"""The cheapest configuration of a chart that is as right and as quick as is asked for.

Nothing here runs or compiles: what a step may be is asked of the caller, for few rows. The choice
is scored on presses that it was not made from by palpate_editor.advise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from palpate.study.scene_chart import Chart, Configuration, Cost, Row, find_front

STEP_SHARE = 0.8
"""[-] of the longest stable step at rest, that a step of a choice may take."""
TIME_FACTOR = 1.5
"""[-] The p99 of a tick in touch, so many times over, must be within a tick: an interrupt, a warm
machine and a press at another place have room in it."""
FEWEST_IN_TOUCH = 3
"""Substeps that a tick in touch has at least [contact: substeps]."""
FORCE, DISPLACEMENT, TIME, STEP = "force", "displacement", "time", "step"
NEEDS = (FORCE, DISPLACEMENT, TIME, STEP)
"""Errors of a row and of the truth together, 1.5 times the p99 in touch, a step of the limit."""
TRUTH, NOTHING = "truth", "nothing"
SMALL_DISPLACEMENTS = ("linear_solid",)
"""Kinds that turn where they only bend, and are right for small displacements alone."""
BINDINGS = (*NEEDS, TRUTH, NOTHING)
"""Which need keeps cheaper rows from being chosen. The truth: they are right enough, but for what
the truth itself leaves open. Nothing: no row is cheaper."""


@dataclass(frozen=True)
class Targets:
    """What is asked for."""

    force_error: float
    """[-] Root mean square, of the truth's largest force; the truth's own error included."""
    displacement_error: float
    """[-] Root mean square, of the tool's depth; the truth's own error included."""
    rate: float
    """[Hz] of ticks."""
    depth: float = 0.0
    """[m] How far the organ will be pressed or pulled, where that is farther than it was charted:
    kinds for small displacements are no choice then."""


@dataclass(frozen=True)
class Need:
    """One of NEEDS, as a row has it."""

    name: str
    value: float | None
    """[-], for TIME [s]; None where nobody measured it, which meets nothing."""
    allowed: float
    """The same unit."""

    @property
    def ratio(self) -> float:
        """[-] of what is allowed; infinite where it is not known."""
        return math.inf if self.value is None else self.value / self.allowed

    @property
    def is_met(self) -> bool:
        return self.ratio <= 1.0

    @property
    def margin(self) -> float:
        """[-] of what is allowed, that is left; negative where it is missed."""
        return 1.0 - self.ratio


@dataclass(frozen=True)
class Steps:
    """How a configuration steps at rest."""

    count: int
    """Of a tick in the air."""
    limit: float
    """[s] The longest that is stable; infinite where nothing can swing, or the step is implicit."""


FindSteps = Callable[[Row], Steps]


@dataclass(frozen=True)
class Candidate:
    """A row as it would be used."""

    row: Row
    configuration: Configuration
    """The row's, with more substeps where its own would come too near the limit."""
    cost: Cost
    """Of the row; at most so, times the steps that were added."""
    needs: tuple[Need, ...]
    """In the order of NEEDS; without STEP where nobody asked for the limit."""

    @property
    def fits(self) -> bool:
        return all(need.is_met for need in self.needs)

    @property
    def worst(self) -> Need:
        """The need with the least margin."""
        return max(self.needs, key=lambda need: need.ratio)

    @property
    def misses(self) -> tuple[Need, ...]:
        return tuple(need for need in self.needs if not need.is_met)


@dataclass(frozen=True)
class Advice:
    """The choice, or the nearest miss, and its neighbours."""

    targets: Targets
    choice: Candidate | None
    """It fits, or it is the nearest miss; None where no row of the chart ran."""
    binding: str
    """One of BINDINGS: of a choice that fits, what its next cheaper neighbour misses most."""
    cheaper: Candidate | None
    """The best that is cheaper for certain; it misses something."""
    better: Candidate | None
    """The cheapest whose force is better by more than the truth's own error; its shape no worse."""
    own: Candidate | None
    """What the organ came with; None where that did not run."""
    tried: int
    ran: int

    @property
    def fits(self) -> bool:
        return self.choice is not None and self.choice.fits

    @property
    def keeps_own(self) -> bool:
        """The choice is what the organ came with."""
        choice = self.choice
        if choice is None:
            return False
        return choice.row.own and choice.configuration == choice.row.configuration


def advise(chart: Chart, targets: Targets, find_steps: FindSteps) -> Advice:
    """Of the rows that meet every target, none is certain to be cheaper than the choice; of those
    whose costs cannot be told apart, it is the most accurate.

    Args:
        chart: At the rate of the targets, which the caller has checked.
        targets: What is asked for.
        find_steps: Asked for rows that could be chosen, and the neighbours of the choice.
    """
    rows = [row for row in chart.list_ran() if holds(row, chart, targets)]
    fitting = find_fitting(chart, rows, targets, find_steps)
    choice = choose(fitting) if fitting else find_nearest(chart, rows, targets, find_steps)
    cheaper = better = None
    if choice is not None:
        cheaper = weigh_if(find_cheaper(rows, choice), chart, targets, find_steps)
        better = weigh_if(find_better(rows, choice, chart), chart, targets, find_steps)
    own = next((row for row in chart.list_ran() if row.own), None)
    return Advice(
        targets,
        choice,
        find_binding(choice, cheaper, chart),
        cheaper,
        better,
        weigh_if(own, chart, targets, find_steps),
        len(chart.rows),
        len(rows),
    )


def is_deeper(targets: Targets, chart: Chart) -> bool:
    """Whether the organ will be pressed or pulled farther than it was charted."""
    return targets.depth > abs(chart.way.depth)


def holds(row: Row, chart: Chart, targets: Targets) -> bool:
    """Whether its kind is made for displacements as large as are asked for."""
    return row.configuration.kind not in SMALL_DISPLACEMENTS or not is_deeper(targets, chart)


def weigh_if(
    row: Row | None, chart: Chart, targets: Targets, find_steps: FindSteps
) -> Candidate | None:
    return None if row is None else weigh(row, chart, targets, find_steps(row))


def weigh(row: Row, chart: Chart, targets: Targets, steps: Steps | None = None) -> Candidate:
    """A row that ran beside the targets; without `steps` as cheap as it can be."""
    assert row.total is not None and row.cost is not None
    configuration, cost, share = row.configuration, row.cost, 0.0
    if steps is not None:
        most = STEP_SHARE * steps.limit * targets.rate
        count = max(steps.count, math.ceil(1.0 / most)) if math.isfinite(most) else steps.count
        if count > steps.count:
            configuration = replace(configuration, substeps=count)
            cost = scale(cost, max(1.0, count / max(steps.count, FEWEST_IN_TOUCH)))
        share = 1.0 / (targets.rate * count * steps.limit)
    held, seen = chart.truth, row.total.displacement
    needs = [
        Need(FORCE, row.total.force_rms + held.force_error, targets.force_error),
        Need(
            DISPLACEMENT,
            None if seen is None else seen + held.displacement_error,
            targets.displacement_error,
        ),
        Need(TIME, TIME_FACTOR * cost.p99, 1.0 / targets.rate),
    ]
    if steps is not None:
        needs.append(Need(STEP, share, STEP_SHARE))
    return Candidate(row, configuration, cost, tuple(needs))


def scale(cost: Cost, factor: float) -> Cost:
    """Of so many times the steps: every part of a tick is taken to grow with them."""
    spans = {name: factor * getattr(cost, name) for name in ("median", "least", "most", "p99")}
    return replace(cost, **spans)


def find_fitting(
    chart: Chart, rows: Iterable[Row], targets: Targets, find_steps: FindSteps
) -> list[Candidate]:
    """Rows that meet every target, but for those that one of them is cheaper than for certain."""
    found: list[Candidate] = []
    hopeful = [row for row in rows if weigh(row, chart, targets).fits]
    for row in sorted(hopeful, key=lambda row: (row.cost.least, row.number)):
        if any(other.cost.most < row.cost.least for other in found):
            break
        candidate = weigh(row, chart, targets, find_steps(row))
        if candidate.fits:
            found.append(candidate)
    return found


def choose(fitting: Sequence[Candidate]) -> Candidate:
    """The most accurate of those than which no other is cheaper for certain."""
    least = min(candidate.cost.most for candidate in fitting)
    kept = [candidate for candidate in fitting if candidate.cost.least <= least]
    return min(kept, key=rank)


def rank(candidate: Candidate) -> tuple[float, float, int]:
    row = candidate.row
    assert row.total is not None
    return row.total.force_rms, candidate.cost.median, row.number


def find_nearest(
    chart: Chart, rows: Iterable[Row], targets: Targets, find_steps: FindSteps
) -> Candidate | None:
    """The row whose worst need is missed by least; of equal ones the cheaper."""
    best: Candidate | None = None
    hoped = [weigh(row, chart, targets) for row in rows]
    for hope in sorted(hoped, key=lambda one: (one.worst.ratio, one.cost.median, one.row.number)):
        if best is not None and hope.worst.ratio >= best.worst.ratio:
            break
        candidate = weigh(hope.row, chart, targets, find_steps(hope.row))
        if best is None or candidate.worst.ratio < best.worst.ratio:
            best = candidate
    return best


def find_cheaper(rows: Iterable[Row], choice: Candidate) -> Row | None:
    """The most accurate of those that are cheaper for certain."""
    front = find_front([row for row in rows if row.cost.most < choice.cost.least])
    return front[-1] if front else None


def find_better(rows: Iterable[Row], choice: Candidate, chart: Chart) -> Row | None:
    """The cheapest whose force is better by more than the truth's own error, and whose shape is no
    worse by more than that: a surface of springs may have the force of one press by chance."""
    total, truth = choice.row.total, chart.truth
    most = total.force_rms - truth.force_error
    shape = math.inf
    if total.displacement is not None:
        shape = total.displacement + truth.displacement_error
    found = [
        row
        for row in rows
        if row.total.force_rms < most and (row.total.displacement or 0.0) <= shape
    ]
    front = find_front(found)
    return front[0] if front else None


def find_binding(choice: Candidate | None, cheaper: Candidate | None, chart: Chart) -> str:
    """What keeps from something cheaper; of a miss, what is missed most."""
    if choice is None:
        return NOTHING
    if not choice.fits:
        return name_binding(choice, chart)
    return NOTHING if cheaper is None else name_binding(cheaper, chart)


def name_binding(candidate: Candidate, chart: Chart) -> str:
    """The need that is missed most, or the truth where that alone brings it over its target."""
    worst, held = candidate.worst, chart.truth
    own = {FORCE: held.force_error, DISPLACEMENT: held.displacement_error}.get(worst.name)
    if own is None or worst.value is None:
        return worst.name
    return TRUTH if worst.value - own <= worst.allowed else worst.name
