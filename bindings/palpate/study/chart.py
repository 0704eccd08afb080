# SPDX-License-Identifier: BSD-3-Clause
"""Cost of a model against its error: one point per kind and body, as PNG."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from palpate.files.whole_file import write_whole
from palpate.render.force_plot import DPI, dress
from palpate.render.theme import THEMES, Theme
from palpate.study.accuracy import Row
from palpate.study.cost import Cost

WIDTH, HEIGHT, KEYS = 1280, 480, 190
"""[px] of the figure, of each row of panels, and of the keys with the title."""
MARKERS = "osD^vP*"
COLOURS = (
    "#8c8c8c",
    "#4d4d4d",
    "#1f6fb2",
    "#0f9d7a",
    "#7a4fb5",
    "#8fb31d",
    "#d9822b",
    "#c23b3b",
    "#b0256f",
)
TARGETS = (0.10, 0.05)
"""Of force and of displacement: what a hand and an eye let pass [accuracy: targets]."""


def save_chart(
    path: Path, rows: Sequence[Row], costs: Sequence[Cost], groups: Mapping[str, Sequence[str]]
) -> None:
    """Mean over the places of each body's linear errors; cost with its spread. Raises OSError.

    Args:
        path: Of the PNG.
        rows: Of compare_linear.
        costs: Of measure_costs.
        groups: What bodies stand together in a row of panels -> their names.
    """
    theme = THEMES["light"]
    groups = {title: names for title, names in groups.items() if names}
    figure = Figure(
        figsize=(WIDTH / DPI, (KEYS + HEIGHT * len(groups)) / DPI),
        dpi=DPI,
        layout="constrained",
        facecolor=theme.panel,
    )
    canvas = FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.12)
    grid = figure.subplots(len(groups), 2, sharey=True, squeeze=False)
    kinds = list(dict.fromkeys(cost.kind for cost in costs))
    bodies = list(dict.fromkeys(cost.reference for cost in costs))
    for panels, (title, names) in zip(grid, groups.items(), strict=True):
        for axes, error, label, target in zip(panels, ERRORS, LABELS, TARGETS, strict=True):
            for cost in costs:
                if cost.reference in names:
                    plot_point(axes, cost, error(rows, cost), kinds, bodies)
            axes.axvline(target, color=theme.faint, linewidth=1.0, linestyle=(0, (4, 3)))
            axes.axhline(1.0, color=theme.faint, linewidth=1.0, linestyle=(0, (1, 2)))
            scale(axes, theme)
            axes.set_xlabel(label)
        panels[0].set_title(title, loc="left", color=theme.text, fontsize=11, fontweight="bold")
        panels[0].set_ylabel("processor seconds\nper second of tissue at 1 kHz")
    write_keys(figure, kinds, bodies, theme)
    figure.suptitle(
        "What a model costs, and how far it is from finite elements", color=theme.text,
        fontsize=15, fontweight="bold", x=0.012, ha="left",
    )  # fmt: skip
    file = io.BytesIO()
    canvas.print_png(file)
    write_whole(path, file.getvalue())


def scale(axes: Axes, theme: Theme) -> None:
    """Both axes by decades, errors in percent."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    scale_percents(axes.xaxis)
    dress(axes, theme)


def scale_percents(axis: Axis) -> None:
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{100 * value:g} %"))
    axis.set_minor_formatter(NullFormatter())


def chosen(rows: Sequence[Row], cost: Cost) -> list[Row]:
    return [
        row
        for row in rows
        if (row.reference, row.kind, row.depth) == (cost.reference, cost.kind, None)
    ]


def find_force_error(rows: Sequence[Row], cost: Cost) -> float:
    return float(np.mean([abs(row.force_ratio - 1.0) for row in chosen(rows, cost)]))


def find_displacement_error(rows: Sequence[Row], cost: Cost) -> float:
    return float(np.mean([row.rms for row in chosen(rows, cost)]))


ERRORS = (find_force_error, find_displacement_error)
LABELS = ("force: |ratio to the truth - 1|", "displacement: root mean square over the depth")


def plot_point(
    axes: Axes, cost: Cost, error: float, kinds: Sequence[str], bodies: Sequence[str]
) -> None:
    axes.errorbar(
        error,
        cost.median,
        yerr=[[cost.median - cost.least], [cost.most - cost.median]],
        marker=MARKERS[bodies.index(cost.reference) % len(MARKERS)],
        color=COLOURS[kinds.index(cost.kind) % len(COLOURS)],
        markersize=8,
        markeredgecolor="white",
        linewidth=1.2,
    )


def write_keys(figure: Figure, kinds: Sequence[str], bodies: Sequence[str], theme: Theme) -> None:
    keys = [
        Line2D([], [], marker="s", linestyle="", color=COLOURS[i % len(COLOURS)], label=kind)
        for i, kind in enumerate(kinds)
    ]
    keys += [
        Line2D([], [], marker=MARKERS[i % len(MARKERS)], linestyle="", color=theme.text, label=body)
        for i, body in enumerate(bodies)
    ]
    keys.append(
        Line2D(
            [], [], color=theme.faint, linestyle=(0, (4, 3)), label="what a hand, an eye lets pass"
        )
    )
    keys.append(Line2D([], [], color=theme.faint, linestyle=(0, (1, 2)), label="real time"))
    figure.legend(
        handles=keys, loc="outside lower left", ncols=4, frameon=False, labelcolor=theme.text,
        fontsize=9,
    )  # fmt: skip
