# SPDX-License-Identifier: BSD-3-Clause
"""How many times faster Palpate is than each of the others, as one picture."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from palpate.files.whole_file import write_whole

Report = dict[str, Any]
INK, FAINT, LINE = "#1d2127", "#616b77", "#e6e8eb"
MEASURED, QUOTED, SLOWER = "#1f6fb4", "#a9c6de", "#c2571a"
ORGAN, SOLID, SHELL = "gallbladder", "spleen", 5400


@dataclass(frozen=True)
class Bar:
    """One comparison: a ratio above 1 says that Palpate is faster; None says why there is none."""

    label: str
    ratio: float | None
    words: str = ""
    quoted: bool = False


def save_ratio_chart(path: Path, report: Report) -> None:
    """Draws what bench_all.py found and writes a PNG. Raises OSError."""
    groups = {
        f"the same work, plainly written in double ({ORGAN})": bars_of_rows(report["rows"]),
        f"trees ({ORGAN})": bars_of_trees(report["trees"]),
        f"pressing a shell in real time ({SHELL} vertices)": bars_of_peers(report["peers"]),
    }
    groups = {title: bars for title, bars in groups.items() if bars}
    heights = [len(bars) + 1.1 for bars in groups.values()]
    figure = Figure(
        figsize=(9.0, 0.27 * sum(heights) + 0.8), dpi=110, layout="constrained", facecolor="white"
    )
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots(len(groups), 1, sharex=True, height_ratios=heights, squeeze=False)[:, 0]
    for place, (title, bars) in zip(axes, groups.items(), strict=True):
        draw_group(place, title, bars)
    highest = max(bar.ratio for bars in groups.values() for bar in bars if bar.ratio)
    axes[-1].set_xlim(0.3, 3.0 * highest)
    axes[-1].set_xlabel("times faster than each of them, on one core", color=INK, fontsize=9)
    file = io.BytesIO()
    canvas.print_png(file)
    write_whole(path, file.getvalue())


def bars_of_rows(report: Report) -> list[Bar]:
    names = {
        (ORGAN, "mss_step", None): "mass-spring step",
        (ORGAN, "mss_dashpot_step", None): "mass-spring step, dashpots",
        (ORGAN, "mms_step", None): "molecular step",
        (ORGAN, "mss_dashpot_tick", 12): "mass-spring tick, 12 substeps",
        (ORGAN, "mms_dashpot_tick", 12): "molecular tick, 12 substeps",
        (ORGAN, "shell_step", None): "step of a wall of prisms",
        (SOLID, "solid_step", None): f"step of a solid ({SOLID})",
        (SOLID, "linear_step", None): f"step of a linear solid ({SOLID})",
    }
    return [
        Bar(label, row["ratio_to_naive"])
        for named, label in names.items()
        for row in report["rows"]
        if (row["mesh"], row["work"], row["substeps"]) == named
    ]


def bars_of_trees(report: Report) -> list[Bar]:
    bars = []
    for row in report["rows"]:
        if row["library"] in ("Palpate", "textbook"):
            continue
        words = "" if row["ratio_to_palpate"] is not None else "its results differ: not compared"
        bars.append(Bar(f"{row['work']}: {row['library']}", row["ratio_to_palpate"], words))
    return bars


def bars_of_peers(report: Report) -> list[Bar]:
    rows = [row for row in report["rows"] if row["vertices"] == SHELL]
    ours = [row for row in rows if row["peer"] == "Palpate" and row.get("passes")]
    bars = []
    for row in rows if ours else ():
        quoted = bool(row.get("quoted"))
        if row["peer"] == "Palpate":
            continue
        if "real_time_factor" not in row:
            words = row.get("not_run", "no step of it has a force within 10 %")
            bars.append(Bar(row["peer"], None, words))
            continue
        ratio = ours[0]["real_time_factor"] / row["real_time_factor"]
        bars.append(Bar(row["peer"] + (" (quoted)" if quoted else ""), ratio, quoted=quoted))
    return bars


def draw_group(axes: Axes, title: str, bars: list[Bar]) -> None:
    axes.set_xscale("log")
    for i, bar in enumerate(bars):
        if bar.ratio is None:
            axes.text(1.05, i, bar.words, color=FAINT, fontsize=8, va="center", style="italic")
            continue
        colour = QUOTED if bar.quoted else MEASURED if bar.ratio >= 1.0 else SLOWER
        axes.barh(i, bar.ratio - 1.0, left=1.0, height=0.68, color=colour)
        axes.annotate(
            write_ratio(bar.ratio),
            (max(bar.ratio, 1.0), i),
            xytext=(4, 0),
            textcoords="offset points",
            color=INK,
            fontsize=8,
            va="center",
        )
    axes.axvline(1.0, color=INK, lw=0.9)
    axes.set_yticks(range(len(bars)), [bar.label for bar in bars])
    axes.set_ylim(len(bars) - 0.4, -0.6)
    axes.set_title(title, color=INK, fontsize=9.5, loc="left", pad=4)
    axes.grid(True, axis="x", which="major", color=LINE, lw=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}x"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(colors=FAINT, labelsize=8, length=0)
    axes.tick_params(axis="y", colors=INK)
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)


def write_ratio(ratio: float) -> str:
    decimals = 0 if ratio >= 10.0 else 1 if ratio >= 1.0 else 2
    return f"{ratio:.{decimals}f}x"
