# SPDX-License-Identifier: BSD-3-Clause
"""A simulated hand that looks at objects, takes them and brings them elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

import palpate
from palpate.assessment.free_ways import (
    Hollows,
    find_lookout,
    find_thinnest_roll,
    roll_about_shaft,
)
from palpate.assessment.hand import step_to
from palpate.assessment.organ_surface import Vec, unit
from palpate.assessment.person import Person
from palpate.assessment.skill import Skill

VERBS, KINDS = palpate.TaskVerb, palpate.PlaceKind
BEFORE, PAST = 0.008, 0.004
"""[m] From the middle of an object: where jaws open, and where they close beyond it."""
INSIDE_SPEED, SLOW = 0.05, 0.02
"""[m/s] in what is hollow, and at the object."""
AWAY = 0.7
"""[-] Of the way from an object to the trocar: where a hand waits."""
ABOVE = 0.03
"""[m] over a space, from where a hand comes down into it."""
LIFT = 0.001
"""[m] Jaws are above the middle of what lies: it is taken up with them."""
AGAIN = 1.0
"""[s] after which what has not come about is tried once more."""


@dataclass
class Goal:
    """Where a hand goes, and what it does there."""

    to: Vec
    """[m]"""
    closed: bool
    speed: float
    """[m/s]"""
    stay: float = 0.1
    """[s]"""


def moves_objects(task: palpate.Task, instrument: int) -> bool:
    """Whether an instrument has a step at an object, or looks."""
    steps = [step for step in task.steps if step.instrument == instrument]
    return any(is_of_objects(task, step) for step in steps)


def is_of_objects(task: palpate.Task, step: palpate.TaskStep) -> bool:
    if step.verb is VERBS.look:
        return True
    return step.place >= 0 and task.places[step.place].kind is KINDS.object


class Mover(Person):
    """Goes through what is hollow to an object, and out again the same way."""

    def __init__(
        self, scene: palpate.Scene, task: palpate.Task, skill: Skill, seed: int, instrument: int = 0
    ):
        super().__init__(scene, task, skill, seed, instrument)
        self.hollows = Hollows(task)
        self.places = [np.array(body.position) for body in scene.rigid]
        self.turns = [np.array(body.orientation) for body in scene.rigid]
        self.goals: list[Goal] = []
        self.number, self.left, self.past_end = -1, 0.0, 0.0
        self.held = np.zeros(3)
        trocar = scene.instruments[instrument].trocar
        self.trocar = None if trocar is None else np.asarray(trocar)
        gravity = np.array(scene.gravity)
        self.up = -unit(gravity) if np.linalg.norm(gravity) > 0.0 else np.array([0.0, 0.0, 1.0])
        self.closes = scene.instruments[instrument].tool.jaws is not None
        self.buttons = int(self.closes)
        self.ahead = np.zeros(3)

    def see(self, world: palpate.World) -> None:
        self.places = [np.array(body.position) for body in world.rigid]

    def move(self, time: float, dt: float, force: Vec, state: palpate.TaskState) -> None:
        active = [n for n in self.mine if state.steps[n].status is palpate.StepStatus.active]
        if active and not is_of_objects(self.task, self.task.steps[active[0]]):
            super().move(time, dt, force, state)
            return
        if active and active[0] != self.number:
            self.number, self.left = active[0], self.skill.pause
            self.goals = self.plan(self.task.steps[self.number])
            self.past_end = 0.0
        self.follow(dt)
        if active and not self.goals:
            self.past_end += dt
            if self.past_end > AGAIN:  # it has not come about
                self.number = -1
        self.position = self.base + self.tremble(dt)

    def follow(self, dt: float) -> None:
        """Goes on to the next goal. A hand that slips while it waits goes on as it last went."""
        if self.left > 0.0 or not self.goals:
            self.left -= dt
            if self.skill.lapses > 0.0:
                self.base = self.base + self.ahead * self.slip(dt)
                self.hold()
            return
        goal = self.goals[0]
        self.ahead = unit(goal.to - self.base)
        self.base, arrived = step_to(self.base, goal.to, goal.speed * dt)
        self.base = self.base + self.ahead * self.slip(dt)
        self.closes = goal.closed
        self.hold()
        if arrived:
            self.goals.pop(0)
            self.left = goal.stay

    def hold(self) -> None:
        """A finger slips as well."""
        self.buttons = 1 if self.closes and self.lapse <= 0.0 else 0

    def find_outside(self, place: Vec) -> Vec:
        """[m] On the way from a point to the trocar, or over it."""
        if self.trocar is None:
            return place + self.surface.far * self.up
        return np.asarray(place + AWAY * (self.trocar - place))

    def plan(self, step: palpate.TaskStep) -> list[Goal]:
        place = self.task.places[step.place]
        if step.verb is VERBS.look:
            return self.plan_look(step, place)
        if step.verb is VERBS.grasp:
            return self.plan_grasp(place.body)
        if step.verb is VERBS.remove:
            out = self.find_outside(self.base)
            way = self.hollows.keep_to_middle(self.base, out)
            speeds = [SLOW, SLOW, *[INSIDE_SPEED] * len(way)]
            return [Goal(to, True, speed, 0.0) for to, speed in zip(way, speeds, strict=False)]
        if step.verb is VERBS.carry:
            space = self.task.places[step.space]
            self.held = self.base - self.places[place.body]
            put = np.array(space.points[0]) + 0.4 * space.radius * self.up + self.held
            over = put + ABOVE * self.up
            return [Goal(over, True, INSIDE_SPEED), Goal(put, True, INSIDE_SPEED, 0.4)]
        return [
            Goal(self.base, False, SLOW, 0.6),
            Goal(self.base + ABOVE * self.up, False, INSIDE_SPEED),
        ]

    def plan_grasp(self, rigid: int) -> list[Goal]:
        """In with closed jaws, open before the object, past its middle, closed."""
        place = self.places[rigid]
        miss = 1.0 + self.draw.gauss(0.0, self.skill.error)
        outside = self.find_outside(place)
        shaft = unit(outside - place)
        mesh = np.asarray(self.scene.rigid[rigid].mesh.vertices)
        turned = self.turn(rigid, mesh) + place
        self.orientation = roll_about_shaft(find_thinnest_roll(turned, shaft))
        before = place + BEFORE * miss * shaft + LIFT * self.up
        around = place - PAST * miss * shaft + LIFT * self.up
        way = self.hollows.keep_to_middle(outside, before)
        return [
            Goal(outside, True, self.skill.speed),
            *(Goal(to, True, INSIDE_SPEED, 0.0) for to in way),
            Goal(before, False, SLOW, 0.3),
            Goal(around, False, SLOW, 0.2),
            Goal(around, True, SLOW, 0.6),
        ]

    def plan_look(self, step: palpate.TaskStep, place: palpate.TaskPlace) -> list[Goal]:
        """To where it is seen; nowhere, where that is not known."""
        camera = next(c for c in self.task.cameras if c.instrument == self.instrument)
        if self.trocar is None:
            return []
        tool = self.scene.instruments[self.instrument].tool
        found = find_lookout(camera, self.trocar, self.find_points(place), step.distance,
                             self.hollows, tool.radius + 0.004)  # fmt: skip
        if found is None:
            return []
        tip, roll = found
        self.orientation = roll_about_shaft(roll)
        return [Goal(tip, False, self.skill.speed, step.duration + 0.5)]

    def find_points(self, place: palpate.TaskPlace) -> Vec:
        """[m] (n, 3) by which a place is seen."""
        if place.kind is KINDS.object:
            centres = np.asarray(self.scene.rigid[place.body].sphere_centres)
            return self.turn(place.body, centres) + self.places[place.body]
        if place.kind is KINDS.space:
            return np.array(place.points, dtype=float)
        return np.asarray(self.surface.vertices[place.body][np.asarray(place.seen)])

    def turn(self, rigid: int, points: Vec) -> Vec:
        """As the object is turned at the start."""
        return np.asarray(Rotation.from_quat(self.turns[rigid]).apply(points))
