# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with an assessment, all of it at once."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import palpate
from palpate import scenario
from palpate.assessment.check_problem import ERROR, WARNING, Problem
from palpate.assessment.check_reach import check_limits, check_reach, check_times
from palpate.assessment.check_tools import check_tools
from palpate.assessment.provenance import find_void
from palpate.assessment.texts import UNITS, find_numbers

SEEDS = 20
"""As many attempts of each level are drawn."""
SHARE_OF_LIMIT = 0.8
"""[-] A target must lie below this part of a limit beside it, for hands tremble."""
SHARE_OF_TIME = 0.5
"""[-] All dwells together must take less than this part of the time limit."""

Json = Mapping[str, Any]


def find_problems(published: scenario.Scenario) -> list[Problem]:
    """Errors first. Of a scenario that has an assessment."""
    assessment = json.loads(published.assessment)
    found: dict[Problem, None] = {}
    built: set[str] = set()
    for level in scenario.list_levels(published) or [""]:
        for seed in range(SEEDS):
            try:
                drawn = scenario.draw_task(published, level, seed)
            except ValueError as problem:
                where = f"level {level or 'of all'}, seed {seed}"
                found[Problem(ERROR, where, str(problem))] = None
                continue
            for each in check_inclusion(published, drawn, built):
                found[each] = None
            for each in check_attempt(published.scene, drawn):
                found[each] = None
    tools = check_tools(published.scene, assessment)
    for each in [*tools, *check_texts(assessment), *check_goals(assessment)]:
        found[each] = None
    for where in find_void(published):
        text = "is of another task or organ than this file has now, and void"
        found[Problem(WARNING, where, text)] = None
    return sorted(found, key=lambda each: each.severity != ERROR)


def check_inclusion(
    published: scenario.Scenario, drawn: scenario.DrawnTask, built: set[str]
) -> Iterator[Problem]:
    """Whether the tissue with a stiff spot can be simulated; of each once."""
    if not drawn.inclusion or drawn.inclusion in built:
        return
    built.add(drawn.inclusion)
    try:
        scenario.draw_scene(published, drawn)
    except ValueError as problem:
        yield Problem(ERROR, f"places.{drawn.inclusion}.inclusion", str(problem))


def check_attempt(scene: palpate.Scene, drawn: scenario.DrawnTask) -> Iterator[Problem]:
    """What the numbers of one level and seed come to."""
    level = f" ({drawn.level})" if drawn.level else ""
    for number, (name, step) in enumerate(zip(drawn.steps, drawn.task.steps, strict=True)):
        where = f"steps.{name}{level}"
        device = scene.instruments[step.instrument].coupling.force_max
        least = step.force.least
        if least >= device:
            text = f"asks for {least:g} N, and the coupling gives {device:g} N at most"
            yield Problem(ERROR, where, text)
        yield from check_against_limits(drawn, number, where)
    yield from check_reach(scene, drawn, level)
    yield from check_limits(scene, drawn, level)
    yield from check_times(drawn, level)
    yield from check_order(drawn, level)
    dwells = sum(step.duration for step in drawn.task.steps)
    if dwells >= SHARE_OF_TIME * drawn.task.time_limit:
        text = (
            f"its steps last {dwells:g} s, more than half of the {drawn.task.time_limit:g} s "
            "there are"
        )
        yield Problem(ERROR, f"finish.time_limit_s{level}", text)


def check_against_limits(drawn: scenario.DrawnTask, number: int, where: str) -> Iterator[Problem]:
    """A band whose least lies so near a limit that no hand stays between."""
    step = drawn.task.steps[number]
    bands = {
        palpate.TaskMeasure.force: (step.force, "N"),
        palpate.TaskMeasure.depth: (step.depth, "m"),
        palpate.TaskMeasure.distance: (step.distance, "m"),
    }
    for name, limit in zip(drawn.limits, drawn.task.limits, strict=True):
        if limit.measure not in bands or not limit.above or limit.place >= 0:
            continue
        if limit.instrument != step.instrument:
            continue
        if limit.during and number not in limit.during:
            continue
        band, unit = bands[limit.measure]
        if band.least > SHARE_OF_LIMIT * limit.bound:
            text = (
                f"asks for {band.least:g} {unit}, more than {SHARE_OF_LIMIT:g} of the limit "
                f"{name} at {limit.bound:g} {unit}"
            )
            yield Problem(ERROR, where, text)


def check_order(drawn: scenario.DrawnTask, level: str) -> Iterator[Problem]:
    """A release is nothing to do where nothing was held before."""
    verbs = palpate.TaskVerb
    for number, (name, step) in enumerate(zip(drawn.steps, drawn.task.steps, strict=True)):
        if step.verb is not verbs.release:
            continue
        before = find_before(drawn.task, number)
        held = any(
            drawn.task.steps[other].verb in (verbs.grasp, verbs.pull)
            and drawn.task.steps[other].instrument == step.instrument
            for other in before
        )
        if not held:
            text = "releases what no step before it has held, so it is done at once"
            yield Problem(ERROR, f"steps.{name}{level}", text)


def find_before(task: palpate.Task, number: int) -> set[int]:
    """The steps that are done before a step begins."""
    before: set[int] = set()
    left = list(task.steps[number].after)
    while left:
        other = left.pop()
        if other not in before:
            before.add(other)
            left += task.steps[other].after
    return before


def check_goals(assessment: Json) -> Iterator[Problem]:
    """A goal of time that nobody can miss: the task is over before."""
    limit = assessment["finish"]["time_limit_s"]
    for number, goal in enumerate(assessment.get("goals", [])):
        most = goal.get("at_most")
        numbers = isinstance(most, int | float) and isinstance(limit, int | float)
        if goal["metric"] == "time" and numbers and most >= limit:
            text = f"is at most {most:g} s, and the task is over after {limit:g} s"
            yield Problem(WARNING, f"goals[{number}]", text)


def check_texts(assessment: Json) -> Iterator[Problem]:
    """Texts that a language lacks, numbers that no parameter has."""
    texts, parameters = assessment["texts"], assessment.get("parameters", {})
    for code, said in texts.items():
        for key in texts["en"]:
            if not said.get(key):
                severity = ERROR if code == "en" else WARNING
                yield Problem(severity, f"texts.{code}.{key}", "is missing")
        for key, text in said.items():
            for name, unit in find_numbers(text):
                if name not in parameters:
                    message = f"shows {{{name}:{unit}}}, and there is no parameter {name}"
                    yield Problem(ERROR, f"texts.{code}.{key}", message)
                elif unit not in UNITS:
                    message = f"shows {{{name}:{unit}}}: expected one of {', '.join(UNITS)}"
                    yield Problem(ERROR, f"texts.{code}.{key}", message)
