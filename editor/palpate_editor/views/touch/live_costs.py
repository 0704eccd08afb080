# SPDX-License-Identifier: GPL-3.0-or-later
"""What the 1 kHz loop costs while it runs: every number as a share of its limit."""

from __future__ import annotations

from collections import deque
from statistics import median

import palpate
from palpate.runs.live import Frame
from palpate.translation.numbers import say_digits
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QWidget

from palpate_editor.views.translations import tr

GOOD, NEAR, OVER = QColor("#2f9e6e"), QColor("#d9912b"), QColor("#d64545")
"""Colours of a share that is well inside, near and beyond its limit."""
NEAR_SHARE, NEAR_MARGIN, OVER_SHARE = 0.6, 0.95, 1.0
"""[-] from where a share is near its limit, that of the stability margin, and where it is over."""
REMEMBERED = 60
"""Frames a number is the median of, about a second."""
NOTHING = "–"


class Meter(QWidget):
    """A bar that shows a share of a limit, full at the limit."""

    def __init__(self, near: float, parent: QWidget | None = None):
        super().__init__(parent)
        self.near = near
        self.share: float | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        return QSize(70, 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(44, 10)

    def show_share(self, share: float | None) -> None:
        """[-] 1 is the limit; None for nothing to show."""
        self.share = share
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        ground = self.palette().windowText().color()
        ground.setAlphaF(0.14)
        painter.setBrush(ground)
        round_ = self.height() / 2
        painter.drawRoundedRect(self.rect(), round_, round_)
        if self.share is not None and self.share > 0.0:
            bar = self.rect()
            bar.setWidth(max(self.height(), round(bar.width() * min(self.share, 1.0))))
            painter.setBrush(colour_of(self.share, self.near))
            painter.drawRoundedRect(bar, round_, round_)
        painter.end()


def colour_of(share: float, near: float) -> QColor:
    return GOOD if share < near else NEAR if share < OVER_SHARE else OVER


class LiveCosts(QWidget):
    """A compact table: cost and lateness of a tick, stability margin, missed ticks."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("live_costs")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(8, 6, 8, 6)
        self._grid.setHorizontalSpacing(10)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(2, 1)
        self._meters: dict[str, Meter] = {}
        self._numbers: dict[str, QLabel] = {}
        self._add(
            "cost",
            tr("Tick"),
            tr(
                "Computing one tick of the simulation, median of the last second, and its "
                "share of the millisecond it may take."
            ),
        )
        self._add(
            "lateness",
            tr("Lateness"),
            tr("How late a tick starts, median of the last second, as a share of the millisecond."),
        )
        self._add(
            "margin",
            tr("Stability"),
            tr(
                "The time step as a share of the longest stable one: beyond 100 % the tissue "
                "blows up. Substeps are chosen so that it stays below."
            ),
        )
        self._add(
            "missed",
            tr("Missed"),
            tr("Ticks left out because the one before took too long, of all ticks."),
        )
        self._grid.setRowStretch(len(self._numbers), 1)
        self.clear()

    def _add(self, name: str, title: str, tip: str) -> None:
        row = len(self._numbers)
        near = NEAR_MARGIN if name == "margin" else NEAR_SHARE
        text, number, meter = QLabel(title, self), QLabel(NOTHING, self), Meter(near, self)
        number.setObjectName(f"live_{name}")
        number.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        widest = number.fontMetrics().horizontalAdvance("0.000 ms 000 %")
        number.setMinimumWidth(widest)
        for column, widget in enumerate((text, number, meter)):
            widget.setToolTip(tip)
            self._grid.addWidget(widget, row, column)
        self._numbers[name], self._meters[name] = number, meter

    def text(self, name: str) -> str:
        """What stands beside cost, lateness, margin or missed."""
        return self._numbers[name].text()

    def clear(self) -> None:
        """Nothing runs."""
        self._costs: deque[float] = deque(maxlen=REMEMBERED)
        self._latenesses: deque[float] = deque(maxlen=REMEMBERED)
        for name in self._numbers:
            self._show(name, NOTHING, None)

    def show_margin(self, step: float, margin: float) -> None:
        """The time step [s] of a scene, and how many times longer it could be."""
        share = 1.0 / margin
        self._show("margin", f"{1e3 * step:.3f} ms {100 * share:4.0f} %", share)

    def show_frame(self, frame: Frame, rate: float) -> None:
        """A frame of a loop of `rate` [Hz]."""
        self._costs.append(frame.cost)
        self._latenesses.append(frame.lateness)
        self._show_time("cost", median(self._costs), rate)
        self._show_time("lateness", median(self._latenesses), rate)
        self._show_missed(frame.missed_ticks, frame.tick + 1)

    def show_report(self, report: palpate.LoopReport, rate: float) -> None:
        """What a whole run cost of a loop of `rate` [Hz]."""
        for name, seconds in (("cost", report.cost), ("lateness", report.lateness)):
            self._show_time(name, seconds.median, rate)
        self._show_missed(report.missed_ticks, report.ticks)

    def _show_time(self, name: str, seconds: float, rate: float) -> None:
        share = seconds * rate
        self._show(name, f"{1e3 * seconds:.3f} ms {100 * share:4.0f} %", share)

    def _show_missed(self, missed: int, ticks: int) -> None:
        # one missed tick of a hundred can be felt, so the bar is full there
        self._show("missed", f"{missed} / {ticks}", 100.0 * missed / max(1, ticks))

    def _show(self, name: str, text: str, share: float | None) -> None:
        self._numbers[name].setText(say_digits(text))
        self._meters[name].show_share(share)
