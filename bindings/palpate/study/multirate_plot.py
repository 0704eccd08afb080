# SPDX-License-Identifier: BSD-3-Clause
"""The multi-rate chart: error, jump and passivity margin over the tissue's rate, as PNG or SVG."""

from __future__ import annotations

import io
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator

from palpate.files.whole_file import write_whole
from palpate.render.force_plot import DPI, RUN_COLOURS, dress, write_key
from palpate.render.theme import THEMES
from palpate.study.multirate import (
    FULL,
    MODES,
    RATES,
    WEAK,
    MultirateChart,
    MultirateRow,
    find_weak_spring,
)

SIZE = (1280, 900)
"""[px]"""
LABELS = {
    "hold": "the last force, held",
    "extrapolation": "the line through the last two",
    "local_stiffness": "local stiffness",
}
TARGET = 0.05
"""[-] of force: what a hand lets pass [accuracy: targets]."""


def save_multirate_plot(path: Path, chart: MultirateChart) -> None:
    """As PNG, or as SVG by its name. Raises OSError."""
    theme = THEMES["light"]
    figure = Figure(
        figsize=(SIZE[0] / DPI, SIZE[1] / DPI),
        dpi=DPI,
        layout="constrained",
        facecolor=theme.panel,
    )
    FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.12)
    (rms, largest), (jump, margin) = figure.subplots(2, 2)
    full = next(row for row in chart.rows if row.mode == FULL)
    plot(rms, chart, "rms")
    rms.axhline(100 * TARGET, color=theme.faint, linewidth=1.0, linestyle=(0, (4, 3)))
    rms.set_ylabel("force error, rms\n[% of the largest force]")
    plot(largest, chart, "largest")
    largest.set_ylabel("largest force error\n[% of the largest force]")
    plot(jump, chart, "jump", 1e3)
    jump.axhline(1e3 * full.jump, color=theme.text, linewidth=1.2, linestyle=(0, (1, 2)))
    jump.set_ylabel("largest jump in a tick [mN]\n(dotted: at full rate)")
    for axes in (rms, largest, jump):
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    plot(margin, chart, "margin")
    margin.axhline(0.0, color=theme.faint, linewidth=1.0)
    margin.axhline(100 * full.margin, color=theme.text, linewidth=1.2, linestyle=(0, (1, 2)))
    margin.set_ylabel("passivity margin: energy kept\n[% of what the hand put in]")
    for axes in (rms, largest, jump, margin):
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(FixedLocator(list(RATES)))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        dress(axes, theme)
    for axes in (jump, margin):
        axes.set_xlabel("exchanges with the tissue [Hz]")
    weak = next((row for row in chart.rows if row.mode == WEAK), None)
    if weak is not None:
        passive, _ = find_weak_spring(weak.rate)
        values = {rms: weak.rms, largest: weak.largest, margin: weak.margin, jump: 10 * weak.jump}
        for axes, value in values.items():
            axes.axhline(
                100 * value,
                color=RUN_COLOURS["light"][3],
                linewidth=1.4,
                linestyle=(0, (6, 2, 1, 2)),
                label=f"at full rate, a device that bears {passive:.0f} N/m",
            )
    write_key(rms, theme, ncols=1)
    figure.suptitle(
        f"A slow tissue under a fast hand: {chart.scene}, {1e3 * chart.depth:g} mm pressed, "
        f"{1e3 * chart.slip:g} mm slipped, {chart.peak:.2f} N",
        color=theme.text, fontsize=13, fontweight="bold", x=0.012, ha="left",
    )  # fmt: skip
    picture = io.BytesIO()
    kind = "svg" if path.suffix.lower() == ".svg" else "png"
    figure.savefig(picture, format=kind, facecolor=theme.panel, metadata=NO_DATE[kind])
    write_whole(path, picture.getvalue())


NO_DATE: dict[str, dict[str, str | None]] = {"svg": {"Date": None}, "png": {"Software": None}}
"""The same chart makes the same file."""


def plot(axes: Axes, chart: MultirateChart, field: str, scale: float = 100.0) -> None:
    for number, mode in enumerate(MODES):
        rows: list[MultirateRow] = [row for row in chart.rows if row.mode == mode]
        axes.plot(
            [row.rate for row in rows],
            [scale * getattr(row, field) for row in rows],
            marker="os^"[number],
            markersize=5,
            linewidth=1.8,
            color=RUN_COLOURS["light"][number],
            label=LABELS[mode],
        )
