# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as the language of the window writes them: one decimal sign in all of its windows.

Files and command lines always have a point.
"""

from __future__ import annotations

import re

from PySide6.QtCore import QLocale

POINT = re.compile(r"(?<=\d)\.(?=\d)")
NUMBER = re.compile(r"[-−+]?\d+(\.\d+)?([eE][-+]?\d+)?")


def find_decimal_sign() -> str:
    """A comma in Turkish, a point in English."""
    return QLocale().decimalPoint()


def say_digits(text: str) -> str:
    """A number that was written with a point, with the sign of the window's language."""
    sign = find_decimal_sign()
    return text if sign == "." else POINT.sub(sign, text)


def is_number(text: str) -> bool:
    """Whether a text is a number and nothing else."""
    return NUMBER.fullmatch(text) is not None


class SpokenNumber(float):
    """A float that a format writes with the decimal sign of the window's language."""

    def __format__(self, spec: str) -> str:
        return say_digits(super().__format__(spec))
