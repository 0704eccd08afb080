# SPDX-License-Identifier: BSD-3-Clause
"""What a second of each kind of model costs, ticked at its scene's rate with nothing in touch."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

import palpate
from palpate.study.accuracy import build_or_say
from palpate.study.models import KINDS, Built, Kind
from palpate.study.reference import Reference

RUNS, TICKS = 7, 150
WARM_UP = 30


@dataclass(frozen=True)
class Cost:
    """Of one kind of one body, on this machine."""

    reference: str
    kind: str
    median: float
    """[s] of one thread per simulated second."""
    least: float
    most: float
    substeps: int
    """Steps of the tissue in a tick of 1 ms."""
    kernel: str


def measure_costs(references: Iterable[Reference], kinds: Iterable[Kind] = KINDS) -> list[Cost]:
    built = [(r, kind, build_or_say(r, kind)) for r in references for kind in kinds]
    return [measure_cost(r, k, organ.model) for r, k, organ in built if isinstance(organ, Built)]


def measure_cost(reference: Reference, kind: Kind, model: palpate.TissueModel) -> Cost:
    scene = palpate.build_scene(palpate.make_scene(model))
    world = palpate.World(scene, recovers=False)
    sample = palpate.HapticSample()
    sample.position = reference.vertices.max(axis=0) + 0.1
    dt = 1.0 / scene.rate
    for _ in range(WARM_UP):
        palpate.tick(scene, sample, dt, world)
    spans = []
    for _ in range(RUNS):
        start = time.thread_time()
        for _ in range(TICKS):
            palpate.tick(scene, sample, dt, world)
        spans.append((time.thread_time() - start) / (TICKS * dt))
    return Cost(
        reference.name,
        kind.name,
        float(np.median(spans)),
        min(spans),
        max(spans),
        scene.bodies[0].substeps,
        scene.bodies[0].kernel.name,
    )
