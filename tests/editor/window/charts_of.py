# SPDX-License-Identifier: GPL-3.0-or-later
"""A chart of the organ on the desk, with numbers made up: nothing of it ran."""

from __future__ import annotations

from dataclasses import replace
from math import exp

from palpate.study.scene_chart import (
    Chart,
    Configuration,
    Cost,
    Counts,
    Errors,
    Held,
    Machine,
    Row,
    Way,
)
from palpate_editor.configuration import describe_provenance, name_configuration
from palpate_editor.configurations import list_configurations
from palpate_editor.document import Organ

FAILED = "tetrahedron 7 turned inside out"


def make_chart(organ: Organ, count: int | None = None) -> Chart:
    """Every configuration that a chart tries, or the first few; each fifth is ended by an alarm."""
    wanted = list_configurations(organ)[:count]
    return Chart(
        organ=organ.title or organ.name,
        key="5" * 64,
        command="palpate chart a.organ",
        young_modulus=organ.material.young_modulus,
        poisson_ratio=organ.material.poisson_ratio,
        wall_thickness=organ.material.wall_thickness,
        tool_radius=organ.tool.radius,
        rate=organ.hand.rate,
        force_target=0.10,
        displacement_target=0.05,
        complete=True,
        way=Way("press", "", 0.01, 3e-3, 1, 500),
        truth=Held("1" * 64, "linear", 0.12, 0.02, 0.01),
        machine=Machine("a processor", "AVX2", "one after the other"),
        rows=tuple(make_row(organ, i, c) for i, c in enumerate(wanted)),
    )


def make_row(organ: Organ, number: int, c: Configuration) -> Row:
    """A finer mesh costs more and is better; what is implicit costs more."""
    ran = number % 5 != 4
    size = (c.tetrahedra or 3 * (c.vertices or organ.vertex_count)) / 1000.0
    slower = 1.0 if c.integrator == "symplectic_euler" else 6.0
    cost = 4e-5 * size**1.1 * slower * (0.4 if c.kind == "linear_solid" else 1.0)
    off = 0.05 + 0.3 * exp(-size) + (0.25 if c.constants == "chosen" else 0.0)
    error = off * (1.4 if c.contact_law == "hard" else 1.0) * (0.9 + 0.02 * (number % 7))
    return Row(
        number=number,
        name=name_configuration(c, organ),
        own=number == 0,
        configuration=c,
        provenance=describe_provenance(c, organ),
        outcome="ran" if ran else "alarm",
        reason="" if ran else FAILED,
        kernel="packed",
        force=0.1,
        jump=1e-3,
        total=Errors(error, 2.0 * error, 0.5 * error) if ran else None,
        model=Errors(0.9 * error, 1.8 * error, 0.5 * error) if ran else None,
        time=Errors(0.1 * error, 0.2 * error, None) if ran else None,
        reference_limited=ran and error < 0.02,
        counts=Counts(
            organ.vertex_count if not (c.tetrahedra or c.vertices) else c.vertices or 800,
            int(1000 * size), 12, None, 12.0,
        ) if ran else None,
        cost=Cost(cost, 0.9 * cost, 1.1 * cost, 1.5 * cost, 0.0, 1000) if ran else None,
    )  # fmt: skip


def drop_costs(chart: Chart, first: int) -> Chart:
    """As it is while it is drawn: rows from `first` on are not timed yet."""
    rows = tuple(r if r.number < first else replace(r, cost=None) for r in chart.rows)
    return replace(chart, rows=rows, complete=False)
