# SPDX-License-Identifier: BSD-3-Clause
"""What a person does with the trainee's window, and reads in it."""

from __future__ import annotations

from palpate.player import TraineeWindow
from palpate.player.cards import BREAK
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton
from windows import LEFT, move


def texts(window: TraineeWindow) -> list[str]:
    """Everything that can be read now; where a long name may be broken is not seen."""
    found = [*window.findChildren(QLabel), *window.findChildren(QPushButton)]
    said = (thing.text().replace(BREAK, "") for thing in found if thing.isVisible())
    return [text for text in said if text]


def middle(window: TraineeWindow) -> QPoint:
    """A pixel of the organ."""
    return window.view.world_to_pixel(window.view.scenery.centre).toPoint()


def press_and_wait(window: TraineeWindow, qtbot) -> None:
    """With a real mouse, until the force of it is on the screen."""
    move(window.view, middle(window))
    QTest.mousePress(window.view, LEFT, Qt.KeyboardModifier.NoModifier, middle(window))
    qtbot.waitUntil(lambda: window.over.force.force > 0.0, timeout=20_000)
