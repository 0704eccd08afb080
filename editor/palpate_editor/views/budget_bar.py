# SPDX-License-Identifier: GPL-3.0-or-later
"""The budget bar: how much of a tick every body, tool and contact takes."""

from __future__ import annotations

from html import escape

import palpate
from palpate.viewport.tone import set_tone
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from palpate_editor.compile import list_tools
from palpate_editor.document import Organ
from palpate_editor.views.budget import BODY, CONTACT, TOOL, Budget, Part, read_budget
from palpate_editor.views.stages.facts import write_label
from palpate_editor.views.translations import quantity, tr

COLOURS = {
    BODY: ("#3f8ae0", "#27a3a3", "#7a6ff0", "#5a9e3d"),
    TOOL: ("#a05fc0", "#c06090", "#7f86d8", "#b98ad0"),
    CONTACT: ("#e08a2b", "#c9a227", "#d2603a", "#a8792f"),
}
"""By kind, one part after the other; seen on a light and on a dark ground."""
LEAST_ROWS = 3
"""Parts that there is room for before any is measured, so that what stands below stays there: one
body, one tool, and the two together."""
NEAR_SHARE, OVER_SHARE = 0.6, 1.0
"""[-] of a tick from where its p99 is near what it may be, and where it is over."""


def colour_of(part: Part) -> QColor:
    colours = COLOURS[part.kind]
    return QColor(colours[part.index % len(colours)])


def write_time(seconds: float) -> str:
    return quantity(1e6 * seconds, "µs", 3)


def find_budget(costs: palpate.SceneCosts, rate: float, organ: Organ) -> Budget | None:
    """Of the scene of an organ at `rate` [Hz]; None where nothing was measured."""
    body = organ.name or tr("Tissue")
    named = list_tools(organ)
    tools = sorted(named, key=lambda name: named[name].get("instrument", 0))
    if len(tools) != len(costs.instruments):
        tools = [tr("Tool")]
    return read_budget(costs, rate, [body], tools, tr("{tool} on {body}"))


class Stack(QWidget):
    """Medians one after the other; a tick is as long as the bar, and a line stands at its p99."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.budget: Budget | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        return QSize(120, 18)

    def minimumSizeHint(self) -> QSize:
        return QSize(60, 18)

    def place(self, seconds: float) -> float:
        """[px] from the left of so many seconds; beyond a tick the bar is as long as the p99."""
        budget = self.budget
        return self.width() * min(1.0, seconds / max(budget.period, budget.p99))

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        text = self.palette().windowText().color()
        ground = QColor(text)
        ground.setAlphaF(0.14)
        bar = QRectF(0.0, 3.0, self.width(), self.height() - 6.0)
        outline = QPainterPath()
        outline.addRoundedRect(bar, 4.0, 4.0)
        painter.fillPath(outline, ground)
        if self.budget is not None:
            painter.setClipPath(outline)
            self._draw_parts(painter, bar)
            painter.setClipping(False)
            self._draw_line(painter, self.budget.p99, text)
            if self.budget.p99 > self.budget.period:
                self._draw_line(painter, self.budget.period, QColor("#d64545"))
        painter.end()

    def _draw_parts(self, painter: QPainter, bar: QRectF) -> None:
        begin, spent = 0.0, 0.0
        for part in self.budget.parts:
            spent += part.median
            end = self.place(spent)
            painter.fillRect(QRectF(begin, bar.top(), end - begin, bar.height()), colour_of(part))
            begin = end

    def _draw_line(self, painter: QPainter, seconds: float, colour: QColor) -> None:
        at = min(self.place(seconds), self.width() - 2.0)
        painter.fillRect(QRectF(at, 0.0, 2.0, self.height()), colour)


class Swatch(QWidget):
    """A square of a part's colour."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.colour = QColor(Qt.GlobalColor.transparent)
        self.setFixedSize(11, 11)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self.colour)
        painter.drawRoundedRect(self.rect(), 2.5, 2.5)
        painter.end()


