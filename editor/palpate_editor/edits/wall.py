# SPDX-License-Identifier: GPL-3.0-or-later
"""The wall that an open surface needs, as long as nobody has said how thick it is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any
from weakref import WeakKeyDictionary

import palpate

from palpate_editor.document import Organ, Surface
from palpate_editor.document.defaults import WALL_THICKNESS

WALL = "wall_thickness"
CLOSED: WeakKeyDictionary[Surface, bool] = WeakKeyDictionary()
"""Of surfaces that were asked about: of 100 000 triangles it takes a tenth of a second."""


def is_closed(surface: Surface) -> bool:
    """Asked once of each surface: who makes one beside the window asks there, so that the window
    need not."""
    known = CLOSED.get(surface)
    if known is None:
        known = CLOSED[surface] = bool(palpate.is_closed(surface.triangles))
    return known


def settle_wall(organ: Organ, before: Organ) -> Organ:
    """The organ with a wall of the usual thickness where its surface is open and has none, and
    without it where it was closed since; one that was chosen stays."""
    surface, wall = organ.surface, organ.material.wall_thickness
    if surface is None or surface is before.surface:
        return organ
    closed = is_closed(surface)
    was_open = before.surface is not None and not is_closed(before.surface)
    if wall is None and not closed:
        wall = WALL_THICKNESS
    elif wall is not None and closed and was_open and not has_chosen_wall(organ):
        wall = None
    else:
        return organ
    return replace(organ, material=replace(organ.material, wall_thickness=wall))


def has_chosen_wall(organ: Organ) -> bool:
    """Whether the organ is hollow because a designer has said so: by another thickness than the
    usual one, or by an edit since the surface was read."""
    wall = organ.material.wall_thickness
    if wall is None:
        return False
    lines = () if organ.history is None else organ.history.lines
    return wall != WALL_THICKNESS or any(find_walls(line.values) for line in lines)


def find_walls(values: Mapping[str, Any]) -> list[float]:
    """[m] Those that the values of an edit set."""
    return [wall for wall in iterate_walls(values) if wall is not None]


def iterate_walls(values: Mapping[str, Any]) -> Iterator[float | None]:
    if values.get("field") == WALL:
        yield values.get("value")
    for name, value in values.items():
        if name == WALL:
            yield value
        elif isinstance(value, Mapping):
            yield from iterate_walls(value)
