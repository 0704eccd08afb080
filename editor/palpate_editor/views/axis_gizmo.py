# SPDX-License-Identifier: GPL-3.0-or-later
"""Which way is x, y and z, in a corner of the viewport; a click on an end looks along it."""

from __future__ import annotations

import math

import numpy as np
from palpate.viewport import View
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from palpate_editor.views.translations import tr

SIZE, ARM, BALL, EDGE = 92, 32, 8.5, 12
"""[px] of the widget, from its middle to an end, of an end, to the corner of the viewport."""
INK = {"x": "#d9534f", "y": "#4f9d52", "z": "#3f7fd6"}
STEEPEST = math.radians(89.0)
LOOKS = {
    ("x", 1): (0.0, 0.0),
    ("x", -1): (math.pi, 0.0),
    ("y", 1): (math.pi / 2, 0.0),
    ("y", -1): (-math.pi / 2, 0.0),
    ("z", 1): (-math.pi / 2, STEEPEST),
    ("z", -1): (-math.pi / 2, -STEEPEST),
}
"""[rad] azimuth and elevation of an eye on that side."""


class AxisGizmo(QWidget):
    """Three axes as the camera sees them."""

    def __init__(self, view: View):
        super().__init__(view)
        self.view = view
        self.setObjectName("axis_gizmo")
        self.setFixedSize(SIZE, SIZE)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setToolTip(tr("Click on an end to look from there"))
        self.drawn: tuple[float, float] | None = None
        view.installEventFilter(self)
        view.frame_drawn.connect(self.follow)
        self.place()

    def follow(self) -> None:
        """Draws it where the camera has turned."""
        seen = (self.view.camera.azimuth, self.view.camera.elevation)
        if seen != self.drawn:
            self.update()

    def place(self) -> None:
        self.move(self.view.width() - SIZE - EDGE, self.view.height() - SIZE - EDGE)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.place()
        return super().eventFilter(watched, event)

    def ends(self) -> list[tuple[str, int, QPointF, float]]:
        """Axis, side, where its end is drawn, and how far away it is; the farthest first."""
        right, up, forward = self.view.camera.basis()
        middle, found = SIZE / 2, []
        for axis, direction in zip("xyz", np.eye(3), strict=True):
            for side in (1, -1):
                end = side * direction
                place = QPointF(middle + ARM * float(end @ right), middle - ARM * float(end @ up))
                found.append((axis, side, place, float(end @ forward)))
        return sorted(found, key=lambda entry: -entry[3])

    # ------------------------------------------------------------ events

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        self.drawn = (self.view.camera.azimuth, self.view.camera.elevation)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = QFont(self.font())
        font.setPointSizeF(font.pointSizeF() * 0.82)
        font.setWeight(QFont.Weight.Bold)
        painter.setFont(font)
        for axis, side, place, _ in self.ends():
            ink = QColor(INK[axis])
            ball = QRectF(place.x() - BALL, place.y() - BALL, 2 * BALL, 2 * BALL)
            if side > 0:
                painter.setPen(QPen(ink, 2.2))
                painter.drawLine(QPointF(SIZE / 2, SIZE / 2), place)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(ink)
                painter.drawEllipse(ball)
                painter.setPen(QColor("#ffffff"))
                painter.drawText(ball, Qt.AlignmentFlag.AlignCenter, axis.upper())
            else:
                faint = QColor(ink)
                faint.setAlphaF(0.35)
                painter.setPen(QPen(ink, 1.4))
                painter.setBrush(faint)
                painter.drawEllipse(ball.adjusted(2, 2, -2, -2))
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """The nearest end under the pointer; anything else is meant for the viewport."""
        for axis, side, place, _ in reversed(self.ends()):
            away = event.position() - place
            if math.hypot(away.x(), away.y()) <= BALL + 1:
                self.view.look_from(*LOOKS[axis, side])
                event.accept()
                return
        event.ignore()
