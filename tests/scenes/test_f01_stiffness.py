# SPDX-License-Identifier: BSD-3-Clause
"""F1: springs made stiffer at the same step. The first that blow up are those foretold."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import make_ball, open_springs

STEP = 1e-4
"""[s]"""
RATIO = 1.1
"""[-] from one stiffness to the next."""


def scale(tissue: palpate.TissueModel, factor: float) -> palpate.TissueModel:
    """The same undamped springs, so many times as stiff."""
    links = tissue.springs
    return palpate.TissueModel(
        rest_position=tissue.rest_position,
        mass=tissue.mass,
        fixed=tissue.fixed,
        triangles=tissue.triangles,
        home=factor * np.asarray(tissue.home),
        springs=palpate.Links(
            links.ends, links.rest_length, factor * np.asarray(links.stiffness),
            np.zeros(len(links.ends)),
        ),
    )  # fmt: skip


def blows_up(tissue: palpate.TissueModel) -> bool:
    """Whether a trembling a thousandth of a micrometre wide grows a thousandfold in 400 steps."""
    state, load = palpate.State(tissue), palpate.Load()
    x = np.asarray(tissue.rest_position)
    state.position[:] = x + 1e-9 * np.random.default_rng(1).standard_normal(x.shape)
    start = palpate.compute_energy(tissue, np.zeros(3), state).total()
    for _ in range(400):
        palpate.step(tissue, load, STEP, state)
    end = palpate.compute_energy(tissue, np.zeros(3), state).total()
    return not end < 1e3 * start


BODIES = ["ball of 42", "ball of 162", "spleen", "kidney"]


@pytest.mark.parametrize("name", BODIES)
def test_f1_over_four_decades_the_first_stiffness_that_blows_up_is_the_one_foretold(name):
    if name.startswith("ball"):
        mesh = make_ball(1 if name.endswith("42") else 2)
        tissue = palpate.build_mass_spring(mesh, palpate.Material(wall_thickness=3e-3), 60.0)
    else:
        tissue = open_springs(name).bodies[0].tissue
    one = scale(tissue, 1.0)
    # 2/w of the fastest mode is the step
    foretold = 4.0 / (STEP**2 * palpate.estimate_spectrum(one).stiffness)
    powers = np.arange(-np.log(100.0) / np.log(RATIO), np.log(100.0) / np.log(RATIO))
    factors = foretold * RATIO**powers
    assert factors[-1] / factors[0] > 9e3

    # it blows up from somewhere on, wherever one looks; that place is found by halving
    low, high = 0, len(factors) - 1
    assert not blows_up(scale(tissue, factors[low])) and blows_up(scale(tissue, factors[high]))
    for looked in (len(factors) // 4, 3 * len(factors) // 4):
        assert blows_up(scale(tissue, factors[looked])) == (factors[looked] > foretold)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if blows_up(scale(tissue, factors[middle])) else (middle, high)

    assert factors[high] == pytest.approx(foretold, rel=0.2)
