# SPDX-License-Identifier: BSD-3-Clause
"""A scenario played by simulated hands, without a clock, before anybody else plays it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import palpate
from palpate import scenario
from palpate.assessment.hands import HANDS, make_hand
from palpate.command.verb import Report

SEEDS = 3
"""Of each level, before a task is published"""
GLANCE = 10
"""[ticks] between two looks at how far the task is"""


@dataclass
class Attempt:
    """What a hand did, and what came of it."""

    hand: str
    drawn: scenario.DrawnTask
    state: palpate.TaskState
    samples: list[palpate.HapticSample] = field(default_factory=list)
    events: list[Any] = field(default_factory=list)
    forces: list[float] = field(default_factory=list)
    """[N] size, per tick"""

    def describe(self) -> Report:
        """In a line of a report."""
        opened = {
            name: limit.count
            for name, limit in zip(self.drawn.limits, self.state.limits, strict=True)
            if limit.count
        }
        waiting = [
            name
            for name, step in zip(self.drawn.steps, self.state.steps, strict=True)
            if step.status is not palpate.StepStatus.done
        ]
        return {
            "hand": self.hand,
            "level": self.drawn.level,
            "seed": self.drawn.seed,
            "outcome": self.state.outcome.name,
            "time_s": self.state.time,
            "errors": self.state.errors,
            "warnings": self.state.warnings,
            "peak_force_N": self.state.peak_force,
            "limits": opened,
            "not_done": waiting,
        }


def never() -> bool:
    return False


def attempt(
    scene: palpate.Scene,
    drawn: scenario.DrawnTask,
    hand: str,
    stopped: Callable[[], bool] = never,
) -> Attempt:
    """One of HANDS at a task, in as many ticks as that takes; a jab is over with its first error,
    for it cannot finish without one any more. `stopped` is asked every few ticks, and ends it.
    """
    task, dt = drawn.task, 1.0 / scene.rate
    world, progress = palpate.World(scene), palpate.Progress(task)
    person = make_hand(hand, scene, task, drawn.seed)
    command = palpate.HapticCommand()
    played = Attempt(hand, drawn, progress.state)
    tick = 0
    while played.state.outcome is palpate.Outcome.running:
        person.move(tick * dt, dt, np.asarray(command.force), played.state)
        sample = palpate.HapticSample(
            time=tick * dt, position=person.position, buttons=person.buttons
        )
        command = palpate.tick(scene, sample, dt, world)
        palpate.judge(task, world, [sample], [command], dt, progress)
        played.samples.append(sample)
        played.forces.append(float(np.linalg.norm(command.force)))
        if progress.event_count:
            played.events.extend(progress.events)
        if progress.event_count or tick % GLANCE == 0:
            played.state = progress.state
        if hand == "jab" and played.state.errors > 0:
            played.state = progress.state
            break
        if tick % GLANCE == 0 and stopped():
            break
        tick += 1
    return played


def play_all(
    published: scenario.Scenario,
    seeds: Iterable[int],
    tell: Callable[[Attempt], None] = lambda played: None,
) -> list[Attempt]:
    """Every hand at every level and seed; who does nothing, at one seed of each level."""
    played = []
    seeds = list(seeds)
    for level in scenario.list_levels(published) or [""]:
        for seed in seeds:
            drawn = scenario.draw_task(published, level, seed)
            scene = scenario.draw_scene(published, drawn)
            for hand in HANDS:
                if hand == "idle" and seed != seeds[0]:
                    continue
                one = attempt(scene, drawn, hand)
                one.samples.clear()
                tell(one)
                played.append(one)
    return played


def judge_hands(played: Iterable[Attempt]) -> list[Report]:
    """What these attempts say against the scenario: errors and warnings, worst first."""
    played, problems = list(played), []
    for one in played:
        done = one.state.outcome is palpate.Outcome.done
        clean = done and one.state.errors == 0
        where = f"{one.hand}, level {one.drawn.level or 'of all'}, seed {one.drawn.seed}"
        if one.hand == "careful" and not clean:
            told = one.describe()
            text = f"{told['outcome']} with {told['errors']} errors"
            text += f", limits {told['limits']}" if told["limits"] else ""
            text += f", not done {told['not_done']}" if told["not_done"] else ""
            problems.append(
                say("error", where, f"a careful hand should finish without error: {text}")
            )
        if one.hand in ("idle", "jab") and clean:
            text = "finishes without error, and should not"
            problems.append(say("error", where, text))
    clumsy = [one for one in played if one.hand == "clumsy"]
    if clumsy and not any(one.state.errors for one in clumsy):
        text = f"none of {len(clumsy)} attempts has an error: the scenario tells nobody apart"
        problems.append(say("warning", "clumsy", text))
    return problems


def say(severity: str, where: str, message: str) -> Report:
    return {"severity": severity, "where": where, "message": message}
