# SPDX-License-Identifier: BSD-3-Clause
"""The mouse as the hand: where it points, how deep it presses, what it holds."""

from __future__ import annotations

import enum
import math
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QObject, QPointF, Qt
from PySide6.QtGui import QInputEvent, QKeyEvent, QMouseEvent, QWheelEvent

import palpate
from palpate.runs.press import find_top
from palpate.viewport.hint_line import Means, say_holding, say_hovering, say_pressing
from palpate.viewport.navigation import meet_plane
from palpate.viewport.view_base import ViewBase

Array = NDArray[np.float64]

SMALLEST_PRESS, LARGEST_PRESS = 2e-3, 6e-3
"""[m]"""


class Grip(enum.Enum):
    """What the hand is doing."""

    hovering = enum.auto()
    pressing = enum.auto()
    holding = enum.auto()


HINTS = {Grip.hovering: say_hovering, Grip.pressing: say_pressing, Grip.holding: say_holding}
TURN, LEAN = math.radians(10.0), math.radians(5.0)
"""[rad] for each notch of the wheel."""
SWAYED = math.radians(75.0)
"""[rad] that a shaft leans from the vertical at most."""
APART = 0.5
"""[-] of the organ's half diagonal between where two instruments begin."""


class PointerHand(QObject):
    """A view's tool that tells a SurfacePointer where to go. The device moves the hand, in the
    haptic thread, so that a slow window changes nothing in what is felt. Gestures, with the pointer
    over the organ:

    - moving: the tip follows the surface at rest, a little above it;
    - wheel: deeper or higher, so that one can stroke the surface at a depth;
    - left button: presses a few millimetres deep; while it is held the tip slides over the surface
      at that depth, and the wheel presses deeper;
    - right button or Ctrl + left: touches, takes hold of the tissue and pulls it along in the plane
      through the touched point that is parallel to the screen; the wheel pulls it nearer or pushes
      it away; letting go of the button lets go;
    - A: takes hold where the tip is, and lets go;
    - of an instrument with a shaft Shift + wheel turns it about itself and, where no trocar does,
      Alt + wheel leans it to or from the viewer. Its jaws close where a ball takes hold.

    Beside the organ everything turns the camera, as does the middle button; Ctrl + wheel zooms. The
    organ is whatever is under the pointer: any body or scenery, or a stone where it is now. What
    else the tip meets on its way it touches too.
    """

    def __init__(
        self,
        view: ViewBase,
        device: palpate.SurfacePointer,
        scene: palpate.Scene,
        instrument: int = 0,
        next_hand: int = 0,
    ):
        """`next_hand` is the number of the instrument that Tab changes to, 0 for none."""
        super().__init__(view)  # type: ignore[arg-type]  # the mixin of a QWidget
        self._view, self._device = view, device
        its = scene.instruments[instrument]
        self.means = find_means(its, next_hand)
        self._hints = {grip: partial(say, self.means) for grip, say in HINTS.items()}
        self._roll, self._lean = 0.0, np.array([0.0, 0.0, 0.0, 1.0])
        self._offset = np.zeros(3)
        """[m] from where the pointer means to where what is held is."""
        self._surfaces = palpate.SceneSurfaces(scene)
        self._stones = [(np.array(r.position), np.array(r.orientation)) for r in scene.rigid]
        self._rigid = -1
        """The rigid body that the goal is of."""
        tissue = scene.bodies[0].tissue
        x = palpate.compute_surface(tissue, tissue.rest_position)
        self._radius = its.tool.radius
        reach = palpate.compute_diagonal(x) / 2
        self.press_depth = min(max(0.08 * reach, SMALLEST_PRESS), LARGEST_PRESS)
        """[m] how deep the left button presses."""
        self._clearance, self._notch = 0.04 * reach, 0.01 * reach
        self._deepest, self._highest = 0.8 * reach, 0.8 * reach
        if instrument == 0:
            top = find_top(scene)
            point, self._outward = np.array(top.point), np.array(top.outward)
        else:
            normals = np.asarray(palpate.compute_vertex_normals(x, tissue.triangles))
            start = find_start(x, normals, instrument, APART * reach)
            point, self._outward = x[start], normals[start]
        self._goal = self._grabbed = point
        self._path = palpate.PointerPath.along
        self.grip = Grip.hovering
        self._depth = self._hover_depth = -self._clearance
        self._time = 0.0
        self._post()

    @property
    def depth(self) -> float:
        """[m] of the tip below the surface at rest, as it is asked for; negative above it."""
        return self._depth

    @property
    def goal(self) -> Array:
        """[m] (3,) the point of the surface, or beside it, that the tip is asked to go to."""
        return self._goal

    # ------------------------------------------------------------ a view's tool

    def press(self, view: ViewBase, event: QMouseEvent) -> bool:
        hit = self._find(view, event.position())
        button = event.button()
        if hit is None or button not in (Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton):
            return False
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:  # moves the camera
            return False
        self._go_over(hit)
        holds = button == Qt.MouseButton.RightButton or bool(
            event.modifiers() & Qt.KeyboardModifier.ControlModifier
        )
        pressed = SMALLEST_PRESS if holds else self.press_depth
        depth = max(self._depth, 0.0) if self.grip is Grip.hovering else self._depth
        self._take(Grip.holding if holds else Grip.pressing, depth + pressed, event)
        return True

    def move(self, view: ViewBase, event: QMouseEvent) -> bool:
        if self.grip is Grip.holding:
            self._go_freely(self._meet(view, event.position(), self._goal) + self._offset)
        elif self.grip is Grip.pressing:
            self._slide(view, event.position())
        elif event.buttons() != Qt.MouseButton.NoButton:
            return False
        else:
            hit = self._find(view, event.position())
            if hit is None:  # beside the organ, as far away as the pointer left it
                reach = self._outward * (self._radius - self._depth)
                self._goal = self._meet(view, event.position(), self._goal + reach) - reach
                self._rigid = -1
                self._path = palpate.PointerPath.around
            else:
                self._go_over(hit)
            self._post(event)
            return hit is not None
        self._post(event)
        return True

    def release(self, view: ViewBase, event: QMouseEvent) -> bool:
        del view
        if self.grip is Grip.hovering:
            return False
        self._let_go(event)
        return True

    def wheel(self, view: ViewBase, event: QWheelEvent) -> bool:
        keys = event.modifiers()
        if keys & Qt.KeyboardModifier.ControlModifier:
            return False
        # Qt turns the wheel aside while Alt is down
        notches = (event.angleDelta().y() or event.angleDelta().x()) / 120
        if self.means.turns and keys & Qt.KeyboardModifier.ShiftModifier:
            self._roll += TURN * notches
            self._post(event)
            return True
        if self.means.leans and keys & Qt.KeyboardModifier.AltModifier:
            self._sway(LEAN * notches, view.seen_from.basis()[0])
            self._post(event)
            return True
        if self.grip is Grip.holding:
            # away from the viewer or nearer: what is held need not move along its normal
            self._go_freely(self._goal + view.seen_from.basis()[2] * (self._notch * notches))
        elif self.grip is Grip.hovering and not self._is_over(view, event.position()):
            return False
        else:
            self._set_depth(self._depth + self._notch * notches)
        self._post(event)
        return True

    def leave(self, view: ViewBase) -> None:
        del view
        if self.grip is Grip.hovering:
            self._set_depth(-self._clearance)
            self._post()

    def key(self, view: ViewBase, event: QKeyEvent) -> bool:
        del view
        if event.key() != Qt.Key.Key_A or event.isAutoRepeat() or event.modifiers():
            return False
        if self.grip is Grip.holding:
            self._let_go(event)
        else:
            self._take(Grip.holding, max(self._depth, SMALLEST_PRESS), event)
        return True

    # ------------------------------------------------------------ among several

    def take_over(self, at: QPointF) -> None:
        """The pointer is this hand's from now on; what it holds stays where it is."""
        self._offset = np.zeros(3)
        if self.grip is Grip.holding:
            self._offset = self._goal - self._meet(self._view, at, self._goal)
        self._view.hint.say(self._hints[self.grip])

    # ------------------------------------------------------------ inside

    def _sway(self, angle: float, axis: Array) -> None:
        """Leans the shaft about an axis of the world, not farther than SWAYED."""
        lean = multiply(turn_about(axis, angle), self._lean)
        upright = 1.0 - 2.0 * float(lean[0] ** 2 + lean[1] ** 2)
        if upright >= math.cos(SWAYED):
            self._lean = lean / np.linalg.norm(lean)

    def _find(self, view: ViewBase, at: QPointF) -> palpate.ScenePoint | None:
        """Where the pointer's ray meets what is first, tissue at rest and stones as they are seen.

        Not tissue as it is now: what the tip has pressed down would draw it deeper still.
        """
        for number, pose in enumerate(view.hard_parts.poses[: len(self._stones)]):
            self._stones[number] = pose
            self._surfaces.place_rigid(number, *pose)
        return self._surfaces.find_ray_hit(*view.ray_at(at))

    def _is_over(self, view: ViewBase, at: QPointF) -> bool:
        return view.pick(at) is not None or self._find(view, at) is not None

    def _meet(self, view: ViewBase, at: QPointF, point: Array) -> Array:
        """[m] Under the pointer, in the plane through a point that is parallel to the screen."""
        return meet_plane(*view.ray_at(at), point, view.seen_from.basis()[2])

    def _go_over(self, hit: palpate.ScenePoint) -> None:
        self._goal, self._path = np.array(hit.point), palpate.PointerPath.along
        self._outward = np.array(hit.normal)
        self._rigid = hit.index if hit.part is palpate.ScenePart.rigid else -1

    def _go_freely(self, goal: Array) -> None:
        self._goal, self._path = goal, palpate.PointerPath.straight

    def _slide(self, view: ViewBase, at: QPointF) -> None:
        """Over the surface; where the pointer has left the organ, along its rim."""
        hit = self._find(view, at)
        if hit is None:
            beside = self._meet(view, at, self._goal)
            hit = self._surfaces.find_closest_point(beside, self._rigid)
        if hit is not None:
            self._go_over(hit)

    def _take(self, grip: Grip, depth: float, event: QInputEvent) -> None:
        if self.grip is Grip.hovering:
            self._hover_depth = self._depth
        self._path = palpate.PointerPath.along
        self._grabbed, self.grip, self._offset = self._goal, grip, np.zeros(3)
        self._set_depth(depth)
        self._post(event)

    def _let_go(self, event: QInputEvent) -> None:
        if self.grip is Grip.holding:  # back to where it was taken; a stroke ends where it ends
            self._goal = self._grabbed
        self.grip, self._path = Grip.hovering, palpate.PointerPath.along
        self._set_depth(self._hover_depth)
        self._post(event)

    def _set_depth(self, depth: float) -> None:
        self._depth = min(max(depth, -self._highest), self._deepest)

    def _post(self, event: QInputEvent | None = None) -> None:
        if event is not None:
            self._time = 1e-3 * event.timestamp()
        holds = self.grip is Grip.holding
        stone = {}
        if self._rigid >= 0:
            position, orientation = self._stones[self._rigid]
            stone = {"rigid_position": position, "rigid_orientation": orientation}
        self._device.post(
            palpate.PointerTarget(
                time=self._time,
                goal=self._goal,
                depth=self._depth,
                path=self._path,
                pressing=self.grip is not Grip.hovering,
                buttons=palpate.ATTACH_BUTTON if holds else 0,
                orientation=multiply(self._lean, turn_about((0.0, 0.0, 1.0), self._roll)),
                rigid=self._rigid,
                **stone,
            )
        )
        self._view.hint.say(self._hints[self.grip])


