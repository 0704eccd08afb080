# SPDX-License-Identifier: BSD-3-Clause
"""Force plots of recorded runs as still pictures, on matplotlib's Agg canvas."""

from __future__ import annotations

import io
import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from palpate.files.whole_file import write_whole
from palpate.render.theme import THEMES, Colour, Theme
from palpate.render.trace import Trace, find_spans, read_trace

DPI = 100
SMALLEST = (800, 600)
"""[px] Below it the panels have no room left beside their labels."""
RUN_COLOURS: dict[str, list[Colour]] = {
    "dark": [(1.0, 0.48, 0.36), (0.36, 0.72, 1.0), (0.55, 0.85, 0.45), (0.85, 0.62, 1.0)],
    "light": [(0.82, 0.22, 0.13), (0.05, 0.40, 0.72), (0.16, 0.52, 0.18), (0.48, 0.25, 0.68)],
}
AXIS_DASHES = {"x": (0, (1, 1.2)), "y": (0, (4, 1.6)), "z": "solid"}


def draw_force_plot(
    records: Mapping[str, Any],
    *,
    title: str = "",
    theme: str = "dark",
    size: tuple[int, int] = (1280, 800),
) -> NDArray[np.uint8]:
    """Draws one or several runs, name by name, (h, w, 3).

    Against time: the force's magnitude, its components, the tool's depth, and when it touched and
    was attached; beside them the force along the press against the depth. Raises ValueError for no
    records, an empty one, or an unknown theme.
    """
    canvas = plot_records(records, title, theme, size)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()


def save_force_plot(
    path: str | os.PathLike[str],
    records: Mapping[str, Any],
    *,
    title: str = "",
    theme: str = "dark",
    size: tuple[int, int] = (1280, 800),
) -> None:
    """Draws as draw_force_plot does and writes it as PNG. Raises OSError as well."""
    file = io.BytesIO()
    plot_records(records, title, theme, size).print_png(file)
    write_whole(path, file.getvalue())


def plot_records(
    records: Mapping[str, Any], title: str, theme: str, size: tuple[int, int]
) -> FigureCanvasAgg:
    if not records:
        raise ValueError("records: got none, expected at least one to plot")
    if size[0] < SMALLEST[0] or size[1] < SMALLEST[1]:
        raise ValueError(f"size must be at least {SMALLEST} pixels, got {size}")
    if theme not in THEMES:
        raise ValueError(f"theme must be one of {', '.join(THEMES)}, got {theme!r}")
    traces = {name: read_trace(record) for name, record in records.items()}
    shades, palette = THEMES[theme], RUN_COLOURS[theme]
    colours = {name: palette[i % len(palette)] for i, name in enumerate(traces)}
    figure = Figure(
        figsize=(size[0] / DPI, size[1] / DPI),
        dpi=DPI,
        layout="constrained",
        facecolor=shades.corner if theme == "dark" else shades.panel,
    )
    canvas = FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.09, hspace=0.0)
    rows = [3.0, 2.2, 2.0, 0.32 * len(traces) + 0.2]
    grid = figure.add_gridspec(4, 2, width_ratios=[1.9, 1.0], height_ratios=rows)
    top = figure.add_subplot(grid[0, 0])
    panels = [top, *(figure.add_subplot(grid[row, 0], sharex=top) for row in (1, 2, 3))]
    loop = figure.add_subplot(grid[:, 1])
    plot_magnitude(panels[0], traces, colours, shades)
    plot_components(panels[1], traces, colours, shades)
    plot_depth(panels[2], traces, colours, shades)
    plot_contact(panels[3], traces, colours, shades)
    plot_loop(loop, traces, colours, shades)
    for axes in (*panels, loop):
        dress(axes, shades)
    for axes in panels[:-1]:
        axes.tick_params(labelbottom=False)
    if title:
        figure.suptitle(
            title,
            color=shades.text,
            fontsize=15,
            fontweight="bold",
            x=0.0125,
            ha="left",
            parse_math=False,
        )
    return canvas


Traces = Mapping[str, Trace]
Colours = Mapping[str, Colour]


