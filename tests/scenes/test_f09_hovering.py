# SPDX-License-Identifier: BSD-3-Clause
"""F9: a tool that hovers a tenth of a millimetre over tissue is felt as nothing at all."""

from __future__ import annotations

import numpy as np
import pytest
from failure_scenes import SURFACES, Hand, make_ball, make_scene, open_organ, open_springs

RESOLUTION = 0.012
"""[N] of the arm: one step of its motors' 8 bits."""


@pytest.mark.parametrize("name", ["spleen", "gallbladder", "simple_tissue"])
def test_f9_over_a_shipped_organ_nothing_is_felt(name):
    hand = Hand(open_organ(name)).stay(-1e-4, 0.5)

    assert not np.any(hand.force)


@pytest.mark.parametrize("law", SURFACES)
def test_f9_over_a_rubber_band_of_a_wall_that_still_swings_nothing_is_felt(law):
    hand = Hand(make_scene(SURFACES[law](make_ball())))
    hand.go(0.0, 2e-3, 0.05).go(2e-3, -5e-3, 0.02)
    away = len(hand.force)

    hand.stay(-5e-3, 1.0).stay(-1e-4, 1.0)

    noise = np.diff(np.linalg.norm(hand.force[away + 900 :], axis=1))
    assert np.sqrt((noise**2).mean()) < RESOLUTION
    assert np.linalg.norm(hand.force[-300:], axis=1).max() < RESOLUTION


def test_f9_over_an_organ_of_springs_nothing_is_felt():
    hand = Hand(open_springs("gallbladder")).stay(-1e-4, 0.5)

    assert not np.any(hand.force)
