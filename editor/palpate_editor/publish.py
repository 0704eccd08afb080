# SPDX-License-Identifier: GPL-3.0-or-later
"""From a designer's document to the file that a trainee opens."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from palpate import FileError, Scene, scenario
from palpate.assessment.author import without_muted
from palpate.assessment.check import find_problems
from palpate.assessment.check_problem import ERROR
from palpate.assessment.provenance import describe_selfplay, hash_content, with_selfplay
from palpate.assessment.publish import with_assessment
from palpate.assessment.selfplay import SEEDS, Attempt, play_all
from palpate.command.verb import Report
from palpate.scene.scene_file import hash_file

from palpate_editor.check import Assessment, assess, describe_model, describe_problem
from palpate_editor.document import Organ, phrase
from palpate_editor.document.cost_rules import LATE
from palpate_editor.document.files import FORMAT, VERSION, pack_organ
from palpate_editor.document.problems import Problem


class PublishError(Exception):
    """An organ that nobody should be given: all that is wrong with it."""

    def __init__(self, problems: tuple[Problem, ...]):
        self.problems = problems
        text = "; ".join(f"{p.where}: got {p.got}, expected {p.expected}" for p in problems)
        super().__init__(text)


def tell_nobody(played: Attempt) -> None:
    del played


def publish(
    organ: Organ,
    path: Path,
    assessment: Assessment | None = None,
    slow: bool = False,
    tried: Report | None = None,
    tell: Callable[[Attempt], None] = tell_nobody,
) -> Report:
    """Checks, compiles and writes, whole or not at all: a second for a large one, on any thread,
    and as long as simulated hands need where there is a task, which they try out first.

    The document itself goes into the file, so that it can be opened again and worked on; where the
    mesh file lay on the designer's machine, and what was done to the organ step by step, does not.

    Args:
        organ: What is published.
        path: A name ending in .palpate.
        assessment: Of the very same organ, if there is one.
        slow: Whether it may be late on the reference machine: for a faster one.
        tried: A report of describe_selfplay, if hands have played; of another task it does not
            count, and they play again.
        tell: Hears of every attempt; may raise, which ends the work.

    Raises PublishError with every error there is; FileError where the disk refuses.
    """
    if assessment is None or assessment.organ is not organ or assessment.scene is None:
        assessment = assess(organ)
    errors = find_errors(assessment, slow)
    if errors or assessment.scene is None:
        raise PublishError(errors or assessment.errors)
    made = judge_task(path, make_scenario(organ, assessment.scene, path))
    made = try_task(made, tried, tell)
    write(made, path)
    return {
        "out": str(path),
        "title": organ.title,
        "task": organ.task,
        "languages": list(organ.languages),
        "vertices": organ.vertex_count,
        "description": describe_model(assessment.scene),
        "bytes": path.stat().st_size,
        "sha256": hash_file(path),
        "problems": list(map(describe_problem, assessment.problems)),
    }


def find_errors(assessment: Assessment, slow: bool) -> tuple[Problem, ...]:
    """What prevents publishing, where what is slow may be published or not."""
    return tuple(p for p in assessment.errors if not (slow and p.key == LATE))


def write_scenario(organ: Organ, scene: Scene, path: Path) -> None:
    """Without asking whether it should be published. Raises FileError or Refusal."""
    write(make_scenario(organ, scene, path), path)


def judge_task(path: Path, made: scenario.Scenario) -> scenario.Scenario:
    """The very same, where nothing is wrong with its task. Raises PublishError."""
    if not made.assessment:
        return made
    problems = tuple(
        Problem("task", "error", "scenario", found.where, phrase("{text}", text=found.message),
                phrase("a task that can be done and judged"))
        for found in find_problems(made)
        if found.severity == ERROR
    )  # fmt: skip
    if problems:
        raise PublishError(problems)
    return made


def try_task(
    made: scenario.Scenario, tried: Report | None, tell: Callable[[Attempt], None]
) -> scenario.Scenario:
    """With the report of hands that have played it in it: careful ones finish, idle and violent
    ones do not. Raises PublishError.
    """
    if not made.assessment:
        return made
    if tried is None or tried["content_sha256"] != hash_content(made):
        tried = describe_selfplay(made, play_all(made, range(SEEDS), tell))
    problems = tuple(
        Problem("task", "error", "scenario", found["where"],
                phrase("{text}", text=found["message"]),
                phrase("a task that careful hands finish, and idle or violent ones do not"))
        for found in tried["problems"]
        if found["severity"] == ERROR
    )  # fmt: skip
    if problems:
        raise PublishError(problems)
    return with_selfplay(made, tried)


def make_scenario(organ: Organ, scene: Scene, path: Path) -> scenario.Scenario:
    """What a trainee opens. Raises Refusal, which calls it `path`, for a task that is none."""
    source = organ.source and replace(organ.source, folder="")
    content, arrays = pack_organ(replace(organ, source=source, history=None))
    made = scenario.Scenario(
        scene=scene,
        title=organ.title,
        task=organ.task,
        authored=json.dumps({"format": FORMAT, "version": VERSION, "content": content}),
        authored_arrays=arrays,
        languages={
            code: scenario.Words(text.title, text.task) for code, text in organ.languages.items()
        },
    )
    if not has_task(organ):
        return made
    return with_assessment(path, json.loads(organ.assessment), made)


def has_task(organ: Organ) -> bool:
    """Whether there is a step that is published."""
    if not organ.assessment:
        return False
    steps = without_muted(json.loads(organ.assessment)).get("steps")
    return bool(steps)


def write(made: scenario.Scenario, path: Path) -> None:
    try:
        scenario.write(os.fspath(path), made)
    except ValueError as problem:
        raise FileError(str(path), "", str(problem), "an organ that a file can hold") from None
