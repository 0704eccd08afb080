# SPDX-License-Identifier: GPL-3.0-or-later
"""The force plot: what the hand feels against time, with the runs before it to compare."""

from __future__ import annotations

from html import escape
from pathlib import Path

import numpy as np
import pyqtgraph as pg
from numpy.typing import ArrayLike
from palpate.files.whole_file import write_whole
from palpate.render.force_plot import RUN_COLOURS
from palpate.render.theme import THEMES
from palpate.translation.numbers import say_digits
from PySide6.QtCore import QEvent, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QColor
from PySide6.QtWidgets import QLabel, QMenu, QSizePolicy, QVBoxLayout, QWidget

from palpate_editor.views.touch.force_trace import ForceTrace, write_csv
from palpate_editor.views.touch.save_dialog import ask_save
from palpate_editor.views.translations import tr

FRAME = 33
"""[ms] between two drawings, about 30 a second."""
SPANS = (2.0, 5.0, 10.0)
"""[s] shown at once: the least that holds a run, and at most its last ten seconds."""
NEAR_SIDE = 0.08
"""[-] of the span within which the peak's label is turned inwards."""
COMPARED = 3
"""Earlier runs kept beside the newest."""
LEAST_FORCE = 0.5
"""[N] at the top of the axis: noise of a resting hand should not fill the plot."""
HEADROOM = 1.28
"""[-] of the axis above the highest force, for the peak's label."""
AXIS_WIDTH = 48
"""[px] so that the plot does not jump when the labels gain a digit."""


class SpokenAxis(pg.AxisItem):
    """Its numbers have the decimal sign of the window's language."""

    def tickStrings(self, values: list[float], scale: float, spacing: float) -> list[str]:
        return [say_digits(text) for text in super().tickStrings(values, scale, spacing)]


