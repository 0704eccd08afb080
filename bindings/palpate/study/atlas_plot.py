# SPDX-License-Identifier: BSD-3-Clause
"""The atlas of an organ as a picture: where steps hold, where they fail, and where the scene is."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from pathlib import Path

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator

from palpate.files.whole_file import write_whole
from palpate.render.force_plot import DPI, dress
from palpate.render.theme import THEMES, Theme
from palpate.study.atlas import DAMPINGS, MESHES, NEVER, OWN, Atlas, Row, Spot
from palpate.study.atlas_table import draw_table
from palpate.study.atlas_words import (
    INTEGRATORS,
    find_limit,
    say_present,
    write_step,
    write_subtitle,
    write_title,
)
from palpate.study.scene_chart_words import KINDS

WIDTH, HEIGHT = 1500, 1200
"""[px]"""
HOLDS, FAILS, MARK = "#d9efdc", "#f7d9d6", "#111418"
DASHED = (0, (5, 3))
TICKS = {0.01: "1/100", 0.1: "1/10", 1.0: "as it is", 10.0: "10 x", 100.0: "100 x"}


def save_atlas(path: Path, atlas: Atlas) -> None:
    """As SVG where the name ends so, else as PNG.

    Raises OSError, and ValueError for an atlas without rows.
    """
    file = io.BytesIO()
    # an equal atlas is an equal file
    with rc_context({"svg.hashsalt": atlas.key, "svg.fonttype": "none"}):
        figure = draw_atlas(atlas)
        if path.suffix.lower() == ".svg":
            FigureCanvasSVG(figure).print_svg(file, metadata={"Date": None})
        else:
            FigureCanvasAgg(figure).print_png(file)
    write_whole(path, file.getvalue())


def draw_atlas(atlas: Atlas) -> Figure:
    """Stiffness, damping and mesh of the organ's own model; below, every model and integrator."""
    if not atlas.rows:
        raise ValueError("atlas: got no row, expected at least one")
    theme = THEMES["light"]
    figure = Figure(
        figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI, layout="constrained", facecolor=theme.panel
    )
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.12)
    rows = 0.55 + 0.62 * len(atlas.list_kinds())
    grid = figure.add_gridspec(3, 2, width_ratios=[1.55, 1.0], height_ratios=[2.6, 2.6, rows])
    stiffness = figure.add_subplot(grid[:2, 0])
    plot_stiffness(stiffness, atlas, theme)
    plot_others(figure.add_subplot(grid[0, 1]), atlas, theme, DAMPINGS, "damping")
    plot_others(figure.add_subplot(grid[1, 1]), atlas, theme, MESHES, "mesh")
    draw_table(figure.add_subplot(grid[2, :]), atlas, theme)
    write_keys(figure, atlas, theme)
    figure.suptitle(
        write_title(atlas), color=theme.text, fontsize=15, fontweight="bold", x=0.012, ha="left",
        parse_math=False,
    )  # fmt: skip
    figure.text(
        0.012, 0.963, write_subtitle(atlas), color=theme.faint, fontsize=10, ha="left", va="top"
    )
    stiffness.set_title(" ", fontsize=16)  # room for that
    return figure


def find_shown(atlas: Atlas) -> str:
    """The integrator of the large map: the scene's own, or the usual one if it has no limit."""
    present = atlas.present
    limited = [
        name for name in INTEGRATORS if len(atlas.list_line(present.kind, name)) > 1
    ]  # fmt: skip
    if present.integrator in limited or not limited:
        return present.integrator
    return limited[0]


def plot_stiffness(axes: Axes, atlas: Atlas, theme: Theme) -> None:
    """Step against stiffness: green holds, red fails."""
    present, shown = atlas.present, find_shown(atlas)
    line = atlas.list_line(present.kind, shown)
    axes.set_xscale("log")
    axes.set_yscale("log")
    low, high = find_span(atlas, line)
    if line:
        x = [row.spot.stiffness for row in line]
        y = [row.measured or low for row in line]
        axes.fill_between(x, low, y, color=HOLDS, linewidth=0)
        axes.fill_between(x, y, high, color=FAILS, linewidth=0)
        colour = INTEGRATORS[shown][1]
        axes.plot(x, y, color=colour, linewidth=2.4, marker="o", markersize=5)
        plot_predicted(axes, line, colour)
        axes.set_xlim(x[0], x[-1])
        write_regions(axes, theme)
    axes.set_ylim(low, high)
    mark_present(axes, atlas, theme)
    dress(axes, theme)
    axes.xaxis.set_major_locator(FixedLocator(list(TICKS)))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: TICKS.get(value, "")))
    scale_steps(axes)
    kind = KINDS[present.kind][0]
    axes.set_xlabel(f"stiffness of the organ ({kind}), times its own")
    axes.set_ylabel(f"time step of {INTEGRATORS[shown][0]}")


def find_span(atlas: Atlas, line: Sequence[Row]) -> tuple[float, float]:
    """[s] From below the scene's step to above the limits."""
    steps = [row.measured for row in line if row.measured] + [atlas.present.step]
    return 0.4 * min(steps), 2.0 * max(steps)


def write_regions(axes: Axes, theme: Theme) -> None:
    for x, y, ha, text in (
        (0.03, 0.05, "left", "the step holds"),
        (0.97, 0.95, "right", "it blows up"),
    ):
        axes.text(
            x, y, text, transform=axes.transAxes, ha=ha, va="bottom" if y < 0.5 else "top",
            fontsize=13, color=theme.faint, fontweight="bold", alpha=0.75,
        )  # fmt: skip


