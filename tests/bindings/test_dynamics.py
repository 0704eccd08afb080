# SPDX-License-Identifier: BSD-3-Clause
"""Forces, energies, tangents and steps as Python calls them."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
import scipy.sparse
from surfaces import MEMBRANE, chain, ellipsoid

EXPLICIT = [
    "explicit_euler",
    "symplectic_euler",
    "midpoint",
    "runge_kutta_4",
    "symplectic_euler_implicit_damping",
]
IMPLICIT = [
    "implicit_euler_linear",
    "implicit_euler",
    "implicit_midpoint",
    "xpbd",
    "projective_dynamics",
]


def molecular_model() -> palpate.TissueModel:
    constants = palpate.MolecularConstants(
        bond_stiffness=50.0, bend_stiffness=2e-5, stretch_coupling=0.01
    )
    options = palpate.SurfaceOptions(fixed=[0, 1], pressure=20.0)
    mesh = ellipsoid((0.03, 0.025, 0.02), 1)
    return palpate.build_molecular(mesh, MEMBRANE, constants, options)


def shaken(model: palpate.TissueModel) -> palpate.State:
    state = palpate.State(model)
    state.position[:] += np.random.default_rng(5).normal(0.0, 5e-4, state.position.shape)
    return state


def test_a_link_stretched_by_1_mm_pulls_its_ends_together_with_k_times_1_mm():
    links = palpate.Links([(0, 1)], [0.010], [200.0], [0.0])
    x = np.array([[0.0, 0.0, 0.0], [0.011, 0.0, 0.0]])
    f = np.zeros((2, 3))

    palpate.accumulate_link_forces(links, palpate.DampingLaw.axis, x, np.zeros_like(x), f)

    assert f[0, 0] == pytest.approx(0.2)
    assert (f[0] + f[1] == 0.0).all()


def test_kernels_add_to_what_is_there():
    f = np.ones((2, 3))

    palpate.accumulate_gravity([1.0, 2.0], (0.0, 0.0, -10.0), f)
    palpate.accumulate_drag([1.0, 2.0], 0.5, [(0, 0, 0), (0, 4, 0)], f)

    assert f.tolist() == [[1.0, 1.0, -9.0], [1.0, -3.0, -19.0]]


def test_a_push_is_shared_by_its_weights():
    f = np.zeros((3, 3))
    push = palpate.Push(0, (0.5, 0.25, 0.25), (0.0, 0.0, 4.0))
    load = palpate.Load(1)

    palpate.accumulate_push_forces([(0, 1, 2)], palpate.Skin(), [push], f)

    assert load.add(push)
    assert not load.add(push)
    assert load.pushes()["force"].tolist() == [[0.0, 0.0, 4.0]]
    palpate.accumulate_push_forces([(0, 1, 2)], palpate.Skin(), load.pushes(), f)
    assert f[:, 2].tolist() == [4.0, 2.0, 2.0]


def test_the_sum_of_the_kernels_is_what_compute_forces_gives():
    model = molecular_model()
    state = shaken(model)
    x, v = state.position, np.zeros_like(state.position)
    load = palpate.Load()
    load.gravity = (0.0, 0.0, -9.81)
    together, parts = np.empty_like(x), np.zeros_like(x)

    palpate.compute_forces(model, load, x, v, together)
    palpate.accumulate_link_forces(model.bonds, model.damping_law, x, v, parts)
    palpate.accumulate_angle_forces(model.angles, x, parts)
    palpate.accumulate_home_forces(model.home, model.rest_position, x, parts)
    palpate.accumulate_pressure_forces(model.triangles, model.pressure, x, parts)
    palpate.accumulate_gravity(model.mass, load.gravity, parts)

    assert together == pytest.approx(parts, rel=1e-12, abs=1e-15)
    assert np.abs(together).max() > 1e-3


def test_force_is_the_negative_gradient_of_the_energy():
    model = molecular_model()
    state = shaken(model)
    f = np.empty_like(state.position)
    palpate.compute_forces(model, palpate.Load(), state.position, np.zeros_like(f), f)
    h = 1e-7

    for particle, axis in [(5, 0), (17, 1), (40, 2)]:
        energies = []
        for sign in (-1.0, 2.0):
            state.position[particle, axis] += sign * h
            energies.append(palpate.compute_energy(model, (0, 0, 0), state).total())
        state.position[particle, axis] -= h
        assert -(energies[1] - energies[0]) / (2 * h) == pytest.approx(
            f[particle, axis], rel=1e-5, abs=1e-8
        )


def test_stiffness_is_sparse_and_the_negative_derivative_of_the_force():
    model = molecular_model()
    model.pressure = 0.0
    state = shaken(model)
    x = state.position
    n = x.size
    rest = np.zeros_like(x)

    def force(moved: np.ndarray) -> np.ndarray:
        f = np.empty_like(x)
        palpate.compute_forces(model, palpate.Load(), moved, rest, f)
        return f.ravel()

    stiffness = palpate.compute_stiffness(model, x, palpate.Projection.none)
    h = 1e-7
    columns = range(3 * len(model.fixed), n, 7)

    assert scipy.sparse.issparse(stiffness)
    assert stiffness.format == "csc"
    assert stiffness.shape == (n, n)
    assert stiffness[: 3 * len(model.fixed)].nnz == 0
    free = np.arange(n) >= 3 * len(model.fixed)
    for column in columns:
        offset = np.zeros(n)
        offset[column] = h
        offset = offset.reshape(x.shape)
        slope = -(force(x + offset) - force(x - offset)) / (2 * h)
        assert stiffness[:, [column]].toarray().ravel()[free] == pytest.approx(
            slope[free], rel=1e-4, abs=1e-3
        )


def test_damping_of_a_chain_is_drag_and_dashpots():
    model = chain(2, mass=2.0, damping=3.0)
    model.drag = 0.5

    damping = palpate.compute_damping(model, model.rest_position).toarray()

    assert damping[3:, 3:].diagonal() == pytest.approx([4.0, 1.0, 1.0])


@pytest.mark.parametrize("name", EXPLICIT)
def test_an_explicit_integrator_follows_an_oscillator(name):
    model = chain(2, mass=1e-3, stiffness=100.0)
    state = palpate.State(model)
    state.position[1, 0] += 1e-3
    w = (100.0 / 1e-3) ** 0.5
    steps = 2000
    dt = 2 * np.pi / w / steps
    integrator = palpate.find_integrator(name)

    for _ in range(steps):
        palpate.step(model, palpate.Load(), dt, integrator, state)

    assert palpate.integrator_name(integrator) == name
    assert state.time == pytest.approx(2 * np.pi / w)
    assert state.position[1, 0] == pytest.approx(0.011, abs=2e-5)


def test_the_default_step_is_symplectic_euler():
    model = chain(4, damping=0.01)
    one, other = palpate.State(model), palpate.State(model)
    for state in (one, other):
        state.velocity[3] = (0.1, 0.2, 0.3)

    for _ in range(50):
        palpate.step(model, palpate.Load(), 1e-4, one)
        palpate.step(model, palpate.Load(), 1e-4, palpate.Integrator.symplectic_euler, other)

    assert np.array_equal(one.position, other.position)


@pytest.mark.parametrize("name", IMPLICIT)
def test_an_implicit_stepper_stands_steps_no_explicit_one_would(name):
    model = chain(5)
    stepper = palpate.ImplicitStepper(model, palpate.find_integrator(name))
    state = palpate.State(model)
    state.velocity[4, 0] = 0.1

    iterations = [stepper.step(palpate.Load(), 0.3, state) for _ in range(20)]

    assert min(iterations) >= 1
    assert np.abs(state.position - model.rest_position).max() < 0.01


def test_an_unknown_integrator_is_not_found():
    assert palpate.find_integrator("leapfrog") is None


def test_the_alarm_is_a_value_that_is_false_until_something_is_wrong():
    model = chain(3)
    state = palpate.State(model)
    guard = palpate.Guard(model, (0, 0, 0), state)

    assert not palpate.check(model, (0, 0, 0), state, 0.0, guard)
    state.position[2] = np.nan
    alarm = palpate.check(model, (0, 0, 0), state, 0.0, guard)

    assert alarm
    assert alarm.kind is palpate.AlarmKind.not_finite
    assert alarm.index == 2


def test_a_guard_that_knows_of_other_links_is_refused():
    model = chain(3)
    state = palpate.State(model)
    guard = palpate.Guard(model, (0, 0, 0), state)
    guard.torn_links = [0] * (len(model.springs.ends) + len(model.bonds.ends) - 1)

    with pytest.raises(ValueError, match=r"guard\.torn_links"):
        palpate.check(model, (0, 0, 0), state, 0.0, guard)
