# SPDX-License-Identifier: BSD-3-Clause
"""A mouse over a view, and the tissue under its hand, in a time that only the test lets pass."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import palpate
from palpate.viewport import PointerHand
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

NO_KEYS = Qt.KeyboardModifier.NoModifier
NO_BUTTON = Qt.MouseButton.NoButton
LEFT = Qt.MouseButton.LeftButton


def tell_mouse(widget, kind: QEvent.Type, at: QPointF, buttons, time: float) -> None:
    """An event of the mouse that the window system saw at `time` [s]."""
    button = NO_BUTTON if kind == QEvent.Type.MouseMove else LEFT
    where = widget.mapToGlobal(at)
    event = QMouseEvent(kind, at, where, button, buttons, NO_KEYS)
    event.setTimestamp(round(1e3 * time))
    QApplication.sendEvent(widget, event)


class Bench:
    """A hand and the world it would touch, tick by tick and without a clock."""

    def __init__(self, view, scene: palpate.Scene):
        self.view, self.scene = view, scene
        self.device = palpate.SurfacePointer(scene)
        self.hand = view.tool = PointerHand(view, self.device, scene)
        self.world = palpate.World(scene)
        self.x = palpate.compute_surface(
            scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position
        )
        self.faces = np.array(scene.bodies[0].tissue.triangles)
        self.tree = palpate.AabbTree(self.x, self.faces)
        self.ticks = 0
        self.samples: list[palpate.HapticSample] = []
        self.forces: list[np.ndarray] = []
        self.touching: list[bool] = []
        self.feel(5)

    @property
    def time(self) -> float:
        """[s]"""
        return self.ticks / self.scene.rate

    @property
    def position(self) -> np.ndarray:
        """[m] of the middle of the hand's tip."""
        return np.array(self.samples[-1].position)

    def feel(self, ticks: int) -> np.ndarray:
        """Lets ticks pass; the force [N] of the last."""
        for _ in range(ticks):
            sample = self.device.read(self.time)
            command = palpate.tick(self.scene, sample, 1.0 / self.scene.rate, self.world)
            self.samples.append(sample)
            self.forces.append(np.array(command.force))
            self.touching.append(self.world.instruments[0].tool.touching)
            self.ticks += 1
        return self.forces[-1]

    def settle(self) -> np.ndarray:
        """Lets time pass until the hand rests; the force [N] then."""
        for _ in range(60):
            before = np.array(self.device.read(self.time).position)
            force = self.feel(100)
            if np.array_equal(before, self.position):
                return force
        raise AssertionError("the hand does not come to rest")

    def hover(self, pixel: QPoint) -> None:
        tell_mouse(self.view, QEvent.Type.MouseMove, QPointF(pixel), NO_BUTTON, self.time)
        self.settle()

    def depth(self, position: np.ndarray | None = None) -> float:
        """[m] of a tip below the surface at rest."""
        p = self.position if position is None else position
        radius = self.scene.instruments[0].tool.radius
        near = palpate.find_closest_point(self.tree, self.x, p)
        corners = self.x[self.faces[near.triangle]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        inside = (p - np.asarray(near.point)) @ normal < 0.0
        return radius + near.distance if inside else radius - near.distance

    def play(self, rate: float, doings: list[tuple[float, Callable[[float], None]]], end: float):
        """What a person does at times [s] from now, heard by a window of `rate` frames a second."""
        begin, left = self.time, sorted(doings, key=lambda doing: doing[0])
        ticks = round(end * self.scene.rate)
        for k in range(ticks):
            frame = int(k * rate / self.scene.rate) != int((k - 1) * rate / self.scene.rate)
            while frame and left and left[0][0] <= k / self.scene.rate:
                when, do = left.pop(0)
                do(begin + when)
            self.feel(1)