def find_means(instrument: palpate.Instrument, next_hand: int) -> Means:
    """What a mouse can do with an instrument."""
    shaft = bool(instrument.tool.capsules)
    return Means(
        turns=shaft,
        leans=shaft and instrument.trocar is None,
        jaws=getattr(instrument.tool, "jaws", None) is not None,
        next_hand=next_hand,
    )


def find_start(x: Array, normals: Array, number: int, apart: float) -> int:
    """The highest vertex that is so far [m] from those over which earlier instruments begin."""
    free = normals[:, 2] > 0.3
    chosen = int(x[:, 2].argmax())
    for _ in range(number):
        free &= np.linalg.norm(x - x[chosen], axis=1) > apart
        if not free.any():
            return chosen
        chosen = int(np.where(free, x[:, 2], -np.inf).argmax())
    return chosen


def turn_about(axis: ArrayLike, angle: float) -> Array:
    """The unit quaternion (x, y, z, w) of an angle [rad] about a unit axis."""
    return np.array([*(math.sin(angle / 2) * np.asarray(axis)), math.cos(angle / 2)])


def multiply(a: Array, b: Array) -> Array:
    """The turn b and then a, as quaternions (x, y, z, w)."""
    v = a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3])
    return np.array([*v, a[3] * b[3] - a[:3] @ b[:3]])
