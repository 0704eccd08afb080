# SPDX-License-Identifier: BSD-3-Clause
"""The words of an assessment in a language, with the numbers of an attempt in them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from palpate import scenario

NUMBER = re.compile(r"\{(\w[\w-]*):(\w+)\}")
"""{press:N}: a parameter, and the unit to show it in."""
UNITS = {"N": 1.0, "mN": 1e3, "m": 1.0, "mm": 1e3, "cm": 1e2, "s": 1.0, "ml": 1e6}
COMMA = ("tr", "de", "fr", "es", "it", "pt", "ru")
"""Languages that write 0,6."""


def find_text(
    assessment: Mapping[str, Any],
    key: str,
    language: str,
    values: Iterable[scenario.DrawnValue] = (),
) -> str:
    """A text in a language, else in the same language elsewhere, else in English."""
    texts = assessment["texts"]
    found, written_in = key, "en"
    for code in ("en", language.split("-")[0], language):
        if key in texts.get(code, {}):
            found, written_in = texts[code][key], code.split("-")[0]
    drawn = {value.name: value.value for value in values}

    def show(match: re.Match[str]) -> str:
        name, unit = match[1], match[2]
        if name not in drawn or unit not in UNITS:
            return match[0]
        text = f"{drawn[name] * UNITS[unit]:.3g} {unit}"
        return text.replace(".", ",") if written_in in COMMA else text

    return NUMBER.sub(show, found)


def find_numbers(text: str) -> list[tuple[str, str]]:
    """(parameter, unit) of every number that a text shows."""
    return NUMBER.findall(text)
