# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps on the way from a file to a scenario: always open, ticked when all is well."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QResizeEvent,
)
from PySide6.QtWidgets import QAbstractButton, QButtonGroup, QHBoxLayout, QSizePolicy, QWidget

from palpate_editor.views.stage import Stages
from palpate_editor.views.theme import Colours
from palpate_editor.views.translations import say_problems, tr

SHORTEST = 6
"""Letters of a name that is cut short, with its dots: fewer tell less than none."""
HEIGHT, BADGE, TIP = 38, 20, 11
"""[px] of a step, of the disc with its number, of the arrow at its right."""


@dataclass(frozen=True)
class Verdict:
    """How a stage stands."""

    errors: int = 0
    warnings: int = 0
    known: bool = False
    """False until it has been looked at: no tick, no badge."""

    @property
    def good(self) -> bool:
        return self.known and not self.errors and not self.warnings


class Step(QAbstractButton):
    """One stage, drawn as an arrow that points to the next."""

    def __init__(
        self, stage: str, title: str, place: int, colours: Colours, parent: QWidget | None = None
    ):
        super().__init__(parent)
        self.stage, self.place, self.colours = stage, place, colours
        self.verdict = Verdict()
        self.narrow = False
        self.setText(title)
        self.setCheckable(True)
        self.setObjectName(f"stage_{stage}")
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def sizeHint(self) -> QSize:
        """Where there is no room for all names, that of the stage that is shown."""
        if self.narrow and not self.isChecked():
            return self.minimumSizeHint()
        width = QFontMetricsF(self.bold()).horizontalAdvance(self.text())
        return QSize(int(width) + BADGE + 3 * TIP + 34, HEIGHT)

    def minimumSizeHint(self) -> QSize:
        """The disc with its number: on a small screen the name is cut short, or left out."""
        return QSize(BADGE + 2 * TIP + 20, HEIGHT)

    def bold(self) -> QFont:
        font = QFont(self.font())
        font.setWeight(QFont.Weight.DemiBold)
        return font

    def show_verdict(self, verdict: Verdict) -> None:
        self.verdict = verdict
        self.setToolTip(f"{self.text()} (Ctrl+{self.place})\n{self.describe()}")
        self.setAccessibleDescription(self.describe())
        self.update()

    def describe(self) -> str:
        verdict = self.verdict
        if not verdict.known:
            return tr("Not checked yet")
        if verdict.good:
            return tr("No problems")
        return say_problems(verdict.errors, verdict.warnings)

    # ------------------------------------------------------------ painting

    def outline(self) -> QPolygonF:
        w, h = float(self.width()) - 1, float(self.height())
        notch = 0.0 if self.place == 1 else TIP
        return QPolygonF(
            [QPointF(0, 0), QPointF(w - TIP, 0), QPointF(w, h / 2), QPointF(w - TIP, h)]
            + [QPointF(0, h), QPointF(notch, h / 2)]
        )

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        c, chosen = self.colours, self.isChecked()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        fill = c.accent if chosen else c.hover if self.underMouse() else c.panel
        painter.setBrush(QColor(fill))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawPolygon(self.outline())
        if self.hasFocus():
            painter.setPen(QPen(QColor(c.accent_text), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawPolygon(self.outline())
        left = 12.0 if self.place == 1 else 12.0 + TIP
        badge = QRectF(left, (self.height() - BADGE) / 2, BADGE, BADGE)
        self.draw_badge(painter, badge, chosen)
        painter.setPen(QColor("#ffffff" if chosen else c.text))
        painter.setFont(self.bold() if chosen else self.font())
        room = QRectF(badge.right() + 8, 0, self.width() - badge.right() - 8 - TIP, self.height())
        text = painter.fontMetrics().elidedText(
            self.text(), Qt.TextElideMode.ElideRight, max(0, int(room.width()))
        )
        text = "" if text != self.text() and len(text) < SHORTEST else text
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()

    def draw_badge(self, painter: QPainter, badge: QRectF, chosen: bool) -> None:
        c, verdict = self.colours, self.verdict
        colour = QColor(c.faint)
        if verdict.errors:
            colour = QColor(c.bad)
        elif verdict.warnings:
            colour = QColor(c.warning)
        elif verdict.good:
            colour = QColor(c.good)
        if chosen:
            colour = QColor("#ffffff")
        painter.setPen(QPen(colour, 1.6))
        painter.setBrush(colour if verdict.good else Qt.BrushStyle.NoBrush)
        painter.drawEllipse(badge.adjusted(1, 1, -1, -1))
        ink = QColor(c.accent if chosen else c.panel)
        if verdict.good:
            painter.setPen(QPen(ink, 2.0, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            middle = badge.center()
            points = [QPointF(-4.2, 0.3), QPointF(-1.2, 3.4), QPointF(4.4, -3.2)]
            painter.drawPolyline(QPolygonF([middle + point for point in points]))
            return
        font = self.bold()
        font.setPointSizeF(font.pointSizeF() * 0.88)
        painter.setFont(font)
        sign = "!" if verdict.errors or verdict.warnings else str(self.place)
        painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, sign)


class StageBar(QWidget):
    """All stages in a row."""

    chosen = Signal(str)

    def __init__(self, stages: Stages, colours: Colours, parent: QWidget | None = None):
        super().__init__(parent)
        self.group = QButtonGroup(self)
        self.group.setExclusive(True)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(2, 2, 2, 2)
        layout.setSpacing(0)
        self.steps: dict[str, Step] = {}
        for place, stage in enumerate(stages.names, start=1):
            step = Step(stage, stages.title(stage), place, colours, self)
            self.group.addButton(step)
            layout.addWidget(step)
            self.steps[stage] = step
            step.show_verdict(Verdict())
        self.group.buttonClicked.connect(self.tell)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        for step in self.steps.values():
            step.narrow = False
        wide = sum(step.sizeHint().width() for step in self.steps.values())
        for step in self.steps.values():
            step.narrow = wide + 4 > self.width()
            step.updateGeometry()

    def tell(self, button: QAbstractButton) -> None:
        if isinstance(button, Step):
            self.chosen.emit(button.stage)

    def show_stage(self, stage: str) -> None:
        self.steps[stage].setChecked(True)
        for step in self.steps.values():
            step.updateGeometry()

    def show_verdict(self, stage: str, verdict: Verdict) -> None:
        self.steps[stage].show_verdict(verdict)

    def use_colours(self, colours: Colours) -> None:
        for step in self.steps.values():
            step.colours = colours
            step.update()
