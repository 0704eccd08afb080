# SPDX-License-Identifier: BSD-3-Clause
"""What stands beside the points of a chart: titles, the front, and the rail of what failed."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from matplotlib.axes import Axes

from palpate.render.theme import Theme
from palpate.study.scene_chart import Chart, Row, find_front

LINE = 54
"""Letters of a line of the lists."""
MOST_REASONS = 7
"""On the rail; the rest is counted."""
KINDS = {
    "solid": ("solid: springs and volumes", "#1f6fb2"),
    "linear_solid": ("linear solid", "#0f9d7a"),
    "corotated_solid": ("corotated solid", "#7a4fb5"),
    "neo_hookean_solid": ("neo-Hookean solid", "#b0256f"),
    "shell": ("shell of prisms", "#8fb31d"),
    "mass_spring": ("springs on the surface (MSS)", "#d9822b"),
    "molecular": ("molecules on the surface (MMS)", "#c23b3b"),
}
"""Kind of model -> what it is called, its colour."""


def write_title(chart: Chart) -> str:
    ball, depth = 1e3 * chart.tool_radius, 1e3 * abs(chart.way.depth)
    done = "" if chart.complete else " (not finished)"
    return (
        f"{chart.organ}: speed against accuracy, {chart.way.kind} of {depth:.2g} mm, "
        f"ball of {ball:g} mm{done}"
    )


def write_subtitle(chart: Chart) -> str:
    """What the organ is made of, and where costs were measured."""
    wall = chart.wall_thickness
    body = "" if wall is None else f", a wall of {1e3 * wall:g} mm"
    return (
        f"E {1e-3 * chart.young_modulus:g} kPa, nu {chart.poisson_ratio:g}{body}; largest force "
        f"{1e3 * chart.truth.force:.3g} mN, known to {100 * chart.truth.force_error:.2g} %; "
        f"{chart.machine.processor}, {chart.machine.target}"
    )


def write_time(seconds: float) -> str:
    """700 us, 1.2 ms"""
    return f"{1e6 * seconds:.3g} us" if seconds < 0.9995e-3 else f"{1e3 * seconds:.3g} ms"


def say_front(chart: Chart) -> list[tuple[str, str]]:
    """Head and lines of the front: what each costs, and how far it is off."""
    lines = [
        f"{number}   {write_time(row.cost.median)}, {100 * row.total.force_rms:.3g} %"
        f"{' (reference-limited)' if row.reference_limited else ''}: {row.name}"
        for number, row in enumerate(find_front(chart.rows), start=1)
    ]
    return [("The front: nothing cheaper is nearer to the truth", "head"),
            *((line, "line") for line in lines)]  # fmt: skip


def say_rail(chart: Chart) -> list[tuple[str, str]]:
    """What did not run to its end, by reason."""
    reasons: dict[str, list[Row]] = {}
    for row in chart.list_failed():
        reasons.setdefault(row.reason.split(";")[0], []).append(row)
    ordered = sorted(reasons.items(), key=lambda item: -len(item[1]))
    lines = [(f"Not run to the end: {len(chart.list_failed())} of {len(chart.rows)}", "head")]
    for reason, rows in ordered[:MOST_REASONS]:
        kinds = ", ".join(dict.fromkeys(KINDS[row.configuration.kind][0] for row in rows))
        lines.append((f"{len(rows)} x {kinds}: {reason}", "line"))
    left = sum(len(rows) for _, rows in ordered[MOST_REASONS:])
    if left:
        lines.append((f"{left} more, for other reasons", "line"))
    return lines


def write_list(axes: Axes, lines: Sequence[tuple[str, str]], theme: Theme) -> None:
    """A head and lines of text from the top of a panel, as long as there is room."""
    axes.axis("off")
    width = LINE * (2 if axes.get_subplotspec().colspan.start == 0 else 1) + 8
    y = 1.0
    for text, style in lines:
        head = style == "head"
        wrapped = textwrap.wrap(text, width, subsequent_indent="     ")
        axes.text(
            0.0, y, "\n".join(wrapped), transform=axes.transAxes, va="top", color=theme.text,
            fontsize=10.5 if head else 9, fontweight="bold" if head else "normal",
            parse_math=False,
        )  # fmt: skip
        y -= (0.085 if head else 0.062) * len(wrapped) + 0.012
        if y < 0.0:
            break
