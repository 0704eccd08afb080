# SPDX-License-Identifier: BSD-3-Clause
"""F16: a force that stands still between the ticks of a slow simulation, and then jumps."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import Hand, open_organ, open_springs
from tiers import keep_everyday

JUMP = 10e-3
"""[N] between two ticks, from which a hand may notice a stair; twice the true rate is none."""


def press(scene: palpate.Scene, parts: int = 1) -> np.ndarray:
    """[N] along the press, once a millisecond: 4 mm deep and out again, at 40 mm/s as a hand
    explores; each millisecond in so many ticks."""
    hand = Hand(scene).go(-1e-3, 4e-3, 0.125, dt=1e-3 / parts)
    hand.go(4e-3, -1e-3, 0.125, dt=1e-3 / parts)
    return (np.array(hand.force) @ hand.place.outward)[parts - 1 :: parts]


def find_jump(force: np.ndarray) -> float:
    return float(np.abs(np.diff(force)).max())


@pytest.mark.parametrize(
    "name", keep_everyday(["spleen", "gallbladder", "stomach", "simple_tissue"], ["spleen"])
)
def test_f16_at_1_khz_no_tick_jumps_by_what_a_hand_would_notice(name):
    force, finer = press(open_organ(name)), press(open_organ(name), parts=4)

    assert force.max() > 0.02
    assert find_jump(force) <= max(JUMP, 2.0 * find_jump(finer))


def test_f16_held_for_24_hz_the_same_force_jumps_far():
    force, period = press(open_springs("spleen"))[:125], round(1000 / 24)
    held = np.repeat(force[::period], period)

    assert find_jump(held) > 5.0 * find_jump(force)
    assert find_jump(held) > 2.0 * JUMP
