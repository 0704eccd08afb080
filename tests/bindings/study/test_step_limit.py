# SPDX-License-Identifier: BSD-3-Clause
"""Limits that are found by running: those of oscillators and meshes, whose limits are known."""

from __future__ import annotations

import math

import numpy as np
import palpate
import pytest
from palpate.study.step_failure import holds_long_steps, measure_failure
from palpate.study.step_limit import (
    FINE,
    LIMIT_SHARE,
    foretell_limit,
    measure_limit,
)
from surfaces import MEMBRANE, ellipsoid

SYMPLECTIC, RK4 = palpate.Integrator.symplectic_euler, palpate.Integrator.runge_kutta_4
MIDPOINT, EXPLICIT = palpate.Integrator.midpoint, palpate.Integrator.explicit_euler
W = math.sqrt(1e5)
"""[1/s]"""


def make_oscillator(ratio: float = 0.0) -> palpate.TissueModel:
    """Two masses of 1 g, each on a spring of 100 N/m to where it rests: w = 316 1/s."""
    return palpate.TissueModel(
        rest_position=[[0.0, 0.0, 0.0], [0.01, 0.0, 0.0]],
        mass=[1e-3, 1e-3],
        home=[100.0, 100.0],
        drag=2.0 * ratio * W,
    )


@pytest.mark.parametrize("ratio", [0.0, 0.2, 0.9])
def test_symplectic_euler_fails_at_the_step_of_theory(ratio):
    found = measure_limit(make_oscillator(ratio), SYMPLECTIC, 2.0 / W)

    exact = 2.0 / W * (math.sqrt(1.0 + ratio**2) - ratio)
    assert found.limit == pytest.approx(exact, rel=0.02)
    assert found.held < found.failed <= FINE * found.held


def test_runge_kutta_4_fails_at_2_828_over_w():
    assert measure_limit(make_oscillator(), RK4, 2.0 / W).limit == pytest.approx(
        2.828 / W, rel=0.02
    )


@pytest.mark.parametrize(("integrator", "exact"), [(EXPLICIT, 1.8), (MIDPOINT, 1.93)])
def test_what_needs_damping_fails_where_its_factor_leaves_the_unit_circle(integrator, exact):
    """Of ratio 0.9: explicit Euler at 2 zeta/w; midpoint where |1 + z + z²/2| = 1."""
    z = 0.9
    turn = complex(-z, math.sqrt(1.0 - z * z))
    if integrator == MIDPOINT:
        grid = np.linspace(0.1, 3.0, 29_001)
        grown = np.abs(1.0 + grid * turn + (grid * turn) ** 2 / 2.0) > 1.0
        exact = float(grid[grown.argmax()])

    found = measure_limit(make_oscillator(z), integrator, 1.0 / W)

    assert W * found.limit == pytest.approx(exact, rel=0.03)


def test_undamped_explicit_euler_grows_at_steps_far_below_every_limit():
    found = measure_limit(make_oscillator(), EXPLICIT, 2.0 / W)

    assert foretell_limit(make_oscillator(), EXPLICIT) == 0.0
    assert found.failed < 0.1 * 2.0 / W


@pytest.mark.parametrize("integrator", [SYMPLECTIC, RK4, MIDPOINT])
def test_a_mesh_fails_where_it_is_foretold_and_holds_what_stable_step_gives(integrator):
    model = palpate.build_mass_spring(
        ellipsoid((0.05, 0.04, 0.03), 2),
        palpate.Material(density=1000.0, damping_ratio=0.4),
        50.0,
    )
    limit = foretell_limit(model, integrator)

    found = measure_limit(model, integrator, limit)

    assert limit * LIMIT_SHARE == pytest.approx(palpate.stable_step(model, integrator))
    assert found.held >= limit / FINE
    assert found.failed <= limit * (1.05 if integrator == SYMPLECTIC else 2.5)


def test_limits_are_the_same_every_time():
    assert measure_limit(make_oscillator(0.1), SYMPLECTIC, 2.0 / W) == measure_limit(
        make_oscillator(0.1), SYMPLECTIC, 2.0 / W
    )


def test_a_wall_under_pressure_is_knocked_where_it_comes_to_rest():
    mesh = ellipsoid((0.03, 0.03, 0.03), 1)
    options = palpate.SurfaceOptions()
    options.pressure = 50.0
    model = palpate.build_mass_spring(mesh, MEMBRANE, 50.0, options)

    found = measure_limit(model, SYMPLECTIC, foretell_limit(model, SYMPLECTIC))

    assert found.limit == pytest.approx(foretell_limit(model, SYMPLECTIC), rel=0.2)


@pytest.mark.parametrize("name", ["implicit_euler", "implicit_midpoint", "xpbd"])
def test_what_is_implicit_holds_long_steps(name):
    assert holds_long_steps(make_oscillator(), palpate.Integrator.__members__[name])


def test_implicit_euler_swallows_what_theory_says_and_implicit_midpoint_nothing():
    """It loses ln(1 + (w dt)²)/2 of its amplitude a step."""
    dt = 0.3 / W
    euler = measure_failure(make_oscillator(), palpate.Integrator.implicit_euler, dt)
    midpoint = measure_failure(make_oscillator(), palpate.Integrator.implicit_midpoint, dt)

    assert euler.loss == pytest.approx(1.0 - (1.0 + 0.3**2) ** -6, rel=0.1)
    assert abs(midpoint.loss) < 0.05


def test_implicit_midpoint_chatters_in_long_steps_and_not_in_short_ones():
    midpoint = palpate.Integrator.implicit_midpoint

    assert measure_failure(make_oscillator(), midpoint, 20.0 / W).chatter > 0.9
    assert measure_failure(make_oscillator(), midpoint, 0.1 / W).chatter < 0.1
