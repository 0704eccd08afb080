# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairing an organ: its surface step by step, then one problem after another by the edits that
are offered for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from palpate_editor.check import Assessment, assess
from palpate_editor.document import Organ
from palpate_editor.document.problems import Problem
from palpate_editor.edits.edit import EditError
from palpate_editor.edits.ladder import climb

Apply = Callable[[Problem, Organ], Organ]
"""Does what a problem's fix says."""


def apply_fix(problem: Problem, organ: Organ) -> Organ:
    """Raises EditError."""
    assert problem.fix is not None
    return problem.fix(organ)


def repair_all(organ: Organ) -> tuple[Assessment, list[str]]:
    """What is known of the organ once all that can be repaired is, and the titles of what was done.

    Raises EditError where there is no surface.
    """
    found = climb(organ)
    assessment, done = repair_problems(found.organ)
    return assessment, [*(rung.title for rung in found.rungs), *done]


def repair_problems(
    organ: Organ, wanted: Sequence[str] = (), apply: Apply = apply_fix
) -> tuple[Assessment, list[str]]:
    """What is known of the organ once its problems are repaired, and the titles of what was done.

    One at a time, in the order of the stages: what solves one problem may solve, or change,
    another. A fix that did not help is not tried again; one that is refused leaves its problem to
    be told, where that was not asked for by its key.

    Args:
        organ: What is repaired.
        wanted: Keys of problems; every error that can be repaired where empty.
        apply: Does what a problem's fix says.
    """
    done: list[str] = []
    tried: set[tuple[str, str]] = set()
    assessment = assess(organ)
    while problem := find_next(assessment.problems, wanted, tried):
        assert problem.fix is not None
        tried.add((problem.key, problem.where))
        try:
            after = apply(problem, assessment.organ)
        except EditError:
            if wanted:
                raise
            continue
        done.append(problem.fix.title)
        assessment = assess(after, before=assessment)
    return assessment, done


def find_next(
    problems: Sequence[Problem], wanted: Sequence[str], tried: set[tuple[str, str]]
) -> Problem | None:
    for problem in problems:
        chosen = problem.key in wanted if wanted else problem.severity == "error"
        if chosen and problem.fix and (problem.key, problem.where) not in tried:
            return problem
    return None
