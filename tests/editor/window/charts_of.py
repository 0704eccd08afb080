# SPDX-License-Identifier: GPL-3.0-or-later
"""A chart of the organ on the desk, with numbers made up: nothing of it ran."""

from __future__ import annotations

from dataclasses import replace
from math import exp

from made_up_charts import make_chart as make_any_chart
from made_up_charts import make_row as make_any_row
from palpate.study.scene_chart import Chart, Configuration, Row
from palpate_editor.configuration import describe_provenance, name_configuration
from palpate_editor.configurations import list_configurations
from palpate_editor.document import Organ

FAILED = "tetrahedron 7 turned inside out"


def make_chart(organ: Organ, count: int | None = None) -> Chart:
    """Every configuration that a chart tries, or the first few; each fifth is ended by an alarm."""
    wanted = list_configurations(organ)[:count]
    return replace(
        make_any_chart(),
        organ=organ.title or organ.name,
        young_modulus=organ.material.young_modulus,
        poisson_ratio=organ.material.poisson_ratio,
        wall_thickness=organ.material.wall_thickness,
        tool_radius=organ.tool.radius,
        rate=organ.hand.rate,
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
    row = make_any_row(
        number, cost=cost, error=error, reason="" if ran else FAILED, own=number == 0
    )
    particles = organ.vertex_count if not (c.tetrahedra or c.vertices) else c.vertices or 800
    return replace(
        row,
        name=name_configuration(c, organ),
        configuration=c,
        provenance=describe_provenance(c, organ),
        counts=replace(row.counts, particles=particles, elements=int(1000 * size)) if ran else None,
    )


def drop_costs(chart: Chart, first: int) -> Chart:
    """As it is while it is drawn: rows from `first` on are not timed yet."""
    rows = tuple(r if r.number < first else replace(r, cost=None) for r in chart.rows)
    return replace(chart, rows=rows, complete=False)
