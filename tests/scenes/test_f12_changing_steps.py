# SPDX-License-Identifier: BSD-3-Clause
"""F12: the tick changes from 1 ms to 4 and back in the middle of a press."""

from __future__ import annotations

import palpate
import pytest
from failure_scenes import SURFACES, Hand, make_ball, make_block, make_scene, make_solid

FORMS = {
    **{law: lambda law=law: SURFACES[law](make_ball()) for law in SURFACES},
    "springs and volumes": lambda: make_solid(palpate.build_solid, make_block()),
    "linear": lambda: make_solid(palpate.build_linear_solid, make_block()),
}


@pytest.mark.parametrize("law", FORMS)
def test_f12_at_a_tick_of_4_ms_and_at_1_ms_again_the_press_rests_where_it_did(law):
    # the longest tick that comes is what a scene is built for
    hand = Hand(make_scene(FORMS[law](), rate=250.0)).go(-5e-4, 2e-3, 0.1, dt=1e-3)
    before = hand.stay(2e-3, 0.6, dt=1e-3).mean(50)

    during = hand.stay(2e-3, 0.6, dt=4e-3).mean(12)
    after = hand.stay(2e-3, 0.6, dt=1e-3).mean(50)

    assert before > 0.005
    assert during == pytest.approx(before, rel=2e-3)
    assert after == pytest.approx(before, rel=2e-3)
