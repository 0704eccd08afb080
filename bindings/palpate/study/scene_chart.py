# SPDX-License-Identifier: BSD-3-Clause
"""The chart of one organ: what each way to simulate it costs, and how far it is from the truth.

A chart has a row for every configuration (model x contact law x integrator x step x mesh) along one
path of the hand. palpate_editor.chart runs them; chart_file keeps a chart; nothing here runs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

FORCE_TARGET, DISPLACEMENT_TARGET = 0.10, 0.05
"""[-] What a hand and an eye let pass [accuracy: targets]."""
RAN, REFUSED, ALARM, LOST = "ran", "refused", "alarm", "lost"
OUTCOMES = (RAN, REFUSED, ALARM, LOST)
"""Of a row: it ran to the end of the path; it cannot be built; an alarm ended it; the process that
ran it ended, and nobody knows."""
PATHS = ("press", "pull", "drag", "script")
"""Straight down; up, with the tool holding on; over the surface at one depth; a script's."""

FAR_FIELDS = ("fine", "mesh")
"""Of a solid with a near field: solved on a finer mesh, or that of the tetrahedra it ticks on."""


@dataclass(frozen=True)
class Configuration:
    """What a point of the chart decides of an organ's document; all else is the organ's own.

    palpate_editor.configuration.apply_configuration gives an organ its values.
    """

    kind: str
    """model.kind: mass_spring, molecular, shell, solid, linear_solid, ..."""
    constants: str
    """model.constants: tissue, from Young's modulus and Poisson's ratio; or chosen by hand, as the
    four numbers below say. Only springs and molecules can have chosen ones."""
    spring_rule: str
    """model.spring_rule, of mass_spring with constants from tissue."""
    angle_law: str
    """model.angle_law, of molecular."""
    stiffness: float
    """[N/m] model.stiffness; counts where chosen."""
    bend_stiffness: float
    """[J] model.bend_stiffness; counts where chosen."""
    stretch_coupling: float
    """[N] model.stretch_coupling; counts where chosen."""
    home_stiffness: float | None
    """[N/m³] model.home_stiffness; None: the builder's own. Of springs, molecules and shells."""
    contact_law: str
    """model.contact_law: near_field or hard. Of solids and walls of prisms; springs and molecules
    have the hard law."""
    integrator: str
    """A name of palpate.Integrator. A linear solid under symplectic_euler answers from its
    precomputed response, at rest in every step; under any other its masses swing."""
    substeps: int
    """hand.substeps: steps of a tick in the air at least; 0: as many as the tissue needs."""
    vertices: int
    """Of the surface, decimated from the imported one; 0: the surface as the document has it."""
    tetrahedra: int
    """fill.tetrahedra that are asked for; 0 for a surface, which has none."""
    far_field: str = "mesh"
    """Of solids with a near field: fine, the organ's table that was solved on a finer mesh; or
    mesh, that of the tetrahedra it ticks on."""


@dataclass(frozen=True)
class Errors:
    """How far a force is from another along the path, and a displacement; smaller is better.

    A force is compared along the truth's direction, with the other's at the place where the tool
    itself is at that tick, so that the hand's spring hides nothing.
    """

    force_rms: float
    """[-] Root mean square over the ticks in touch, of the truth's largest force on the path."""
    force_most: float
    """[-] The largest of them, of the same."""
    displacement: float | None
    """[-] Root mean square of the surface's, of the tool's depth, over the looks at it; None where
    none was looked at."""


@dataclass(frozen=True)
class Cost:
    """What a tick costs in touch, on the machine that the chart names."""

    median: float
    """[s] The median of the medians of batches."""
    least: float
    """[s] Median of the quickest batch ..."""
    most: float
    """[s] ... and of the slowest: the interval of `median`."""
    p99: float
    """[s] Of all ticks in touch of all batches."""
    misses: float
    """[-] Share of these ticks that took longer than a tick of the scene's rate may."""
    ticks: int
    """How many were measured."""


@dataclass(frozen=True)
class Counts:
    """What no machine changes."""

    particles: int
    elements: int
    """Tetrahedra, prisms, or springs and bonds: of which the tissue is made."""
    substeps: int
    """Of a tick in touch, the most."""
    iterations: float | None
    """Of XPBD or projective dynamics, mean of the ticks in touch; None for the others."""
    evaluations: float | None
    """Of all the tissue's forces, mean of the ticks in touch, by an explicit integrator; None for
    what solves for its step, and for a response, which evaluates none."""