class ForcePlot(QWidget):
    """Draws the newest run and a few before it. Feed it with begin, add and finish."""

    said = Signal(str)
    """A sentence worth the status bar."""
    failed = Signal(str)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("force_plot")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.traces: list[ForceTrace] = []
        """Oldest first; the last one is the newest."""
        axes = {side: SpokenAxis(side) for side in ("left", "bottom")}
        self._plot = pg.PlotWidget(self, axisItems=axes)
        self._plot.setMenuEnabled(False)
        self._plot.hideButtons()
        self._plot.getAxis("left").setWidth(AXIS_WIDTH)
        self._key = QLabel(self)
        self._key.setObjectName("force_key")
        self._key.setTextFormat(Qt.TextFormat.RichText)
        self._key.setAlignment(Qt.AlignmentFlag.AlignRight)
        self._key.setWordWrap(True)
        self._key.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._curves: list[pg.PlotDataItem] = []
        self._peak_mark = pg.ScatterPlotItem(size=9)
        self._peak_text = pg.TextItem(anchor=(0.5, 1.25))
        for item in (self._peak_mark, self._peak_text):
            self._plot.addItem(item, ignoreBounds=True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._key)
        layout.addWidget(self._plot, 1)
        self._plot.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._plot.customContextMenuRequested.connect(self._show_menu)
        self._build_actions()
        self._timer = QTimer(self, interval=FRAME)
        self._timer.timeout.connect(self._draw_if_new)
        self._new = False
        self._theme = "dark"
        self._dress()

    def _build_actions(self) -> None:
        self.clear_action = QAction(tr("Clear the plot"), self)
        self.clear_action.triggered.connect(self.clear)
        self.export_action = QAction(tr("Export as CSV…"), self)
        self.export_action.triggered.connect(self.choose_csv)
        self.fit_action = QAction(tr("Show the last seconds"), self)
        self.fit_action.triggered.connect(self.show_last)
        self.all_action = QAction(tr("Show whole runs"), self)
        self.all_action.triggered.connect(self.show_all)

    # ------------------------------------------------------------ feeding

    def begin(self, name: str) -> None:
        """Starts a new run; those before it stay to compare."""
        self.traces = [trace for trace in self.traces if len(trace)][-COMPARED:]
        self.traces.append(ForceTrace(name))
        self._rebuild_curves()
        self._new = True
        self._timer.start()

    def add(self, time: float, force: ArrayLike) -> None:
        """A time [s] and force [N] of the newest run."""
        if self.traces:
            self.traces[-1].add(time, force)
            self._new = True

    def finish(self, time: ArrayLike | None = None, force: ArrayLike | None = None) -> None:
        """Ends the newest run; with its record's every tick in place of what was drawn live."""
        if self.traces and time is not None and force is not None:
            self.traces[-1].replace(time, force)
        self._timer.stop()
        self._new = True
        self._draw_if_new()

    def clear(self) -> None:
        """Forgets all runs but one that is going on, which starts over."""
        running = self._timer.isActive() and self.traces
        self.traces = [ForceTrace(self.traces[-1].name)] if running else []
        self._rebuild_curves()
        self._draw()

    # ------------------------------------------------------------ files

    def choose_csv(self) -> None:
        """Asks for a file and writes the runs into it."""
        if not self.traces:
            self.failed.emit(tr("There is no run to export yet: press the organ first."))
            return
        ask_save(
            self,
            tr("Export forces"),
            "forces.csv",
            tr("Table (*.csv)"),
            self._take_csv_name,
        )

    def _take_csv_name(self, name: str) -> None:
        self.export_csv(Path(name))

    def export_csv(self, path: Path) -> None:
        """Writes all runs in the plot, whole or not at all."""
        path = path if path.suffix else path.with_suffix(".csv")
        try:
            write_whole(path, write_csv(self.traces).encode())
        except OSError as problem:
            self.failed.emit(tr("The forces were not exported: {problem}").format(problem=problem))
            return
        self.said.emit(tr("Forces exported to {file}").format(file=path))

    # ------------------------------------------------------------ drawing

    def use_theme(self, theme: str) -> None:
        """`dark` or `light`."""
        self._theme = theme
        self._dress()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_timer"):
            self.use_theme("dark" if self.palette().window().color().lightness() < 128 else "light")

    def _dress(self) -> None:
        theme = THEMES[self._theme]
        self._plot.setBackground(self.palette().window().color())
        text, faint = to_colour(theme.text), to_colour(theme.faint)
        labels = {"left": tr("Force [N]"), "bottom": tr("Time [s]")}
        for side, label in labels.items():
            axis = self._plot.getAxis(side)
            axis.setPen(pg.mkPen(faint))
            axis.setTextPen(pg.mkPen(text))
            axis.setLabel(label, siPrefixEnableRanges=(), color=text.name())
        self._plot.showGrid(x=True, y=True, alpha=0.18)
        self._peak_text.setColor(text)
        self._rebuild_curves()
        self._draw()

    def _rebuild_curves(self) -> None:
        for curve in self._curves:
            self._plot.removeItem(curve)
        self._curves = []
        for age, trace in enumerate(reversed(self.traces)):
            colour = self._colour(age)
            colour.setAlphaF(1.0 if age == 0 else 0.55)
            pen = pg.mkPen(colour, width=2 if age == 0 else 1)
            curve = pg.PlotDataItem(pen=pen, autoDownsample=True, clipToView=True)
            curve.setZValue(-age)
            self._plot.addItem(curve)
            self._curves.append(curve)
            if age:
                curve.setData(trace.time, trace.size)
        self._peak_mark.setBrush(pg.mkBrush(self._colour(0)))
        self._peak_mark.setPen(pg.mkPen(to_colour(THEMES[self._theme].text)))

    def _colour(self, age: int) -> QColor:
        """Of a run; the newest has age 0."""
        colours = RUN_COLOURS[self._theme]
        return to_colour(colours[age % len(colours)])

    def _write_key(self) -> str:
        """The runs and their peaks over the plot, where no curve runs through them."""
        if not any(len(trace) for trace in self.traces):
            colour = to_colour(THEMES[self._theme].faint).name()
            text = escape(tr("Press the organ: the force appears here"))
            return f'<span style="color:{colour}">{text}</span>&nbsp;&nbsp;'
        items = [
            f'<span style="color:{self._colour(age).name()}">\N{BLACK CIRCLE}</span>&nbsp;'
            f"{escape(describe_trace(trace))}"
            for age, trace in enumerate(reversed(self.traces))
        ]
        return "&nbsp;&nbsp;&nbsp; ".join(items) + "&nbsp;&nbsp;"

    def _draw_if_new(self) -> None:
        if self._new and self.isVisible():
            self._draw()
            self._new = False

    def showEvent(self, event: QEvent) -> None:
        super().showEvent(event)
        self._draw()

    def _draw(self) -> None:
        self._key.setText(self._write_key())
        peak = None
        if self.traces:
            newest = self.traces[-1]
            self._curves[0].setData(newest.time, newest.size)
            peak = newest.find_peak()
        self._peak_mark.setData(*([[peak[0]], [peak[1]]] if peak else [[], []]))
        self._peak_text.setVisible(peak is not None)
        if peak:
            self._peak_text.setText(say_digits(f"{peak[1]:.2f} N"))
            self._peak_text.setPos(*peak)
        self.show_last()

    def show_last(self) -> None:
        """The newest seconds of the newest run, and a little room above its force."""
        ends = [float(trace.time[-1]) for trace in self.traces if len(trace)]
        # a run that is over is compared whole; one that goes on has the axis to itself
        newest = self.traces[-1].time if self.traces else np.empty(0)
        last = float(newest[-1]) if len(newest) else 0.0
        longest = last if self._timer.isActive() else max(ends, default=last)
        span = next((span for span in SPANS if longest <= span), SPANS[-1])
        end = max(last, span)
        self._show_span(end - span, end)

    def show_all(self) -> None:
        """All runs from beginning to end."""
        ends = [float(trace.time[-1]) for trace in self.traces if len(trace)]
        self._show_span(0.0, max(ends, default=SPANS[0]))

    def _show_span(self, start: float, end: float) -> None:
        top = LEAST_FORCE
        for trace in self.traces:
            seen = trace.size[np.searchsorted(trace.time, start) :]
            top = max(top, float(seen.max(initial=0.0)))
        self._plot.setXRange(start, end, padding=0.01)
        self._plot.setYRange(0.0, HEADROOM * top, padding=0.0)
        self._turn_label(start, end)

    def _turn_label(self, start: float, end: float) -> None:
        place = (self._peak_text.pos().x() - start) / max(end - start, 1e-9)
        side = 0.0 if place < NEAR_SIDE else 1.0 if place > 1.0 - NEAR_SIDE else 0.5
        self._peak_text.setAnchor((side, 1.25))

    def _show_menu(self, place: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addActions([self.fit_action, self.all_action])
        menu.addSeparator()
        menu.addActions([self.export_action, self.clear_action])
        menu.popup(self._plot.mapToGlobal(place))


def describe_trace(trace: ForceTrace) -> str:
    peak = trace.find_peak()
    return f"{trace.name}: " + say_digits(f"{peak[1]:.2f} N") if peak else trace.name


def to_colour(colour: tuple[float, float, float]) -> QColor:
    return QColor.fromRgbF(*colour)
