# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface that was cut, seen from the front of the patient."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QWidget

MOST = 20_000
"""Triangles that are drawn; of more every so many is left out."""
TURN = np.radians(25.0)
LIGHT = np.array([-0.35, -0.75, 0.55])
FLESH = np.array([214.0, 118.0, 104.0])
MARGIN = 0.08


class SurfacePreview(QWidget):
    """Triangles from the back to the front, each in one colour."""

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setMinimumSize(160, 120)
        self.corners = np.empty((0, 3, 2))
        """Across and up, 0 to 1, far ones first."""
        self.colours = np.empty((0, 3))

    def show_surface(self, vertices: np.ndarray, triangles: np.ndarray) -> None:
        shown = triangles[:: max(1, -(-len(triangles) // MOST))]
        c, s = np.cos(TURN), np.sin(TURN)
        x = (vertices - vertices.mean(axis=0)) @ np.array([[c, s, 0.0], [-s, c, 0.0], [0, 0, 1.0]])
        corners = x[shown]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
        facing = normal[:, 1] < 0.0
        corners, normal = corners[facing], normal[facing]
        order = np.argsort(-corners[:, :, 1].mean(axis=1))
        light = 0.35 + 0.65 * np.clip(normal @ LIGHT, 0.0, 1.0)
        size = max(float(np.ptp(x[:, [0, 2]], axis=0).max()), 1e-9)
        self.corners = (corners[:, :, [0, 2]] / size)[order]
        self.colours = (light[:, None] * FLESH)[order]
        self.update()

    def clear(self) -> None:
        self.corners, self.colours = np.empty((0, 3, 2)), np.empty((0, 3))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.fillRect(self.rect(), Qt.GlobalColor.black)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        side = (1.0 - 2.0 * MARGIN) * min(self.width(), self.height())
        middle = np.array([0.5 * self.width(), 0.5 * self.height()])
        for corners, colour in zip(self.corners, self.colours, strict=True):
            points = middle + corners * (side, -side)
            brush = QColor(*map(int, colour))
            painter.setPen(brush)
            painter.setBrush(brush)
            painter.drawPolygon(QPolygonF([QPointF(*point) for point in points]))
        painter.end()
