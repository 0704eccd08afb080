# SPDX-License-Identifier: BSD-3-Clause
"""A grasper tears every organ that ships, where its tissue tears: without an alarm, and alike."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.runs.live import LiveRun
from palpate.runs.press import find_top
from palpate.scene.surfaces import join_torn
from test_grasped_organs import DEPTH, ORGANS, leave, take, turn_to
from test_long_grasps import open_scene, write_grasps

STRETCH = 1.05
"""[-] At which tissue tears here: below what is usual, so that all of it does."""
FRAMES = (
    *((0.3, None, 0), (0.4, None, 1), (0.7, None, 1), (1.3, 0.025, 1), (1.8, 0.025, 1)),
    *((1.85, 0.025, 0), (2.3, 0.045, 0), (2.6, 0.045, 0)),
)
"""[s], [m] over the surface at rest, None at the depth, and the button: taken at the top, drawn far
out, held, let go of."""


def draw_out(name: str, stretch: float) -> tuple[np.ndarray, int, bytes]:
    """[N] (ticks,) what is felt, what has torn at the end, and the hash of that."""
    scene = take(name)
    scene.bodies[0].tear_stretch = stretch
    tissue, place = scene.bodies[0].tissue, find_top(scene)
    x = palpate.compute_surface(tissue, tissue.rest_position)
    centre, outward = x.mean(axis=0), np.asarray(place.outward)
    end = leave(centre, np.linalg.norm(x - centre, axis=1).max() + 0.03, place)
    frames = [palpate.KeyFrame(0.0, end)] + [
        palpate.KeyFrame(
            time, place.point + (-DEPTH if height is None else height) * outward, buttons=button
        )
        for time, height, button in FRAMES
    ]
    device, world, felt = palpate.ScriptedDevice(frames), palpate.World(scene), []
    for tick in range(round(FRAMES[-1][0] * scene.rate)):
        sample = device.read(tick / scene.rate)
        sample.orientation = turn_to(outward)
        felt.append(np.linalg.norm(palpate.tick(scene, sample, 1.0 / scene.rate, world).force))
        assert not world.alarm, (name, tick, world.alarm)
    return np.array(felt), world.bodies[0].torn_count, palpate.compute_hash(world)


FUNDUS = (
    *((0.0, 0.015, 0), (0.3, -0.012, 0), (0.35, -0.012, 1), (0.6, -0.012, 1)),
    *((1.2, 0.02, 1), (1.8, 0.02, 1), (1.85, 0.02, 0), (2.4, 0.05, 0)),
)
"""[s], [m] over the surface at rest, and the button."""


def draw_fundus(stretch: float) -> tuple[np.ndarray, int, bytes]:
    """The gallbladder of `gallbladder_grasp`, taken where its task says and drawn out by 20 mm."""
    scene, task = open_scene("gallbladder_grasp")
    scene.bodies[0].tear_stretch = stretch
    hand, world, felt = write_grasps(scene, task, 0, 1, FUNDUS), palpate.World(scene), []
    for tick in range(2400):
        command = palpate.tick(scene, hand.read(tick / scene.rate), 1.0 / scene.rate, world)
        felt.append(np.linalg.norm(command.force))
        assert not world.alarm, (tick, world.alarm)
    return np.array(felt), world.bodies[0].torn_count, palpate.compute_hash(world)


@pytest.mark.landing
def test_a_gallbladder_that_is_drawn_too_far_tears_in_the_jaws():
    whole, none, _ = draw_fundus(0.0)
    felt, count, end = draw_fundus(1.25)

    assert none == 0 and count > 0
    assert felt.max() < 0.8 * whole.max()  # 4.4 of 6.7 N
    assert felt[1700] < 0.5 * whole[1700]  # 0.3 of 5.6 N
    steps = np.abs(np.diff(felt[1000:1800]))
    assert steps.max() < 0.1 * felt.max()  # 0.1 N
    assert draw_fundus(1.25)[1:] == (count, end)


@pytest.mark.landing
@pytest.mark.parametrize("stretch", [0.0, 1.3])
def test_where_tissue_has_torn_is_told_to_who_draws_it(stretch):
    scene, task = open_scene("gallbladder_grasp")
    scene.bodies[0].tear_stretch = stretch
    hand = write_grasps(scene, task, 0, 1, FUNDUS)
    frame = None
    with LiveRun(scene, hand, options=palpate.LoopOptions(duration=2.0)) as run:
        assert run.wait(60.0)
        frame = run.take_frame()

    assert frame is not None
    torn = join_torn(frame.torn, frame.positions)
    assert (torn is None) == (stretch == 0.0)
    if torn is None:
        return
    x = palpate.compute_surface(scene.bodies[0].tissue, scene.bodies[0].tissue.rest_position)
    assert torn.shape == (len(x),) and torn.max() == 1.0
    # what the jaws have taken, and nothing on the other side of the organ
    taken = np.asarray(hand.read(0.5).position)
    assert np.linalg.norm(x[torn > 0.0] - taken, axis=1).max() < 0.03
    assert (torn == 0.0).sum() > 0.5 * len(torn)


@pytest.mark.verify
@pytest.mark.parametrize("name", ORGANS)
def test_an_organ_that_tears_raises_no_alarm_and_tears_alike_each_time(name):
    _, count, end = draw_out(name, STRETCH)

    assert count > 0
    assert draw_out(name, STRETCH)[1:] == (count, end)
