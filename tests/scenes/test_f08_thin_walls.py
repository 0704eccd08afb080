# SPDX-License-Identifier: BSD-3-Clause
"""F8: a flick that is faster than a wall is thick in a tick, at 1 kHz and at 24 Hz."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import NONE, SURFACES, make_ball, make_scene
from palpate.runs.press import Place, find_place

SPEED, DEEP = 1.0, 6e-3
"""[m/s], and [m] that the hand ends inside of a wall of 3 mm."""


def flick(scene: palpate.Scene, place: Place) -> palpate.World:
    """From 8 mm outside, then a rest; raises AssertionError where the tool is ever inside."""
    tissue = scene.bodies[0].tissue
    world, sample, dt = palpate.World(scene), palpate.HapticSample(), 1.0 / scene.rate
    radius = scene.instruments[0].tool.radius
    count = int(np.ceil((8e-3 + DEEP) / SPEED / dt)) + max(3, round(0.02 / dt))
    for k in range(count):
        height = 8e-3 - min(8e-3 + DEEP, SPEED * k * dt)
        sample.time = k * dt
        sample.position = place.point + (radius + height) * place.outward
        palpate.tick(scene, sample, dt, world)
        where = world.instruments[0].tool.position
        x = palpate.surface_position(world.bodies[0])
        assert palpate.compute_winding_number(tissue.triangles, x, where) < 0.5, k
    return world


@pytest.mark.parametrize("rate", [1000.0, 24.0])
@pytest.mark.parametrize("law", ["springs", "a wall of prisms"])
def test_f8_a_flick_at_1_m_s_never_passes_a_wall_of_3_mm(law, rate):
    mesh = make_ball(3)
    # as many substeps a second as there are at 1 kHz
    scene = make_scene(SURFACES[law](mesh), rate=rate, substeps_max=round(32e3 / rate))
    x = np.asarray(mesh.vertices)
    for number in range(6):
        place = find_place(scene, x[number * 7919 % len(x)] + [1e-4, 2e-4, 3e-4])

        world = flick(scene, place)

        assert world.alarm.kind == NONE, number
        assert world.instruments[0].tool.touching, number
