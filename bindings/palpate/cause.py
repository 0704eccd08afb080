# SPDX-License-Identifier: BSD-3-Clause
"""What crossed its limit where a run ended in an alarm: found from the scene, after the run."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import palpate

UNTOUCHED = 1.0
"""[s] of a run in which nothing is touched, to see whether the tissue bears its own pressure."""
BLOWN = (
    palpate.AlarmKind.not_finite,
    palpate.AlarmKind.moved_far,
    palpate.AlarmKind.energy,
)
"""For want of substeps; what is merely strained is so however many there are."""


@dataclass(frozen=True)
class Cause:
    """What asks for more substeps of a tick than there can be, or pressure."""

    name: str
    """substeps, damping, contact or pressure."""
    needed: int = 0
    """Substeps; 0 for pressure."""
    most: int = 0
    """Substeps that the scene allows."""


def find_cause(scene: palpate.Scene, alarm: palpate.Alarm) -> Cause | None:
    """The first that alone explains the alarm, from the tissue at rest to the tool; None where the
    scene does not tell. Takes up to a second of ticks where there is pressure.
    """
    stiffness, damping = scene.spectrum_stiffness, scene.spectrum_damping
    needs = {
        "substeps": count_substeps(scene, stiffness, 0.0),
        "damping": count_substeps(scene, stiffness, damping),
        "contact": count_substeps(scene, stiffness + bound_tip_stiffness(scene), damping),
    }
    wanting = [name for name, needed in needs.items() if needed > scene.substeps_max]
    if alarm.kind not in BLOWN:
        wanting = []
    if "damping" not in wanting and scene.tissue.pressure != 0.0 and ends_untouched(scene):
        return Cause("pressure")
    return Cause(wanting[0], needs[wanting[0]], scene.substeps_max) if wanting else None


def count_substeps(scene: palpate.Scene, stiffness: float, damping: float) -> int:
    """Substeps of a tick that are stable at eigenvalues [1/s²] and [1/s] of K and C over M:

    dt <= (sqrt(c² + 4 w²) - c) / w² (core/sim/haptics/choose_substeps.cpp).
    """
    if not stiffness > 0.0:
        return 1
    longest = (math.sqrt(damping**2 + 4.0 * stiffness) - damping) / stiffness
    return math.ceil(1.0 / (scene.rate * longest))


def bound_tip_stiffness(scene: palpate.Scene) -> float:
    """[1/s²] that the contact law adds to M⁻¹K where a tip lies lightly on the tissue: k_A a / m,
    with the third a of the areas of a vertex' triangles."""
    triangles = np.asarray(scene.tissue.triangles)
    mass = np.asarray(palpate.compute_surface_mass(scene.tissue))
    area = np.zeros(len(mass))
    np.add.at(area, triangles, np.asarray(scene.rest_areas)[:, None] / 3.0)
    moves = np.isfinite(mass) & (mass > 0.0)
    return float(scene.tool.stiffness * (area[moves] / mass[moves]).max(initial=0.0))


def ends_untouched(scene: palpate.Scene) -> bool:
    """Whether the tissue raises an alarm with nobody near it."""
    world, sample = palpate.World(scene), palpate.HapticSample()
    x = np.asarray(scene.tissue.rest_position)
    sample.position = x.max(axis=0) + 10.0 * np.ptp(x, axis=0) + 1.0
    for _ in range(round(UNTOUCHED * scene.rate)):
        palpate.tick(scene, sample, 1.0 / scene.rate, world)
        if world.alarm:
            return True
    return False
