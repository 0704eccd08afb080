# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts: the organ's name, and the title and task a trainee reads."""

from __future__ import annotations

from dataclasses import dataclass, replace

from palpate import scenario

from palpate_editor.document import Organ, Translation, is_language, phrase
from palpate_editor.edits.edit import EditError

MOST_NAME_BYTES = 200


def check_text(what: str, text: str, most: int) -> None:
    try:
        count = len(text.encode())
    except UnicodeEncodeError:  # half of a surrogate pair: no file can keep it
        raise EditError(phrase("{what}: letters that cannot be written.", what=what)) from None
    if count > most:
        raise EditError(
            phrase(
                "{what}: got {count} bytes of text, expected at most {most}.",
                what=what,
                count=count,
                most=most,
            )
        )


@dataclass(frozen=True)
class SetName:
    """Name the organ."""

    name: str

    @property
    def title(self) -> str:
        return phrase("Name the organ: {name}", name=self.name)

    def __call__(self, organ: Organ) -> Organ:
        check_text("name", self.name, MOST_NAME_BYTES)
        return replace(organ, name=self.name)


@dataclass(frozen=True)
class SetTask:
    """Say what the trainee sees and is asked to do. None leaves one of the two as it is."""

    scenario_title: str | None = None
    task: str | None = None
    language: str = ""
    """A code such as "tr" for a translation; empty for the texts that stand where there is none."""

    @property
    def title(self) -> str:
        if self.scenario_title is None:
            return phrase("Set the task")
        if self.task is None:
            return phrase("Title: {title}", title=self.scenario_title)
        return phrase("Set title and task")

    def __call__(self, organ: Organ) -> Organ:
        if self.language and not is_language(self.language):
            raise EditError(
                phrase(
                    "The language must be a code such as tr or pt-BR, got {got}.", got=self.language
                )
            )
        said = organ.languages.get(self.language, Translation()) if self.language else organ
        title = said.title if self.scenario_title is None else self.scenario_title
        task = said.task if self.task is None else self.task
        check_text("title", title, scenario.MOST_TITLE_BYTES)
        check_text("task", task, scenario.MOST_TASK_BYTES)
        if not self.language:
            return replace(organ, title=title, task=task)
        languages = {**organ.languages, self.language: Translation(title, task)}
        if not title and not task:
            del languages[self.language]
        if len(languages) > scenario.MOST_LANGUAGES:
            most = scenario.MOST_LANGUAGES
            raise EditError(phrase("A scenario has at most {most} further languages.", most=most))
        return replace(organ, languages=languages)