@dataclass(frozen=True)
class Row:
    """One configuration along the path."""

    number: int
    """In the order of the chart, from 0."""
    name: str
    """In words: `solid, near field, 3000 tetrahedra, symplectic Euler x1`."""
    own: bool
    """It is the configuration that the organ came with; exactly one row is."""
    configuration: Configuration
    provenance: str
    """In words: where the constants come from."""
    outcome: str
    """One of OUTCOMES. All below is None or 0 where it did not run, but for what was counted."""
    reason: str
    """Why it did not run to the end, in words; empty where it did."""
    kernel: str
    """reference, packed or response: what ran it."""
    force: float
    """[N] the largest along the truth's direction."""
    jump: float
    """[N] The largest change of the force on the hand from tick to tick."""
    total: Errors | None
    """Of the run beside the truth."""
    model: Errors | None
    """Of the same model converged in time beside the truth: law, mesh and contact. None where that
    did not run to the end."""
    time: Errors | None
    """Of the run beside the same model converged in time, tick by tick."""
    reference_limited: bool
    """The truth's own error is not below the total: which of two such rows is better, the truth
    cannot tell."""
    counts: Counts | None
    cost: Cost | None
    """None also where nothing was timed yet."""


@dataclass(frozen=True)
class Way:
    """The path of the hand that all rows share."""

    kind: str
    """One of PATHS."""
    file: str
    """Name of the script; empty for the others."""
    speed: float
    """[m/s] of the hand, mean; of a script, over all of it."""
    depth: float
    """[m] The deepest that the truth was solved to, beyond first touch; negative for a pull."""
    stations: int
    """Places along it at which the truth was solved."""
    ticks: int


@dataclass(frozen=True)
class Held:
    """The truth that all rows are held against, but for its arrays."""

    key: str
    """Of palpate.study.truth.Truth."""
    law: str
    """linear or neo_hookean."""
    force: float
    """[N] Its largest along the path: what errors are parts of."""
    force_error: float
    """[-] of that: its own error, the largest along the path."""
    displacement_error: float
    """[-] of the depth: its own error, the largest along the path."""


@dataclass(frozen=True)
class Machine:
    """Where costs were measured, and how."""

    processor: str
    target: str
    """The vector target of the packed kernels."""
    timing: str
    """In words: what else ran meanwhile."""


@dataclass(frozen=True)
class Chart:
    """One organ, one path, one truth, and every configuration."""

    organ: str
    """Its title."""
    key: str
    """Hash of all that errors depend on: organ, tool, hand, path and truth. Rows of another key are
    rows of another chart."""
    command: str
    """What draws it again."""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    wall_thickness: float | None
    """[m]; None for a solid organ."""
    tool_radius: float
    """[m]"""
    rate: float
    """[Hz] of ticks."""
    force_target: float
    """[-] The lines of the chart ..."""
    displacement_target: float
    """[-] ... and what an advisor goes by, unless it is asked for others."""
    complete: bool
    """Every row was tried; not so after Ctrl-C."""
    way: Way
    truth: Held
    machine: Machine
    rows: tuple[Row, ...]

    def list_ran(self) -> list[Row]:
        """Rows that have errors and a cost: the points of the chart."""
        return [row for row in self.rows if row.total is not None and row.cost is not None]

    def list_failed(self) -> list[Row]:
        """Rows on the rail."""
        return [row for row in self.rows if row.outcome != RAN]


def find_front(rows: Sequence[Row]) -> list[Row]:
    """The Pareto front: by rising cost, whatever has a smaller force error (RMS) than all that are
    cheaper. Rows without errors or cost are left out."""
    points = [row for row in rows if row.total is not None and row.cost is not None]
    front: list[Row] = []
    for row in sorted(points, key=lambda row: (row.cost.median, row.total.force_rms, row.number)):
        if not front or row.total.force_rms < front[-1].total.force_rms:
            front.append(row)
    return front


def find_possible_front(rows: Sequence[Row], force_error: float) -> list[Row]:
    """Those that the intervals leave on the front: no other row is both cheaper, its slowest batch
    below their quickest, and better by more than the truth's own error.

    Args:
        rows: Of a chart.
        force_error: [-] The truth's.
    """
    points = [row for row in rows if row.total is not None and row.cost is not None]
    return [
        row
        for row in points
        if not any(
            other.cost.most < row.cost.least
            and other.total.force_rms + force_error < row.total.force_rms
            for other in points
        )
    ]
