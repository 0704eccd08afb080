# SPDX-License-Identifier: BSD-3-Clause
"""Sentences that a command prints as they are and a window says in its own language."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Sentence:
    """A text with places %1 to %9, and what stands there."""

    template: str
    """In English; the key of its translations."""
    values: tuple[str, ...] = ()

    def __str__(self) -> str:
        return fill(self.template, self.values)


def sentence(template: str, *values: object) -> Sentence:
    """Numbers are to be written by the caller, who knows their digits."""
    return Sentence(template, tuple(str(value) for value in values))


def fill(template: str, values: tuple[str, ...]) -> str:
    """The template with its places filled."""
    for place, value in enumerate(values, start=1):
        template = template.replace(f"%{place}", value)
    return template


class PoorData(RuntimeError):
    """What was measured cannot be used; says why and what to do."""

    def __init__(self, template: str, *values: object):
        self.sentence = sentence(template, *values)
        super().__init__(str(self.sentence))
