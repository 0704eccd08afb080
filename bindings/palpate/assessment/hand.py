# SPDX-License-Identifier: BSD-3-Clause
"""What moves one instrument of a task, and hands that know nothing of it."""

from __future__ import annotations

import numpy as np

import palpate
from palpate.assessment.organ_surface import OrganSurface, Vec, unit

REST = 0.02
"""[m] over which a hand comes down"""


class Hand:
    """What moves the tool of one instrument: asked once a tick, told what is felt and seen."""

    def __init__(self, scene: palpate.Scene, task: palpate.Task, instrument: int = 0):
        self.scene, self.task, self.instrument = scene, task, instrument
        self.surface = OrganSurface(task, scene.instruments[instrument].tool.radius)
        self.position: Vec = self.surface.centre + self.surface.far * self.find_side()
        self.buttons = 0
        self.orientation: tuple[float, ...] = (0.0, 0.0, 0.0, 1.0)
        """(x, y, z, w) of the device."""

    def find_side(self) -> Vec:
        """Unit, from the middle of all: where its instrument waits, on the side of its trocar."""
        trocar = self.scene.instruments[self.instrument].trocar
        if trocar is not None:
            return unit(np.asarray(trocar) - self.surface.centre)
        return unit(np.array([0.5 * self.instrument, 0.0, 1.0]))

    def list_steps(self) -> list[int]:
        """The steps of the task that are its instrument's."""
        return [n for n, s in enumerate(self.task.steps) if s.instrument == self.instrument]

    def find_anchor(self, place: palpate.TaskPlace) -> tuple[Vec, Vec]:
        """The point [m] of a place to go to, and where from, a unit vector."""
        if place.kind is palpate.PlaceKind.object:
            return np.array(self.scene.rigid[place.body].position), self.find_side()
        if place.kind is palpate.PlaceKind.space:
            return np.array(place.points[0]), self.find_side()
        return self.surface.find_anchor(place)

    def see(self, world: palpate.World) -> None:
        """Looks where things are: asked every few ticks."""

    def move(self, time: float, dt: float, force: Vec, state: palpate.TaskState) -> None:
        """Goes on by dt [s], having felt a force [N]."""


class Idle(Hand):
    """Does nothing."""


class Jab(Hand):
    """Thrusts at every place with all its force, clicks there, and cares for nothing."""

    SPEED, DEPTH, STAY = 0.5, 0.03, 0.4

    def __init__(self, scene: palpate.Scene, task: palpate.Task, instrument: int = 0):
        super().__init__(scene, task, instrument)
        self.way: list[tuple[Vec, int]] = []
        self.next, self.wait = 0, 0.0
        steps = [task.steps[number] for number in self.list_steps()]
        self.places = [step.place for step in steps if step.place >= 0]

    def move(self, time: float, dt: float, force: Vec, state: palpate.TaskState) -> None:
        if self.wait > 0.0:
            self.wait -= dt
            return
        if not self.places:
            return
        if not self.way:
            place = self.task.places[self.places[self.next % len(self.places)]]
            self.next += 1
            anchor, normal = self.find_anchor(place)
            above = self.surface.above(anchor, normal, REST)
            deep = self.surface.above(anchor, normal, -self.DEPTH)
            ways = [(corner, 0) for corner in self.surface.find_way(self.position, above)]
            self.way = [*ways, (deep, 0), (deep, 1), (above, 1), (above, 0)]
        goal, buttons = self.way[0]
        self.buttons = buttons
        self.position, arrived = step_to(self.position, goal, self.SPEED * dt)
        if arrived:
            self.way.pop(0)
            self.wait = self.STAY if np.array_equal(goal, self.position) and not buttons else 0.05


def step_to(a: Vec, b: Vec, length: float) -> tuple[Vec, bool]:
    """From a so far [m] towards b, and whether that is there."""
    side = b - a
    distance = float(np.sqrt(side @ side))
    return (b, True) if distance <= length else (a + side * (length / distance), False)
