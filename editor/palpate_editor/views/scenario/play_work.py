# SPDX-License-Identifier: GPL-3.0-or-later
"""Hands that play the open organ's task, and its checks, beside the window."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import palpate
from palpate import scenario
from palpate.assessment.check import find_problems
from palpate.assessment.check_problem import Problem
from palpate.assessment.provenance import describe_selfplay
from palpate.assessment.selfplay import SEEDS, Attempt, attempt, play_all
from palpate.command.verb import Report
from palpate.files.refusal import Refusal

from palpate_editor.document import Organ
from palpate_editor.publish import has_task, make_scenario
from palpate_editor.views.jobs import Progress
from palpate_editor.views.translations import tr

FILE = Path("scenario")
"""What refusals call it."""


@dataclass(frozen=True, eq=False)
class CheckWork:
    """All that is wrong with the task of an organ whose scene is known."""

    organ: Organ
    scene: palpate.Scene

    def __call__(self, progress: Progress) -> tuple[Organ, list[Problem]]:
        del progress
        if not has_task(self.organ):
            return self.organ, []
        try:
            return self.organ, find_problems(make_scenario(self.organ, self.scene, FILE))
        except Refusal as refusal:
            text = f"got {refusal.got}, expected {refusal.expected}"
            return self.organ, [Problem("error", refusal.where, text)]


@dataclass(frozen=True, eq=False)
class CarefulWork:
    """One attempt of a careful hand."""

    organ: Organ
    scene: palpate.Scene
    level: str
    seed: int

    def __call__(self, progress: Progress) -> Attempt:
        progress(tr("A careful hand plays"), 0.2)
        made = make_scenario(self.organ, self.scene, FILE)
        drawn = scenario.draw_task(made, self.level, self.seed)
        return attempt(scenario.draw_scene(made, drawn), drawn, "careful")


@dataclass(frozen=True, eq=False)
class EveryHandWork:
    """Every hand at every level, three seeds each: what publishing would want to know."""

    organ: Organ
    scene: palpate.Scene

    def __call__(self, progress: Progress) -> Report:
        made = make_scenario(self.organ, self.scene, FILE)
        levels = scenario.list_levels(made) or [""]
        count = len(levels) * (3 * SEEDS + 1)
        done = 0

        def tell(played: Attempt) -> None:
            nonlocal done
            done += 1
            told = played.describe()
            progress(f"{told['hand']}, {told['level']} {told['seed']}: {told['outcome']}",
                     done / count)  # fmt: skip

        return describe_selfplay(made, play_all(made, range(SEEDS), tell))
