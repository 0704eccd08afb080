# SPDX-License-Identifier: BSD-3-Clause
"""Equilibria: by hand on chains, and by the energy on organs."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.study import statics
from palpate.study.statics import Press, Unbalanced, compute_pull, follow, measure_energy, respond
from round_surfaces import ball

OUT = np.array([1.0, 0.0, 0.0])


def make_chain(n: int = 5, stiffness: float = 100.0) -> palpate.TissueModel:
    """n springs of 10 mm along +x, the first end held."""
    x = np.zeros((n + 1, 3))
    x[:, 0] = 0.01 * np.arange(n + 1)
    ends = np.stack([np.arange(n), np.arange(1, n + 1)], axis=1)
    springs = palpate.Links(ends, np.full(n, 0.01), np.full(n, stiffness), np.zeros(n))
    return palpate.TissueModel(
        rest_position=x, mass=np.full(n + 1, 1e-3), fixed=[0], springs=springs
    )


def make_ball() -> tuple[palpate.TissueModel, np.ndarray]:
    """A shell of springs with home springs, held below, and its highest particles."""
    x, triangles = ball(200, 0.03)
    z = x[:, 2] / 0.03
    mesh = palpate.SurfaceMesh(x, triangles)
    options = palpate.SurfaceOptions(fixed=np.flatnonzero(z < -0.6), home_stiffness=2e5)
    model = palpate.build_mass_spring(mesh, palpate.Material(), 60.0, options)
    return model, np.flatnonzero(z > 0.9).astype(np.int32)


def test_a_chain_that_is_pulled_shares_the_way_among_its_springs():
    press = Press(make_chain(), np.array([5]), OUT)

    (x, force), (_, far) = follow(press, [-0.004, -0.02], 0.01)

    assert x[:, 0] == pytest.approx(0.0108 * np.arange(6))
    assert force == pytest.approx(-100.0 * 0.004 / 5)
    assert far == pytest.approx(-100.0 * 0.02 / 5)


def test_the_linear_answer_of_a_chain_is_one_spring_after_another():
    unit, stiffness = respond(Press(make_chain(), np.array([5]), OUT))

    assert stiffness == pytest.approx(100.0 / 5)
    assert unit[:, 0] == pytest.approx(-0.2 * np.arange(6))


def test_a_held_particle_of_the_patch_stays_held():
    press = Press(make_chain(), np.array([0, 5]), OUT)

    x, _ = next(follow(press, [-0.004], 0.01))

    assert press.movable().tolist() == [5]
    assert not x[0].any()


def test_an_organ_comes_to_rest_where_nothing_pulls_on_what_is_free():
    model, top = make_ball()
    press = Press(model, top, np.array([0.0, 0.0, 1.0]))

    for x, _ in follow(press, [0.002, 0.006], 0.002):
        f = compute_pull(model, x)
        assert np.abs(f[press.free()]).max() < 1e-7 * np.abs(f).max()


def test_the_force_of_a_press_is_the_slope_of_the_energy():
    model, top = make_ball()
    press = Press(model, top, np.array([0.0, 0.0, 1.0]))
    state = palpate.State(model)

    found = list(follow(press, [0.00499, 0.005, 0.00501], 0.002))

    energy = [measure_energy(model, state, x) for x, _ in found]
    assert found[1][1] == pytest.approx((energy[2] - energy[0]) / 2e-5, rel=1e-4)


def test_a_shallow_press_answers_as_the_tangent_says():
    model, top = make_ball()
    press = Press(model, top, np.array([0.0, 0.0, 1.0]))
    unit, stiffness = respond(press)

    x, force = next(follow(press, [1e-6], 0.002))

    assert force == pytest.approx(1e-6 * stiffness, rel=1e-3)
    assert (x - np.asarray(model.rest_position)) / 1e-6 == pytest.approx(unit, abs=2e-3)


def test_what_cannot_be_balanced_says_how_far_it_came(monkeypatch):
    press = Press(make_chain(), np.array([5]), OUT)
    balance = statics.balance
    # as if the tissue gave way at 3 mm
    monkeypatch.setattr(statics, "balance", lambda press, x: give_way(balance, press, x))

    found = follow(press, [-0.002, -0.006], 0.002)

    next(found)
    with pytest.raises(Unbalanced, match=r"no equilibrium beyond a depth of -3\.00 mm"):
        next(found)


def give_way(balance, press: Press, x: np.ndarray) -> np.ndarray:
    if x[5, 0] > 0.053 + 1e-12:
        raise Unbalanced("it gave way")
    return balance(press, x)
