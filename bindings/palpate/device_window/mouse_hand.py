# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand that holds a simulated device's stylus."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

from palpate.device.link import Link
from palpate.device_window.arm_scene import ArmScene
from palpate.viewport import ViewBase
from palpate.viewport.navigation import meet_plane

NEAR = 46.0
"""[px] from the tip, within which a press takes the stylus and not the camera."""
NOTCH = 4e-3
"""[m] nearer or farther for each notch of the wheel."""


class MouseHand:
    """A view's tool: taken near its tip, the stylus moves in the plane of the screen; the wheel,
    meanwhile, brings it nearer or farther. Everything else moves the camera.
    """

    def __init__(self, scene: ArmScene):
        self._scene = scene
        self.link: Link | None = None
        """Of a simulated device, or None where the hand is a real one."""
        self.holds = False
        self._place = np.zeros(3)

    def press(self, view: ViewBase, event: QMouseEvent) -> bool:
        if self.link is None or event.button() != Qt.MouseButton.LeftButton:
            return False
        if not self._is_near(view, event.position()):
            return False
        self.holds, self._place = True, np.array(self._scene.tip)
        return True

    def move(self, view: ViewBase, event: QMouseEvent) -> bool:
        if not self.holds:
            near = self.link is not None and self._is_near(view, event.position())
            shape = Qt.CursorShape.OpenHandCursor if near else Qt.CursorShape.ArrowCursor
            view.setCursor(shape)  # type: ignore[attr-defined]
            return False
        ray = view.ray_at(event.position())
        self._go(meet_plane(*ray, self._place, view.camera.basis()[2]))
        return True

    def release(self, view: ViewBase, event: QMouseEvent) -> bool:
        del view, event
        held, self.holds = self.holds, False
        return held

    def wheel(self, view: ViewBase, event: QWheelEvent) -> bool:
        if not self.holds:
            return False
        self._go(self._place + view.camera.basis()[2] * NOTCH * event.angleDelta().y() / 120)
        return True

    def leave(self, view: ViewBase) -> None:
        del view

    def key(self, view: ViewBase, event: QKeyEvent) -> bool:
        del view, event
        return False

    def _is_near(self, view: ViewBase, at: QPointF) -> bool:
        offset = view.world_to_pixel(self._scene.tip) - at
        return (offset.x() ** 2 + offset.y() ** 2) ** 0.5 < NEAR

    def _go(self, place: np.ndarray) -> None:
        self._place = place
        if self.link is not None:
            self.link.hold(place)
