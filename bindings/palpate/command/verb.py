# SPDX-License-Identifier: BSD-3-Clause
"""What one word of the `palpate` command is, and the numbers with units that it takes."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Report = dict[str, Any]


class WrongCall(Exception):
    """A call whose options do not fit together; the command exits 2."""


@dataclass(frozen=True)
class Verb:
    """One word of the command line: `palpate NAME ...`."""

    name: str
    summary: str
    example: str
    """One call that works, shown by --help."""
    add_arguments: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], Report]
    """Does the work; what it returns is printed as JSON under --json."""
    describe: Callable[[Report], str]
    """The report in words, for people."""
    failed: Callable[[Report], bool] = lambda report: False
    """True where a report stands for refused data (exit 1): problems found, replay not equal."""


def quantity(unit: str) -> Callable[[str], float]:
    """A reader of numbers with a unit, to SI: quantity("m") takes 6mm, 0.6cm or 0.006m.

    The unit must be written, so no call can be a thousand times off in silence.
    """
    scales = UNITS[unit]

    def read(text: str) -> float:
        for name in sorted(scales, key=len, reverse=True):
            if text.endswith(name):
                try:
                    value = float(text[: -len(name)]) * scales[name]
                except ValueError:
                    break
                if abs(value) < float("inf"):
                    return value
        raise argparse.ArgumentTypeError(
            f"got {text!r}, expected a number with a unit of {', '.join(scales)}"
        )

    read.__name__ = f"quantity in {unit}"
    return read


def plain_number(unit: str = "") -> Callable[[str], float]:
    """A reader of numbers that are written without a unit; `unit` is what they are then in."""

    def read(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if abs(value) < float("inf"):
            return value
        said = f"a number of {unit}, without the unit" if unit else "a number"
        raise argparse.ArgumentTypeError(f"got {text!r}, expected {said}")

    return read


UNITS: dict[str, dict[str, float]] = {
    "m": {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6},
    "m3": {"m3": 1.0, "l": 1e-3, "ml": 1e-6, "mm3": 1e-9},
    "s": {"s": 1.0, "ms": 1e-3},
    "m/s": {"m/s": 1.0, "mm/s": 1e-3},
    "N": {"N": 1.0, "mN": 1e-3},
    "N/m": {"N/m": 1.0, "N/mm": 1e3},
    "N/m3": {"N/m3": 1.0, "N/mm3": 1e9},
    "J": {"J": 1.0, "mJ": 1e-3, "uJ": 1e-6},
    "Pa": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6},
    "kg/m3": {"kg/m3": 1.0},
    "1/s": {"/s": 1.0},
}
