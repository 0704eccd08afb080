# SPDX-License-Identifier: BSD-3-Clause
"""Which numbers and names a layout can have, alike where they are said and where they are read.

Numbers are as a scene file holds them; beyond, a unit was mistaken.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from palpate.layout.stone import FEWEST, MOST


@dataclass(frozen=True)
class Range:
    """Of a number, both ends in it."""

    least: float
    most: float
    unit: str = ""
    scale: float = 1.0
    """[SI] of one unit."""

    def holds(self, value: float) -> bool:
        return self.least <= value <= self.most  # never true of NaN

    def say(self, value: float) -> str:
        try:
            shown = value / self.scale
        except OverflowError:  # a whole number beyond what a float can be
            shown = math.inf
        return f"{shown:g} {self.unit}".rstrip()

    def __str__(self) -> str:
        return f"{self.least / self.scale:g} to {self.say(self.most)}"


@dataclass(frozen=True)
class Fault:
    """What is wrong with a part of a layout: which of its fields, what it has, what it may have."""

    field: str
    got: str
    expected: str


FRICTION = Range(0.0, 2.0)
PLACE = Range(-10.0, 10.0, "mm", 1e-3)
TURN = Range(-20.0 * math.pi, 20.0 * math.pi, "degrees", math.pi / 180.0)
GRAVITY = Range(-100.0, 100.0, "m/s²")
FLUID = (Range(0.0, 2e4, "kg/m³"), Range(0.0, 10.0, "Pa s"))
GAP = Range(0.0, 1.0, "mm", 1e-3)
"""Between regions that are laid on each other."""
PARTS = {"density": Range(1.0, 3e4), "spheres": Range(FEWEST, MOST), "friction": FRICTION}
PAIRS = {"thickness": Range(0.0, 5e-3, "mm", 1e-3), "stiffness": Range(0.0, 1e13, "N/m3"),
         "damping": Range(0.0, 1.0), "friction": FRICTION}  # fmt: skip
TOOLS = {"radius": Range(1e-5, 0.2), "length": Range(0.0, 0.05), "jaw_opening": Range(0.0, 1.57),
         "friction": FRICTION, "grip_force": Range(0.001, 100.0)}  # fmt: skip
"""As of an assessment's."""
NAME = "a name, without /"


def find_faults(row: object, ranges: Mapping[str, Range]) -> Iterator[Fault]:
    """Of the numbers that it has."""
    for name, range in ranges.items():
        value = getattr(row, name, None)
        if value is not None and not range.holds(value):
            yield Fault(name, range.say(value), str(range))


def find_row_faults(field: str, numbers: Iterable[float], range: Range) -> Iterator[Fault]:
    for value in numbers:
        if not range.holds(value):
            yield Fault(field, range.say(value), str(range))


def find_name_faults(name: str) -> Iterator[Fault]:
    """BODY/REGION is told apart at its slash."""
    if not name.strip() or "/" in name:
        yield Fault("name", repr(name), NAME)


def find_part_faults(part: Any) -> Iterator[Fault]:
    """Of what is placed."""
    yield from find_name_faults(part.name)
    yield from find_row_faults("position", part.position, PLACE)
    yield from find_row_faults("rotation", part.rotation, TURN)
    yield from find_row_faults("tool_friction", part.tool_friction, FRICTION)
    scale = getattr(part, "scale", 1.0)
    if not 0.0 < scale < math.inf:
        yield Fault("scale", f"{scale:g}", "more than 0")
    yield from find_faults(part, PARTS)


def find_tool_faults(tool: Any) -> Iterator[Fault]:
    yield from find_faults(tool, TOOLS)
    yield from find_row_faults("trocar", tool.trocar, PLACE)


def find_scene_faults(layout: Any) -> Iterator[Fault]:
    """Of gravity and the fluid."""
    yield from find_row_faults("gravity", layout.gravity, GRAVITY)
    for value, range in zip(layout.fluid, FLUID, strict=False):
        yield from find_row_faults("fluid", (value,), range)
