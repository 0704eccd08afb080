# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of an atlas: step against stiffness, where it holds, and where the scene is."""

from __future__ import annotations

from collections.abc import Sequence
from math import log10

import numpy as np
import pyqtgraph as pg
from palpate.study.atlas import Row
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from palpate_editor.atlas_fit import Mark
from palpate_editor.document.constants import VALUE_NAMES
from palpate_editor.views.chart.map_plot import MapPlot
from palpate_editor.views.translations import number, say, tr

HOLDS, FAILS, LINE = QColor(47, 158, 110, 56), QColor(205, 70, 60, 56), QColor("#2f7fd0")
MARK = 19
"""[px] of the star."""
SPARE = 0.35
"""Decades around what is shown."""


def write_factor(factor: float) -> str:
    return f"{number(factor, 2)} ×"


class AtlasPlot(MapPlot):
    """Draws one line of an atlas, and the mark of the scene."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__("atlas", write_factor, parent)
        self.line: Sequence[Row] = ()
        self.mark: Mark | None = None
        self.star = pg.ScatterPlotItem(pxMode=True)
        self.margin = pg.PlotDataItem([], [])
        self.dress()

    def show_line(self, line: Sequence[Row]) -> None:
        """Of limits by rising stiffness; empty for nothing."""
        self.line = line
        self.draw()

    def show_mark(self, mark: Mark | None) -> None:
        """Where the scene is now."""
        self.mark = mark
        self.draw_mark()

    # ------------------------------------------------------------ drawing

    def name_axes(self) -> dict[str, str]:
        return {"left": tr("Time step"), "bottom": tr("Stiffness, times that of the atlas")}

    def draw(self) -> None:
        for item in self.drawn:
            self.plot.removeItem(item)
        self.drawn = []
        rows = [row for row in self.line if row.measured is not None]
        self.fit(rows)
        self.key.setVisible(bool(rows))
        if rows:
            step = str(say(VALUE_NAMES.get(rows[0].integrator, rows[0].integrator)))
            self.key.setText(
                tr("{step}: the line was found by running it, dashes are foretold, \N{BLACK STAR} "
                   "is this scene").format(step=step)
            )  # fmt: skip
            x = np.array([log10(row.spot.stiffness) for row in rows])
            y = np.array([log10(row.measured or 1.0) for row in rows])
            self.fill(x, y)
            self.add(pg.PlotDataItem(x, y, pen=pg.mkPen(LINE, width=2.4), symbol="o",
                                     symbolSize=6, symbolBrush=LINE, symbolPen=None))  # fmt: skip
            known = [(a, log10(r.predicted)) for a, r in zip(x, rows, strict=True) if r.predicted]
            pen = pg.mkPen(self.text, width=1.4, style=Qt.PenStyle.DashLine)
            self.add(pg.PlotDataItem([a for a, _ in known], [b for _, b in known], pen=pen))
            self.write(tr("the step holds"), self.left, self.low, (0.0, 1.0))
            self.write(tr("it blows up"), self.right, self.high, (1.0, 0.0))
        self.draw_mark()

    def fit(self, rows: Sequence[Row]) -> None:
        """What is shown: the line, and below it room for the scene's steps."""
        x = [log10(row.spot.stiffness) for row in rows] or [-2.0, 2.0]
        y = [log10(row.measured or 1e-3) for row in rows] or [-4.0, -2.0]
        self.left, self.right = min(x) - SPARE, max(x) + SPARE
        self.low, self.high = min(y) - 2.0 * SPARE, max(y) + SPARE
        self.plot.setRange(
            xRange=(self.left, self.right), yRange=(self.low, self.high), padding=0.0
        )

    def fill(self, x: np.ndarray, y: np.ndarray) -> None:
        """Green under the line and red over it."""
        for level, colour in ((self.low - 9.0, HOLDS), (self.high + 9.0, FAILS)):
            edge = pg.PlotCurveItem(x, np.full(len(x), level))
            self.add(pg.FillBetweenItem(pg.PlotCurveItem(x, y), edge, brush=colour))

    def draw_mark(self) -> None:
        """A star where the scene is, and a line up to its limit."""
        self.plot.removeItem(self.star)
        self.plot.removeItem(self.margin)
        if self.mark is None:
            self.star.setData([])
            return
        x, y = log10(self.mark.stiffness), log10(self.mark.step)
        pen = pg.mkPen(self.palette().window().color(), width=1.2)
        self.star.setData(
            [{"pos": (x, y), "size": MARK, "symbol": "star", "pen": pen,
              "brush": pg.mkBrush(self.text)}]
        )  # fmt: skip
        top = y if self.mark.limit is None else log10(self.mark.limit)
        self.margin.setData([x, x], [y, top])
        self.margin.setPen(pg.mkPen(self.text, width=2.0))
        self.plot.addItem(self.margin, ignoreBounds=True)
        self.plot.addItem(self.star, ignoreBounds=True)

    def write(self, text: str, x: float, y: float, anchor: tuple[float, float]) -> None:
        label = pg.TextItem(text, color=self.faint, anchor=anchor)
        font = label.textItem.font()
        font.setPointSizeF(1.35 * font.pointSizeF())
        label.setFont(font)
        label.setPos(x, y)
        self.add(label)

    def add(self, item: pg.GraphicsObject) -> None:
        self.plot.addItem(item, ignoreBounds=True)
        self.drawn.append(item)
