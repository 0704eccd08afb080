# SPDX-License-Identifier: BSD-3-Clause
"""What every tick of a script takes of the thread's processor, and a line of it."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np
import palpate

GOAL = 1e-3
"""[s] A loop of 1 kHz has no more."""


def time_ticks(
    scene: palpate.Scene, *hands: Sequence[palpate.HapticSample]
) -> tuple[np.ndarray, palpate.World, list[palpate.HapticCommand]]:
    """[s] (ticks,) of a fresh world under one hand for each instrument; the world and what it
    answers at the end. Ends the program at an alarm."""
    world, dt = palpate.World(scene), 1.0 / scene.rate
    commands: list[palpate.HapticCommand] = []
    times = []
    for samples in zip(*hands, strict=True):
        each = list(samples)
        began = time.thread_time()
        commands = palpate.tick(scene, each, dt, world)
        times.append(time.thread_time() - began)
        if world.alarm:
            raise SystemExit(f"alarm: {world.alarm}")
    return np.array(times), world, commands


def time_least(
    times: int, scene: palpate.Scene, *hands: Sequence[palpate.HapticSample]
) -> np.ndarray:
    """[s] (ticks,) A tick is the same each time it is run: the least of its times."""
    return np.min([time_ticks(scene, *hands)[0] for _ in range(times)], axis=0)


def head_row(label: str) -> str:
    return f"{label} {'median':>8} {'p99':>8} {'max':>8} {'/median':>8}  ticks over 1 ms"


def write_row(label: str, ticks: np.ndarray) -> str:
    """[us] Of ticks [s]."""
    median, p99, most = 1e6 * np.array([np.median(ticks), np.quantile(ticks, 0.99), ticks.max()])
    late = f"{(ticks > GOAL).sum()} of {len(ticks)}"
    return f"{label} {median:8.0f} {p99:8.0f} {most:8.0f} {most / median:8.2f}  {late}"
