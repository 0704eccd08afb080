# SPDX-License-Identifier: GPL-3.0-or-later
"""What the parts of a scene cost of a tick, as the budget bar shows it. Knows no Qt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import palpate

BODY, TOOL, CONTACT = "body", "tool", "contact"
"""Kinds of a part."""


@dataclass(frozen=True)
class Part:
    """A body, a tool, or a tool with a body."""

    kind: str
    index: int
    """Among the parts of its kind."""
    name: str
    median: float
    """[s] of a tick."""
    p99: float
    """[s] of a tick."""


@dataclass(frozen=True)
class Budget:
    """The parts, the whole, and what it may take."""

    parts: tuple[Part, ...]
    median: float
    """[s] of the whole tick."""
    p99: float
    """[s] of the whole tick."""
    period: float
    """[s] that a tick may take."""
    alarm: bool = False
    """The run that was measured ended in an alarm."""


def read_budget(
    costs: palpate.SceneCosts, rate: float, bodies: Sequence[str], tools: Sequence[str], on: str
) -> Budget | None:
    """None where nothing was measured. `rate` [Hz] of the ticks, names of bodies and of tools, and
    `on` for a tool with a body: "{tool} on {body}"."""
    if costs.ticks == 0:
        return None
    pairs = [on.format(tool=tool, body=body) for tool in tools for body in bodies]
    parts = [
        Part(kind, index, name, cost.median, cost.p99)
        for kind, names, found in (
            (BODY, bodies, costs.bodies),
            (TOOL, tools, costs.instruments),
            (CONTACT, pairs, costs.pairs),
        )
        for index, (name, cost) in enumerate(zip(names, found, strict=True))
    ]
    return Budget(
        tuple(parts), costs.tick.median, costs.tick.p99, 1.0 / rate, alarm=bool(costs.alarm)
    )
