# SPDX-License-Identifier: GPL-3.0-or-later
"""A chart beside the organ on the desk: whether it is of it, and which row is what it is now."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import isclose

from palpate.scene.scene_parts import FILLED
from palpate.study.scene_chart import Chart, Configuration, Row

from palpate_editor.document import Organ, Phrase, phrase
from palpate_editor.document.constants import find_constant
from palpate_editor.edits.configure import find_configuration

SAME = 1e-6
"""[-] Numbers that differ by less are the same."""
LAYERS = {"shell": 2}
"""Particles of a tissue for each vertex of its surface, where they are more than one."""
SHARED = {
    "material.young_modulus": "young_modulus",
    "material.poisson_ratio": "poisson_ratio",
    "material.wall_thickness": "wall_thickness",
    "tool.radius": "tool_radius",
    "hand.rate": "rate",
}
"""Constant of the document -> field of a chart that was drawn with it."""


def find_difference(chart: Chart, organ: Organ) -> Phrase | None:
    """The first number in which the organ is not what the chart is of; None where it may be."""
    for key, field in SHARED.items():
        constant = find_constant(*key.split("."))
        assert constant is not None
        here, there = getattr(getattr(organ, constant.part), constant.field), getattr(chart, field)
        if not is_same(here, there):
            return phrase(
                "It was drawn with another value: {label} of {there}, where the organ has {here}.",
                label=constant.label,
                there=constant.describe(there),
                here=constant.describe(here),
            )
    return None


def is_same(here: float | None, there: float | None) -> bool:
    if here is None or there is None:
        return here is there
    return isclose(here, there, rel_tol=SAME)


def find_present(rows: Iterable[Row], organ: Organ) -> Row | None:
    """The row of the configuration that the organ has now."""
    own = find_configuration(organ)
    for row in rows:
        wanted = find_wanted(row, organ)
        if wanted.vertices in (0, organ.vertex_count) and replace(wanted, vertices=0) == own:
            return row
    return None


def find_wanted(row: Row, organ: Organ) -> Configuration:
    """What brings an organ to a row: where that was run on the surface as it was then, and the
    organ has another now, so many vertices."""
    c = row.configuration
    if c.kind in FILLED or c.vertices or row.counts is None:
        return c
    count = row.counts.particles // LAYERS.get(c.kind, 1)
    return c if count == organ.vertex_count else replace(c, vertices=count)
