# SPDX-License-Identifier: BSD-3-Clause
"""Cost against vertices, and the largest mesh that keeps 1 kHz, as figures and as a picture."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from palpate.bench.meshes import generate_meshes
from palpate.bench.rows import Options, bench_meshes
from palpate.command.verb import Report
from palpate.files.whole_file import write_whole

SIZES = (1_000, 2_000, 5_400, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000)
QUICK_SIZES = (1_000, 5_400, 20_000)
SUBSTEPS = (1, 4, 10)
STEP = 0
"""In place of substeps: a step alone, without contact, alarm, or dashpots."""
LAWS = {"mss": "mass-spring", "mms": "molecular"}
TICK = 1e3
"""[us] a tick may take at 1 kHz."""
COLOURS = {STEP: "#6b5fb5", 1: "#1f6fb4", 4: "#1c8a5a", 10: "#c2571a"}
NAIVE_COLOUR = "#8a8f98"
INK, FAINT = "#1d2127", "#616b77"


def measure_scaling(budget: float, quick: bool, say: Callable[[str], None]) -> Report:
    """Steps, and ticks in the air at 1, 4 and 10 substeps, of both laws on many surfaces."""
    works = tuple(name_work(law, substeps) for law in LAWS for substeps in (STEP, 1))
    options = Options(budget=budget, works=works, air_substeps=SUBSTEPS, press=False)
    report = bench_meshes(generate_meshes(QUICK_SIZES if quick else SIZES), options, say)
    report["largest"] = [
        {"law": law, "substeps": substeps, "vertices": find_largest(report["rows"], law, substeps)}
        for law in LAWS
        for substeps in (STEP, *SUBSTEPS)
    ]
    return report


def name_work(law: str, substeps: int) -> str:
    return f"{law}_step" if substeps == STEP else f"{law}_dashpot_tick"


def rows_of(rows: Sequence[Report], law: str, substeps: int) -> list[Report]:
    work = name_work(law, substeps)
    return [r for r in rows if r["work"] == work and r["substeps"] == (substeps or None)]


def find_largest(rows: Sequence[Report], law: str, substeps: int) -> int | None:
    """Vertices at which the median takes a millisecond, between two sizes that were measured.

    None where no two measured sizes have it between them.
    """
    curve = rows_of(rows, law, substeps)
    sizes = np.array([row["vertices"] for row in curve], dtype=float)
    costs = np.array([row["median_us"] for row in curve])
    above = np.flatnonzero(costs > TICK)
    if len(above) == 0 or above[0] == 0:
        return None
    i = above[0]
    share = np.log(TICK / costs[i - 1]) / np.log(costs[i] / costs[i - 1])
    return int(np.exp(np.log(sizes[i - 1]) + share * np.log(sizes[i] / sizes[i - 1])))


def describe_scaling(report: Report) -> str:
    lines = [f"wrote {report['picture']}", "largest surface whose median keeps 1 kHz:"]
    for row in report["largest"]:
        size = "not within the sizes measured" if row["vertices"] is None else row["vertices"]
        lines.append(f"  {LAWS[row['law']]}, {name_substeps(row['substeps'])}: {size}")
    return "\n".join(lines + [f"missing: {sentence}" for sentence in report["missing"]])


def save_scaling_chart(path: Path, report: Report) -> None:
    """Draws what measure_scaling found and writes a PNG. Raises OSError."""
    figure = Figure(figsize=(10.0, 4.6), dpi=110, layout="constrained", facecolor="white")
    canvas = FigureCanvasAgg(figure)
    figures = figure.subplots(1, 2, sharey=True)
    for axes, law in zip(figures, LAWS, strict=True):
        draw_law(axes, report["rows"], law)
    figures[0].set_ylabel("median of a step or a whole tick", color=INK)
    row = report["rows"][0]
    figure.supxlabel(
        "vertices; at the end of a line, how many it takes at 1 kHz; one core, "
        f"{row['simd_target'] or 'plain code'}, {row['compiler_flags']}",
        fontsize=8,
        color=FAINT,
    )
    file = io.BytesIO()
    canvas.print_png(file)
    write_whole(path, file.getvalue())


def draw_law(axes: Axes, rows: Sequence[Report], law: str) -> None:
    axes.set(xscale="log", yscale="log")
    axes.axhline(TICK, color=INK, lw=0.9, ls=(0, (4, 3)))
    axes.text(0.012, 1.12 * TICK, "1 kHz", color=INK, fontsize=8, transform=blend(axes))
    for substeps in (STEP, *SUBSTEPS):
        draw_curve(axes, rows_of(rows, law, substeps), law, substeps, rows)
    naive = rows_of(rows, law, 1)
    sizes = [row["vertices"] for row in naive]
    axes.plot(sizes, [row["naive_median_us"] for row in naive], color=NAIVE_COLOUR, lw=1.4, ls=":")
    axes.annotate(
        "naive, 1 substep",
        (sizes[0], naive[0]["naive_median_us"]),
        xytext=(4, 7),
        textcoords="offset points",
        color=FAINT,
        fontsize=8,
        rotation=30,
        rotation_mode="anchor",
    )
    axes.set_title(LAWS[law], color=INK, fontsize=11, loc="left")
    axes.grid(True, which="major", color="#e6e8eb", lw=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:,.0f}".replace(",", " ")))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: write_time(y)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(colors=FAINT, labelsize=8)
    axes.spines[["top", "right"]].set_visible(False)


def draw_curve(
    axes: Axes, curve: Sequence[Report], law: str, substeps: int, rows: Sequence[Report]
) -> None:
    sizes = [row["vertices"] for row in curve]
    costs = [row["median_us"] for row in curve]
    colour = COLOURS[substeps]
    line = "--" if substeps == STEP else "-"
    axes.plot(sizes, costs, color=colour, lw=2, ls=line, marker="o", ms=4)
    largest = find_largest(rows, law, substeps)
    name = name_substeps(substeps)
    axes.annotate(
        name if largest is None else f"{name}: {largest / 1e3:.0f}k",
        (sizes[-1], costs[-1]),
        xytext=(6, -3),
        textcoords="offset points",
        color=colour,
        fontsize=8,
        annotation_clip=False,
    )
    if largest is not None:
        axes.plot([largest], [TICK], color=colour, marker="o", ms=8, mfc="white", mew=1.8)


def name_substeps(count: int) -> str:
    if count == STEP:
        return "step alone"
    return f"{count} substep" + ("s" if count > 1 else "")


def blend(axes: Axes):
    """Across in parts of the axes, up in data."""
    return axes.get_yaxis_transform()


def write_time(microseconds: float) -> str:
    """A time [us] as one reads it."""
    for scale, unit in ((1e6, "s"), (1e3, "ms")):
        if microseconds >= scale:
            return f"{microseconds / scale:g} {unit}"
    return f"{microseconds:g} us"
