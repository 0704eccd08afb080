# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot of a chart: cost of a tick in touch against force error, the front, and what failed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from math import log10

import pyqtgraph as pg
from palpate.scene.scene_parts import EXPLICIT, WITH_NEAR_FIELD
from palpate.study.scene_chart import Chart, Row, find_front
from palpate.translation.refusals import say_refusal
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from palpate_editor.document.constants import VALUE_NAMES
from palpate_editor.views.chart.log_axis import write_share
from palpate_editor.views.chart.map_plot import MapPlot
from palpate_editor.views.translations import say, tr

COLOURS = {
    "dark": {
        "solid": "#58a6e8",
        "linear_solid": "#34c99f",
        "corotated_solid": "#a98be0",
        "neo_hookean_solid": "#e06aa6",
        "shell": "#b3d34a",
        "mass_spring": "#f0a04b",
        "molecular": "#ee6d63",
    },
    "light": {
        "solid": "#1f6fb2",
        "linear_solid": "#0f9d7a",
        "corotated_solid": "#7a4fb5",
        "neo_hookean_solid": "#b0256f",
        "shell": "#7f9f16",
        "mass_spring": "#d9822b",
        "molecular": "#c23b3b",
    },
}
"""By kind of model; in the light ones pictures of charts are drawn (study.scene_chart_plot)."""
SYMBOLS = dict.fromkeys(EXPLICIT, "t1") | {"symplectic_euler": "o"}
IMPLICIT = "s"
LEAST_ERROR, LEAST_COST = 1e-5, 1e-8
"""[-] and [s] At which a smaller error or cost is drawn."""
MARGIN, RAIL = 0.12, 0.3
"""[decades] around the points, and from them to a rail."""
POINT, RING = 9.0, 17.0
"""[px]"""


