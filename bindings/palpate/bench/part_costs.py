# SPDX-License-Identifier: BSD-3-Clause
"""What each part of a published scene costs in a tick, while it is pressed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import palpate
from palpate import scenario
from palpate.runs.costs import press_costs

Row = dict[str, Any]


def measure_part_costs(path: Path) -> Row:
    """Of the whole tick and its parts, over a press at the top with its way there and back [us]."""
    scene = scenario.read(path).scene
    costs = press_costs(scene)
    bodies = len(scene.bodies)
    parts = [describe("whole tick", costs.tick)]
    parts += [describe(f"body {b}", cost) for b, cost in enumerate(costs.bodies)]
    for i, cost in enumerate(costs.instruments):
        parts.append(describe(f"instrument {i}, {name_shape(scene, i)}", cost))
    for k, cost in enumerate(costs.pairs):
        parts.append(describe(f"instrument {k // bodies} on body {k % bodies}", cost))
    for pair, cost in zip(scene.body_pairs, costs.body_pairs, strict=True):
        parts.append(describe(f"body {pair.first} on body {pair.second}", cost))
    stops = [(s, body) for s, part in enumerate(scene.scenery) for body in part.bodies]
    for (s, body), cost in zip(stops, costs.scenery, strict=True):
        parts.append(describe(f"body {body} on scenery {s}", cost))
    if scene.rigid:
        parts.append(describe(f"{len(scene.rigid)} rigid", costs.rigid))
    return {
        "scene": str(path),
        "ticks": costs.ticks,
        "ended_by_alarm": bool(costs.alarm),
        "parts": parts,
    }


def describe(part: str, cost: palpate.Percentiles) -> Row:
    return {
        "part": part,
        "median_us": 1e6 * cost.median,
        "p99_us": 1e6 * cost.p99,
        "max_us": 1e6 * cost.max,
    }


def name_shape(scene: palpate.Scene, instrument: int) -> str:
    """What touches, and whether it rubs."""
    tool = scene.instruments[instrument].tool
    shape = f"{len(tool.capsules)} capsules" if tool.capsules else "ball"
    return f"{shape}, friction {tool.friction:g}" if tool.friction > 0.0 else shape


def describe_part_costs(measured: Row) -> list[str]:
    """Lines of a table."""
    lines = [
        f"{measured['scene']}: parts of {measured['ticks']} ticks of a press",
        f"{'part':40} {'median us':>10} {'p99 us':>10} {'max us':>10}",
    ]
    for row in measured["parts"]:
        lines.append(
            f"{row['part']:40} {row['median_us']:10.1f} {row['p99_us']:10.1f} {row['max_us']:10.1f}"
        )
    if measured["ended_by_alarm"]:
        lines.append("ended early by an alarm")
    return lines
