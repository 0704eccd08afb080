# SPDX-License-Identifier: BSD-3-Clause
"""How data that cannot be used is refused."""

from __future__ import annotations

import re

SENTENCE = re.compile(r"(.*?):? *\bgot (.*), expected (.*)", re.DOTALL)


class Refusal(Exception):
    """Data that is refused: which file, where in it, what was got, what was expected."""

    def __init__(self, file: object, where: str, got: str, expected: str):
        self.file = str(file) if file is not None else None
        self.where, self.got, self.expected = where, got, expected
        place = ": ".join(part for part in (self.file, where) if part)
        super().__init__(f"{place or 'input'}: got {got}, expected {expected}")


def split_sentence(sentence: str) -> tuple[str, str, str] | None:
    """Where, got and expected of a sentence of the library; None of one that says otherwise."""
    found = SENTENCE.fullmatch(sentence)
    return (found[1], found[2], found[3]) if found else None
