# SPDX-License-Identifier: GPL-3.0-or-later
"""How the reader of scans says no."""

from __future__ import annotations


class Refused(Exception):  # noqa: N818  # an answer, not an error of the program
    """Data that is refused: where in it, what was got, what was expected."""

    def __init__(self, where: str, got: str, expected: str):
        super().__init__(where, got, expected)
        self.where, self.got, self.expected = where, got, expected
