# SPDX-License-Identifier: BSD-3-Clause
"""A simulated hand that does what a task asks for, as well as its skill allows."""

from __future__ import annotations

import random
from collections import deque
from dataclasses import dataclass, replace

import numpy as np

import palpate
from palpate.assessment.hand import REST, Hand, step_to
from palpate.assessment.organ_surface import Vec, unit
from palpate.assessment.skill import Skill

VERBS = palpate.TaskVerb
GENTLE = 0.15
"""[N] where a task asks for no force of its own"""
SINK_SPEED = 0.025
"""[m/s] down to the tissue, and of what is held"""
PRESS_SPEED = 0.012
"""[m/s] into the tissue"""
SLIP_TIME, SLIP_SPEED = 0.3, 0.04
"""[s] and [m/s] of a lapse"""
DEEPEST = 0.03
"""[m]"""
GRIP_TIME = 0.1
"""[s] between a button and the pull"""


@dataclass
class Aim:
    """What a hand is doing about a step."""

    number: int
    """of the task"""
    anchor: Vec
    normal: Vec
    way: list[Vec]
    """[m] corners still to go through the air"""
    wait: float
    """[s]"""
    miss: float
    """[-] of what it aims at"""
    stiffness: float
    """[N/m] it expects"""
    depth: float = -REST
    """[m] commanded, of the tip below the surface at rest; negative above"""
    lift: float = 0.0
    """[m] commanded, of what is held"""
    since: float = 0.0
    """[s] it has been in contact, or held"""
    walked: float = 0.0
    """[m] of a path"""
    attached_at: float = 0.0
    """[m] the depth in which it took hold"""


class JawWork:
    """How a hand takes and pulls tissue with jaws: by what it sees, for the tissue between them is
    not where their tips are."""

    BITE = 0.6
    """[-] Of the length of the jaws: how deep they go in, open, before they close."""
    CLOSE_TIME = 0.4
    """[s]"""
    OPEN_TIME = 0.2
    """[s]"""
    BACK_TO = 1.0
    """[-] Of the bite: from where it closed to where it opens; in a dent open jaws are a barb."""
    SLIPPED = 0.85
    """[-] Of the force that was felt before."""
    BACK = 0.005
    """[m]"""

    def __init__(self, tool: palpate.Tool):
        self.bite = self.BITE * float(np.linalg.norm(tool.capsules[0].to - tool.capsules[0].from_))
        """[m]"""
        self.back = self.BACK_TO * self.bite
        """[m]"""
        self.begin()

    def begin(self) -> None:
        """Nothing has been pulled yet."""
        self.heading, self.was_met = 1.0, False
        self.force, self.gone = 0.0, 0.0

    def pull(self, met: bool, late: float, step: float) -> float:
        """[m] Of a `step` [m]: outwards until it is seen that this is far enough. What then is no
        longer so has slipped where less is felt (`late`, [N]), and is pulled on; else it has gone
        too far, and comes back, but not by more than BACK.
        """
        if met:
            self.force = max(late, self.force) if self.was_met else late
            self.was_met = True
            return 0.0
        if self.was_met:
            self.was_met, self.gone = False, 0.0
            self.heading = 1.0 if late < self.SLIPPED * self.force else -1.0
        self.gone += step
        if self.heading < 0.0 and self.gone > self.BACK:
            self.heading = 1.0
        return self.heading * step


