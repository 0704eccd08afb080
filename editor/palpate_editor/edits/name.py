# SPDX-License-Identifier: GPL-3.0-or-later
"""Words: the organ's name, and the title and task a trainee reads."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from palpate import scenario

from palpate_editor.document import Organ, phrase
from palpate_editor.edits.edit import EditError

MOST_NAME_BYTES = 200


def check_words(what: str, words: str, most: int) -> None:
    try:
        count = len(words.encode())
    except UnicodeEncodeError:  # half of a surrogate pair: no file can keep it
        raise EditError(phrase("{what}: letters that cannot be written.", what=what)) from None
    if count > most:
        raise EditError(
            phrase(
                "{what}: {count} bytes of text, at most {most}.", what=what, count=count, most=most
            )
        )


@dataclass(frozen=True)
class SetName:
    """Name the organ."""

    title: ClassVar[str] = "Name the organ"

    name: str

    def __call__(self, organ: Organ) -> Organ:
        check_words("name", self.name, MOST_NAME_BYTES)
        return replace(organ, name=self.name)


@dataclass(frozen=True)
class SetTask:
    """Say what the trainee sees and is asked to do. None leaves one of the two as it is."""

    title: ClassVar[str] = "Set title and task"

    scenario_title: str | None = None
    task: str | None = None

    def __call__(self, organ: Organ) -> Organ:
        title = organ.title if self.scenario_title is None else self.scenario_title
        task = organ.task if self.task is None else self.task
        check_words("title", title, scenario.kMostTitleBytes)
        check_words("task", task, scenario.kMostTaskBytes)
        return replace(organ, title=title, task=task)
