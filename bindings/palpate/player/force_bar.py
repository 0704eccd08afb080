# SPDX-License-Identifier: BSD-3-Clause
"""How strongly the organ pushes back, beside what the device can give at most."""

from __future__ import annotations

import math

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QLinearGradient, QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QWidget

from palpate.player.sentences import format_number, translate
from palpate.player.style import ACCENTS, PANEL, to_colour
from palpate.render.theme import THEMES

SMOOTHING = 0.35
"""[-] share of the way to the newest force in each frame: the number must be readable."""


LEAST_RANGE = 0.1
"""[-] of the limit, that the column shows at least."""


class ForceBar(QWidget):
    """A column of force [N] with ticks, the peak so far, and the limit of the device."""

    def __init__(self, parent: QWidget, limit: float):
        super().__init__(parent)
        self.setObjectName("force")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.limit = limit
        """[N]"""
        self.band: tuple[float, float] | None = None
        """[N] in which a step wants the force; infinite without an end."""
        self.wrong_above = math.inf
        """[N] of the task's limit"""
        self.force = self.peak = 0.0
        """[N]"""
        self.range = choose_range(0.0, limit)
        """[N] The top of the column; grows with the peak, up to the limit."""
        self._shown = 0.0
        self._theme = "dark"
        self._letter = 16.0

    def show_force(self, force: float) -> None:
        """[N] of this moment; the peak is kept."""
        self.force = force
        self.peak = max(self.peak, force)
        shown = self._shown + SMOOTHING * (force - self._shown)
        self._shown = force if abs(force - shown) < 5e-3 else shown
        self.range = max(self.range, choose_range(self.peak, self.limit))
        self.update()

    def show_task(self, band: tuple[float, float] | None, wrong_above: float) -> None:
        """[N] What a step asks for, None for no force, and from where on it is an error."""
        if (band, wrong_above) == (self.band, self.wrong_above):
            return
        self.band, self.wrong_above = band, wrong_above
        ends = [*(band or ()), wrong_above]
        highest = max((end for end in ends if math.isfinite(end)), default=0.0)
        self.range = max(self.range, choose_range(highest, self.limit))
        self.update()

    def rest(self) -> None:
        """No force any more; the peak stays."""
        self.force = self._shown = 0.0
        self.update()

    def reset(self) -> None:
        self.force = self.peak = self._shown = 0.0
        self.range = choose_range(0.0, self.limit)
        self.update()

    def use_style(self, theme: str, letter: float) -> None:
        """`letter` is the height of text [px]."""
        self._theme, self._letter = theme, letter
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        theme = THEMES[self._theme]
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(to_colour(theme.panel, PANEL))
        painter.drawRoundedRect(self.rect(), 14, 14)
        pad, m = 1.0 * self._letter, self._letter
        top = self._write_head(painter, pad, m)
        foot = 2.2 * m
        column = QRectF(pad, top, 1.7 * m, self.height() - top - foot - pad)
        self._draw_column(painter, column)
        self._draw_ticks(painter, column, m)
        peak = translate("Player", "peak %1 N").replace("%1", format_number(self.peak, 2))
        self._write(painter, peak, QPointF(pad, self.height() - pad), 0.85 * m, theme.faint)
        painter.end()

    def _write_head(self, painter: QPainter, pad: float, m: float) -> float:
        """Caption, limit and number; returns where the column may begin."""
        theme, accents = THEMES[self._theme], ACCENTS[self._theme]
        y = pad + 0.8 * m
        self._write(painter, translate("Player", "Force"), QPointF(pad, y), 0.85 * m, theme.faint)
        number = format_number(self._shown, 2)
        width = self._write(
            painter, number, QPointF(pad, y + 2.3 * m), 2.1 * m, theme.text, bold=True
        )
        unit = QPointF(pad + width + 0.35 * m, y + 2.3 * m)
        self._write(painter, "N", unit, 1.1 * m, theme.faint)
        limit = format_number(self.limit, 1 if self.limit % 1 else 0)
        text = translate("Player", "limit %1 N").replace("%1", limit)
        near = self._shown > 0.8 * self.limit
        colour = accents.hot if near else theme.faint
        self._write(painter, text, QPointF(pad, y + 3.9 * m), 0.85 * m, colour)
        return y + 5.0 * m

    def _draw_column(self, painter: QPainter, column: QRectF) -> None:
        theme, accents = THEMES[self._theme], ACCENTS[self._theme]
        shape = QPainterPath()
        shape.addRoundedRect(column, 7, 7)
        painter.fillPath(shape, to_colour(theme.text, 0.10))
        # the colours tell of the device's limit, whatever the column shows of it
        whole = column.height() * self.limit / self.range
        gradient = QLinearGradient(
            column.bottomLeft(), QPointF(column.left(), column.bottom() - whole)
        )
        for share, colour in ((0.0, accents.accent), (0.5, accents.accent), (0.8, accents.warm)):
            gradient.setColorAt(share, to_colour(colour))
        gradient.setColorAt(1.0, to_colour(accents.hot))
        painter.save()
        painter.setClipPath(shape)
        filled = QRectF(column)
        filled.setTop(self._height(column, self._shown))
        painter.fillRect(filled, gradient)
        painter.restore()
        self._draw_task(painter, column)
        if self.peak > 0.0:
            y = self._height(column, self.peak)
            mark = QRectF(column.left() - 2.0, y - 1.0, column.width() + 4.0, 2.0)
            painter.fillRect(mark, to_colour(theme.text))

    def _draw_task(self, painter: QPainter, column: QRectF) -> None:
        """The band as a bracket at the left of the column, the limit as a dashed line over it."""
        accents = ACCENTS[self._theme]
        if self.band is not None:
            low = self._height(column, max(self.band[0], 0.0))
            high = self._height(column, min(self.band[1], self.range))
            side = column.left() - 7.0
            for bar in (
                QRectF(side, high, 3.0, low - high),
                QRectF(side, high - 1.5, 7.0, 3.0),
                QRectF(side, low - 1.5, 7.0, 3.0),
            ):
                painter.fillRect(bar, to_colour(accents.accent))
        if self.wrong_above <= self.range:
            y = self._height(column, self.wrong_above)
            for k in range(4):
                x = column.left() + k * column.width() / 3.5
                dash = QRectF(x, y - 1.5, column.width() / 7.0, 3.0)
                painter.fillRect(dash, to_colour(accents.hot))

    def _draw_ticks(self, painter: QPainter, column: QRectF, m: float) -> None:
        theme, accents = THEMES[self._theme], ACCENTS[self._theme]
        step = choose_step(self.range)
        x = column.right() + 0.35 * m
        for k in range(math.floor(self.range / step + 1e-9) + 1):
            y = self._height(column, k * step)
            painter.fillRect(QRectF(x, y - 0.5, 0.4 * m, 1.0), to_colour(theme.faint))
            text = format_number(k * step, 0 if step >= 1.0 else 1 if step >= 0.1 else 2)
            self._write(painter, text, QPointF(x + 0.75 * m, y + 0.3 * m), 0.85 * m, theme.faint)
        if self.range >= self.limit:
            edge = QRectF(column.left(), column.top() - 1.0, x - column.left() + 0.4 * m, 2.0)
            painter.fillRect(edge, to_colour(accents.hot))

    def _height(self, column: QRectF, force: float) -> float:
        """[px] where a force [N] stands in the column."""
        return column.bottom() - min(1.0, force / self.range) * column.height()

    def _write(
        self,
        painter: QPainter,
        text: str,
        at: QPointF,
        height: float,
        colour: tuple[float, float, float],
        bold: bool = False,
    ) -> float:
        """Text with its baseline at a point; returns its width [px]."""
        font = QFont(self.font())
        font.setPixelSize(max(9, round(height)))
        if bold:
            font.setWeight(QFont.Weight.DemiBold)
        painter.setFont(font)
        painter.setPen(to_colour(colour))
        painter.drawText(at, text)
        painter.setPen(Qt.PenStyle.NoPen)
        return QFontMetricsF(font).horizontalAdvance(text)


def choose_range(peak: float, limit: float) -> float:
    """[N] A round top of the column, with room above the peak: a soft organ must be seen too."""
    wanted = max(1.25 * peak, LEAST_RANGE * limit)
    power = 10.0 ** math.floor(math.log10(wanted))
    above = (k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= wanted * (1 - 1e-9))
    return min(limit, next(above))


def choose_step(limit: float) -> float:
    """[N] between ticks: at most six of them."""
    raw = limit / 6.0
    power = 10.0 ** math.floor(math.log10(raw))
    return next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= raw * (1 - 1e-9))