def plot_magnitude(axes: Axes, traces: Traces, colours: Colours, shades: Theme) -> None:
    for name, trace in traces.items():
        force = trace.magnitude()
        peak = int(force.argmax())
        axes.plot(
            trace.time,
            force,
            color=colours[name],
            linewidth=1.8,
            label=f"{name}: peak {force[peak]:.3g} N",
        )
        axes.plot(trace.time[peak], force[peak], "o", color=colours[name], markersize=5)
    axes.set_ylabel("force [N]")
    axes.set_ylim(bottom=0.0)
    write_key(axes, shades, ncols=len(traces))


def plot_components(axes: Axes, traces: Traces, colours: Colours, shades: Theme) -> None:
    for name, trace in traces.items():
        for column, dashes in enumerate(AXIS_DASHES.values()):
            axes.plot(
                trace.time,
                trace.force[:, column],
                color=colours[name],
                linewidth=1.2,
                linestyle=dashes,
            )
    axes.set_ylabel("by axis [N]")
    keys = [
        Line2D([], [], color=shades.text, linewidth=1.2, linestyle=dashes, label=axis)
        for axis, dashes in AXIS_DASHES.items()
    ]
    write_key(axes, shades, handles=keys, ncols=3)


def plot_depth(axes: Axes, traces: Traces, colours: Colours, shades: Theme) -> None:
    for name, trace in traces.items():
        axes.plot(trace.time, 1e3 * trace.depth, color=colours[name], linewidth=1.5)
    axes.axhline(0.0, color=shades.faint, linewidth=0.8)
    axes.set_ylabel("depth [mm]")
    say_if_untouched(axes, traces, shades)


def plot_contact(axes: Axes, traces: Traces, colours: Colours, shades: Theme) -> None:
    """A bar per run: thin where it touched, thick where it was attached."""
    for row, (name, trace) in enumerate(traces.items()):
        touching = find_spans(trace.time, trace.touching)
        attached = find_spans(trace.time, trace.attached)
        axes.broken_barh(touching, (row - 0.14, 0.28), color=colours[name], alpha=0.55, linewidth=0)
        axes.broken_barh(attached, (row - 0.36, 0.72), color=colours[name], linewidth=0)
    axes.set_ylim(len(traces) - 0.45, -0.55)
    axes.set_yticks(range(len(traces)), list(traces))
    first = next(iter(traces.values()))
    axes.set_xlim(float(first.time[0]), max(float(t.time[-1]) for t in traces.values()) + 1e-3)
    axes.set_xlabel("time [s]        bars: thin touching, thick attached")


def plot_loop(axes: Axes, traces: Traces, colours: Colours, shades: Theme) -> None:
    for name, trace in traces.items():
        felt = trace.touching | trace.attached
        depth = np.where(felt, 1e3 * trace.depth, np.nan)
        axes.plot(depth, trace.along_press(), color=colours[name], linewidth=1.5)
    axes.axhline(0.0, color=shades.faint, linewidth=0.8)
    axes.axvline(0.0, color=shades.faint, linewidth=0.8)
    axes.set_xlabel("depth of the tool [mm]")
    axes.set_ylabel("force out of the tissue [N]")
    axes.set_title("force against indentation", color=shades.text, fontsize=11)
    say_if_untouched(axes, traces, shades)


def say_if_untouched(axes: Axes, traces: Traces, shades: Theme) -> None:
    if all(np.isnan(trace.depth).all() for trace in traces.values()):
        axes.text(
            0.5,
            0.5,
            "nothing was touched",
            transform=axes.transAxes,
            ha="center",
            va="center",
            color=shades.faint,
        )


def write_key(axes: Axes, shades: Theme, **key: Any) -> None:
    """Above the panel, where no curve runs through it."""
    axes.legend(
        frameon=False,
        labelcolor=shades.text,
        fontsize=9,
        borderpad=0.2,
        borderaxespad=0.0,
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        **key,
    )


def dress(axes: Axes, shades: Theme) -> None:
    """Colours of the theme and a quiet grid."""
    axes.set_facecolor("none")
    axes.grid(True, color=shades.faint, alpha=0.22, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(colors=shades.faint, labelcolor=shades.text, labelsize=9, length=3)
    axes.xaxis.label.set(color=shades.text, fontsize=10)
    axes.yaxis.label.set(color=shades.text, fontsize=10)
    for side, spine in axes.spines.items():
        spine.set_visible(side in ("left", "bottom"))
        spine.set_color(shades.faint)
