# SPDX-License-Identifier: BSD-3-Clause
"""Chooses the host that works on this platform."""

from __future__ import annotations

from PySide6.QtGui import QGuiApplication, QOpenGLContext, QSurfaceFormat
from PySide6.QtWidgets import QWidget

from palpate.viewport.fbo_view import FboView
from palpate.viewport.gl_view import GLView, build_format

View = GLView | FboView
"""Either host: both are a ViewBase and a QWidget."""
WITHOUT_GL = ("offscreen", "minimal", "minimalegl", "vnc", "linuxfb")
"""Platforms where a QOpenGLWidget shows nothing, even where a context can be made."""


def make_view(parent: QWidget | None = None) -> View:
    """A view on OpenGL of the window system or, without one, on OpenGL of no display at all."""
    return GLView(parent) if has_window_gl() else FboView(parent)


def has_window_gl() -> bool:
    """Whether a QOpenGLWidget works here. There must be a QApplication."""
    if QGuiApplication.platformName() in WITHOUT_GL:
        return False
    context = QOpenGLContext()
    context.setFormat(build_format())
    made = context.create()
    have: QSurfaceFormat = context.format()
    return made and (have.majorVersion(), have.minorVersion()) >= (3, 3)
