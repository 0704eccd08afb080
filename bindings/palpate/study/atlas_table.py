# SPDX-License-Identifier: BSD-3-Clause
"""The table of an atlas: every model of the organ under every integrator."""

from __future__ import annotations

import math

from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from palpate.render.theme import Theme
from palpate.study.atlas import (
    AT_REST,
    FAILED,
    LIMITED,
    LOST,
    NEVER,
    REFUSED,
    UNLIMITED,
    Atlas,
    Row,
)
from palpate.study.atlas_words import INTEGRATORS, count_substeps, say_row
from palpate.study.scene_chart_words import KINDS

COLOURS = {
    NEVER: "#f0b5af",
    UNLIMITED: "#d8e6f5",
    AT_REST: "#d8e6f5",
    FAILED: "#f0b5af",
    REFUSED: "#eceff2",
    LOST: "#eceff2",
}
FEW, MANY = (0xCF, 0xEB, 0xD3), (0xF8, 0xE3, 0xB8)
"""Of a limited row: one step a tick is enough, and a hundred are needed."""
MOST = 100.0
LEFT = 2.15
"""Cells that the names of models take."""


def draw_table(axes: Axes, atlas: Atlas, theme: Theme) -> None:
    """A cell for each model and integrator, as the organ is; the scene's own has a frame."""
    kinds, names = atlas.list_kinds(), atlas.list_integrators()
    axes.set_xlim(-LEFT, len(names))
    axes.set_ylim(len(kinds) + 0.05, -0.75)
    axes.axis("off")
    axes.set_title(
        f"Every model under every integrator, at {atlas.rate:g} ticks a second: the longest step "
        "that holds and how many a tick needs; what never breaks, and its worst fault"
        f"{say_mesh(atlas)}",
        loc="left", color=theme.text, fontsize=10.5,
    )  # fmt: skip
    for column, name in enumerate(names):
        text = INTEGRATORS[name][0].replace(" ", "\n", 1)
        write(axes, column + 0.5, -0.33, text, theme, bold=True)
    for line, kind in enumerate(kinds):
        name, colour = KINDS[kind]
        axes.text(
            -LEFT + 0.02, line + 0.5, name, va="center", fontsize=9, color=colour,
            fontweight="bold",
        )  # fmt: skip
        for column, integrator in enumerate(names):
            row = atlas.find_usual(kind, integrator)
            if row is not None:
                draw_cell(axes, column, line, row, atlas, theme)


def say_mesh(atlas: Atlas) -> str:
    """Where cells are of the coarser mesh."""
    rows = (
        atlas.find_usual(kind, name)
        for kind in atlas.list_kinds()
        for name in atlas.list_integrators()
    )
    half = any(row is not None and row.spot.mesh == "half" for row in rows)
    return " (on half the mesh)" if half else ""


def draw_cell(axes: Axes, column: int, line: int, row: Row, atlas: Atlas, theme: Theme) -> None:
    present = atlas.present
    own = (row.spot.kind, row.integrator) == (present.kind, present.integrator)
    axes.add_patch(
        Rectangle((column + 0.02, line + 0.04), 0.96, 0.92, facecolor=find_colour(row, atlas.rate),
                  edgecolor=theme.text if own else "none", linewidth=2.0, zorder=3 if own else 2)
    )  # fmt: skip
    first, second = say_row(row, atlas.rate)
    faint = row.outcome in (REFUSED, LOST)
    write(axes, column + 0.5, line + (0.36 if second else 0.5), first, theme, not faint, faint)
    write(axes, column + 0.5, line + 0.70, second, theme, small=True)


def find_colour(row: Row, rate: float) -> str:
    count = count_substeps(row, rate)
    if row.outcome != LIMITED or count is None:
        return COLOURS.get(row.outcome, COLOURS[NEVER])
    share = min(1.0, math.log(count) / math.log(MOST))
    mixed = (round(few + share * (many - few)) for few, many in zip(FEW, MANY, strict=True))
    return "#" + "".join(f"{part:02x}" for part in mixed)


def write(
    axes: Axes,
    x: float,
    y: float,
    text: str,
    theme: Theme,
    bold: bool = False,
    faint: bool = False,
    small: bool = False,
) -> None:
    axes.text(
        x, y, text, ha="center", va="center", zorder=4, fontsize=7.6 if small else 8.8,
        color=theme.faint if faint else theme.text, fontweight="bold" if bold else "normal",
        parse_math=False,
    )  # fmt: skip
