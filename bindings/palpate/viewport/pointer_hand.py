# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand: where it points, how deep it presses, what it holds."""

from __future__ import annotations

import enum

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QObject, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent

import palpate
from palpate.press import find_top
from palpate.viewport.navigation import meet_plane
from palpate.viewport.view_base import ViewBase

Array = NDArray[np.float64]

SPEED = 0.05
"""[m/s] in which a button or the wheel moves the tip in and out: a firm touch, no blow."""
HOLD_DELAY = 0.08
"""[s] between the arrival of the tip and its grip, for the device glides after its orders."""
STEP_MS = 8
SMALLEST_PRESS, LARGEST_PRESS = 2e-3, 6e-3
"""[m]"""


class Grip(enum.Enum):
    """What the hand is doing."""

    hovering = enum.auto()
    pressing = enum.auto()
    holding = enum.auto()


class PointerHand(QObject):
    """A view's tool that moves a PointerDevice. Gestures, with the pointer over the organ:

    - moving: the tip follows the surface at rest, a little above it;
    - wheel: deeper or higher, so that one can stroke the surface at a depth;
    - left button: presses a few millimetres deep; while it is held the tip moves in the plane
      through the touched point that is parallel to the screen, and the wheel presses deeper;
    - right button or Ctrl + left: touches, takes hold of the tissue and pulls it along in that
      plane; the wheel pulls it nearer or pushes it away; letting go of the button lets go;
    - A: takes hold where the tip is, and lets go.

    Beside the organ everything turns the camera, as does the middle button; Ctrl + wheel zooms.
    """

    def __init__(self, view: ViewBase, device: palpate.PointerDevice, scene: palpate.Scene):
        super().__init__(view)  # type: ignore[arg-type]  # the mixin of a QWidget
        self._view, self._device = view, device
        self._x = np.array(scene.tissue.rest_position)
        self._triangles = np.array(scene.tissue.triangles)
        self._tree = palpate.AabbTree(self._x, self._triangles)
        self._normals = np.asarray(palpate.compute_vertex_normals(self._x, self._triangles))
        self._radius = scene.tool.radius
        reach = palpate.compute_diagonal(self._x) / 2
        self.press_depth = min(max(0.08 * reach, SMALLEST_PRESS), LARGEST_PRESS)
        """[m] how deep the left button presses."""
        self._clearance, self._notch = 0.03 * reach, 0.01 * reach
        self._deepest, self._highest = 0.8 * reach, 0.8 * reach
        top = find_top(scene)
        self._base, self._outward = np.array(top.point), np.array(top.outward)
        self._grabbed = self._base
        self.grip = Grip.hovering
        self._depth = self._wanted = self._hover_depth = -self._clearance
        self._buttons = 0
        self._still = QElapsedTimer()
        self._timer = QTimer(self)
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self._advance)
        self._last_step = QElapsedTimer()
        self._send()

    @property
    def depth(self) -> float:
        """[m] of the tip below the surface at rest; negative above it."""
        return self._depth

    @property
    def position(self) -> Array:
        """[m] (3,) the middle of the tip, as the device was told last."""
        return self._base + self._outward * (self._radius - self._depth)

    # ------------------------------------------------------------ a view's tool

    def press(self, view: ViewBase, event: QMouseEvent) -> bool:
        hit = self._find(view, event)
        button = event.button()
        if hit is None or button not in (Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton):
            return False
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:  # moves the camera
            return False
        self._go_over(hit)
        self._grabbed = self._base
        holds = button == Qt.MouseButton.RightButton or bool(
            event.modifiers() & Qt.KeyboardModifier.ControlModifier
        )
        if self.grip is Grip.hovering:
            self._hover_depth = self._wanted
        self.grip = Grip.holding if holds else Grip.pressing
        pressed = SMALLEST_PRESS if holds else self.press_depth
        self._go_to(max(self._hover_depth, 0.0) + pressed)
        return True

    def move(self, view: ViewBase, event: QMouseEvent) -> bool:
        if self.grip is not Grip.hovering:
            self._drag(view, event)
            return True
        if event.buttons() != Qt.MouseButton.NoButton:
            return False
        hit = self._find(view, event)
        if hit is not None:
            self._go_over(hit)
        else:  # beside the organ, at the depth where the pointer left it
            self._base = self._meet(view, event, self._base)
        self._send()
        return hit is not None

    def release(self, view: ViewBase, event: QMouseEvent) -> bool:
        del view, event
        if self.grip is Grip.hovering:
            return False
        self._let_go()
        return True

    def wheel(self, view: ViewBase, event: QWheelEvent) -> bool:
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            return False
        notches = event.angleDelta().y() / 120
        if self.grip is Grip.holding:
            # away from the viewer or nearer: what is held need not move along its normal
            self._base = self._base + view.camera.basis()[2] * (self._notch * notches)
            self._send()
            return True
        if self.grip is Grip.hovering and view.pick(event.position()) is None:
            return False
        self._go_to(self._wanted + self._notch * notches)
        return True

    def leave(self, view: ViewBase) -> None:
        del view
        if self.grip is Grip.hovering:
            self._go_to(-self._clearance)

    def key(self, view: ViewBase, event: QKeyEvent) -> bool:
        del view
        if event.key() != Qt.Key.Key_A or event.isAutoRepeat() or event.modifiers():
            return False
        if self.grip is Grip.holding:
            self._let_go()
        else:
            self._hover_depth = self._wanted if self.grip is Grip.hovering else -self._clearance
            self._grabbed = self._base
            self.grip = Grip.holding
            self._go_to(max(self._wanted, SMALLEST_PRESS))
        return True

    def settle(self) -> None:
        """Goes at once where button and wheel want the tip, for scripts that have no time."""
        self._depth = self._wanted
        if self.grip is Grip.holding:
            self._buttons = palpate.kAttachButton
        self._timer.stop()
        self._send()

    # ------------------------------------------------------------ inside

    def _find(self, view: ViewBase, event: QMouseEvent) -> palpate.SurfacePoint | None:
        """Where the pointer's ray meets the surface at rest.

        Not the surface as it is now: what the tip has pressed down would draw it deeper still.
        """
        origin, direction = view.ray_at(event.position())
        hit = palpate.find_ray_hit(self._tree, self._x, origin, direction)
        if hit is None or view.pick(event.position()) is None:
            return None
        a, b, c = self._x[self._triangles[hit.triangle]]
        return hit if np.cross(b - a, c - a) @ direction < 0.0 else None

    def _go_over(self, hit: palpate.SurfacePoint) -> None:
        outward = np.asarray(hit.weights) @ self._normals[self._triangles[hit.triangle]]
        length = float(np.linalg.norm(outward))
        if length > 0.0:
            self._outward = outward / length
        self._base = np.array(hit.point)

    def _meet(self, view: ViewBase, event: QMouseEvent, point: Array) -> Array:
        """[m] Under the pointer, in the plane through a point that is parallel to the screen."""
        return meet_plane(*view.ray_at(event.position()), point, view.camera.basis()[2])

    def _drag(self, view: ViewBase, event: QMouseEvent) -> None:
        at = self._meet(view, event, self._base)
        self._base = at
        self._send()

    def _let_go(self) -> None:
        self.grip = Grip.hovering
        self._buttons = 0
        self._base = self._grabbed
        self._go_to(self._hover_depth)

    def _go_to(self, depth: float) -> None:
        self._wanted = min(max(depth, -self._highest), self._deepest)
        self._still.start()
        if not self._timer.isActive():
            self._last_step.start()
            self._timer.start()

    def _advance(self) -> None:
        """One step of the tip towards its depth, and of the grip once it is there."""
        most = SPEED * 1e-3 * max(1, self._last_step.restart())
        way = self._wanted - self._depth
        self._depth += min(max(way, -most), most)
        if abs(way) > most:
            self._still.start()
        elif self.grip is not Grip.holding:
            self._timer.stop()
        elif self._still.elapsed() > 1e3 * HOLD_DELAY:
            self._buttons = palpate.kAttachButton
            self._timer.stop()
        self._send()

    def _send(self) -> None:
        self._device.set(palpate.HapticSample(position=self.position, buttons=self._buttons))
