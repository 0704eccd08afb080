# SPDX-License-Identifier: GPL-3.0-or-later
"""The nearest constants with which an organ can be felt, where it cannot with those it has."""

from __future__ import annotations

from dataclasses import replace

import palpate
from palpate.runs.cause import HARD, Cause, find_cause, find_hard_part, take_out
from palpate.scene.nearest import find_nearest
from palpate.scene.scene_parts import SceneFile
from palpate.scene.tick_cost import count_affordable

from palpate_editor.compile import build_organ, parts_of
from palpate_editor.document import Organ
from palpate_editor.document.constants import MOST_SUBSTEPS
from palpate_editor.document.cost_rules import TICK_SHARE
from palpate_editor.document.problems import NearestFacts

IN_TOUCH = 0.75
"""[-] A touch may ask for a third more substeps than the tissue at rest (scene.cpp)."""
HARDER = 10.0
"""[-] Times what is usual, from which a constant of tool or hand is tried out."""
KEYS = {
    "pressure": "model.pressure",
    "eq10": "model.bend_stiffness",
    "contact": "tool.stiffness",
    "grip": "hand.hold_stiffness",
    "finer": "hand.substeps",
}
"""The constant that a cause (palpate.runs.cause) is of, of those that a trial finds."""


def find_fitting(organ: Organ, tetrahedra: int = 0) -> NearestFacts | None:
    """The constant that asks for more substeps than a tick has time for, where easing it alone is
    enough. Builds the tissue some ten times where one does.

    Args:
        organ: With a surface.
        tetrahedra: Of a solid.
    """
    count = tetrahedra or organ.vertex_count
    there_are = count_affordable(organ.model.kind, count, organ.hand.rate, TICK_SHARE)
    most = int(IN_TOUCH * min(there_are, MOST_SUBSTEPS))

    def build(parts: SceneFile) -> palpate.TissueModel:
        return build_organ(replace(organ, material=parts.material, model=parts.model))

    found = find_nearest(parts_of(organ), build, most)
    if found is None:
        return None
    return NearestFacts(found.key, found.value, found.limit, found.needed, found.excess)


def find_blown(scene: palpate.Scene, alarm: palpate.Alarm | None) -> NearestFacts | None:
    """What ended a light press, with a value that does not; None where nothing did, or no constant
    alone explains it. Without an alarm, tools and hands far harder than usual are tried."""
    cause: Cause | None = None
    if alarm is not None:
        cause = find_cause(scene, alarm, 0)
    elif any(hard.excess(scene) > HARDER for hard in HARD):
        cause = find_hard_part(take_out(scene, 0, 0))
    if cause is None or cause.name not in KEYS:
        return None
    return NearestFacts(KEYS[cause.name], cause.value, cause.limit)
