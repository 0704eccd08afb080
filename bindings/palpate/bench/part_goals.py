# SPDX-License-Identifier: BSD-3-Clause
"""What parts of a scene may cost: goals that were set for the gallbladder at twelve substeps, and
whether they are met. What is no part by itself is told by a press without it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from copy import copy
from dataclasses import dataclass
from typing import Any

import palpate
from palpate.runs.costs import hold_costs

Row = dict[str, Any]

SCALE = (
    "goals are of the gallbladder, 5400 vertices, at 12 substeps a tick, and of medians in touch"
)
JAWS, JAWS_WANTED = 120.0, 65.0
"""[us] Of a pair of jaws that holds: at most, and wanted."""
SHAFT = 40.0
"""[us] Of 100 mm looked for at a quarter of the rate; a shorter one costs no more."""
FRICTION = 0.02
"""[-] Of the tick without it."""
TROCAR, TEAR, BONE, STONE = 1.0, 2.0, 2.0, 10.0
"""[us] Bone of every body that it stops, a stone of each."""
TOUCHING, APART = 100.0, 5.0
"""[us] Of two bodies with each other."""
TIMES = 2
"""Presses with and without, of which the least median counts."""


def judge(median: float, *most: float) -> list[Row]:
    """Goals [us], and whether a median [us] meets them."""
    return [{"most_us": each, "met": median <= each} for each in most]


def list_contact_goals(tool: palpate.Tool) -> tuple[float, ...]:
    """[us] Of an instrument with a body that it touches or, with jaws, holds."""
    if tool.jaws is not None:
        return (JAWS, JAWS_WANTED)
    return (SHAFT,) if tool.capsules else ()


def is_touched(scene: palpate.Scene, world: palpate.World, instrument: int, body: int) -> bool:
    """Whether an instrument touches a body or, with jaws, holds it."""
    touches = world.pair(instrument, body).load.push_count > 0
    has_jaws = scene.instruments[instrument].tool.jaws is not None
    return touches and (not has_jaws or world.instruments[instrument].tool.has_hold())


@dataclass(frozen=True)
class Addition:
    """What a scene has that can be left out."""

    part: str
    without: palpate.Scene
    measure: Callable[[palpate.SceneCosts], float]
    """[s] The median of what it is a part of."""
    find_goal: Callable[[float], float]
    """[us] By that median [us] without it."""


def list_additions(scene: palpate.Scene) -> Iterator[Addition]:
    """Friction of what has no jaws, which hold by it, trocars, and tissue that may tear."""
    for i, instrument in enumerate(scene.instruments):
        if instrument.tool.friction > 0.0 and instrument.tool.jaws is None:
            yield Addition(
                f"friction of instrument {i}",
                leave_out(scene, i, friction=True),
                lambda costs: costs.tick.median,
                lambda tick: FRICTION * tick,
            )
        if instrument.trocar is not None:
            yield Addition(
                f"trocar of instrument {i}",
                leave_out(scene, i, trocar=True),
                lambda costs, i=i: costs.instruments[i].median,
                lambda median: TROCAR,
            )
    for b, body in enumerate(scene.bodies):
        if body.tear_stretch > 0.0:
            changed = copy(scene)
            changed.bodies[b].tear_stretch = 0.0
            yield Addition(
                f"tear of body {b}",
                palpate.build_scene(changed),
                lambda costs, b=b: costs.bodies[b].median,
                lambda median: TEAR,
            )


def leave_out(
    scene: palpate.Scene, number: int, friction: bool = False, trocar: bool = False
) -> palpate.Scene:
    """The scene without what is named of an instrument."""
    changed = copy(scene)
    if friction:
        tool = copy(changed.instruments[number].tool)
        tool.friction = 0.0
        changed.instruments[number].tool = tool
        changed.instruments[number].pair_friction = []
    if trocar:
        changed.instruments[number].trocar = None
    return palpate.build_scene(changed)


def measure_additions(scene: palpate.Scene, first: palpate.SceneCosts) -> list[Row]:
    """What each adds to the median [us] of what it is a part of, of hands that hold, with (`first`)
    and without it."""
    added = list(list_additions(scene))
    if not added:
        return []
    whole = [first, *(hold_costs(scene) for _ in range(TIMES - 1))]
    rows = []
    for each in added:
        bare = find_least(each, [hold_costs(each.without) for _ in range(TIMES)])
        cost = find_least(each, whole) - bare
        rows.append({"part": each.part, "median_us": None, "p99_us": None, "max_us": None,
                     "touching_us": cost, "goals": judge(cost, each.find_goal(bare))})  # fmt: skip
    return rows


def find_least(addition: Addition, costs: Sequence[palpate.SceneCosts]) -> float:
    """[us]"""
    return 1e6 * min(addition.measure(each) for each in costs)


def describe_goals(goals: Sequence[Row]) -> str:
    """Two columns: what it may cost [us], and whether it does; '-' where there is no goal."""
    most = ", ".join(f"{goal['most_us']:.3g}" for goal in goals) or "-"
    met = ", ".join("yes" if goal["met"] else "no" for goal in goals) or "-"
    return f"{most:>9} {met:>8}"
