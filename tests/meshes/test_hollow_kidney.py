# SPDX-License-Identifier: BSD-3-Clause
"""The kidney that can be entered: in through the tract, through the neck, to the wall within."""

from __future__ import annotations

import numpy as np
import palpate
from palpate import scenario
from palpate_meshes.catalogue import PUBLISHED, read_regions
from palpate_meshes.generate.collecting_system import ENTRY, LOWER, LUMEN, MOUTH

SPEED, BEYOND = 0.06, 0.016
"""[m/s], and [m] that the hand goes on after the middle of the pelvis."""


LINING = ("lining of the pelvis", "lower calyx", "middle calyx", "upper calyx", "access tract")
DEPTH, ABOVE = 3e-3, 1e-3
"""[m] of a press from within, and how far over the wall it begins."""


def walk(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """[m] The hand's positions, one each tick, (ticks, 3)."""
    ticks = max(2, int(np.linalg.norm(end - start) / SPEED * 1000.0))
    return start + np.linspace(0.0, 1.0, ticks)[:, None] * (end - start)


def test_a_tip_meets_nothing_on_its_way_in_and_then_the_far_wall_of_the_pelvis():
    scene = scenario.read(PUBLISHED / "collecting_system.palpate").scene
    world = palpate.World(scene)

    def feel(positions: np.ndarray) -> np.ndarray:
        return np.array(
            [palpate.tick(scene, palpate.HapticSample(position=p), 1e-3, world).force
             for p in positions]
        )  # fmt: skip

    mouth, entry, neck, pelvis = (
        1e-3 * np.array(p[:3]) for p in (MOUTH, ENTRY, LOWER[1], LUMEN[1])
    )
    ahead = (pelvis - neck) / np.linalg.norm(pelvis - neck)
    inside = feel(np.concatenate([walk(mouth, entry), walk(entry, neck), walk(neck, pelvis)]))
    far = pelvis + BEYOND * ahead
    pressed, left = feel(walk(pelvis, far)), feel(walk(far, pelvis))

    assert not inside.any()
    assert not world.alarm
    assert 0.05 < -(pressed[-1] @ ahead) < 1.0
    assert not left[-1].any()


def test_its_walls_are_pressed_from_within_and_push_back():
    scene = scenario.read(PUBLISHED / "collecting_system.palpate").scene
    tissue = scene.bodies[0].tissue
    x = palpate.compute_surface(tissue, tissue.rest_position)
    normals = palpate.compute_vertex_normals(x, tissue.triangles)
    radius, regions = scene.instruments[0].tool.radius, read_regions("collecting_system")

    for vertex in (int(regions[name][len(regions[name]) // 2]) for name in LINING):
        over = x[vertex] + (radius + ABOVE) * normals[vertex]
        world = palpate.World(scene)
        for p in walk(over, over - (ABOVE + DEPTH) * normals[vertex]):
            force = palpate.tick(scene, palpate.HapticSample(position=p), 1e-3, world).force

        assert not world.alarm
        assert 0.01 < force @ normals[vertex] < 0.5
