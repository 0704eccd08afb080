# SPDX-License-Identifier: BSD-3-Clause
"""Refusals of the core and of the system, said in the language of the window.

They come as finished English sentences: where, what was found and what was expected. They are
known by their pattern: a template such as "%1 bytes", and what stands in its places, which may be
a sentence again. What no template fits stays as it is. translations/ lists the templates.
"""

from __future__ import annotations

import re
from functools import cache

from PySide6.QtCore import QCoreApplication

from palpate import translation
from palpate.translation.numbers import is_number, say_digits

CONTEXT = "Refusal"
PLACE = re.compile(r"%(\d)")
FOREIGN = re.compile(r"\(%(\d)\)")
"""A place in brackets holds the words of another library."""
NUMBER = r"([-+]?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan))"
FEW_LETTERS = 7
"""A template of no more, such as "%1 to %2", is that of numbers: its first place must hold one."""
DEEPEST = 6
"""Sentences within sentences that are looked into."""


def say_refusal(text: str, depth: int = DEEPEST) -> str:
    """A sentence of the core in the language of the window; in English as it is."""
    for template, pattern in read_patterns():
        found = pattern.fullmatch(text)
        if found is None:
            continue
        said = QCoreApplication.translate(CONTEXT, template)
        values = dict(enumerate(found.groups(), 1))
        foreign = {int(place) for place in FOREIGN.findall(template)}
        values = {k: v if k in foreign else say_inside(v, depth) for k, v in values.items()}
        return PLACE.sub(lambda place, values=values: values[int(place.group(1))], said)
    if is_number(text):
        return say_digits(text)
    head, colon, rest = text.partition(": ")
    # a name of a file or a device before what happened to it
    return f"{head}: {say_inside(rest, depth)}" if colon else text


def say_note(text: str) -> str:
    """What the core did, told in parts with semicolons between them."""
    return "; ".join(map(say_refusal, text.split("; ")))


def say_inside(text: str, depth: int) -> str:
    return say_refusal(text, depth - 1) if depth > 0 else text


@cache
def read_patterns() -> list[tuple[str, re.Pattern[str]]]:
    """(template, what fits it), those with most words of their own first."""
    translations = translation.read_translations("palpate.translation", "tr")
    templates = [source for context, source in translations if context == CONTEXT]
    templates.sort(key=lambda source: (-count_letters(source), source))
    return [(source, build_pattern(source)) for source in templates]


def build_pattern(template: str) -> re.Pattern[str]:
    """Places are numbered in the order of the English sentence."""
    parts = [re.escape(part) for part in PLACE.split(template)[::2]]
    # the last word of what was expected is that of the outer sentence
    pattern = "(.*?)".join(parts).replace(r"(.*?),\ expected", r"(.*),\ expected")
    if not parts[0] and count_letters(template) <= FEW_LETTERS:
        pattern = pattern.replace("(.*?)", NUMBER, 1)
    return re.compile(pattern, re.DOTALL)


def count_letters(template: str) -> int:
    """Of its own, without its places."""
    return len(PLACE.sub("", template).replace(" ", ""))
