# SPDX-License-Identifier: BSD-3-Clause
"""What becomes of stones and organs before any hand comes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

import palpate
from palpate.runs.other_hands import park

SETTLED = 1.0
"""[s] that is looked at."""


@dataclass(frozen=True)
class Settled:
    """A stone, or the vertex of an organ that moved most, after a second without a hand."""

    moved: float
    """[m] from where it began."""
    speed: float
    """[m/s]"""


@dataclass(frozen=True)
class Rest:
    """What becomes of a scene in a second without a hand."""

    stones: list[Settled]
    bodies: list[Settled]
    end: palpate.Alarm
    """What ended the second early, or none."""
    end_body: int
    """Whose that is."""


def settle(scene: palpate.Scene) -> Rest:
    world = palpate.World(scene)
    away = [
        palpate.HapticSample(position=park(scene, number))
        for number in range(len(scene.instruments))
    ]
    for _ in range(round(SETTLED * scene.rate)):
        palpate.tick(scene, away, 1.0 / scene.rate, world)
        if world.alarm:
            break
    stones = [
        Settled(measure(state.position, body.position), measure(state.velocity))
        for state, body in zip(world.rigid, scene.rigid, strict=True)
    ]
    bodies = [
        Settled(measure(state.tissue.position, body.tissue.rest_position),
                measure(state.tissue.velocity))
        for state, body in zip(world.bodies, scene.bodies, strict=True)
    ]  # fmt: skip
    return Rest(stones, bodies, world.alarm, world.alarm_body)


def measure(now: ArrayLike, before: ArrayLike = 0.0) -> float:
    """The longest of the vectors in between."""
    between = np.atleast_2d(np.asarray(now) - np.asarray(before))
    return float(np.linalg.norm(between, axis=1).max())
