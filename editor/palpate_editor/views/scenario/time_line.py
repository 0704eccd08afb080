# SPDX-License-Identifier: GPL-3.0-or-later
"""The last self-play against time: the force, the band of each step, and the limits of force."""

from __future__ import annotations

import numpy as np
import palpate
import pyqtgraph as pg
from palpate.assessment.selfplay import Attempt
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPen
from PySide6.QtWidgets import QGraphicsRectItem, QVBoxLayout, QWidget

from palpate_editor.views.touch.force_plot import SpokenAxis
from palpate_editor.views.translations import tr

HEIGHT = 190
MOST_POINTS = 2000
HEADROOM = 1.3
BAND, LINE, LIMIT, STEP = "#39b36b", "#4da3ff", "#e2503a", "#8a94a3"


class TimeLine(QWidget):
    """Empty until hands have played."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("time_line")
        axes = {side: SpokenAxis(side) for side in ("left", "bottom")}
        self.plot = pg.PlotWidget(self, axisItems=axes)
        self.plot.setMenuEnabled(False)
        self.plot.hideButtons()
        self.plot.setMouseEnabled(x=True, y=False)
        self.plot.setFixedHeight(HEIGHT)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.plot)
        self.attempt: Attempt | None = None
        self.bands: list[QGraphicsRectItem] = []
        self.limits: list[pg.InfiniteLine] = []
        self.use_theme("dark")

    def use_theme(self, name: str) -> None:
        del name  # the palette is that of the theme already
        self.plot.setBackground(self.palette().window().color())
        for side, text, unit in (("left", tr("Force"), "N"), ("bottom", tr("Time"), "s")):
            axis = self.plot.getAxis(side)
            axis.setPen(STEP)
            axis.setTextPen(STEP)
            axis.setLabel(f"{text} [{unit}]", color=STEP)

    def show_attempt(self, attempt: Attempt | None, rate: float = 1000.0) -> None:
        """Draws all of it; None for nothing."""
        self.attempt, self.bands, self.limits = attempt, [], []
        self.plot.clear()
        if attempt is None or not attempt.forces:
            return
        force = np.array(attempt.forces)
        every = max(1, len(force) // MOST_POINTS)
        time = np.arange(len(force)) / rate
        top = HEADROOM * max(float(force.max()), self._find_highest(attempt), 0.1)
        self._draw_steps(attempt, rate, top)
        self._draw_limits(attempt)
        pen = pg.mkPen(LINE, width=1.5)
        self.plot.plot(time[::every], force[::every], pen=pen)
        self.plot.setXRange(0.0, float(time[-1]), padding=0.02)
        self.plot.setYRange(0.0, top, padding=0.0)

    def _find_highest(self, attempt: Attempt) -> float:
        """[N] of limits and bands, so that all of them are seen."""
        task = attempt.drawn.task
        bounds = [row.bound for row in task.limits if row.measure is palpate.TaskMeasure.force]
        ends = [step.force.most for step in task.steps] + [step.force.least for step in task.steps]
        return max([0.0, *bounds, *(end for end in ends if np.isfinite(end))])

    def _draw_steps(self, attempt: Attempt, rate: float, top: float) -> None:
        rows = zip(attempt.drawn.steps, attempt.drawn.task.steps, attempt.state.steps, strict=True)
        for name, step, state in rows:
            if state.from_tick < 0:
                continue
            start = state.from_tick / rate
            until = state.until_tick if state.until_tick >= 0 else len(attempt.forces)
            label = {"position": 0.92, "color": STEP, "anchors": [(0, 0), (0, 0)]}
            pen = pg.mkPen(STEP, style=Qt.PenStyle.DotLine)
            line = pg.InfiniteLine(start, pen=pen, label=name, labelOpts=label)
            self.plot.addItem(line, ignoreBounds=True)
            least, most = step.force.least, step.force.most
            if not (np.isfinite(least) or np.isfinite(most)):
                continue
            low, high = max(least, 0.0), min(most, top)
            rect = QGraphicsRectItem(QRectF(start, low, until / rate - start, high - low))
            fill = QColor(BAND)
            fill.setAlpha(60)
            rect.setBrush(QBrush(fill))
            rect.setPen(QPen(Qt.PenStyle.NoPen))
            self.plot.addItem(rect, ignoreBounds=True)
            self.bands.append(rect)

    def _draw_limits(self, attempt: Attempt) -> None:
        for name, limit in zip(attempt.drawn.limits, attempt.drawn.task.limits, strict=True):
            if limit.measure is not palpate.TaskMeasure.force or limit.place >= 0:
                continue
            line = pg.InfiniteLine(limit.bound, angle=0, label=name,
                                   pen=pg.mkPen(LIMIT, style=Qt.PenStyle.DashLine),
                                   labelOpts={"position": 0.9, "color": LIMIT})  # fmt: skip
            self.plot.addItem(line, ignoreBounds=True)
            self.limits.append(line)
