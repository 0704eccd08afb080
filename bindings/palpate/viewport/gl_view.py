# SPDX-License-Identifier: BSD-3-Clause
"""The view of a desktop: draws with the OpenGL that Qt made for its window."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from types import TracebackType

import moderngl
from PySide6.QtCore import QByteArray, QPointF, Signal
from PySide6.QtGui import QOpenGLContext, QSurfaceFormat
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QWidget

from palpate.render.context import GL_VERSION
from palpate.viewport.canvas import Canvas
from palpate.viewport.view_base import ViewBase

GL_UNPACK_ALIGNMENT = 0x0CF5


class QtLoader:
    """Gives moderngl the functions of whatever context Qt has made current."""

    def load_opengl_function(self, name: str) -> int:
        context = QOpenGLContext.currentContext()
        return int(context.getProcAddress(QByteArray(name.encode())) or 0) if context else 0

    def __enter__(self) -> QtLoader:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        pass

    def release(self) -> None:
        pass


def build_format() -> QSurfaceFormat:
    """OpenGL 3.3 core, as palpate.render wants it."""
    wanted = QSurfaceFormat()
    wanted.setVersion(GL_VERSION // 100, GL_VERSION // 10 % 10)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setDepthBufferSize(24)
    return wanted


class GLView(ViewBase, QOpenGLWidget):
    """A view on the graphics card. Qt may build it several times: nothing lives only there."""

    frame_drawn = Signal()
    hover = Signal(QPointF)

    def __init__(self, parent: QWidget | None = None):
        super().__init__(parent)
        self.setFormat(build_format())
        self._context: moderngl.Context | None = None
        self.set_up()

    def initializeGL(self) -> None:
        # the old context is gone with all that was in it, or about to go
        self._forget()
        self.context().aboutToBeDestroyed.connect(self._let_go)
        self._context = moderngl.create_context(require=GL_VERSION, context=QtLoader())
        self._canvas = Canvas(self._context)
        self.scenery.build(self._context)

    def paintGL(self) -> None:
        self.paint_frame()
        self.frame_drawn.emit()

    def paint_frame(self) -> bool:
        """Shows the newest frame; True where it had to be drawn. Qt's context must be current."""
        if self._context is None or self._canvas is None:
            return False
        drawn = self.draw_frame(self._canvas)
        screen = self._context.detect_framebuffer(self.defaultFramebufferObject())
        self._canvas.paste(screen, self.pixels())
        # moderngl leaves 1 behind, with which Qt's own text comes out garbled
        self.context().functions().glPixelStorei(GL_UNPACK_ALIGNMENT, 4)
        return drawn

    @contextmanager
    def in_context(self) -> Iterator[None]:
        self.makeCurrent()
        try:
            yield
        finally:
            self.doneCurrent()

    def _let_go(self) -> None:
        """The context is about to be destroyed, as when a dock moves to another window."""
        if self._context is not None:
            self.makeCurrent()
            self.scenery.release()
            if self._canvas is not None:
                self._canvas.release()
            self.doneCurrent()
        self._forget()

    def _forget(self) -> None:
        self._context = self._canvas = None
