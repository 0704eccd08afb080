# SPDX-License-Identifier: BSD-3-Clause
"""F6: soft tissue pushed into soft tissue; and S1 to S7 of what touches besides."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import NONE, TICK, make_block

THICKNESS, GAP = 5e-3, 5e-4
"""[m] of each of two layers, and between them at rest."""
SPEED = 0.05
"""[m/s] of the hand."""


def make_layer(side: float, cells: int, height: float, modulus: float) -> palpate.SoftBody:
    """A layer around `height` [m], held at its four sides."""
    block = make_block((cells, cells, 2), (side, side, THICKNESS))
    points = np.asarray(block.vertices)
    rim = np.abs(points[:, :2]).max(axis=1) > 0.499 * side
    solid = palpate.SolidMesh(points + [0.0, 0.0, height], block.tetrahedra)
    material = palpate.Material(young_modulus=modulus, poisson_ratio=0.45, damping_ratio=0.2)
    options = palpate.SolidOptions(fixed=np.flatnonzero(rim))
    return palpate.SoftBody(tissue=palpate.build_solid(solid, material, options))


def make_layers(side=0.06, cells=12, radius=3e-3, moduli=(5e3, 5e3)) -> palpate.Scene:
    bodies = [
        make_layer(side, cells, height, modulus)
        for height, modulus in zip((0.0, THICKNESS + GAP), moduli, strict=True)
    ]
    instrument = palpate.Instrument(tool=palpate.Tool(radius=radius))
    return palpate.build_scene(
        palpate.Scene(bodies=bodies, instruments=[instrument], body_pairs=[palpate.BodyPair(0, 1)])
    )


def push(scene: palpate.Scene, depth: float) -> tuple[palpate.World, float]:
    """The ball goes `depth` [m] into the upper layer and rests; the least gap [m]."""
    world, sample, least = palpate.World(scene), palpate.HapticSample(), np.inf
    top = 1.5 * THICKNESS + GAP + scene.instruments[0].tool.radius + 1e-4
    for k in range(round((depth / SPEED + 0.1) / TICK)):
        sample.time = k * TICK
        sample.position = (0.001, 0.002, top - min(depth, SPEED * sample.time))
        palpate.tick(scene, sample, TICK, world)
        least = min(least, world.body_pairs[0].least_gap)
    return world, least


def count_inside(scene: palpate.Scene, world: palpate.World, body: int, other: int) -> int:
    """Vertices of the middle of a body that another goes round."""
    x = np.asarray(palpate.surface_position(world.bodies[body]))
    around = palpate.surface_position(world.bodies[other])
    triangles = scene.bodies[other].tissue.triangles
    near = x[np.abs(x[:, :2]).max(axis=1) < 0.02]
    numbers = [palpate.compute_winding_number(triangles, around, p) for p in near]
    return sum(number > 0.5 for number in numbers)


@pytest.mark.parametrize("radius", [3e-3, 8e-3])
def test_f6_two_layers_that_are_pushed_down_together_keep_apart(radius):
    scene = make_layers(radius=radius)

    world, least = push(scene, depth=0.012)

    assert world.alarm.kind == NONE
    assert least > 0.0
    assert world.body_pairs[0].touching > 20
    assert world.body_pairs[0].force[2] > 0.05
    assert count_inside(scene, world, 0, 1) == count_inside(scene, world, 1, 0) == 0


@pytest.mark.landing
@pytest.mark.parametrize("radius", [3e-3, 8e-3])
@pytest.mark.parametrize("moduli", [(5e3, 5e3), (5e4, 5e3), (5e3, 5e4)])
def test_f6_layers_of_100_mm_are_pushed_down_by_20(radius, moduli):
    scene = make_layers(side=0.1, cells=20, radius=radius, moduli=moduli)

    world, least = push(scene, depth=0.02)

    assert world.alarm.kind == NONE
    assert least > 0.0
    assert count_inside(scene, world, 0, 1) == count_inside(scene, world, 1, 0) == 0
