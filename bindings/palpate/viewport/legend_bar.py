# SPDX-License-Identifier: BSD-3-Clause
"""The legend as a child widget, so that its text never meets OpenGL's state."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QWidget

from palpate.render import Legend
from palpate.render.colour_map import COLOUR_MAPS, LUT_SIZE
from palpate.render.overlay import SUPERSCRIPT
from palpate.render.theme import DARK, Theme
from palpate.translation.numbers import say_digits

BAR_WIDTH, BAR_LENGTH, PAD, TIP = 16, 190, 14, 11
"""[px]"""


class LegendBar(QWidget):
    """Bar, ticks and unit of the values a surface is painted with; hidden when there are none."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("legend")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.theme: Theme = DARK
        self.legend: Legend | None = None
        self.title = ""
        self.hide()

    def show_legend(self, legend: Legend | None, title: str) -> None:
        if legend is not None and legend.exponent:
            power = str(legend.exponent).translate(SUPERSCRIPT)
            title = f"{title} \N{MULTIPLICATION SIGN} 10{power}".strip()
        self.setVisible(legend is not None)
        if (legend, title) == (self.legend, self.title):
            return
        self.legend, self.title = legend, title
        self.resize(self.sizeHint())
        self.update()

    def use_theme(self, theme: Theme) -> None:
        self.theme = theme
        self.update()

    def sizeHint(self) -> QSize:
        if self.legend is None:
            return QSize(0, 0)
        letters = QFontMetricsF(self.font())
        labels = max(letters.horizontalAdvance(say_digits(text)) for text in self.legend.labels)
        width = max(letters.horizontalAdvance(self.title), BAR_WIDTH + 12 + labels)
        height = letters.height() + 10 + BAR_LENGTH + 2 * TIP
        return QSize(round(width + 2 * PAD), round(height + 2 * PAD))

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        if self.legend is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        panel = QColor.fromRgbF(*self.theme.panel, 0.62)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(panel)
        painter.drawRoundedRect(self.rect(), 8, 8)
        letters = QFontMetricsF(self.font())
        painter.setPen(QColor.fromRgbF(*self.theme.text))
        painter.drawText(QPointF(PAD, PAD + letters.ascent()), self.title)
        top = PAD + letters.height() + 10 + TIP
        self._draw_bar(painter, self.legend, QRectF(PAD, top, BAR_WIDTH, BAR_LENGTH))
        self._draw_ticks(painter, self.legend, top, letters)
        painter.end()

    def _draw_bar(self, painter: QPainter, legend: Legend, bar: QRectF) -> None:
        colours = COLOUR_MAPS[legend.colour_map]()
        column = QImage(colours[::-1].tobytes(), 1, LUT_SIZE, 3, QImage.Format.Format_RGB888).copy()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(bar, column)
        painter.setPen(Qt.PenStyle.NoPen)
        # a point at an end says that there is more beyond it
        for more, y, tip, colour in (
            (legend.above, bar.top(), bar.top() - TIP, colours[-1]),
            (legend.below, bar.bottom(), bar.bottom() + TIP, colours[0]),
        ):
            if more:
                painter.setBrush(QColor(*(int(c) for c in colour)))
                corners = [(bar.left(), y), (bar.right(), y), (bar.center().x(), tip)]
                painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))

    def _draw_ticks(
        self, painter: QPainter, legend: Legend, top: float, letters: QFontMetricsF
    ) -> None:
        right = PAD + BAR_WIDTH
        for tick, label in zip(legend.ticks, legend.labels, strict=True):
            share = (tick - legend.low) / (legend.high - legend.low)
            y = top + (1.0 - share) * BAR_LENGTH
            painter.setPen(QColor.fromRgbF(*self.theme.faint))
            painter.drawLine(QPointF(right, y), QPointF(right + 5, y))
            painter.setPen(QColor.fromRgbF(*self.theme.text))
            middle = y + letters.ascent() / 2 - letters.descent() / 2
            painter.drawText(QPointF(right + 11, middle), say_digits(label))
