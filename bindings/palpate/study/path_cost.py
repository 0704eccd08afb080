# SPDX-License-Identifier: BSD-3-Clause
"""What a tick in touch costs along a path: processor time of the calling thread.

So it is that of a machine which does nothing else meanwhile. Runs are timed one after the other,
batch by batch: the spread of their medians is the interval.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from copy import copy
from statistics import median

import numpy as np

import palpate
from palpate.study.scene_chart import Cost

BATCHES = 5
ENOUGH, LEAST_TICKS = 0.2, 40
"""[s] in touch after which a batch ends, and its ticks at least: a slow tissue is not pressed to
the end of a path five times."""


def measure_path_cost(
    scene: palpate.Scene,
    samples: Sequence[palpate.HapticSample],
    clock: Callable[[], float] = time.thread_time,
) -> Cost | None:
    """Every batch begins at rest and follows the path; a tick counts where something is felt.

    None where nothing is felt, or an alarm ends a batch before enough was.
    """
    scene = copy(scene)
    scene.gravity = [0.0, 0.0, 0.0]
    batches = [time_batch(scene, samples, clock) for _ in range(BATCHES)]
    if not all(batches):
        return None
    medians = [median(batch) for batch in batches]
    spans = np.concatenate(batches)
    return Cost(
        median=median(medians),
        least=min(medians),
        most=max(medians),
        p99=float(np.percentile(spans, 99.0)),
        misses=float((spans > 1.0 / scene.rate).mean()),
        ticks=len(spans),
    )


def time_batch(
    scene: palpate.Scene, samples: Sequence[palpate.HapticSample], clock: Callable[[], float]
) -> list[float]:
    """[s] of every tick in touch."""
    world, dt = palpate.World(scene, recovers=False), 1.0 / scene.rate
    spans: list[float] = []
    spent = 0.0
    for sample in samples:
        start = clock()
        command = palpate.tick(scene, sample, dt, world)
        span = clock() - start
        if world.alarm.kind != palpate.AlarmKind.none:
            break
        if np.any(command.force):
            spans.append(span)
            spent += span
        if spent > ENOUGH and len(spans) >= LEAST_TICKS:
            break
    return spans
