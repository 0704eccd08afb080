# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of windows share: pixels, pictures for people, and a mouse."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

SCREENSHOTS = Path(__file__).resolve().parents[2] / "build" / "screenshots"
LEFT, MIDDLE, RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)


def read_pixels(image: QImage) -> np.ndarray:
    """(h, w, 3) as whole numbers, the top row first."""
    plain = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(plain.constBits(), np.uint8).reshape(plain.height(), plain.bytesPerLine())
    return rows[:, : 3 * plain.width()].reshape(plain.height(), plain.width(), 3).astype(int)


def grab(widget: QWidget) -> np.ndarray:
    return read_pixels(widget.grab().toImage())


def keep_picture(widget: QWidget, name: str) -> None:
    """Leaves a picture in the build folder that people can open."""
    host = "x11" if QApplication.platformName() == "xcb" else "offscreen"
    folder = SCREENSHOTS / host
    folder.mkdir(parents=True, exist_ok=True)
    assert widget.grab().toImage().save(str(folder / f"{name}.png"))


def at(point: QPointF) -> QPoint:
    return QPoint(round(point.x()), round(point.y()))


def drag(
    widget: QWidget, start: QPoint, shift: QPoint, button=LEFT, keys=Qt.KeyboardModifier.NoModifier
) -> None:
    """Presses, moves in a few steps, lets go."""
    QTest.mousePress(widget, button, keys, start)
    for k in range(1, 5):
        move(widget, start + shift * k / 4, button, keys)
    QTest.mouseRelease(widget, button, keys, start + shift)


def move(
    widget: QWidget,
    to: QPoint,
    buttons=Qt.MouseButton.NoButton,
    keys=Qt.KeyboardModifier.NoModifier,
) -> None:
    """A move with buttons held, which QTest.mouseMove does not tell."""

    where = QPointF(to)
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        where,
        widget.mapToGlobal(where),
        Qt.MouseButton.NoButton,
        buttons,
        keys,
    )
    QApplication.sendEvent(widget, event)


def turn_wheel(
    widget: QWidget, to: QPoint, notches: int, keys=Qt.KeyboardModifier.NoModifier
) -> None:
    where = QPointF(to)
    event = QWheelEvent(
        where,
        widget.mapToGlobal(where),
        QPoint(0, 0),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        keys,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)