class ChartPlot(MapPlot):
    """Draws a chart. What did not run to its end stands on a rail above, what is not timed yet on
    one below."""

    chosen = Signal(int)
    """The number of a row that was clicked on."""

    def __init__(self, name: Callable[[Row], str], parent: QWidget | None = None):
        """`name` says what a row is called; a bound method."""
        super().__init__("chart", write_share, parent)
        self.layout().setSpacing(2)
        self.name = name
        self.chart: Chart | None = None
        self.selected: int | None = None
        self.present: int | None = None
        self.advised: int | None = None
        self.key.setTextFormat(Qt.TextFormat.RichText)
        self.key.setWordWrap(True)
        self.points = pg.ScatterPlotItem(hoverable=True, tip=self.write_tip, pxMode=True)
        self.points.sigClicked.connect(self.on_clicked)
        self.rings = pg.ScatterPlotItem(pxMode=True)
        self.dress()

    # ------------------------------------------------------------ what is shown

    def show_chart(self, chart: Chart | None) -> None:
        """None for nothing."""
        fresh = chart is None or self.chart is None or chart.key != self.chart.key
        self.chart = chart
        if fresh:
            self.selected = self.advised = self.present = None
        self.draw()

    def select(self, number: int | None) -> None:
        """The row with a ring around it."""
        self.selected = number
        self.draw_rings()

    def show_present(self, number: int | None) -> None:
        """The row that the organ has now."""
        self.present = number
        self.draw_rings()

    def advise(self, number: int | None) -> None:
        """The row that is advised."""
        self.advised = number
        self.draw_rings()

    def find_row(self, number: int) -> Row | None:
        rows = () if self.chart is None else self.chart.rows
        return next((row for row in rows if row.number == number), None)

    # ------------------------------------------------------------ drawing

    def name_axes(self) -> dict[str, str]:
        return {"left": tr("A tick in touch"), "bottom": tr("Force error, of the largest force")}

    def draw(self) -> None:
        for item in self.drawn:
            self.plot.removeItem(item)
        self.drawn = []
        self.places: dict[int, tuple[float, float]] = {}
        self.key.setText(self.write_key())
        self.points.setData([])
        if self.chart is None or not self.chart.rows:
            self.plot.setRange(xRange=(-2.0, 0.0), yRange=(-5.0, -3.0), padding=0.0)
            self.draw_rings()
            return
        self.measure(self.chart)
        self.draw_targets(self.chart)
        self.draw_front(find_front(self.chart.rows))
        self.draw_points(self.chart)
        self.draw_rings()

    def measure(self, chart: Chart) -> None:
        """The part of the plane that all points, targets and rails lie in."""
        ran, waiting = chart.list_ran(), list_waiting(chart)
        x = [find_x(row) for row in (*ran, *waiting)] or [-1.0]
        y = [find_y(row.cost.median) for row in ran] or [find_y(1.0 / chart.rate)]
        x.append(log10(chart.force_target))
        y.append(find_y(1.0 / chart.rate))
        self.left, self.right = min(x) - MARGIN, max(x) + MARGIN
        low, high = min(y) - MARGIN, max(y) + MARGIN
        self.over, self.under = high + 0.3 * RAIL, low - 0.3 * RAIL
        top = high + RAIL if chart.list_failed() else high
        bottom = low - RAIL if waiting else low
        self.plot.setRange(xRange=(self.left, self.right), yRange=(bottom, top), padding=0.0)
        self.low, self.high = low, high
        if chart.list_failed():
            self.write(tr("did not run to the end"), self.left, top, (0.0, 0.0))
            self.rule(high)
        if waiting:
            self.write(tr("not timed yet"), self.left, bottom, (0.0, 1.0))
            self.rule(low)

    def rule(self, y: float) -> None:
        pen = pg.mkPen(self.faint, width=1, style=Qt.PenStyle.DotLine)
        self.add(pg.InfiniteLine(y, angle=0, pen=pen))

    def write(self, text: str, x: float, y: float, anchor: tuple[float, float]) -> None:
        label = pg.TextItem(text, color=self.faint, anchor=anchor)
        label.setPos(x, y)
        self.add(label)

    def add(self, item: pg.GraphicsObject) -> None:
        self.plot.addItem(item, ignoreBounds=True)
        self.drawn.append(item)

    def draw_targets(self, chart: Chart) -> None:
        """What a hand lets pass, a tick, and what the truth cannot tell."""
        pen = pg.mkPen(self.text, width=1, style=Qt.PenStyle.DashLine)
        target, period = log10(chart.force_target), find_y(1.0 / chart.rate)
        self.add(pg.InfiniteLine(target, angle=90, pen=pen))
        self.add(pg.InfiniteLine(period, angle=0, pen=pen))
        self.write(tr("target"), target, self.low, (0.0, 1.0))
        self.write(tr("a tick"), self.right, period, (1.0, 0.0))
        own = log10(max(chart.truth.force_error, LEAST_ERROR))
        if own > self.left:
            shade = QColor(self.faint)
            shade.setAlphaF(0.16)
            region = pg.LinearRegionItem((self.left - 9.0, own), movable=False, brush=shade)
            for line in region.lines:
                line.setPen(pg.mkPen(None))
            self.add(region)
            self.write(tr("the truth's own error"), self.left, self.low, (0.0, 1.0))

    def draw_front(self, front: Sequence[Row]) -> None:
        """Stairs: what is as good and not cheaper, as cheap and not better."""
        at, x, y = self.right, [], []
        for row in front:
            x += [at, find_x(row)]
            y += [find_y(row.cost.median)] * 2
            at = x[-1]
        if front:
            x.append(at)
            y.append(self.high)
            self.add(pg.PlotDataItem(x, y, pen=pg.mkPen(self.text, width=1.6)))

    def draw_points(self, chart: Chart) -> None:
        spots = []
        for row in chart.list_ran():
            x, y = find_x(row), find_y(row.cost.median)
            colour = self.find_colour(row)
            span = [find_y(row.cost.least), find_y(row.cost.most)]
            self.add(pg.PlotDataItem([x, x], span, pen=pg.mkPen(colour, width=1)))
            spots.append(self.build_spot(row, x, y))
        spots += [self.build_spot(row, find_x(row), self.under) for row in list_waiting(chart)]
        failed = chart.list_failed()
        for place, row in enumerate(failed, start=1):
            x = self.left + place * (self.right - self.left) / (len(failed) + 1)
            spots.append(self.build_spot(row, x, self.over))
        self.points.setData(spots)
        self.plot.removeItem(self.points)
        self.plot.addItem(self.points, ignoreBounds=True)

    def build_spot(self, row: Row, x: float, y: float) -> dict[str, object]:
        """Colour is the kind, form the integrator; hollow is what was chosen and not derived:
        constants of springs, the hard law of solids and walls."""
        self.places[row.number] = (x, y)
        c, colour = row.configuration, self.find_colour(row)
        near = c.contact_law == "near_field"
        derived = near if c.kind in WITH_NEAR_FIELD else c.constants == "tissue"
        ground = self.palette().window().color()
        failed = row.total is None
        return {
            "pos": (x, y),
            "size": POINT,
            "symbol": "x" if failed else SYMBOLS.get(c.integrator, IMPLICIT),
            "brush": pg.mkBrush(colour if derived else ground),
            "pen": pg.mkPen(ground if derived and not failed else colour, width=1.2),
            "data": row.number,
        }

    def draw_rings(self) -> None:
        """Around what the organ has, what is advised, and what was clicked on."""
        good = QColor("#2f9e6e")
        rings = [
            (self.present, pg.mkPen(self.text, width=1.8), RING),
            (self.advised, pg.mkPen(good, width=3.0), RING + 6.0),
            (self.selected, pg.mkPen(self.palette().highlight().color(), width=2.4), RING + 2.0),
        ]
        spots = [
            {"pos": self.places[number], "size": size, "pen": pen, "brush": None, "symbol": "o"}
            for number, pen, size in rings
            if number in self.places
        ]
        self.rings.setData(spots)
        self.plot.removeItem(self.rings)
        self.plot.addItem(self.rings, ignoreBounds=True)

    def find_colour(self, row: Row) -> QColor:
        return QColor(self.name_colour(row.configuration.kind))

    def name_colour(self, kind: str) -> str:
        return COLOURS[self.theme].get(kind, "#888888")

    # ------------------------------------------------------------ words

    def write_key(self) -> str:
        """The kinds there are, over the plot."""
        if self.chart is None or not self.chart.rows:
            text = tr("No chart yet: draw one of this organ, or open one")
            return f'<span style="color:{self.faint.name()}">{escape(text)}</span>'
        kinds = dict.fromkeys(row.configuration.kind for row in self.chart.rows)
        items = [
            f'<span style="color:{self.name_colour(kind)}">\N{BLACK CIRCLE}</span>&nbsp;'
            f"{escape(str(say(VALUE_NAMES.get(kind, kind)))).replace(' ', '&nbsp;')}"
            for kind in kinds
        ]
        forms = tr(
            "▲ another explicit step, ■ an implicit one; hollow: chosen constants, or the hard law "
            "of contact"
        )
        items.append(f'<span style="color:{self.faint.name()}">{escape(forms)}</span>')
        return "&nbsp;&nbsp; ".join(items)

    def write_tip(self, x: float, y: float, data: int) -> str:
        del x, y
        row = self.find_row(data)
        if row is None:
            return ""
        name = str(say(self.name(row)))
        return f"{name}\n{say_refusal(row.reason)}" if row.reason else name

    def on_clicked(self, item: object, spots: Sequence[pg.SpotItem], event: object) -> None:
        del item, event
        if len(spots):
            self.chosen.emit(int(spots[0].data()))


def find_x(row: Row) -> float:
    assert row.total is not None
    return log10(max(row.total.force_rms, LEAST_ERROR))


def find_y(seconds: float) -> float:
    return log10(max(seconds, LEAST_COST))


def list_waiting(chart: Chart) -> list[Row]:
    """Rows that ran and were not timed yet."""
    return [row for row in chart.rows if row.total is not None and row.cost is None]
