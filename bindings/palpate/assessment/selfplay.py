# SPDX-License-Identifier: BSD-3-Clause
"""A scenario played by simulated hands, without a clock, before anybody else plays it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from threading import Event
from typing import Any

import numpy as np

import palpate
from palpate import scenario
from palpate.assessment.hands import HANDS, make_hands
from palpate.command.verb import Report
from palpate.system.processor import count_processors

SEEDS = 3
"""Of each level, before a task is published"""
GLANCE = 10
"""[ticks] between two looks at how far the task is, and where things are"""


@dataclass
class Attempt:
    """What a hand did, and what came of it."""

    hand: str
    drawn: scenario.DrawnTask
    state: palpate.TaskState
    samples: list[list[palpate.HapticSample]] = field(default_factory=list)
    """Of each instrument, per tick"""
    events: list[Any] = field(default_factory=list)
    forces: list[float] = field(default_factory=list)
    """[N] size, per tick, the largest of all instruments"""

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
    until_error: bool = False,
) -> Attempt:
    """One of HANDS at a task, in as many ticks as that takes; a jab is over with its first error,
    for it cannot finish without one any more, and so is any hand where that is all that is asked
    (`until_error`). `stopped` is asked every few ticks, and ends it.
    """
    task, dt = drawn.task, 1.0 / scene.rate
    world, progress = palpate.World(scene), palpate.Progress(task)
    hands = make_hands(hand, scene, task, drawn.seed)
    commands = [palpate.HapticCommand() for _ in hands]
    played = Attempt(hand, drawn, progress.state, [[] for _ in hands])
    tick = 0
    while played.state.outcome is palpate.Outcome.running:
        samples = []
        if tick % GLANCE == 0:
            for each in hands:
                each.see(world)
        for each, command, kept in zip(hands, commands, played.samples, strict=True):
            each.move(tick * dt, dt, np.asarray(command.force), played.state)
            sample = palpate.HapticSample(
                time=tick * dt,
                position=each.position,
                orientation=each.orientation,
                buttons=each.buttons,
            )
            samples.append(sample)
            kept.append(sample)
        commands = palpate.tick(scene, samples, dt, world)
        palpate.judge(task, world, samples, commands, dt, progress)
        played.forces.append(max(float(np.linalg.norm(each.force)) for each in commands))
        if progress.event_count:
            played.events.extend(progress.events)
        if progress.event_count or tick % GLANCE == 0:
            played.state = progress.state
        if (until_error or hand == "jab") and played.state.errors > 0:
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
    workers: int | None = None,
) -> list[Attempt]:
    """Every hand at every level and seed; who does nothing, at one seed of each level.

    So many attempts run at once, each in a thread of its own, for a tick leaves Python to the
    others; as many as there are processors without a number. `tell` hears of each as it ends, and
    may raise, which gives up the others.
    """
    stop = Event()
    jobs = list_jobs(published, list(seeds))
    with ThreadPoolExecutor(workers or count_processors()) as pool:
        begun = {pool.submit(play_job, job, stop): number for number, job in enumerate(jobs)}
        played: dict[int, Attempt] = {}
        try:
            for future in as_completed(begun):
                played[begun[future]] = one = future.result()
                tell(one)
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    return [played[number] for number in range(len(jobs))]


Job = tuple[palpate.Scene, scenario.DrawnTask, str]


def list_jobs(published: scenario.Scenario, seeds: list[int]) -> list[Job]:
    """Scene, task and hand of each attempt, in the order of a report."""
    jobs: list[Job] = []
    scenes: dict[str, palpate.Scene] = {}
    for level in scenario.list_levels(published) or [""]:
        for seed in seeds:
            drawn = scenario.draw_task(published, level, seed)
            if drawn.inclusion not in scenes:
                scenes[drawn.inclusion] = scenario.draw_scene(published, drawn)
            hands = [hand for hand in HANDS if hand != "idle" or seed == seeds[0]]
            jobs += [(scenes[drawn.inclusion], drawn, hand) for hand in hands]
    return jobs


def play_job(job: Job, stop: Event) -> Attempt:
    scene, drawn, hand = job
    # whether a clumsy hand errs is all that is asked of it
    one = attempt(scene, drawn, hand, stop.is_set, until_error=hand == "clumsy")
    one.samples.clear()
    return one


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
