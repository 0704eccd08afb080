# SPDX-License-Identifier: GPL-3.0-or-later
"""Small charts of what triangles are like: how many corners of each angle, edges of each length."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QToolTip, QVBoxLayout, QWidget

from palpate_editor.authoring import MeshReport
from palpate_editor.document.rules import ANGLE_LEAST
from palpate_editor.views.context import Context
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.theme import Colours
from palpate_editor.views.translations import count, quantity, tr

LEAST_BAR = 2.0
"""[px] What is there at all can be seen."""
GAP = 1.0
"""[px] Between two bars."""
CHART = 46
"""[px] high, above the numbers."""


class Histogram(QWidget):
    """Bars side by side, the limits of the first and the last under them and what one names."""

    def __init__(self, name: str, parent: QWidget | None = None):
        super().__init__(parent)
        self.limits: list[float] = []
        self.counts: list[int] = []
        self.marks: list[tuple[float, str]] = []
        """Where along the bars, from 0 to 1, and what is written there."""
        self.colours: list[str] = []
        self.say: Callable[[float], str] = str
        self.setObjectName(name)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        return QSize(220, CHART + self.fontMetrics().height() + 3)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self.sizeHint().height())

    def show_counts(
        self,
        limits: Sequence[float],
        counts: Sequence[int],
        colours: Sequence[str],
        marks: Sequence[tuple[float, str]],
        say: Callable[[float], str],
    ) -> None:
        self.limits, self.counts, self.colours = list(limits), list(counts), list(colours)
        self.marks, self.say = list(marks), say
        words = ", ".join(text for _, text in marks)
        self.setAccessibleName(words)
        self.update()

    def find_bar(self, x: float) -> int | None:
        if not self.counts or not 0.0 <= x < self.width():
            return None
        return int(x / self.width() * len(self.counts))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QHelpEvent.Type.ToolTip:
            bar = self.find_bar(event.x())
            if bar is not None:
                QToolTip.showText(event.globalPos(), self.describe(bar), self)
            return True
        return super().event(event)

    def describe(self, bar: int) -> str:
        return tr("{low} to {high}: {count}").format(
            low=self.say(self.limits[bar]),
            high=self.say(self.limits[bar + 1]),
            count=count(self.counts[bar]),
        )

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        text = self.palette().windowText().color()
        ground = QColor(text)
        ground.setAlphaF(0.25)
        painter.fillRect(QRectF(0.0, CHART - 1.0, self.width(), 1.0), ground)
        wide = self.width() / max(1, len(self.counts))
        most = max(self.counts, default=0)
        for i, number in enumerate(self.counts):
            if number:
                high = max(LEAST_BAR, number / most * (CHART - 2.0))
                bar = QRectF(i * wide, CHART - 1.0 - high, max(1.0, wide - GAP), high)
                painter.fillRect(bar, QColor(self.colours[i]))
        faint = QColor(text)
        faint.setAlphaF(0.72)
        painter.setPen(faint)
        self.write_marks(painter)
        painter.end()

    def write_marks(self, painter: QPainter) -> None:
        """Under the bars, each in the middle of its place and none over another."""
        free = 0.0
        metrics = self.fontMetrics()
        for place, text in self.marks:
            wide = metrics.horizontalAdvance(text)
            left = min(max(free, place * self.width() - 0.5 * wide), self.width() - wide)
            if left >= free:
                painter.drawText(QPointF(left, CHART + 1.0 + metrics.ascent()), text)
                free = left + wide + metrics.horizontalAdvance("  ")


class Histograms(QWidget):
    """Angles and lengths of a surface's triangles."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.angles, self.lengths = Histogram("angles", self), Histogram("lengths", self)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 2, 0, 0)
        column.setSpacing(3)
        for title, chart in (
            (tr("Angles of triangles"), self.angles),
            (tr("Lengths of edges"), self.lengths),
        ):
            label = write_label(title, "name", self)
            label.setAlignment(Qt.AlignmentFlag.AlignLeft)
            column.addWidget(label)
            column.addWidget(chart)

    def show_report(self, report: MeshReport | None) -> None:
        self.setVisible(report is not None and bool(report.triangles))
        if report is None or report.edges_mm is None:
            return
        colours = self.context.colours
        angles = report.angles_deg
        shades = [colour_of(low, colours) for low in angles.limits[:-1]]
        marks = [(k / 180.0, f"{k}°") for k in (0, 60, 120, 180)]
        self.angles.show_counts(
            angles.limits, angles.counts, shades, marks, lambda angle: quantity(angle, "°", 3)
        )
        lengths = report.edge_lengths_mm
        shades = [colours.accent_text] * len(lengths.counts)
        low, high = lengths.limits[0], lengths.limits[-1]
        middle = (low * high) ** 0.5
        marks = [(0.0, say_length(low)), (0.5, say_length(middle)), (1.0, say_length(high))]
        marks = marks if high > low else [(0.5, say_length(low))]
        self.lengths.show_counts(lengths.limits, lengths.counts, shades, marks, say_length)


def say_length(length: float) -> str:
    """Of so many millimetres."""
    return quantity(length, "mm", 2) if length >= 0.1 else quantity(1e3 * length, "µm", 2)


def colour_of(angle: float, colours: Colours) -> str:
    """Of corners from `angle` [degree] on: bad where a rule says so, then doubtful, then good."""
    if angle < ANGLE_LEAST:
        return colours.bad
    return colours.warning if angle < 2.0 * ANGLE_LEAST else colours.good
