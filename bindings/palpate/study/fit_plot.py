# SPDX-License-Identifier: BSD-3-Clause
"""A fitted curve over the measured one, and what is left between them, as PNG."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from palpate.files.whole_file import write_whole
from palpate.render.force_plot import DPI, RUN_COLOURS, dress, write_key
from palpate.render.theme import THEMES
from palpate.study.calibrate import Fit
from palpate.study.curve import Curve

SIZE = (1000, 720)
"""[px]"""


def save_fit_plot(path: Path, curve: Curve, fit: Fit, title: str, theme: str = "light") -> None:
    """Raises OSError."""
    shades, colours = THEMES[theme], RUN_COLOURS[theme]
    figure = Figure(
        figsize=(SIZE[0] / DPI, SIZE[1] / DPI),
        dpi=DPI,
        layout="constrained",
        facecolor=shades.panel,
    )
    canvas = FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.12)
    grid = figure.add_gridspec(2, 1, height_ratios=[3.0, 1.0])
    top = figure.add_subplot(grid[0])
    below = figure.add_subplot(grid[1], sharex=top)
    depth = 1e3 * curve.depth
    top.plot(depth, curve.force, "o", color=colours[1], markersize=5, label="measured")
    top.plot(depth, fit.force, color=colours[0], linewidth=2.0, label=describe_fit(fit))
    top.set_ylabel("force [N]")
    top.set_ylim(bottom=min(0.0, float(curve.force.min())))
    top.tick_params(labelbottom=False)
    write_key(top, shades, ncols=2)
    below.axhline(0.0, color=shades.faint, linewidth=0.8)
    below.vlines(depth, 0.0, 1e3 * (curve.force - fit.force), color=colours[1], linewidth=1.5)
    below.plot(depth, 1e3 * (curve.force - fit.force), "o", color=colours[1], markersize=4)
    reach = 1.15e3 * float(np.abs(curve.force - fit.force).max()) + 1e-9
    below.set_ylim(-reach, reach)
    below.set_ylabel("measured less\nfitted [mN]")
    below.set_title(
        f"left over: {1e3 * fit.residual:.3g} mN root mean square, R² {fit.explained:.4f}",
        loc="left", color=shades.text, fontsize=9,
    )  # fmt: skip
    below.set_xlabel("depth of the tip below the surface at rest [mm]")
    for axes in (top, below):
        dress(axes, shades)
    figure.suptitle(
        title,
        color=shades.text,
        fontsize=14,
        fontweight="bold",
        x=0.015,
        ha="left",
        parse_math=False,
    )
    file = io.BytesIO()
    canvas.print_png(file)
    write_whole(path, file.getvalue())


def describe_fit(fit: Fit) -> str:
    factors = ", ".join(
        f"{name} x {factor:.3g} (95 %: {low:.3g} to {high:.3g})"
        for name, factor, low, high in zip(fit.names, fit.factors, fit.low, fit.high, strict=True)
    )
    return f"fitted: {factors}"
