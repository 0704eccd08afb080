# SPDX-License-Identifier: BSD-3-Clause
"""Presses the common work's ball into it with any engine, and says what that cost and gave."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from body import PRESS_TIME, WINDOW, Body, ForceMeter, place_ball
from numpy.typing import NDArray

BUDGET = 60.0
"""[s] by the clock; a run that has not come to the end of the press by then is given up."""
READINGS = 25
LIMIT = 0.05
"""[m] A displacement beyond it is a wreck."""


@dataclass(frozen=True)
class Engine:
    """One engine with the body in it."""

    step: Callable[[float], None]
    """Puts the ball's centre at a height [m] and advances by one step."""
    positions: Callable[[], NDArray[np.float64]]
    """[m] (p, 3) a copy."""
    contacts: Callable[[], int]


def press(engine: Engine, body: Body, dt: float) -> dict:
    """Steps of `dt` [s] to the end of the press: CPU time of a step and force in its last part."""
    meter = ForceMeter(body)
    count = int(round(PRESS_TIME / dt))
    first = int(WINDOW[0] / dt)
    every = max(1, (count - first) // READINGS)
    costs: list[float] = []
    contacts: list[int] = []
    began = time.perf_counter()
    for i in range(count):
        reads = i >= first and (i - first) % every == 0
        before = engine.positions() if reads else None
        start = time.process_time()
        engine.step(place_ball((i + 1) * dt))
        cost = time.process_time() - start
        if i >= first:
            costs.append(cost)
            contacts.append(engine.contacts())
        if reads:
            after = engine.positions()
            moved = np.abs(after[: body.vertices] - body.x[: body.vertices]).max()
            if not moved < LIMIT:
                return {"why": f"blew up at {i * dt:.3f} s"}
            meter.read(i * dt, before, after, dt)
        if time.perf_counter() - began > BUDGET:
            return {"why": f"gave up after {BUDGET:.0f} s at {i * dt:.3f} s of the press"}
    return {
        "force": meter.force(),
        "contacts": float(np.mean(contacts)),
        "median_us": 1e6 * float(np.median(costs)),
        "p99_us": 1e6 * float(np.percentile(costs, 99)),
        "steps": len(costs),
    }


def report(name: str, engine: Engine, body: Body, dt: float, **more: object) -> None:
    """One line of JSON on standard output."""
    row = {"engine": name, "vertices": body.vertices, "dt_ms": 1e3 * dt}
    print(json.dumps({**row, **more, **press(engine, body, dt)}), flush=True)
