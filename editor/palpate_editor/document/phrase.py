# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences that remember how they were made, so that a window can say them in another language."""

from __future__ import annotations

from typing import Any


class Phrase(str):
    """English text, with the template and the values it was made of.

    The command line prints it as it is. A window translates the template and fills it again.
    """

    template: str
    values: dict[str, Any]

    def __new__(cls, template: str, values: dict[str, Any]) -> Phrase:
        made = super().__new__(cls, template.format(**values))
        made.template, made.values = template, values
        return made

    def __reduce__(self) -> tuple[type[Phrase], tuple[str, dict[str, Any]]]:
        return Phrase, (self.template, self.values)


def phrase(template: str, /, **values: Any) -> Phrase:
    """phrase("{count} holes", count=2) reads "2 holes"."""
    return Phrase(template, values)
