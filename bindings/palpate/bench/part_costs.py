# SPDX-License-Identifier: BSD-3-Clause
"""What each part of a published scene costs in a tick, while it is pressed, and what it may."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import palpate
from palpate import scenario
from palpate.bench.part_goals import (
    APART,
    BONE,
    SCALE,
    STONE,
    TOUCHING,
    describe_goals,
    is_touched,
    judge,
    list_contact_goals,
    measure_additions,
)
from palpate.runs.costs import hold_costs, press_costs, run_until_held
from palpate.runs.press import has_jaws

Row = dict[str, Any]


def measure_part_costs(path: Path) -> Row:
    """Of the whole tick and its parts, over a press at the top with its way there and back [us],
    and over one that is held there."""
    scene = scenario.read(path).scene
    costs, held = press_costs(scene), hold_costs(scene)
    return {
        "scene": str(path),
        "ticks": costs.ticks,
        "hand": name_hand(scene),
        "ended_by_alarm": bool(costs.alarm) or bool(held.alarm),
        "substeps": [body.substeps for body in scene.bodies],
        "scale": SCALE,
        "parts": [*list_parts(scene, costs, held), *measure_additions(scene, held)],
    }


def list_parts(
    scene: palpate.Scene, costs: palpate.SceneCosts, held: palpate.SceneCosts
) -> list[Row]:
    """The whole tick, and what of it is measured by itself."""
    rows, world = [], run_until_held(scene)

    def add(
        part: str,
        cost: palpate.Percentiles,
        touching: palpate.Percentiles,
        *most: float,
        touches: bool = True,
    ) -> None:
        touching_us = 1e6 * touching.median if touches else None
        rows.append(
            {
                "part": part,
                "median_us": 1e6 * cost.median,
                "p99_us": 1e6 * cost.p99,
                "max_us": 1e6 * cost.max,
                "touching_us": touching_us,
                "goals": [] if touching_us is None else judge(touching_us, *most),
            }
        )

    bodies, count = len(scene.bodies), len(scene.rigid)
    add("whole tick", costs.tick, held.tick)
    for b, both in enumerate(zip(costs.bodies, held.bodies, strict=True)):
        add(f"body {b}", *both)
    for i, both in enumerate(zip(costs.instruments, held.instruments, strict=True)):
        add(f"instrument {i}, {name_shape(scene, i)}", *both)
    for k, both in enumerate(zip(costs.pairs, held.pairs, strict=True)):
        i, b = divmod(k, bodies)
        goals = list_contact_goals(scene.instruments[i].tool)
        touches = is_touched(scene, world, i, b)
        add(f"instrument {i} on body {b}", *both, *goals, touches=touches)
    of_pairs = zip(costs.body_pairs, held.body_pairs, strict=True)
    for pair, state, both in zip(scene.body_pairs, world.body_pairs, of_pairs, strict=True):
        goal = TOUCHING if state.touching else APART
        add(f"body {pair.first} on body {pair.second}", *both, goal)
    stops = [(s, body) for s, part in enumerate(scene.scenery) for body in part.bodies]
    for (s, body), *both in zip(stops, costs.scenery, held.scenery, strict=True):
        add(f"body {body} on scenery {s}", *both, BONE)
    if scene.rigid:
        add(f"{count} rigid", costs.rigid, held.rigid, count * STONE)
    return rows


def name_hand(scene: palpate.Scene) -> str:
    """What the instruments do to measure it: those with jaws grasp."""
    jaws = {has_jaws(scene, each) for each in range(len(scene.instruments))}
    return " and ".join("a grasp" if closes else "a press" for closes in sorted(jaws))


def name_shape(scene: palpate.Scene, instrument: int) -> str:
    """What touches, and whether it rubs."""
    tool = scene.instruments[instrument].tool
    shape = f"{len(tool.capsules)} capsules" if tool.capsules else "ball"
    return f"{shape}, friction {tool.friction:g}" if tool.friction > 0.0 else shape


def describe_part_costs(measured: Row) -> list[str]:
    """Lines of a table."""
    heads = " ".join(f"{head:>10}" for head in ("median us", "p99 us", "max us", "in touch"))
    lines = [
        f"{measured['scene']}: parts of {measured['ticks']} ticks of {measured['hand']}",
        f"{'part':40} {heads} {'goal us':>9} {'met':>8}",
    ]
    for row in measured["parts"]:
        columns = ("median_us", "p99_us", "max_us", "touching_us")
        figures = " ".join(say_time(row[name]) for name in columns)
        lines.append(f"{row['part']:40} {figures} {describe_goals(row['goals'])}")
    substeps = ", ".join(map(str, measured["substeps"]))
    lines.append(f"{measured['scale']}; this scene begins with {substeps}")
    if measured["ended_by_alarm"]:
        lines.append("ended early by an alarm")
    return lines


def say_time(microseconds: float | None) -> str:
    return f"{'-':>10}" if microseconds is None else f"{microseconds:10.1f}"
