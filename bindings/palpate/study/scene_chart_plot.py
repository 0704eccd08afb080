# SPDX-License-Identifier: BSD-3-Clause
"""The chart of an organ as a picture: cost in touch against error, the front, and what failed."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullFormatter

from palpate.files.whole_file import write_whole
from palpate.render.force_plot import DPI, dress
from palpate.render.theme import THEMES, Theme
from palpate.scene.scene_parts import EXPLICIT, WITH_NEAR_FIELD
from palpate.study.chart import scale, scale_percents
from palpate.study.scene_chart import Chart, Row, find_front
from palpate.study.scene_chart_words import (
    KINDS,
    say_front,
    say_rail,
    write_list,
    write_subtitle,
    write_time,
    write_title,
)

WIDTH, HEIGHT = 1500, 1120
"""[px]"""
MARKERS = {
    "symplectic_euler": ("o", "symplectic Euler"),
    "explicit": ("^", "another explicit integrator"),
    "implicit": ("s", "an implicit integrator"),
    "xpbd": ("P", "XPBD"),
    "projective_dynamics": ("X", "projective dynamics"),
}
SMALLEST, LARGEST = 5.0, 11.0
"""[pt] of a marker, for the coarsest and the finest mesh."""
FRONT = "#111418"


def save_scene_chart(path: Path, chart: Chart) -> None:
    """As SVG where the name ends so, else as PNG.

    Raises OSError, and ValueError for a chart without any point.
    """
    file = io.BytesIO()
    # an equal chart is an equal file
    with rc_context({"svg.hashsalt": chart.key, "svg.fonttype": "none"}):
        figure = draw_scene_chart(chart)
        if path.suffix.lower() == ".svg":
            FigureCanvasSVG(figure).print_svg(file, metadata={"Date": None})
        else:
            FigureCanvasAgg(figure).print_png(file)
    write_whole(path, file.getvalue())


def draw_scene_chart(chart: Chart) -> Figure:
    """Force error, displacement error, and where the error comes from; the lists below."""
    if not chart.list_ran():
        raise ValueError("chart: got no row with errors and a cost, expected at least one")
    theme = THEMES["light"]
    figure = Figure(
        figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI, layout="constrained", facecolor=theme.panel
    )
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.12)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.75, 1.0], height_ratios=[1.0, 1.0, 0.95])
    force = figure.add_subplot(grid[:2, 0])
    displacement = figure.add_subplot(grid[0, 1])
    parts = figure.add_subplot(grid[1, 1])
    plot_force(force, chart, theme)
    plot_displacement(displacement, chart, theme)
    plot_parts(parts, chart, theme)
    write_list(figure.add_subplot(grid[2, 0]), say_front(chart), theme)
    write_list(figure.add_subplot(grid[2, 1]), say_rail(chart), theme)
    write_keys(figure, chart, theme)
    figure.suptitle(
        write_title(chart), color=theme.text, fontsize=15, fontweight="bold", x=0.012, ha="left",
        parse_math=False,
    )  # fmt: skip
    force.set_title(write_subtitle(chart), loc="left", color=theme.faint, fontsize=9.5)
    return figure


def plot_force(axes: Axes, chart: Chart, theme: Theme) -> None:
    front = find_front(chart.rows)
    for row in chart.list_ran():
        draw_point(axes, row, row.total.force_rms, chart)
    draw_front(axes, front, theme)
    for row in chart.list_ran():
        if row.own:
            mark_own(axes, row, theme)
    scale(axes, theme)
    scale_costs(axes)
    draw_targets(axes, chart, chart.force_target, theme)
    low = axes.get_xlim()[0]
    own = chart.truth.force_error
    if own > low:
        axes.axvspan(low, own, color=theme.faint, alpha=0.10, linewidth=0)
        axes.text(
            own, 0.015, "the truth's own error ", transform=axes.get_xaxis_transform(), rotation=90,
            ha="right", va="bottom", fontsize=8.5, color=theme.faint,
        )  # fmt: skip
        axes.set_xlim(left=low)
    axes.set_xlabel("force: root mean square error along the path, of the largest force")
    axes.set_ylabel("processor time of a tick in touch")


def plot_displacement(axes: Axes, chart: Chart, theme: Theme) -> None:
    points = [row for row in chart.list_ran() if row.total.displacement]
    for row in points:
        draw_point(axes, row, row.total.displacement, chart)
        if row.own:
            mark_own(axes, row, theme, row.total.displacement)
    axes.set_xlabel("displacement of the surface: error, of the depth")
    if points:
        scale(axes, theme)
        scale_costs(axes)
        draw_targets(axes, chart, chart.displacement_target, theme)
    else:
        say_none(axes, "the truth has no displacements", theme)


def plot_parts(axes: Axes, chart: Chart, theme: Theme) -> None:
    """Time error against model error: below the line it is the model that errs."""
    points = [row for row in chart.list_ran() if row.model and row.time and row.time.force_rms > 0]
    axes.set_xlabel("model error: law, mesh and contact")
    axes.set_ylabel("time error: integrator and step")
    if not points:
        say_none(axes, "no model converged in time", theme)
        return
    for row in points:
        draw_marker(axes, row, row.model.force_rms, row.time.force_rms, chart)
    scale(axes, theme)
    scale_percents(axes.yaxis)
    low = max(axes.get_xlim()[0], axes.get_ylim()[0])
    high = min(axes.get_xlim()[1], axes.get_ylim()[1])
    if low < high:
        axes.plot([low, high], [low, high], color=theme.faint, linewidth=1.0, linestyle=(0, (4, 3)))


def say_none(axes: Axes, text: str, theme: Theme) -> None:
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", color=theme.faint)
    axes.set_xticks([])
    axes.set_yticks([])
    dress(axes, theme)


def draw_point(axes: Axes, row: Row, error: float, chart: Chart) -> None:
    """A marker with the interval of its cost."""
    colour = KINDS[row.configuration.kind][1]
    axes.plot(
        [error, error], [row.cost.least, row.cost.most], color=colour, linewidth=1.0, alpha=0.6
    )
    draw_marker(axes, row, error, row.cost.median, chart)


def draw_marker(axes: Axes, row: Row, x: float, y: float, chart: Chart) -> None:
    """Colour is the model, form the integrator, size the mesh; hollow is what was chosen instead of
    derived: constants of springs, and the hard law of solids and walls."""
    c = row.configuration
    colour = KINDS[c.kind][1]
    near = c.contact_law == "near_field"
    filled = near if c.kind in WITH_NEAR_FIELD else c.constants == "tissue"
    axes.plot(
        x, y,
        marker=MARKERS[find_form(c.integrator)][0],
        markersize=find_size(row, chart),
        markerfacecolor=colour if filled else "white",
        markeredgecolor="white" if filled else colour,
        markeredgewidth=0.8 if filled else 1.4,
        alpha=0.9,
        linestyle="",
        zorder=3,
    )  # fmt: skip


def find_form(integrator: str) -> str:
    if integrator in MARKERS:
        return integrator
    return "explicit" if integrator in EXPLICIT else "implicit"


def find_size(row: Row, chart: Chart) -> float:
    """[pt] by the particles of the mesh, of those of the chart."""
    counts = [other.counts.particles for other in chart.rows if other.counts is not None]
    least, most = min(counts), max(counts)
    if least == most or row.counts is None:
        return 0.5 * (SMALLEST + LARGEST)
    share = (row.counts.particles - least) / (most - least)
    return SMALLEST + (LARGEST - SMALLEST) * share**0.5


def draw_front(axes: Axes, front: Sequence[Row], theme: Theme) -> None:
    """Stairs through the front, numbered as the list below."""
    if not front:
        return
    x = [row.total.force_rms for row in front]
    y = [row.cost.median for row in front]
    axes.step(x, y, where="post", color=FRONT, linewidth=1.6, alpha=0.75, zorder=2)
    for number, row in enumerate(front, start=1):
        axes.annotate(
            str(number), (row.total.force_rms, row.cost.median), xytext=(-7, -11),
            textcoords="offset points", fontsize=10, fontweight="bold", color=theme.text, zorder=5,
            ha="right",
        )  # fmt: skip


def mark_own(axes: Axes, row: Row, theme: Theme, error: float | None = None) -> None:
    """The organ's own configuration."""
    x = row.total.force_rms if error is None else error
    axes.plot(
        x, row.cost.median, marker="o", markersize=19, markerfacecolor="none",
        markeredgecolor=FRONT, markeredgewidth=1.8, linestyle="", zorder=4,
    )  # fmt: skip
    if error is None:
        axes.annotate(
            "as it is now", (x, row.cost.median), xytext=(13, 11), textcoords="offset points",
            fontsize=10, fontweight="bold", color=theme.text, zorder=5,
        )  # fmt: skip


