# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of other rooms in the language of the program."""

from __future__ import annotations

from typing import Any

from palpate.translation.numbers import SpokenNumber
from palpate.translation.refusals import say_refusal
from PySide6.QtCore import QCoreApplication

from palpate_editor.document import Phrase


def fill(template: str, **values: Any) -> str:
    """A translated template with numbers as the language of the program writes them."""
    return template.format(
        **{k: SpokenNumber(v) if isinstance(v, float) else v for k, v in values.items()}
    )


def say(text: Any) -> Any:
    """A sentence of another room in the language of the program, where it knows how it was made."""
    if isinstance(text, Phrase):
        values = {key: say_value(key, value) for key, value in text.values.items()}
        template = QCoreApplication.translate("phrases", text.template)
        return fill(template, **values) if values else template
    # names of constants are values of many sentences; any other text stays as it is
    return QCoreApplication.translate("constants", text) if isinstance(text, str) else text


def say_value(key: str, value: Any) -> Any:
    """What stands in a sentence: `why` is a sentence of the core, `tissue` one of the library."""
    if key == "tissue" and isinstance(value, str):
        return say_tissue(value)
    return say_refusal(value) if key == "why" and isinstance(value, str) else say(value)


def say_title(title: str) -> str:
    """What an edit is called, with its values where it has some."""
    if isinstance(title, Phrase):
        return str(say(title))
    return QCoreApplication.translate("edits", title)


def say_tissue(text: str) -> str:
    """What the table of tissues that ships says of one: its note, how a value was measured."""
    return QCoreApplication.translate("tissues", " ".join(text.split()))
