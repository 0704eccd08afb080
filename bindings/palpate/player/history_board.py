# SPDX-License-Identifier: BSD-3-Clause
"""What a person has done so far: each task, level and device apart, over time."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QLocale, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLabel, QWidget

from palpate.command.verb import Report
from palpate.player.boards import Board
from palpate.player.cards import build_label
from palpate.player.sentences import (
    format_clock,
    format_number,
    say_outcome_of,
    translate,
)
from palpate.player.style import ACCENTS, to_colour
from palpate.render.theme import THEMES

PERFORMANCE = ("done", "failed", "timed_out")
"""Outcomes that have a time that means something."""
LAST = 5
"""Lines of each group."""
CHART = QSize(240, 86)
"""[px]"""
POINT = 4.0
"""[px]"""


def sort_history(rows: Sequence[Report]) -> list[tuple[tuple[str, str, str], list[Report]]]:
    """By task, level and device, which are not comparable, the group of the newest attempt first;
    in each the oldest first.
    """
    groups: dict[tuple[str, str, str], list[Report]] = {}
    for row in sorted(rows, key=lambda row: row["attempt"], reverse=True):
        groups.setdefault((row["scenario"], row["level"], row["device"]), []).insert(0, row)
    return list(groups.items())


class Trend(QWidget):
    """The time of each attempt that was played to its end: a disc where it was done, a cross where
    it was not.
    """

    def __init__(self, rows: Sequence[Report], theme: str, parent: QWidget):
        super().__init__(parent)
        self.setFixedHeight(CHART.height())
        self.theme = theme
        self.points = [(row["time_s"], row["outcome"] == "done") for row in rows
                       if row["outcome"] in PERFORMANCE and row["time_s"] is not None]  # fmt: skip
        self.setVisible(len(self.points) > 1)
        longest = max((time for time, _ in self.points), default=0.0)
        self.setAccessibleName(
            translate("Player", "Time of %1 attempts").replace("%1", str(len(self.points)))
        )
        self.top = longest

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        theme, accents = THEMES[self.theme], ACCENTS[self.theme]
        font = painter.font()
        font.setPixelSize(max(9, self.fontMetrics().height() * 2 // 3))
        painter.setFont(font)
        label = format_clock(self.top)
        edge = painter.fontMetrics().horizontalAdvance(label) + 10.0
        box = QRectF(self.rect()).adjusted(edge, 10.0, -10.0, -10.0)
        painter.setPen(QPen(to_colour(theme.faint), 1.0))
        painter.drawLine(box.bottomLeft(), box.bottomRight())
        painter.drawText(QPointF(0.0, box.top() + 5.0), label)
        painter.drawText(QPointF(0.0, box.bottom()), format_clock(0.0))
        places = self.place(box)
        painter.setPen(QPen(to_colour(theme.faint), 1.0, Qt.PenStyle.DotLine))
        for a, b in zip(places, places[1:], strict=False):
            painter.drawLine(a, b)
        for at, (_, done) in zip(places, self.points, strict=True):
            painter.setPen(QPen(to_colour(accents.accent if done else accents.hot), 2.0))
            if done:
                painter.setBrush(to_colour(accents.accent))
                painter.drawEllipse(at, POINT, POINT)
            else:
                painter.drawLine(at - QPointF(POINT, POINT), at + QPointF(POINT, POINT))
                painter.drawLine(at - QPointF(POINT, -POINT), at + QPointF(POINT, -POINT))

    def place(self, box: QRectF) -> list[QPointF]:
        """[px] of each attempt, in order, from 0 at the foot of the box."""
        step = box.width() / max(1, len(self.points) - 1)
        top = self.top or 1.0
        return [
            QPointF(box.left() + number * step, box.bottom() - time / top * box.height())
            for number, (time, _) in enumerate(self.points)
        ]


class HistoryBoard(Board):
    """No rank, and nobody else's."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.note = self.add("body")
        self.made: list[QWidget] = []
        self.trends: list[Trend] = []
        self.back = self.add_button(main=True)
        self.theme = "dark"
        self._rows: Sequence[Report] = ()
        self.say()

    def tell(self, rows: Sequence[Report], theme: str) -> None:
        """Of palpate.records.queries.list_history."""
        self._rows, self.theme = rows, theme
        self.say()

    def say(self) -> None:
        self.headline.setText(translate("Player", "Your attempts so far"))
        self.back.setText(translate("Player", "Back"))
        self.note.setText(
            translate("Player", "Each device and level stands for itself: they cannot be compared.")
            if self._rows
            else translate("Player", "No attempts are kept of you.")
        )
        for widget in self.made:
            self.rows.removeWidget(widget)
            widget.hide()
            widget.deleteLater()
        self.made, self.trends = [], []
        for (_, level, device), rows in sort_history(self._rows):
            title = say_title(rows[-1])
            self._put(build_label("title", self.page, wrap=True), title)
            count = translate("Player", "%1 attempts").replace("%1", str(len(rows)))
            parts = [level, say_device(device), count]
            caption = " \N{MIDDLE DOT} ".join(part for part in parts if part)
            self._put(build_label("caption", self.page, wrap=True), caption)
            trend = Trend(rows, self.theme, self.page)
            self._insert(trend)
            self.trends.append(trend)
            lines = [say_attempt(row) for row in reversed(rows[-LAST:])]
            self._put(build_label("body", self.page, wrap=True), "\n".join(lines))

    def _put(self, label: QLabel, text: str) -> None:
        label.setText(text)
        self._insert(label)

    def _insert(self, widget: QWidget) -> None:
        shown = not widget.isHidden() or isinstance(widget, QLabel)
        self.rows.insertWidget(self.rows.indexOf(self.back), widget)
        widget.setVisible(shown)
        self.made.append(widget)


def say_title(row: Report) -> str:
    """In the language of the window, else in English."""
    titles, code = row["title"], QLocale().name().partition("_")[0]
    return str(titles.get(code) or titles.get("en") or row["scenario"])


def say_device(kind: str) -> str:
    if kind == "mouse":
        return translate("Player", "mouse, no force")
    return translate("Player", "haptic arm") if kind == "arm" else kind


def say_attempt(row: Report) -> str:
    """Day, outcome, time, errors and peak force of an attempt."""
    parts = [row["started"][:16].replace("T", " "), say_outcome_of(row["outcome"])]
    if row["time_s"] is not None:
        parts.append(format_clock(row["time_s"]))
    if row["errors"] is not None:
        text = translate("Player", "errors: %1")
        parts.append(text.replace("%1", str(round(row["errors"]))))
    if row["peak_force_N"] is not None:
        parts.append(f"{format_number(row['peak_force_N'], 2)} N")
    return ", ".join(parts)
