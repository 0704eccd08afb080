# SPDX-License-Identifier: BSD-3-Clause
"""Scripted hands for the scenario of the kidney stone: a careful one, from which wrong ones are
made by other goals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import palpate
from palpate import scenario
from palpate_meshes.generate.collecting_system import ENTRY, MOUTH
from palpate_meshes.stone_scene import TRAY, find_turn

TICK = 1e-3
GRASPER, SCOPE = 0, 1
CALYX, TRACT_MOUTH = (1e-3 * find_turn().apply(point) for point in (ENTRY, MOUTH))
OUTWARDS = (TRACT_MOUTH - CALYX) / np.linalg.norm(TRACT_MOUTH - CALYX)
BEFORE_MOUTH = TRACT_MOUTH + 0.03 * OUTWARDS
PUT = np.array(TRAY) + (0.0, 0.0, 0.009)
OVER = np.array([PUT[0], PUT[1], 0.012])
LOOKS_FROM = np.array([0.0831, -0.0141, 0.0259])
"""[m] Where the laparoscope's tip sees the stone along the tract, out of the grasper's way."""
ASIDE = LOOKS_FROM + (0.03, 0.02, 0.04)
"""[m] Where it begins, and sees nothing of it."""


@dataclass
class Goal:
    """Where a hand goes, and what it does there."""

    to: np.ndarray
    """[m]"""
    closed: bool = True
    speed: float = 0.05
    """[m/s]"""
    stay: float = 0.1
    """[s]"""


def take(stone: np.ndarray, reach: float = 0.002) -> list[Goal]:
    """In with closed jaws, open before the stone, `reach` [m] past its middle, and closed."""
    before = stone + 0.008 * OUTWARDS + (0.0, 0.0, 0.001)
    around = stone - reach * OUTWARDS + (0.0, 0.0, 0.001)
    return [
        Goal(BEFORE_MOUTH),
        Goal(CALYX + 0.014 * OUTWARDS - (0.0, 0.0, 0.001)),
        Goal(before),
        Goal(before, closed=False, stay=0.2),
        Goal(around, closed=False, speed=0.02),
        Goal(around, stay=0.6),
    ]


def draw_out() -> list[Goal]:
    return [Goal(CALYX + 0.012 * OUTWARDS, speed=0.02), Goal(BEFORE_MOUTH)]


def put_down(at: np.ndarray = PUT) -> list[Goal]:
    over = np.array([at[0], at[1], OVER[2]])
    return [Goal(over), Goal(at, stay=0.5), Goal(at, closed=False, stay=0.6),
            Goal(over, closed=False, stay=0.3)]  # fmt: skip


def look() -> list[Goal]:
    """Of the laparoscope: to where it sees the stone, and on."""
    return [Goal(LOOKS_FROM, stay=1.5)]


@dataclass
class Verdict:
    """How the judge found it."""

    outcome: palpate.Outcome
    time: float
    """[s]"""
    opened: dict[str, int]
    """Limits, how often"""
    worst: dict[str, float]
    overdue: list[str]
    waiting: list[str]
    """Steps that were not done"""
    events: list[tuple[int, int, int, float]] = field(default_factory=list)
    samples: list[tuple[palpate.HapticSample, palpate.HapticSample]] = field(default_factory=list)


class Driver:
    """Brings one instrument from goal to goal."""

    turn = (0.0, 0.0, 0.0, 1.0)

    def __init__(self, start: np.ndarray, goals: Sequence[Goal]):
        self.at, self.closed = np.asarray(start, dtype=float), True
        self.goals, self.left = list(goals), 0.0
        if self.goals:
            self.left = self.goals[0].stay

    def move(self) -> palpate.HapticSample:
        if self.goals:
            goal = self.goals[0]
            self.closed = goal.closed
            side = goal.to - self.at
            far, step = float(np.linalg.norm(side)), goal.speed * TICK
            if far > step:
                self.at = self.at + step / far * side
            else:
                self.at, self.left = goal.to, self.left - TICK
            if far <= step and self.left <= 0.0:
                self.goals.pop(0)
                self.left = self.goals[0].stay if self.goals else 0.0
        return palpate.HapticSample(
            position=self.at,
            orientation=self.turn,
            buttons=palpate.ATTACH_BUTTON if self.closed else 0,
        )


def find_lying(scene: palpate.Scene) -> np.ndarray:
    """[m] Where the stone comes to lie."""
    world = palpate.World(scene)
    parked = [
        palpate.HapticSample(position=BEFORE_MOUTH + 0.1),
        palpate.HapticSample(position=ASIDE),
    ]
    for _ in range(1000):
        palpate.tick(scene, parked, TICK, world)
    return np.asarray(world.rigid[0].position)


def play(
    made: scenario.Scenario,
    grasper: Sequence[Goal],
    scope: Sequence[Goal],
    level: str = "",
    most: float = 1e9,
) -> Verdict:
    """Both hands at once, the grasper after the laparoscope has looked, until it is over or
    `most` [s]."""
    drawn = scenario.draw_task(made, level, 0)
    scene = made.scene
    world, progress = palpate.World(scene), palpate.Progress(drawn.task)
    hands = [Driver(BEFORE_MOUTH, grasper), Driver(ASIDE, scope)]
    hands[0].turn = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    events, kept = [], []
    waits = 2.6 if scope else 0.0
    while progress.state.outcome is palpate.Outcome.running:
        now = world.tick_count * TICK
        idle = now < waits
        samples = [
            palpate.HapticSample(
                position=hands[0].at, orientation=hands[0].turn, buttons=palpate.ATTACH_BUTTON
            )
            if idle
            else hands[0].move(),
            hands[1].move(),
        ]
        commands = palpate.tick(scene, samples, TICK, world)
        palpate.judge(drawn.task, world, samples, commands, TICK, progress)
        kept.append(tuple(samples))
        if progress.event_count:
            events += [tuple(row) for row in progress.events.tolist()]
        over = not hands[0].goals and not hands[1].goals and now > most
        if over:
            break
    state = progress.state
    limits = dict(zip(drawn.limits, state.limits, strict=True))
    steps = dict(zip(drawn.steps, state.steps, strict=True))
    return Verdict(
        state.outcome,
        state.time,
        {name: limit.count for name, limit in limits.items() if limit.count},
        {name: limit.worst for name, limit in limits.items()},
        [name for name, step in steps.items() if step.overdue],
        [name for name, step in steps.items() if step.status is not palpate.StepStatus.done],
        events,
        kept,
    )
