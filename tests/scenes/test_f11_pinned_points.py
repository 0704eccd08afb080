# SPDX-License-Identifier: BSD-3-Clause
"""F11: a press beside a point that is held does not tremble in the hand."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import SURFACES, Hand, hold_lowest, make_ball, make_scene, open_springs
from palpate.runs.press import find_place

FELT = 1e-3
"""[N] of any one frequency from 50 to 500 Hz; a fingertip feels some ten times that at 250 Hz."""


def find_loudest(force: np.ndarray, rate: float) -> float:
    """[N] the largest amplitude of a line between 50 and 500 Hz."""
    window = np.hanning(len(force))
    lines = 2.0 * np.abs(np.fft.rfft((force - force.mean()) * window)) / window.sum()
    frequency = np.fft.rfftfreq(len(force), 1.0 / rate)
    return float(lines[(frequency >= 50.0) & (frequency <= 500.0)].max())


def press_beside(scene: palpate.Scene, near: np.ndarray) -> tuple[float, float]:
    """[N] the mean force of a hold, and its loudest trembling."""
    hand = Hand(scene, find_place(scene, near)).go(-5e-4, 2e-3, 0.1).stay(2e-3, 1.4)
    along = np.array(hand.force[-1000:]) @ hand.place.outward
    return float(along.mean()), find_loudest(along, scene.rate)


@pytest.mark.parametrize("law", SURFACES)
def test_f11_beside_a_held_vertex_a_press_is_quiet(law):
    mesh = make_ball()
    x = np.asarray(mesh.vertices)
    pinned = int(x[:, 2].argmax())
    tissue = SURFACES[law](mesh, sorted({*hold_lowest(x), pinned}))

    force, loudest = press_beside(make_scene(tissue), x[pinned] + [4e-3, 1e-3, 0.0])

    assert force > 0.02
    assert loudest < FELT


@pytest.mark.parametrize("name", ["spleen", "simple_tissue"])
def test_f11_beside_the_rim_that_an_organ_is_held_at_a_press_is_quiet(name):
    scene = open_springs(name)
    tissue = scene.bodies[0].tissue
    x, rim = np.asarray(tissue.rest_position), np.asarray(tissue.fixed)
    free = np.setdiff1d(np.arange(len(x)), rim)
    beside = free[np.linalg.norm(x[free] - x[rim[0]], axis=1).argmin()]

    force, loudest = press_beside(scene, x[beside])

    assert force > 0.005
    assert loudest < FELT