def draw_targets(axes: Axes, chart: Chart, target: float, theme: Theme) -> None:
    axes.axvline(target, color=theme.faint, linewidth=1.1, linestyle=(0, (4, 3)), zorder=1)
    axes.axhline(
        1.0 / chart.rate, color=theme.faint, linewidth=1.1, linestyle=(0, (1, 2)), zorder=1
    )


def scale_costs(axes: Axes) -> None:
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: write_time(value)))
    axes.yaxis.set_minor_formatter(NullFormatter())


def write_keys(figure: Figure, chart: Chart, theme: Theme) -> None:
    rows = chart.list_ran()
    kinds = {row.configuration.kind for row in rows}
    forms = {find_form(row.configuration.integrator) for row in rows}
    keys = [
        Line2D([], [], marker="o", linestyle="", color=colour, markersize=8, label=name)
        for kind, (name, colour) in KINDS.items()
        if kind in kinds
    ]
    keys += [
        Line2D([], [], marker=marker, linestyle="", color=theme.text, markersize=7, label=name)
        for form, (marker, name) in MARKERS.items()
        if form in forms
    ]
    keys.append(
        Line2D([], [], marker="o", linestyle="", markerfacecolor="white", markersize=8,
               markeredgecolor=theme.text, label="hollow: hard contact law, or chosen constants")
    )  # fmt: skip
    dashes = (0, (4, 3)), (0, (1, 2))
    names = "what a hand, an eye lets pass", f"a tick at {chart.rate:g} Hz"
    keys += [
        Line2D([], [], color=theme.faint, linestyle=dash, label=name)
        for dash, name in zip(dashes, names, strict=True)
    ]
    keys.append(Line2D([], [], color=FRONT, linewidth=1.6, label="the front; larger: finer mesh"))
    figure.legend(
        handles=keys, loc="outside lower left", ncols=4, frameon=False, labelcolor=theme.text,
        fontsize=9,
    )  # fmt: skip
