# SPDX-License-Identifier: BSD-3-Clause
"""F15: a force that is gone, or another, after an upgrade."""

from __future__ import annotations

import pytest
from failure_scenes import Hand, open_springs

PRESSED = {"spleen": 0.2218, "kidney": 0.0948, "gallbladder": 0.1297, "simple_tissue": 0.3671}
"""[N] of organs of springs that shipped long ago, whose records are kept beside them."""


@pytest.mark.parametrize("name", PRESSED)
def test_f15_a_slow_press_of_an_organ_that_shipped_long_ago_feels_as_it_did(name):
    felt = Hand(open_springs(name)).go(-1e-3, 4e-3, 0.2).stay(4e-3, 0.4).mean(50)

    assert felt == pytest.approx(PRESSED[name], rel=0.02)
