# SPDX-License-Identifier: BSD-3-Clause
"""A scripted hand takes the top of the shipped gallbladder with a grasper, pulls and lets go."""

from __future__ import annotations

from copy import copy

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.scene.scene_file import build_tool
from palpate.scene.scene_parts import ToolPart
from palpate_meshes.catalogue import PUBLISHED

GRASPER = ToolPart(
    radius=0.0012, friction=0.8, length=0.02, jaw_opening=0.52, grip_force=10.0, trocar_height=0.0
)
PULL = 0.012
"""[m] With 20 mm the wall pulls with 8 N, more than the friction of its pinch bears: it slips."""


def make_scene() -> palpate.Scene:
    scene = copy(scenario.read(PUBLISHED / "gallbladder.palpate").scene)
    scene.instruments[0].tool = build_tool(GRASPER)
    scene.instruments[0].coupling = palpate.Coupling(stiffness=500.0, force_max=10.0)
    return palpate.build_scene(scene)


class Hand:
    """Comes down on the highest vertex with open jaws, which open along x."""

    def __init__(self, scene: palpate.Scene) -> None:
        self.scene, self.world = scene, palpate.World(scene)
        x = np.asarray(scene.bodies[0].tissue.rest_position)
        self.at = x[x[:, 2].argmax()] + [0.0, 0.0, 0.03]
        self.turn = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
        self.forces: list[np.ndarray] = []

    def go(self, way: float, ticks: int, closed: bool) -> None:
        start = self.at
        for k in range(1, ticks + 1):
            self.at = start + np.array([0.0, 0.0, way * k / ticks])
            sample = palpate.HapticSample(
                position=self.at,
                orientation=self.turn,
                buttons=palpate.ATTACH_BUTTON if closed else 0,
            )
            force = palpate.tick(self.scene, sample, 1e-3, self.world).force
            self.forces.append(np.array(force))
            assert not self.world.alarm

    def grasp_and_pull(self) -> None:
        self.go(-0.042, 300, closed=False)
        self.go(0.0, 250, closed=True)
        self.go(PULL, 800, closed=True)
        self.go(0.0, 600, closed=True)


@pytest.mark.landing
def test_the_top_is_taken_pulled_and_let_go():
    scene = make_scene()
    hand, other = Hand(scene), Hand(scene)
    hand.grasp_and_pull()
    tool = hand.world.instruments[0].tool

    held = np.linalg.norm(hand.forces[-300:], axis=1)
    assert tool.pinches and tool.pinch > 3.0 and tool.pad_pressure > 1e5
    assert held.min() > 3.0
    assert np.ptp(held) < 0.01 * held.mean()
    assert tool.held_load <= 2.0 * 0.8 * tool.pinch * (1.0 + 1e-9)

    other.grasp_and_pull()
    assert palpate.compute_hash(hand.world) == palpate.compute_hash(other.world)

    before = len(hand.forces)
    hand.go(0.0, 200, closed=False)
    steps = np.linalg.norm(np.diff(hand.forces[before - 1 :], axis=0), axis=1)
    assert steps.max() < 0.25 * held.mean()
    assert not hand.world.instruments[0].tool.has_hold()
    assert np.linalg.norm(hand.forces[-1]) == 0.0
