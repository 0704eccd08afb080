# SPDX-License-Identifier: BSD-3-Clause
"""Skin, fat and muscle with a lump: it is felt before anything of it is seen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate import scenario
from palpate_meshes.build_scenes import LAYERS, build_block_scene, choose_layers, make_layered_block
from palpate_meshes.generate.layered_block import (
    ACROSS,
    FAT,
    HEIGHTS,
    LUMP,
    MUSCLE,
    SIDE,
    SKIN,
    TOP,
    find_layer_values,
    find_lump_share,
    layered_block,
)

PUBLISHED = Path(palpate_meshes.__file__).parent / "scenes" / "layered_block.palpate"
OVER = np.array(LUMP.centre[:2])
BESIDE = -OVER
"""[m] x and y of a place that mirrors the one over the lump, in a block that is the same there."""


@pytest.fixture(scope="module")
def blocks() -> tuple[palpate.Scene, palpate.Scene]:
    """With the lump, and without."""
    return build_block_scene(), build_block_scene(lump=None)


def press(scene: palpate.Scene, at: np.ndarray, depth: float) -> tuple[float, np.ndarray]:
    """[N] The force 0.2 s after the pad has come to a depth [m], and [m] (n,) how far the vertices
    of the upper face that it leaves free have risen."""
    world, sample = palpate.World(scene), palpate.HapticSample()
    radius = scene.instruments[0].tool.radius
    force = 0.0
    for tick in range(round(depth / 3e-5) + 200):
        sample.position = (*at, TOP + radius + 1e-4 - min(depth, 3e-5 * tick))
        force = palpate.tick(scene, sample, 1e-3, world).force[2]
        assert not world.alarm
    rest = np.asarray(scene.bodies[0].tissue.rest_position)
    free = (rest[:, 2] > TOP - 1e-9) & (np.linalg.norm(rest[:, :2] - at, axis=1) > 1.5 * radius)
    return force, (np.asarray(world.bodies[0].tissue.position) - rest)[free, 2]


def test_the_block_is_as_large_as_its_layers_and_every_tetrahedron_has_a_volume():
    points, tetrahedra = layered_block()
    corners = points[tetrahedra]
    edges = corners[:, 1:] - corners[:, :1]

    volumes = np.linalg.det(edges) / 6.0

    assert len(points) == (ACROSS + 1) ** 2 * len(HEIGHTS)
    assert volumes.min() > 0.0
    assert volumes.sum() == pytest.approx(SIDE**2 * (SKIN + FAT + MUSCLE))
    assert np.ptp(points, axis=0) == pytest.approx([SIDE, SIDE, TOP])


def test_each_layer_has_its_own_value_and_the_lump_fades_over_a_quarter_of_its_radius():
    heights = np.array([[0, 0, z] for z in (1e-3, MUSCLE, MUSCLE + 1e-3, MUSCLE + FAT, TOP)])
    assert find_layer_values(heights, (4.0, 1.0, 3.0)) == pytest.approx([3.0, 2.0, 1.0, 2.5, 4.0])
    at = np.array(LUMP.centre) + np.outer(LUMP.radius * np.array([0.0, 0.8, 1.0, 1.2]), (1, 0, 0))
    assert find_lump_share(at) == pytest.approx([1.0, 1.0, 0.5, 0.0])


def test_layers_are_those_of_the_library_each_checked_in_its_source():
    layers = choose_layers()
    assert [layer.name for layer in layers] == list(LAYERS)
    skin, fat, muscle = (layer.young_modulus for layer in layers)
    assert fat < skin < muscle
    assert all(layer.status == "checked" and layer.source for layer in layers)


@pytest.mark.landing
def test_the_lump_is_felt_before_it_is_seen(blocks):
    block, without = blocks
    rest = np.asarray(block.bodies[0].tissue.rest_position)
    upper = rest[:, 2] > TOP - 5e-4
    assert np.ptp(rest[upper, 2]) == 0.0  # nothing stands out of an untouched block

    over, risen = press(block, OVER, 4e-3)
    beside, risen_beside = press(block, BESIDE, 4e-3)
    alike, risen_alike = press(without, OVER, 4e-3)

    assert over / beside > 1.5
    assert alike == pytest.approx(beside, rel=0.05)
    # a fold of the skin in good light is a tenth of a millimetre
    assert np.abs(risen - risen_alike).max() < 1e-4
    assert risen.max() < 5e-4
    assert risen.max() - risen_beside.max() < 5e-5


@pytest.mark.landing
def test_the_scene_that_ships_is_what_its_generator_makes():
    kept, made = scenario.read(PUBLISHED), make_layered_block()

    for name in ("springs", "volumes"):
        column = "stiffness" if name == "springs" else "bulk"
        rows = [getattr(getattr(s.scene.bodies[0].tissue, name), column) for s in (kept, made)]
        np.testing.assert_allclose(*rows, rtol=1e-9)
    np.testing.assert_allclose(
        kept.scene.bodies[0].tissue.rest_position, made.scene.bodies[0].tissue.rest_position
    )
    assert (kept.title, kept.task, kept.languages["tr"].title) == (
        made.title, made.task, made.languages["tr"].title)  # fmt: skip
    assert len(np.unique(kept.authored_arrays["surface/colours"], axis=0)) == 3
