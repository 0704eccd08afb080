# SPDX-License-Identifier: BSD-3-Clause
"""Simulated hands, which try a task out before a trainee does.

They test the software and the numbers of a scenario. They are no evidence that it teaches or
measures anything: all their numbers are invented.
"""

from __future__ import annotations

import palpate
from palpate.assessment.hand import Hand, Idle, Jab
from palpate.assessment.mover import Mover, moves_objects
from palpate.assessment.person import Person
from palpate.assessment.skill import CAREFUL, CLUMSY

HANDS = ("careful", "idle", "jab", "clumsy")
OTHERS_SEED = 1_000_003
"""Between the seeds of the hands of one person."""


def make_hands(name: str, scene: palpate.Scene, task: palpate.Task, seed: int) -> list[Hand]:
    """One of HANDS at every instrument."""
    return [make_hand(name, scene, task, seed, i) for i in range(len(scene.instruments))]


def make_hand(
    name: str, scene: palpate.Scene, task: palpate.Task, seed: int, instrument: int = 0
) -> Hand:
    """One of HANDS at one instrument."""
    if name == "idle":
        return Idle(scene, task, instrument)
    if name == "jab":
        return Jab(scene, task, instrument)
    skill = CAREFUL if name == "careful" else CLUMSY
    if moves_objects(task, instrument):
        return Mover(scene, task, skill, seed + OTHERS_SEED * instrument, instrument)
    return Person(scene, task, skill, seed + OTHERS_SEED * instrument, instrument)
