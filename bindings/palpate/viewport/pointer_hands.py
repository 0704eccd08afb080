# SPDX-License-Identifier: BSD-3-Clause
"""One mouse and several instruments: Tab gives it to the next, and the others stay as they are."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QObject, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

import palpate
from palpate.viewport.pointer_hand import PointerHand
from palpate.viewport.view_base import ViewBase


class PointerHands(QObject):
    """A view's tool that moves the hand of one instrument at a time.

    A hand that is left stays where it is, and goes on holding what it has taken hold of by A: both
    are the haptic thread's. Tab while a button is down does nothing.
    """

    takes_tab = True

    def __init__(
        self,
        view: ViewBase,
        devices: Sequence[tuple[int, palpate.SurfacePointer]],
        scene: palpate.Scene,
    ):
        """`devices` are instruments of the scene and the device of each. Raises ValueError for
        none."""
        if not devices:
            raise ValueError("devices: got none, expected one or more")
        super().__init__(view)  # type: ignore[arg-type]  # the mixin of a QWidget
        following = [number + 1 for number, _ in [*devices[1:], devices[0]]]
        if len(devices) == 1:
            following = [0]
        self.hands = [
            PointerHand(view, device, scene, number, after)
            for (number, device), after in zip(devices, following, strict=True)
        ]
        self.active = 0
        """Which of them the mouse is."""
        self._view, self._is_down = view, False
        self._at = QPointF(0.0, 0.0)
        self.hand.take_over(self._at)

    @property
    def hand(self) -> PointerHand:
        """The one that the mouse moves."""
        return self.hands[self.active]

    def press(self, view: ViewBase, event: QMouseEvent) -> bool:
        self._at, self._is_down = event.position(), self.hand.press(view, event)
        return self._is_down

    def move(self, view: ViewBase, event: QMouseEvent) -> bool:
        self._at = event.position()
        return self.hand.move(view, event)

    def release(self, view: ViewBase, event: QMouseEvent) -> bool:
        self._is_down = False
        return self.hand.release(view, event)

    def wheel(self, view: ViewBase, event: QWheelEvent) -> bool:
        self._at = event.position()
        return self.hand.wheel(view, event)

    def leave(self, view: ViewBase) -> None:
        self.hand.leave(view)

    def key(self, view: ViewBase, event: QKeyEvent) -> bool:
        if event.key() != Qt.Key.Key_Tab or event.modifiers():
            return self.hand.key(view, event)
        if len(self.hands) < 2 or self._is_down or event.isAutoRepeat():
            return len(self.hands) > 1
        self.active = (self.active + 1) % len(self.hands)
        self.hand.take_over(self._at)
        return True
