# SPDX-License-Identifier: BSD-3-Clause
"""What a felt force costs: processor time against error, every configuration of every engine."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from palpate.files.whole_file import write_whole

Report = dict[str, Any]
INK, FAINT, LINE, FIT = "#1d2127", "#616b77", "#e6e8eb", "#eaf3ea"
COLOURS = {
    "Palpate": "#1f6fb4",
    "MuJoCo": "#c2571a",
    "PositionBasedDynamics": "#7b5ea7",
    "Newton": "#3d8b5f",
}
MARKS = {"Palpate": "o", "MuJoCo": "s", "PositionBasedDynamics": "^", "Newton": "D"}
COSTS = (0.003, 60.0)
"""[s]"""
LEAST, MOST = 0.005, 3.0
"""[-] Errors beyond are drawn at the edge."""


def save_accuracy_chart(path: Path, report: Report) -> None:
    """Draws what compare_accuracy.py found and writes a PNG. Raises OSError."""
    names = list(report["works"])
    figure = Figure(
        figsize=(4.4 * len(names), 4.6), dpi=110, layout="constrained", facecolor="white"
    )
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for place, name in zip(axes, names, strict=True):
        draw_work(place, report, name)
    axes[0].set_ylabel("force off by, the worse of two depths", color=INK, fontsize=9)
    named = {
        label: handle
        for place in axes
        for handle, label in zip(*place.get_legend_handles_labels(), strict=True)
    }
    handles, labels = list(named.values()), list(named)
    figure.legend(
        handles, labels, loc="outside lower center", ncols=len(labels), fontsize=8.5, frameon=False
    )
    file = io.BytesIO()
    canvas.print_png(file)
    write_whole(path, file.getvalue())


def draw_work(axes: Axes, report: Report, name: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.axhspan(LEAST / 2.0, report["gate"], color=FIT, zorder=0)
    axes.axhline(report["gate"], color=FAINT, lw=0.8, ls="--")
    for engine, colour in COLOURS.items():
        rows = [r for r in report["rows"] if r["work"] == name and r["engine"] == engine]
        points = [place_point(row) for row in rows if "errors" in row]
        if points:
            size = 46 if engine == "Palpate" else 34
            axes.scatter(
                *zip(*points, strict=True), s=size, marker=MARKS[engine], color=colour,
                label=engine, zorder=3, edgecolors="white", linewidths=0.6,
            )  # fmt: skip
        draw_best(axes, report["best"][name].get(engine), engine, colour)
    axes.set_ylim(LEAST * 0.8, MOST * 1.25)
    axes.set_xlim(*COSTS)
    axes.set_xlabel("processor time per simulated second", color=INK, fontsize=9)
    axes.set_title(report["works"][name]["title"], color=INK, fontsize=10, loc="left", pad=6)
    axes.grid(True, which="major", color=LINE, lw=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g} s"))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{y:.0%}" if y >= 0.01 else ""))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_formatter(NullFormatter())
    axes.tick_params(colors=FAINT, labelsize=8, length=0, which="both")
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)


def place_point(row: dict) -> tuple[float, float]:
    error = max(abs(value) for value in row["errors"])
    return row["cpu_per_second"], min(max(error, LEAST), MOST)


def draw_best(axes: Axes, found: dict | None, engine: str, colour: str) -> None:
    """A ring around the cheapest that passes, with what it costs."""
    row = found and found["any_step"]
    if not row:
        return
    x, y = place_point(row)
    axes.scatter([x], [y], s=150, facecolors="none", edgecolors=colour, linewidths=1.4, zorder=2)
    axes.annotate(
        f"{x:.2g} s" if x < 10.0 else f"{x:.0f} s",
        (x, y),
        xytext=(-9, -3) if engine == "Palpate" and x > 0.02 else (0, -16),
        textcoords="offset points",
        ha="right" if engine == "Palpate" and x > 0.02 else "center",
        color=colour,
        fontsize=8.5,
        fontweight="bold",
        zorder=4,
    )