class Person(Hand):
    """Does what the task asks for, step by step, as well as its skill allows."""

    def __init__(
        self,
        scene: palpate.Scene,
        task: palpate.Task,
        skill: Skill,
        seed: int,
        instrument: int = 0,
    ):
        super().__init__(scene, task, instrument)
        self.draw = random.Random(seed)
        self.skill = skill.vary(self.draw)
        self.aim: Aim | None = None
        self.base: Vec = self.position
        self.felt: deque[float] = deque()
        self.seen: deque[bool] = deque()
        self.shake = np.zeros((2, 3))
        self.lapse = 0.0
        held = scene.instruments[instrument]
        self.soft = 1.0 / held.coupling.stiffness
        self.give = self.soft + 1.0 / held.hold_stiffness
        self.mine = self.list_steps()
        self.jaws = None if held.tool.jaws is None else JawWork(held.tool)

    def move(self, time: float, dt: float, force: Vec, state: palpate.TaskState) -> None:
        self.felt.append(float(np.sqrt(force @ force)))
        self.seen.append(self.aim is not None and state.steps[self.aim.number].dwell > 0.0)
        met = self.seen.popleft() if len(self.seen) * dt > self.skill.delay else False
        late = self.felt.popleft() if len(self.felt) * dt > self.skill.delay else 0.0
        self.follow_task(state)
        if self.aim is not None:
            self.act(self.aim, dt, late, met)
        self.position = self.base + self.tremble(dt)

    def follow_task(self, state: palpate.TaskState) -> None:
        """Turns to the first step that is to be done."""
        active = [n for n in self.mine if state.steps[n].status is palpate.StepStatus.active]
        if not active or (self.aim is not None and self.aim.number in active):
            return
        self.aim = self.turn_to(active[0])

    def turn_to(self, number: int) -> Aim:
        step, old = self.task.steps[number], self.aim
        miss = 1.0 + self.draw.gauss(0.0, self.skill.error)
        stiffness = 60.0 * self.draw.lognormvariate(0.0, self.skill.stiffness_error)
        same = old is not None and self.buttons != 0 and step.verb in (VERBS.pull, VERBS.release)
        if same and old is not None:  # goes on with what it holds
            lift, at, since = old.lift, old.attached_at, old.since
            return Aim(number, old.anchor, old.normal, [], self.skill.pause, miss, stiffness,
                       old.depth, lift, since, 0.0, at)  # fmt: skip
        self.buttons = 0
        anchor, normal = self.find_anchor(self.task.places[step.place])
        near = old is not None and bool(np.allclose(anchor, old.anchor))
        if near and old is not None:
            return replace(old, number=number, wait=self.skill.pause, miss=miss, since=0.0)
        above = self.surface.above(anchor, normal, REST)
        start = self.base
        if old is not None:
            start = self.surface.above(old.anchor, old.normal, REST)
        way = [start, *self.surface.find_way(start, above)]
        return Aim(number, anchor, normal, way, self.skill.pause, miss, stiffness)

    def act(self, aim: Aim, dt: float, late: float, met: bool) -> None:
        """One tick of what the step asks for, which it sees to be met or not."""
        if aim.wait > 0.0:
            aim.wait -= dt
            return
        if aim.way:
            self.base, arrived = step_to(self.base, aim.way[0], self.skill.speed * dt)
            if arrived:
                aim.way.pop(0)
            return
        step = self.task.steps[aim.number]
        if step.verb in (VERBS.pull, VERBS.grasp, VERBS.release):
            self.handle(aim, step, dt, late, met)
        elif step.verb is VERBS.trace:
            self.walk(aim, step, dt, late)
        else:
            self.press(aim, step, dt, late)
        self.base = self.surface.above(aim.anchor, aim.normal, aim.lift - aim.depth)

    def press(self, aim: Aim, step: palpate.TaskStep, dt: float, late: float) -> None:
        """Into the tissue to a depth, or until a force is felt, and keeps it there."""
        self.seek(aim, step, dt, late)
        aim.depth += self.slip(dt)
        if step.verb is not VERBS.find:
            return
        ready = max(0.5 * GENTLE, step.force.least) < late <= step.force.most
        aim.since = aim.since + dt if ready else 0.0
        self.buttons = 1 if aim.since > 0.3 else 0

    def seek(self, aim: Aim, step: palpate.TaskStep, dt: float, late: float) -> None:
        depth = middle(step.depth)
        if depth is not None:
            goal = aim.miss * depth + self.soft * late
            speed = SINK_SPEED if aim.depth < 0.0 else PRESS_SPEED
            aim.depth += clamp(goal - aim.depth, speed * dt)
            return
        goal = aim.miss * (middle(step.force) or GENTLE)
        if late < 0.02 and aim.depth < 0.002:  # not there yet
            aim.depth += SINK_SPEED * dt
            return
        if aim.depth > 0.001 and late > 0.02:  # learns what it feels
            aim.stiffness += (late / max(aim.depth, 0.001) - aim.stiffness) * min(1.0, 4.0 * dt)
        change = self.skill.gain * (goal - late) / max(aim.stiffness, 10.0)
        aim.depth = min(aim.depth + clamp(change, PRESS_SPEED) * dt, DEEPEST)

    def walk(self, aim: Aim, step: palpate.TaskStep, dt: float, late: float) -> None:
        """Along a path once it feels the tissue."""
        place = self.task.places[step.place]
        self.seek(aim, step, dt, late)
        aim.depth += self.slip(dt)
        goal = middle(step.force) or GENTLE
        if abs(late - goal) < 0.4 * goal or aim.walked > 0.0:
            aim.walked += 0.2 * self.skill.speed * dt
        arc, points = np.asarray(place.arc_length), np.asarray(place.points)
        at = min(aim.walked, float(arc[-1]))
        point = np.array([np.interp(at, arc, points[:, k]) for k in range(3)])
        aim.anchor, normal = self.surface.find_nearest(place.body, point)
        aim.normal = unit(aim.normal + (normal - aim.normal) * min(1.0, 20.0 * dt))

    def handle(self, aim: Aim, step: palpate.TaskStep, dt: float, late: float, met: bool) -> None:
        """Takes hold of what is pressed gently, moves it outwards, lets it go."""
        if step.verb is VERBS.release:
            self.let_go(aim, dt)
            return
        if self.buttons == 0:
            self.take_hold(aim, step, dt, late)
            return
        aim.since += dt
        closed = GRIP_TIME if self.jaws is None else self.jaws.CLOSE_TIME
        if step.verb is VERBS.grasp or aim.since < closed:
            return
        if late < 0.01 and aim.lift - aim.attached_at > 0.01:  # it has slipped: once more
            self.buttons, aim.lift, aim.depth = 0, 0.0, -REST
            aim.way = [self.surface.above(aim.anchor, aim.normal, REST)]
            return
        distance = middle(step.distance)
        if distance is not None and self.jaws is not None:
            aim.lift += self.jaws.pull(met, late, 0.06 * self.skill.speed * dt) + self.slip(dt)
            return
        if distance is not None:
            there = aim.lift - aim.attached_at - self.give * late
            aim.lift += clamp(4.0 * (aim.miss * distance - there), SINK_SPEED) * dt + self.slip(dt)
            return
        goal = aim.miss * (middle(step.force) or GENTLE)
        change = self.skill.gain * (goal - late) / max(aim.stiffness, 10.0)
        aim.lift += clamp(change, SINK_SPEED) * dt + self.slip(dt)

    def take_hold(self, aim: Aim, step: palpate.TaskStep, dt: float, late: float) -> None:
        """With a button at what is pressed gently, or with open jaws in what lies between them."""
        if self.jaws is not None:
            speed = SINK_SPEED if aim.depth < 0.0 else PRESS_SPEED
            aim.depth += clamp(self.jaws.bite - aim.depth, speed * dt)
            if aim.depth < self.jaws.bite:
                return
            self.jaws.begin()
            self.buttons, aim.since, aim.attached_at = 1, 0.0, aim.depth
            return
        self.seek(aim, step if step.verb is VERBS.grasp else palpate.TaskStep(), dt, late)
        if late > 0.6 * GENTLE:
            self.buttons, aim.since, aim.attached_at = 1, 0.0, aim.depth - self.soft * late

    def let_go(self, aim: Aim, dt: float) -> None:
        """Once it is back where nothing pulls; jaws are open before they are drawn out."""
        back, opening = (0.0, 0.0) if self.jaws is None else (self.jaws.back, self.jaws.OPEN_TIME)
        if aim.lift > back:
            aim.lift = max(aim.lift - SINK_SPEED * dt, back)
            return
        if self.buttons:
            self.buttons, aim.since = 0, 0.0
        aim.since += dt
        if aim.since >= opening and aim.depth > -REST:
            aim.depth -= SINK_SPEED * dt

    def slip(self, dt: float) -> float:
        """[m] that it goes on in a lapse, whatever it aims at."""
        self.lapse -= dt
        if self.lapse < -SLIP_TIME and self.draw.random() < self.skill.lapses * dt:
            self.lapse = SLIP_TIME
        return SLIP_SPEED * dt if self.lapse > 0.0 else 0.0

    def tremble(self, dt: float) -> Vec:
        """[m] Noise through a resonance at 9 Hz with a quality of 3."""
        w = 2.0 * np.pi * 9.0
        x, v = self.shake
        push = np.array([self.draw.gauss(0.0, 1.0) for _ in range(3)])
        size = self.skill.tremor * np.sqrt(w**3 * 2.0 / 3.0 / dt)
        v = v + dt * (-w * w * x - w / 3.0 * v + size * push)
        self.shake = np.array([x + dt * v, v])
        return self.shake[0]


def middle(band: palpate.Band) -> float | None:
    """Where in a band to aim; None without bounds."""
    if band.least == -np.inf and band.most == np.inf:
        return None
    if band.most == np.inf:
        return 1.25 * band.least
    if band.least == -np.inf:
        return 0.6 * band.most
    return 0.5 * (band.least + band.most)


def clamp(value: float, most: float) -> float:
    return min(max(value, -most), most)
