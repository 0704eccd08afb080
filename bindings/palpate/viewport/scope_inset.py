# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a laparoscope beside the one of the room, as a child widget; V changes them."""

from __future__ import annotations

import enum
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFontMetricsF,
    QImage,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QWidget

from palpate.render import Camera, ScopeCamera, has_camera, place_scope
from palpate.render.theme import DARK, Theme
from palpate.viewport.instruments import SeenInstrument

SHARE, LEAST, MOST = 0.36, 120, 380
"""[-] Of the view's height, and [px]: the sides of the inset."""
RIM = 3.0
"""[px]"""
PAD_X, PAD_Y = 10, 4
"""[px]"""


class Shows(enum.Enum):
    """What the large picture is of."""

    room = enum.auto()
    """The laparoscope's is the inset."""
    scope = enum.auto()
    """The room's is the inset."""
    room_alone = enum.auto()


class ScopeInset(QWidget):
    """There where an instrument of the scene is one to see with."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setObjectName("scope_inset")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.theme: Theme = DARK
        self.shows = Shows.room
        self.camera: ScopeCamera | None = None
        """What the laparoscope sees; None where there is none."""
        self._pixels: NDArray[np.uint8] | None = None
        self.hide()

    def follow(self, seen: Sequence[SeenInstrument]) -> None:
        """The first of these that has a camera."""
        held = next((each for each in seen if has_camera(each.tool)), None)
        self.camera = None
        if held is not None:
            self.camera = place_scope(held.tool, held.position, held.orientation)
        self._renew()

    def change(self) -> bool:
        """To the next of what it shows; False where there is no laparoscope."""
        if self.camera is None:
            return False
        order = list(Shows)
        self.shows = order[(order.index(self.shows) + 1) % len(order)]
        self._renew()
        return True

    def choose(self, room: Camera) -> tuple[Camera, Camera | None]:
        """What the large picture is seen from, and the inset; None for no inset."""
        if self.camera is None or self.shows is Shows.room_alone:
            return room, None
        pair = (room, self.camera)
        return pair if self.shows is Shows.room else pair[::-1]

    def place(self, left: float, bottom: float, height: float) -> None:
        """Its lower left corner [px], in a view of a height [px]."""
        side = round(min(max(SHARE * height, LEAST), MOST))
        self.setGeometry(round(left), round(bottom) - side, side, side)

    def take(self, pixels: NDArray[np.uint8]) -> None:
        """(h, w, 4), the top row first; kept and not copied."""
        self._pixels = pixels
        self.update()

    def use_theme(self, theme: Theme) -> None:
        self.theme = theme
        self.update()

    def _renew(self) -> None:
        self.setVisible(self.camera is not None and self.shows is not Shows.room_alone)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.LanguageChange:
            self.update()
        super().changeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        ring = QRectF(self.rect()).adjusted(RIM, RIM, -RIM, -RIM)
        round_ = QPainterPath()
        round_.addEllipse(ring)
        painter.setClipPath(round_)
        painter.fillRect(self.rect(), QColor(0, 0, 0))
        if self._pixels is not None:
            h, w = self._pixels.shape[:2]
            image = QImage(self._pixels.data, w, h, 4 * w, QImage.Format.Format_RGBX8888)
            painter.drawImage(ring, image)
        painter.setClipping(False)
        painter.setPen(QPen(QColor.fromRgbF(*self.theme.faint), RIM / 2))
        painter.drawEllipse(ring)
        self._paint_name(painter, ring)
        painter.end()

    def _paint_name(self, painter: QPainter, ring: QRectF) -> None:
        name = QCoreApplication.translate("Viewport", "Laparoscope")
        if self.shows is Shows.scope:
            name = QCoreApplication.translate("Viewport", "Room")
        text = f"{name}  V"
        letters = QFontMetricsF(self.font())
        wide, high = letters.horizontalAdvance(text) + 2 * PAD_X, letters.height() + 2 * PAD_Y
        box = QRectF(ring.center().x() - wide / 2, ring.bottom() - high - 6, wide, high)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor.fromRgbF(*self.theme.panel, 0.62))
        painter.drawRoundedRect(box, high / 2, high / 2)
        painter.setPen(QColor.fromRgbF(*self.theme.text))
        painter.drawText(QPointF(box.left() + PAD_X, box.top() + PAD_Y + letters.ascent()), text)
