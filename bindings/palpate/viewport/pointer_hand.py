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
WALK_SPEED = 0.25
"""[m/s] of the tip over the surface: what comes faster may be a blow, and its ticks cost more."""
LONGEST_STEP = 0.04
"""[-] of the organ's half diagonal, at once, however long the window took for its last frame: on a
longer way the tip would cut through the organ, and the device glides there within 15 ms."""
LONGEST_PAUSE_MS = 40
"""[ms] of depth that is made up at once."""
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
        self._x = palpate.compute_surface(scene.tissue, scene.tissue.rest_position)
        self._triangles = np.array(scene.tissue.triangles)
        self._tree = palpate.AabbTree(self._x, self._triangles)
        self._normals = np.asarray(palpate.compute_vertex_normals(self._x, self._triangles))
        self._radius = scene.tool.radius
        reach = palpate.compute_diagonal(self._x) / 2
        self.press_depth = min(max(0.08 * reach, SMALLEST_PRESS), LARGEST_PRESS)
        """[m] how deep the left button presses."""
        self._clearance, self._notch = 0.04 * reach, 0.01 * reach
        self._longest_step = LONGEST_STEP * reach
        self._deepest, self._highest = 0.8 * reach, 0.8 * reach
        top = find_top(scene)
        self._base, self._outward = np.array(top.point), np.array(top.outward)
        self._goal = self._grabbed = self._base
        self._is_coming = False
        self.grip = Grip.hovering
        self._depth = self._wanted = self._hover_depth = -self._clearance
        self._buttons = 0
        self._still = QElapsedTimer()
        self._timer = QTimer(self)
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self.advance)
        self._last_step = QElapsedTimer()
        self._last_walk = QElapsedTimer()
        self._last_walk.start()
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
        self._grabbed = self._goal
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
            reach = self._outward * (self._radius - self._depth)
            self._goal = self._meet(view, event, self.position) - reach
        self._move_on()
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
            self._goal = self._goal + view.camera.basis()[2] * (self._notch * notches)
            self._move_on()
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

    def is_moving(self) -> bool:
        """Whether the tip is on its way to where the pointer wants it."""
        return self._timer.isActive()

    def settle(self) -> None:
        """Goes at once where the pointer wants the tip, for scripts that have no time."""
        while self._walk(self._longest_step):
            self._send()
        self._depth = self._wanted
        self._buttons = palpate.ATTACH_BUTTON if self.grip is Grip.holding else 0
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
        self._goal, self._is_coming = np.array(hit.point), True

    def _find_outward(self, at: palpate.SurfacePoint) -> Array:
        """The smooth normal at a point of the surface at rest."""
        outward = np.asarray(at.weights) @ self._normals[self._triangles[at.triangle]]
        length = float(np.linalg.norm(outward))
        return outward / length if length > 0.0 else self._outward

    def _measure_step(self) -> float:
        """[m] that the tip may go since it went last, however many events came in a burst."""
        passed = 1e-9 * self._last_walk.nsecsElapsed()
        self._last_walk.start()
        return min(self._longest_step, WALK_SPEED * passed)

    def _walk(self, longest: float) -> bool:
        """A step of the tip towards its goal, at most `longest` [m]; False once it is there.

        A tip that hovers, or is on its way to where it shall press, goes around the organ: where it
        would come below the surface, it follows the surface. Then it moves freely.
        """
        way = self._goal - self._base
        length = float(np.linalg.norm(way))
        arrives = length <= longest
        base = self._goal if arrives else self._base + way * (longest / length)
        if self.grip is Grip.hovering or self._is_coming:
            near = palpate.find_closest_point(self._tree, self._x, base)
            outward = self._find_outward(near)
            if (base - np.asarray(near.point)) @ outward <= 0.0:
                base, self._outward = np.array(near.point), outward
        blocked = np.linalg.norm(base - self._base) < 1e-3 * longest
        self._base = base
        there = bool(arrives or blocked)
        self._is_coming = self._is_coming and not there
        return not there

    def _meet(self, view: ViewBase, event: QMouseEvent, point: Array) -> Array:
        """[m] Under the pointer, in the plane through a point that is parallel to the screen."""
        return meet_plane(*view.ray_at(event.position()), point, view.camera.basis()[2])

    def _drag(self, view: ViewBase, event: QMouseEvent) -> None:
        self._goal = self._meet(view, event, self._goal)
        self._move_on()

    def _let_go(self) -> None:
        self.grip = Grip.hovering
        self._buttons = 0
        self._goal = self._grabbed
        self._go_to(self._hover_depth)

    def _go_to(self, depth: float) -> None:
        self._wanted = min(max(depth, -self._highest), self._deepest)
        self._move_on()

    def _move_on(self) -> None:
        """Sets the tip in motion; a short way is done at once."""
        self._walk(self._measure_step())
        self._send()
        self._still.start()
        if not self._timer.isActive():
            self._last_step.start()
            self._timer.start()

    def advance(self) -> None:
        """A step over the surface; then one to the depth; then, after a while, the grip."""
        if self._walk(self._measure_step()):
            self._still.start()
            self._last_step.start()
            self._send()
            return
        most = SPEED * 1e-3 * min(max(1, self._last_step.restart()), LONGEST_PAUSE_MS)
        way = self._wanted - self._depth
        self._depth += min(max(way, -most), most)
        if abs(way) > most:
            self._still.start()
        elif self.grip is not Grip.holding:
            self._timer.stop()
        elif self._still.elapsed() > 1e3 * HOLD_DELAY:
            self._buttons = palpate.ATTACH_BUTTON
            self._timer.stop()
        self._send()

    def _send(self) -> None:
        self._device.set(palpate.HapticSample(position=self.position, buttons=self._buttons))
