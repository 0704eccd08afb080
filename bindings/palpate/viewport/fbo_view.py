# SPDX-License-Identifier: BSD-3-Clause
"""The view without a display: draws into memory through EGL, and Qt shows the pixels."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import moderngl
import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRect, Qt, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from palpate.render import RenderError
from palpate.render.context import create_context
from palpate.viewport.canvas import Canvas
from palpate.viewport.scenery import Scenery
from palpate.viewport.view_base import ViewBase


class Held:
    """The OpenGL of a view, given back once, however the view goes: a widget in a window is not
    told beforehand that it will be deleted.
    """

    def __init__(self, context: moderngl.Context, canvas: Canvas, scenery: Scenery):
        self._context: moderngl.Context | None = context
        self._canvas, self._scenery = canvas, scenery

    def release(self) -> None:
        context, self._context = self._context, None
        if context is not None:
            with context:
                self._scenery.release()
                self._canvas.release()
            context.release()

    def __del__(self) -> None:
        self.release()


class FboView(ViewBase, QWidget):
    """A view that needs no OpenGL of the window system; a sentence where there is none at all."""

    frame_drawn = Signal()
    hover = Signal(QPointF)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self._context: moderngl.Context | None = None
        self._held: Held | None = None
        self._pixels = np.zeros((1, 1, 4), np.uint8)
        self._image = QImage()
        self.problem = ""
        """Why nothing can be drawn, in a sentence; empty where it can."""
        self.set_up()
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        if self._context is None and not self.problem:
            self._open()
        painter = QPainter(self)
        if self._context is None:
            self._explain(painter)
        else:
            with self._context:
                self.paint_frame()
            painter.drawImage(self.rect(), self._image)
        painter.end()
        self.frame_drawn.emit()

    def close_context(self) -> None:
        """Gives back all OpenGL; the next frame opens it again."""
        if self._held is not None:
            self._held.release()
        self._held = self._context = self._canvas = None

    def _open(self) -> None:
        try:
            self._context = create_context()
        except RenderError as problem:
            self.problem = str(problem)
            return
        with self._context:
            self._canvas = Canvas(self._context)
            self.scenery.build(self._context)
        self._held = Held(self._context, self._canvas, self.scenery)
        self.destroyed.connect(self._held.release)

    @contextmanager
    def in_context(self) -> Iterator[None]:
        assert self._context is not None
        with self._context:
            yield

    def refined(self) -> None:
        self._image = QImage()
        super().refined()

    def paint_frame(self) -> bool:
        """Brings the image up to date; True where it had to be drawn. Our context must be current.

        The pixels of the image live until the next one.
        """
        assert self._canvas is not None
        drawn = self.draw_frame(self._canvas)
        if not drawn and not self._image.isNull():
            return False
        width, height = self.pixels()
        if self._pixels.shape[:2] != (height, width):
            self._pixels = np.empty((height, width, 4), np.uint8)
        self._canvas.read(self._pixels)
        self._image = QImage(self._pixels.data, width, height, QImage.Format.Format_RGBX8888)
        return drawn

    def _explain(self, painter: QPainter) -> None:
        theme = self.scenery.theme
        painter.fillRect(self.rect(), QColor.fromRgbF(*theme.corner))
        painter.setPen(QColor.fromRgbF(*theme.text))
        text = QCoreApplication.translate(
            "Viewport", "The organ cannot be drawn on this machine: %1"
        )
        margin = QRect(self.rect()).adjusted(24, 24, -24, -24)
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(margin, flags, text.replace("%1", self.problem))
