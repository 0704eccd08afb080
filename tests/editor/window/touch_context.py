# SPDX-License-Identifier: GPL-3.0-or-later
"""A context with a view and a round organ on it, and a mouse that drags over the view."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache

import numpy as np
from palpate.viewport import make_view
from palpate_editor.app.session import Session
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.views.context import Context
from palpate_editor.views.stages.panels import list_stages
from palpate_meshes.generate import ellipsoid
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

RADII = (0.03, 0.03, 0.03)
THIN = (0.05, 0.05, 0.0008)
"""[m] A plate 1.6 mm thick: its two sides lie well within one brush."""
SIZE = (640, 480)
"""[px] of the view."""


def build_organ(radii=RADII, vertices: int = 600) -> Organ:
    """A plain ellipsoid, soft enough to be felt and held at the bottom third."""
    surface = build_surface(radii, vertices)
    organ = replace(EMPTY.with_surface(surface), name="ball")
    return replace(organ, fixed=surface.vertices[:, 2] < -0.5 * radii[2])


@cache
def build_surface(radii: tuple[float, float, float], vertices: int) -> Surface:
    """A value, so it is made once."""
    return Surface(*ellipsoid(vertices, radii, bow=0.0, hollow=0.0, notches=0.0))


@contextmanager
def open_context(qtbot, organ: Organ, settings) -> Iterator[Context]:
    """A context on a shown view that looks at the organ from in front and a little above."""
    view = make_view()
    qtbot.addWidget(view)
    view.resize(*SIZE)
    session = Session()
    context = Context(session, view, settings, list_stages(), view)
    session.restore(organ, None)
    view.show_surface(organ.surface.vertices, organ.surface.triangles)
    view.look_from(np.radians(-60.0), np.radians(50.0))
    view.frame_all()
    with qtbot.waitExposed(view):
        view.show()
    yield context
    # nobody may start work on a context that is about to go
    context.assessor.timer.stop()
    context.assessor.busy = True
    context.jobs.finish()


def middle(view) -> QPoint:
    return QPoint(view.width() // 2, view.height() // 2)


def send_mouse(view, kind, at: QPoint, button, buttons, modifiers=Qt.KeyboardModifier.NoModifier):
    """A mouse event as the window system would send it, with the buttons that are down."""
    event = QMouseEvent(
        kind, QPointF(at), QPointF(view.mapToGlobal(at)), button, buttons, modifiers
    )
    QApplication.sendEvent(view, event)


def drag(
    view,
    start: QPoint,
    end: QPoint,
    *,
    steps: int = 5,
    modifiers=Qt.KeyboardModifier.NoModifier,
    button=Qt.MouseButton.LeftButton,
    let_go: bool = True,
):
    """Presses at one place, moves to another, lets go there."""
    nothing = Qt.MouseButton.NoButton
    send_mouse(view, QEvent.Type.MouseButtonPress, start, button, button, modifiers)
    for k in range(1, steps + 1):
        at = start + (end - start) * (k / steps)
        send_mouse(view, QEvent.Type.MouseMove, at, nothing, button, modifiers)
    if let_go:
        send_mouse(view, QEvent.Type.MouseButtonRelease, end, button, nothing, modifiers)


def click(view, at: QPoint, modifiers=Qt.KeyboardModifier.NoModifier):
    drag(view, at, at, steps=0, modifiers=modifiers)


def hover(view, at: QPoint):
    nothing = Qt.MouseButton.NoButton
    send_mouse(view, QEvent.Type.MouseMove, at, nothing, nothing)


def turn_wheel(view, at: QPoint, notches: int, modifiers=Qt.KeyboardModifier.NoModifier):
    event = QWheelEvent(
        QPointF(at),
        QPointF(view.mapToGlobal(at)),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        modifiers,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view, event)
