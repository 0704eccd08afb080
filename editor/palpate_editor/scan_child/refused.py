# SPDX-License-Identifier: GPL-3.0-or-later
"""How the reader of scans says no."""

from __future__ import annotations

from typing import Any


class Refused(Exception):  # noqa: N818  # an answer, not an error of the program
    """Data that is refused: where in it, what was got, what was expected."""

    def __init__(self, where: str, got: str, expected: str):
        super().__init__(where, got, expected)
        self.where, self.got, self.expected = where, got, expected


class SeveralSeries(Refused):
    """A folder of several series, of which none was named: `series` says which there are, each with
    uid, title, number of slices, and columns and rows."""

    def __init__(self, where: str, got: str, expected: str, series: list[dict[str, Any]]):
        super().__init__(where, got, expected)
        self.series = series
