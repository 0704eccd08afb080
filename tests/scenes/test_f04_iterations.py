# SPDX-License-Identifier: BSD-3-Clause
"""F4: more iterations make a material stiffer. Here they do not, in the steps that a body gets."""

from __future__ import annotations

import palpate
import pytest
from failure_scenes import Hand, make_ball, make_block, make_scene, make_solid, make_springs

BODIES = {
    "springs": lambda: make_springs(make_ball()),
    "corotated": lambda: make_solid(palpate.build_corotated_solid, make_block()),
}


def press(tissue: palpate.TissueModel, integrator: palpate.Integrator, iterations: int) -> float:
    """[N] of a press 2 mm deep that is held."""
    scene = make_scene(tissue, integrator=integrator, iterations=iterations)
    return Hand(scene).go(-5e-4, 2e-3, 0.03).stay(2e-3, 0.1).mean(20)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("integrator", ["xpbd", "projective_dynamics"])
def test_f4_ten_and_fifty_iterations_feel_within_five_percent_of_each_other(body, integrator):
    kind = palpate.Integrator.__members__[integrator]
    tissue = BODIES[body]()
    exact = press(tissue, palpate.Integrator.symplectic_euler, 0)

    usual, many = (press(tissue, kind, count) for count in (10, 50))

    assert usual == pytest.approx(many, rel=0.05)
    assert many == pytest.approx(exact, rel=0.05)
