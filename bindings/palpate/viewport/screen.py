# SPDX-License-Identifier: BSD-3-Clause
"""Windows that fit the screen they open on."""

from __future__ import annotations

from PySide6.QtCore import QRect, QSize
from PySide6.QtWidgets import QStyle, QWidget


def find_room(window: QWidget) -> QSize:
    """[px] What the inside of a window may take on its screen, beside the system's own panels.

    The frame of a window is known once it is shown; until then that of the style is reckoned with.
    """
    free = window.screen().availableGeometry().size()
    frame = window.frameGeometry().size() - window.geometry().size()
    if frame.isEmpty():
        metric = QStyle.PixelMetric
        title = window.style().pixelMetric(metric.PM_TitleBarHeight, None, window)
        rim = window.style().pixelMetric(metric.PM_MdiSubWindowFrameWidth, None, window)
        frame = QSize(2 * rim, title + rim)
    return free - frame


def fit_to_screen(window: QWidget, wanted: QSize) -> None:
    """As large as wanted, and no larger than the screen has room for."""
    window.resize(wanted.boundedTo(find_room(window)))


def keep_on_screen(window: QWidget) -> None:
    """Brings back a window whose place was kept on another screen, or on a larger one."""
    free: QRect = window.screen().availableGeometry()
    window.resize(window.size().boundedTo(find_room(window)))
    place = window.frameGeometry()
    x = max(free.left(), min(place.left(), free.right() + 1 - place.width()))
    y = max(free.top(), min(place.top(), free.bottom() + 1 - place.height()))
    if (x, y) != (place.left(), place.top()):
        window.move(x, y)
