# SPDX-License-Identifier: BSD-3-Clause
"""F10: what is held asks for no more of a tick than a tick has; and S5, S7 of shipped scenes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import palpate
import pytest
from failure_scenes import NONE, TICK
from palpate.layout.costs import find_far_side
from palpate.layout.gaps import Surface, find_least
from palpate.runs.press import find_place
from palpate.runs.run import read_scene
from test_f06_layers import THICKNESS, make_layer

SCENES = Path(__file__).resolve().parents[2] / "meshes" / "scenes"


@pytest.fixture(scope="module")
def fossa() -> palpate.Scene:
    """A liver with its gallbladder."""
    return read_scene(SCENES / "liver_gallbladder.palpate")


def find_far_place(scene: palpate.Scene) -> tuple[np.ndarray, np.ndarray]:
    """[m] A point of the gallbladder across from the liver, and the way out from there."""
    surfaces = []
    for body in scene.bodies:
        x = np.array(palpate.compute_surface(body.tissue, body.tissue.rest_position))
        surfaces.append(Surface(x, np.array(body.tissue.triangles)))
    nearest = find_least(surfaces[1], surfaces[0], 2e-3, np.zeros(3))
    assert nearest is not None
    place = find_place(scene, find_far_side(surfaces[0], nearest), 0)
    return place.point, np.asarray(place.outward)


def flick(scene: palpate.Scene, speed: float) -> tuple[palpate.World, list[int], float]:
    """Takes hold 4 mm deep, pulls 12 mm out, throws it 24 mm back at a speed [m/s], lets go.

    Returns how it ended, the substeps of the gallbladder in every tick, and [m] the least gap.
    """
    point, out = find_far_place(scene)
    radius, now = scene.instruments[0].tool.radius, 0.0
    frames = []
    for lasts, height, buttons in ((0.0, 4e-3, 0), (0.2, -4e-3, 0), (0.1, -4e-3, 1),
                                   (0.2, 12e-3, 1), (0.1, 12e-3, 1), (24e-3 / speed, -12e-3, 1),
                                   (0.1, -12e-3, 1), (0.1, -12e-3, 0), (0.3, 2e-2, 0)):  # fmt: skip
        now += lasts
        frames.append(palpate.KeyFrame(now, point + (radius + height) * out, buttons))
    device, world = palpate.ScriptedDevice(frames), palpate.World(scene)
    substeps, least, held = [], np.inf, False
    for tick in range(round(now / TICK)):
        palpate.tick(scene, device.read(tick * TICK), TICK, world)
        substeps.append(world.bodies[0].substeps)
        least = min(least, world.body_pairs[0].least_gap)
        held = held or world.instruments[0].tool.hold_count > 0
        if world.alarm:
            break
    assert held
    return world, substeps, least


@pytest.mark.landing
def test_s5_an_organ_that_is_held_and_flicked_at_its_neighbour_at_1_m_s_does_not_come_through(
    fossa,
):
    world, _, least = flick(fossa, 1.0)

    assert world.alarm.kind == NONE
    assert least > 0.0


@pytest.mark.landing
def test_f10_no_tick_of_a_grasp_asks_for_more_substeps_than_the_body_may_have(fossa):
    """A late tick is one that does more: at worst a grasp that is flicked takes as many substeps as
    the scene allows, and is otherwise within twice those at rest."""
    _, substeps, _ = flick(fossa, 0.2)

    body = fossa.bodies[0]
    assert max(substeps) <= body.substeps_max
    assert np.median(substeps) <= 2 * body.substeps


@pytest.mark.parametrize("depth", [1e-4, 1e-3])
def test_s7_bodies_that_begin_overlapped_are_refused_with_how_deep_and_not_flung_apart(depth):

    bodies = [make_layer(0.03, 4, height, 5e3) for height in (0.0, THICKNESS - depth)]
    said = rf"vertex \d+ of body [01] {1e3 * depth:g} mm inside of body [01]"
    with pytest.raises(ValueError, match=said):
        palpate.build_scene(palpate.Scene(bodies=bodies, body_pairs=[palpate.BodyPair(0, 1)]))