def plot_predicted(axes: Axes, line: Sequence[Row], colour: str) -> None:
    points = [(row.spot.stiffness, row.predicted) for row in line if row.predicted]
    axes.plot(*zip(*points, strict=True), color=colour, linewidth=1.6, linestyle=DASHED)


def mark_present(axes: Axes, atlas: Atlas, theme: Theme) -> None:
    """Where the scene is, and how far below its limit."""
    present = atlas.present
    limit = find_limit(present)
    axes.plot(
        OWN, present.step, marker="*", markersize=20, color=MARK, markeredgecolor="white",
        linestyle="", zorder=5,
    )  # fmt: skip
    if limit is not None and limit > present.step:
        axes.annotate(
            "", (OWN, limit), (OWN, present.step), zorder=4,
            arrowprops={"arrowstyle": "<->", "color": MARK, "linewidth": 1.4},
        )  # fmt: skip
    axes.annotate(
        say_present(present), (OWN, present.step), xytext=(14, -17), textcoords="offset points",
        fontsize=11.5, fontweight="bold", color=theme.text, zorder=6,
        bbox={"boxstyle": "round,pad=0.3", "facecolor": "white", "alpha": 0.85, "linewidth": 0},
    )  # fmt: skip


def plot_others(axes: Axes, atlas: Atlas, theme: Theme, values: Sequence[str], field: str) -> None:
    """The limits of the organ's own model, with other damping or on another mesh."""
    kind, any_limit = atlas.present.kind, False
    for name in INTEGRATORS:
        rows = [
            (i, row)
            for i, value in enumerate(values)
            if (row := atlas.find_row(find_spot(kind, field, value), name)) is not None
            and row.measured is not None
            and row.predicted is not None
        ]
        if not rows:
            continue
        any_limit, colour = True, INTEGRATORS[name][1]
        x = [i for i, _ in rows]
        axes.plot(x, [r.measured for _, r in rows], color=colour, marker="o", markersize=5)
        axes.plot(
            x, [r.predicted for _, r in rows], color=colour, linestyle=DASHED, marker="_",
            markersize=12, linewidth=1.2,
        )  # fmt: skip
    axes.set_yscale("log")
    axes.plot(1, atlas.present.step, marker="*", markersize=15, color=MARK,
              markeredgecolor="white", linestyle="", zorder=5)  # fmt: skip
    dress(axes, theme)
    axes.set_xlim(-0.5, len(values) - 0.65)
    axes.set_xticks(range(len(values)), [name_value(atlas, field, value) for value in values])
    scale_steps(axes)
    write_never(axes, atlas, values, field, theme)
    if not any_limit:
        axes.text(0.5, 0.6, "no step breaks it", transform=axes.transAxes, ha="center",
                  color=theme.faint)  # fmt: skip
    axes.set_ylabel("time step")
    title = "With other damping" if field == "damping" else "On a coarser or a finer mesh"
    axes.set_title(title, loc="left", color=theme.text, fontsize=10.5)


def write_never(axes: Axes, atlas: Atlas, values: Sequence[str], field: str, theme: Theme) -> None:
    """What no step holds has no point: its name at the bottom."""
    for i, value in enumerate(values):
        rows = (
            atlas.find_row(find_spot(atlas.present.kind, field, value), name)
            for name in INTEGRATORS
        )
        names = [INTEGRATORS[r.integrator][0] for r in rows if r is not None and r.outcome == NEVER]
        if names:
            axes.text(
                i, 0.03, "\n".join(f"{name}: never" for name in names), ha="center", va="bottom",
                transform=axes.get_xaxis_transform(), fontsize=8.5, color=theme.faint,
            )  # fmt: skip


def find_spot(kind: str, field: str, value: str) -> Spot:
    return Spot(kind, OWN, value, "own") if field == "damping" else Spot(kind, OWN, "own", value)


def name_value(atlas: Atlas, field: str, value: str) -> str:
    if field == "damping":
        ratio = f"\n(ratio {atlas.present.damping_ratio:g})"
        return {"none": "none", "own": f"as it is{ratio}", "critical": "critical"}[value]
    for row in atlas.rows:
        if row.spot == find_spot(atlas.present.kind, field, value) and row.elements:
            return f"{value}:\n{row.elements} elements"
    return f"{value}:\nnot to be had"


def scale_steps(axes: Axes) -> None:
    low, high = axes.get_ylim()
    subs = (1.0, 2.0, 5.0) if math.log10(high / low) < 2.5 else (1.0,)
    axes.yaxis.set_major_locator(LogLocator(subs=subs))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: write_step(value)))
    axes.yaxis.set_minor_formatter(NullFormatter())


def write_keys(figure: Figure, atlas: Atlas, theme: Theme) -> None:
    drawn = [name for name in INTEGRATORS if atlas.list_line(atlas.present.kind, name)]
    drawn = [name for name in drawn if any(
        row.predicted for row in atlas.list_line(atlas.present.kind, name))]  # fmt: skip
    keys: list[Line2D | Patch] = [
        Line2D([], [], color=INTEGRATORS[name][1], marker="o", markersize=5,
               label=INTEGRATORS[name][0])
        for name in drawn
    ]  # fmt: skip
    keys += [
        Line2D([], [], color=theme.text, linewidth=2.0, label="found by running it"),
        Line2D([], [], color=theme.text, linestyle=DASHED, label="foretold"),
        Line2D([], [], color=MARK, marker="*", markersize=14, linestyle="", label="this scene"),
        Patch(color=HOLDS, label="steps hold"),
        Patch(color=FAILS, label="steps blow up"),
    ]
    figure.legend(
        handles=keys, loc="outside lower left", ncols=len(keys), frameon=False,
        labelcolor=theme.text, fontsize=9,
    )  # fmt: skip
