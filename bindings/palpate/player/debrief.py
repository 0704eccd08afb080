# SPDX-License-Identifier: BSD-3-Clause
"""After a task that was judged: the outcome, each goal, the worst moments, and one thing to try."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

import palpate
from palpate.player.boards import Board
from palpate.player.moments import KEPT, Moment
from palpate.player.sentences import (
    format_clock,
    format_number,
    say_earlier,
    say_outcome,
    translate,
)

Report = dict[str, Any]

LINE = 40
"""Letters of a line of a button."""


@dataclass(frozen=True)
class Debriefed:
    """What a debrief tells of."""

    state: palpate.TaskState
    goals: Sequence[Report]
    """Of palpate.assessment.verdict."""
    limits: Sequence[str]
    """What each limit says, in the language of the window."""
    moments: Sequence[Moment]
    history: Sequence[Report]
    """Earlier attempts at the same task, the newest first; of palpate.records.queries."""
    kept: str
    """Where it was kept, in a sentence."""


class DebriefBoard(Board):
    """Never a grade, never a rank."""

    moment_wanted = Signal(int)

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.outcome, self.goals = self.add("body"), self.add("body")
        self.moments_title = self.add("title")
        self.moments: list[QPushButton] = []
        for number in range(KEPT):
            button = self.add_button()
            button.setProperty("number", number)
            button.clicked.connect(self._show)
            self.moments.append(button)
        self.next_title, self.next = self.add("title"), self.add("body")
        self.history_title, self.history = self.add("title"), self.add("body")
        self.kept = self.add("caption")
        self.restart = self.add_button(main=True)
        self.another = self.add_button()
        self.see_history = self.add_button()
        self.quit = self.add_button()
        self._told: Debriefed | None = None
        self.say()

    def tell(self, told: Debriefed) -> None:
        self._told = told
        self.say()

    def _show(self) -> None:
        self.moment_wanted.emit(self.sender().property("number"))

    def say(self) -> None:
        self.headline.setText(translate("Player", "Finished"))
        self.moments_title.setText(translate("Player", "Worst moments"))
        self.next_title.setText(translate("Player", "To try next"))
        self.history_title.setText(translate("Player", "Attempts before"))
        self.restart.setText(translate("Player", "Again"))
        self.another.setText(translate("Player", "Another one of this kind"))
        self.see_history.setText(translate("Player", "History"))
        self.quit.setText(translate("Player", "Quit"))
        told = self._told
        if told is None:
            return
        self.outcome.setText(say_outcome(told.state))
        self.goals.setText("\n".join(say_goal(goal) for goal in told.goals))
        self.goals.setVisible(bool(told.goals))
        self.moments_title.setVisible(bool(told.moments))
        for number, button in enumerate(self.moments):
            button.setVisible(number < len(told.moments))
            if number < len(told.moments):
                button.setText(say_moment(told.moments[number], told.limits))
        self.next.setText(advise(told))
        lines = [say_earlier(row) for row in told.history]
        self.history.setText("\n".join(lines))
        self.history.setVisible(bool(lines))
        self.history_title.setVisible(bool(lines))
        self.kept.setText(told.kept)


def find_words(metric: str) -> tuple[str, str, int]:
    """Name, unit and decimals."""
    names = {
        "time": (translate("Player", "Time"), "s", 1),
        "errors": (translate("Player", "Errors"), "", 0),
        "warnings": (translate("Player", "Warnings"), "", 0),
        "peak_force": (translate("Player", "Peak force"), "N", 2),
    }
    return names[metric]


def say_value(value: object, unit: str, decimals: int) -> str:
    """A bound may be a parameter, which has a value in an attempt alone."""
    if isinstance(value, str):
        return value
    return f"{format_number(float(value), decimals)} {unit}".strip()  # type: ignore[arg-type]


def say_bound(goal: Report) -> str:
    _, unit, decimals = find_words(goal["metric"])
    text = ""
    if "at_most" in goal:
        most = say_value(goal["at_most"], unit, decimals)
        text += translate("Player", ", goal: at most %1").replace("%1", most)
    if "at_least" in goal:
        least = say_value(goal["at_least"], unit, decimals)
        text += translate("Player", ", goal: at least %1").replace("%1", least)
    return text


def say_goal_bound(goal: Report) -> str:
    """Before an attempt: no value yet."""
    return find_words(goal["metric"])[0] + say_bound(goal)


def say_goal(goal: Report) -> str:
    """Value and bound, and whether it is met."""
    name, unit, decimals = find_words(goal["metric"])
    mark = "\N{CHECK MARK}" if goal["met"] else "\N{MULTIPLICATION X}"
    return f"{mark} {name}: {say_value(goal['value'], unit, decimals)}{say_bound(goal)}"


def say_moment(moment: Moment, limits: Sequence[str]) -> str:
    clock, said = format_clock(moment.time), limits[moment.limit]
    lasted = translate("Player", "%1 s beyond").replace("%1", format_number(moment.duration, 1))
    text = f"\N{BLACK RIGHT-POINTING TRIANGLE} {clock}  {said} ({lasted})"
    return textwrap.fill(text, LINE)  # a button does not break lines


def advise(told: Debriefed) -> str:
    """One thing: what was longest beyond a limit, else a goal that was missed."""
    worst = max(range(len(told.state.limits)), default=-1,
                key=lambda k: told.state.limits[k].duration)  # fmt: skip
    if worst >= 0 and told.state.limits[worst].count:
        return told.limits[worst]
    if told.state.outcome is not palpate.Outcome.done:
        return translate("Player", "Finish every step; there is no hurry.")
    missed = [goal for goal in told.goals if not goal["met"]]
    if missed and missed[0]["metric"] == "time":
        return translate("Player", "The same, with fewer pauses between the steps.")
    if missed:
        return translate("Player", "The same again, to bring every goal within its bound.")
    return translate("Player", "Another seed, or the next level.")
