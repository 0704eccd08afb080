# SPDX-License-Identifier: BSD-3-Clause
"""What of a Turkish sentence was left in English."""

from __future__ import annotations

import re

from palpate.translation.refusals import say_refusal

WORDS = re.compile(
    r"\b(?:the|an?|is|are|that|which|than|not|no|none|or|and|of|to|from|for|with|within|without"
    r"|found|expected|got|must|be|least|most|more|fewer|smaller|one|two|three|every|each|other"
    r"|number|numbers|text|bytes|rows?|lines?|file|files|list|object|member|field|array|arrays"
    r"|value|nothing|empty|damaged|entry|surface|vertex|vertices|triangles?|particles?)\b"
)
QUOTED = re.compile(r'"[^"]*"|\'[^\']*\'|`[^`]*`|\([^)]*\)|\[[^]]*\]|[^\s:]*[/._][^\s:]*')
"""What a file says itself, names of its parts, and words of other libraries."""


def say_in_turkish(text: str) -> str:
    """As a window says a refusal, where Turkish is installed; fails on what is left in English."""
    said = say_refusal(text)
    # before it stand the names of file and field
    left = WORDS.findall(QUOTED.sub("", said.partition("bulunan: ")[2] or said))
    assert left == [], f"{left} in {said!r}"
    return said
