# SPDX-License-Identifier: GPL-3.0-or-later
"""A plot with two logarithmic axes and a line of text above it, in the colours of the window."""

from __future__ import annotations

from collections.abc import Callable

import pyqtgraph as pg
from palpate.render.theme import THEMES
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

from palpate_editor.views.chart.log_axis import LogAxis, write_span
from palpate_editor.views.touch.force_plot import to_colour

LEFT_WIDTH = 62
"""[px] of the axis of times."""


class MapPlot(QWidget):
    """Times upwards. Those who derive from it give its axes names, and draw; their constructor ends
    with `dress`."""

    def __init__(self, name: str, write_bottom: Callable[[float], str], parent: QWidget | None):
        """`name` is the widget's, NAME_plot, and its text's, NAME_key."""
        super().__init__(parent)
        self.setObjectName(f"{name}_plot")
        self.theme = "dark"
        self.plot = pg.PlotWidget(
            self,
            axisItems={
                "left": LogAxis("left", write_span),
                "bottom": LogAxis("bottom", write_bottom),
            },
        )
        self.plot.setMenuEnabled(False)
        self.plot.hideButtons()
        self.plot.getAxis("left").setWidth(LEFT_WIDTH)
        self.drawn: list[pg.GraphicsObject] = []
        self.key = QLabel(self)
        self.key.setObjectName(f"{name}_key")
        self.key.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 4, 0, 0)
        column.addWidget(self.key)
        column.addWidget(self.plot, 1)

    def name_axes(self) -> dict[str, str]:
        """Labels by side: left and bottom."""
        return {}

    def draw(self) -> None:
        """Again, in the colours that there are now."""

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "text"):
            self.theme = "dark" if self.palette().window().color().lightness() < 128 else "light"
            self.dress()

    def dress(self) -> None:
        theme = THEMES[self.theme]
        self.plot.setBackground(self.palette().window().color())
        self.text, self.faint = to_colour(theme.text), to_colour(theme.faint)
        for side, label in self.name_axes().items():
            axis = self.plot.getAxis(side)
            axis.setPen(pg.mkPen(self.faint))
            axis.setTextPen(pg.mkPen(self.text))
            axis.setLabel(label, siPrefixEnableRanges=(), color=self.text.name())
        self.plot.showGrid(x=True, y=True, alpha=0.13)
        self.draw()