class BudgetBar(QWidget):
    """The bar, a sentence under it, and what each part takes."""

    def __init__(self, waiting: str, parent: QWidget | None = None):
        """`waiting` is what is said before anything was measured."""
        super().__init__(parent)
        self.setObjectName("budget_bar")
        self.setAccessibleName(tr("Cost of a tick"))
        self.budget: Budget | None = None
        self.stack = Stack(self)
        self.words = write_label("", "name", self)
        self.words.setObjectName("budget_words")
        self.words.setWordWrap(True)
        self.grid = QGridLayout()
        self.grid.setHorizontalSpacing(8)
        self.grid.setVerticalSpacing(3)
        self.grid.setColumnStretch(1, 1)
        self.rows: list[tuple[Swatch, QLabel, QLabel]] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(6)
        column.addWidget(self.stack)
        column.addWidget(self.words)
        column.addLayout(self.grid)
        self.wait(waiting)

    def wait(self, words: str) -> None:
        """Nothing is measured, and why not."""
        self._show(None)
        self.words.setText(words)
        set_tone(self.words, "")
        self.setToolTip(words)
        self.setAccessibleDescription(words)

    def show_budget(self, budget: Budget) -> None:
        """What a run cost."""
        self._show(budget)
        median, p99 = budget.median / budget.period, budget.p99 / budget.period
        words = tr("{median:.0f} % of a tick, p99 {p99:.0f} %").format(
            median=100 * median, p99=100 * p99
        )
        if budget.alarm:
            words += "\n" + tr("An alarm ended the press: see the Test stage.")
        self.words.setText(words)
        near = "warning" if p99 >= NEAR_SHARE else "good"
        set_tone(self.words, "bad" if p99 >= OVER_SHARE else near)
        self.setToolTip(write_table(budget))
        self.setAccessibleDescription(describe(budget, words))

    def _show(self, budget: Budget | None) -> None:
        self.budget = self.stack.budget = budget
        parts = () if budget is None else budget.parts
        while len(self.rows) < max(len(parts), LEAST_ROWS):
            self._add_row()
        for i, (swatch, name, value) in enumerate(self.rows):
            part = parts[i] if i < len(parts) else None
            swatch.colour = QColor(Qt.GlobalColor.transparent) if part is None else colour_of(part)
            name.setText("" if part is None else part.name)
            value.setText("" if part is None else write_time(part.median))
            for widget in (swatch, name, value):
                widget.setVisible(part is not None or i < LEAST_ROWS)
            swatch.update()
        self.stack.update()

    def _add_row(self) -> None:
        swatch, name = Swatch(self), write_label("", "name", self)
        value = write_label("", "value", self)
        name.setWordWrap(True)
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        row = len(self.rows)
        for column, widget in enumerate((swatch, name, value)):
            self.grid.addWidget(widget, row, column)
        self.rows.append((swatch, name, value))


def write_table(budget: Budget) -> str:
    """Every part with its median and p99, and the whole, as a table of HTML."""
    rows = [(part.name, part.median, part.p99) for part in budget.parts]
    rows.append((tr("Whole tick"), budget.median, budget.p99))
    head = "".join(f"<th align='left'>{escape(t)}</th>" for t in (tr("Part"), tr("Median"), "p99"))
    lines = [
        f"<tr><td>{escape(name)}&nbsp;&nbsp;</td><td align='right'>{escape(write_time(median))}"
        f"</td><td align='right'>&nbsp;&nbsp;{escape(write_time(p99))}</td></tr>"
        for name, median, p99 in rows
    ]
    limit = tr("A tick may take {time}.").format(time=write_time(budget.period))
    return f"<table><tr>{head}</tr>{''.join(lines)}</table><p>{escape(limit)}</p>"


def describe(budget: Budget, words: str) -> str:
    """The same for who hears it."""
    parts = [
        tr("{name}: {median}, p99 {p99}").format(
            name=part.name, median=write_time(part.median), p99=write_time(part.p99)
        )
        for part in budget.parts
    ]
    return ". ".join((words, *parts))
