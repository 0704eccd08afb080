# SPDX-License-Identifier: BSD-3-Clause
"""Text for a terminal: what a file says may not steer it."""

from __future__ import annotations

import re
import unicodedata

STEERS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029]")
"""Control characters of ASCII and Latin 1, escape among them, but tab and the end of a line."""


def make_harmless(text: str) -> str:
    """The text with whatever a terminal would obey written out, as \\x1b.

    So are marks that turn the direction of writing, with which a name could pass for another, and
    what is no character at all.
    """
    text = STEERS.sub(lambda found: write_out(found[0]), text)
    return "".join(write_out(letter) if is_hidden(letter) else letter for letter in text)


def is_hidden(letter: str) -> bool:
    return not letter.isascii() and unicodedata.category(letter) in ("Cf", "Cs", "Co", "Cn")


def write_out(letter: str) -> str:
    return letter.encode("unicode_escape").decode("ascii")
