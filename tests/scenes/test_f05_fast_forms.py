# SPDX-License-Identifier: BSD-3-Clause
"""F5: a fast form of a method diverges where the exact one holds. Here all forms feel the same."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import SURFACES, Hand, make_ball, make_block, make_scene, make_solid

SAME, PASSING = 5e-3, 0.03
"""[-] of the largest force: the root mean square, and while something snaps through."""


def press(tissue: palpate.TissueModel, **body: object) -> np.ndarray:
    """[N] (n, 3) of a press, a hold and a slide aside."""
    hand = Hand(make_scene(tissue, **body)).go(-1e-3, 3e-3, 0.1).stay(3e-3, 0.1)
    return np.array(hand.stay(3e-3, 0.1, aside=3e-3).force)


@pytest.mark.parametrize("law", [*SURFACES, "springs and volumes"])
def test_f5_vector_code_feels_as_plain_code_does(law):
    solid = law not in SURFACES
    tissue = make_solid(palpate.build_solid, make_block()) if solid else SURFACES[law](make_ball())

    plain = press(tissue, kernel=palpate.Kernel.reference)
    fast = press(tissue, kernel=palpate.Kernel.packed)

    assert np.abs(plain).max() > 0.01
    apart, largest = np.linalg.norm(fast - plain, axis=1), np.abs(plain).max()
    assert np.sqrt((apart**2).mean()) < SAME * largest
    assert apart.max() < PASSING * largest


def test_f5_the_response_of_a_linear_solid_rests_where_its_masses_do():
    tissue = make_solid(palpate.build_linear_solid, make_block())

    def hold(kernel: palpate.Kernel) -> float:
        return Hand(make_scene(tissue, kernel=kernel)).go(-5e-4, 2e-3, 0.1).stay(2e-3, 0.6).mean(50)

    assert hold(palpate.Kernel.automatic) == pytest.approx(hold(palpate.Kernel.reference), rel=0.02)


@pytest.mark.parametrize("depth", [5e-4, 2e-3])
@pytest.mark.parametrize("name", ["runge_kutta_4", "implicit_midpoint"])
def test_f5_integrators_of_stages_feel_a_held_press_as_symplectic_euler_does(name, depth):
    """What contacts push with, held over the stages, gave 2 to 6 times the force."""
    tissue = SURFACES["springs"](make_ball())

    def hold(which: palpate.Integrator) -> tuple[float, float]:
        hand = Hand(make_scene(tissue, integrator=which)).go(-5e-4, depth, 0.05).stay(depth, 0.15)
        force = np.linalg.norm(np.array(hand.force)[-20:], axis=1)
        return float(force.mean()), float(np.ptp(force))

    usual, ringing = hold(palpate.Integrator.symplectic_euler)
    felt, trembling = hold(getattr(palpate.Integrator, name))
    assert felt == pytest.approx(usual, rel=0.03)
    assert trembling < 1.5 * ringing


@pytest.mark.parametrize(
    ("law", "name"),
    [
        ("springs", "explicit_euler"),
        ("springs", "midpoint"),
        ("springs", "runge_kutta_4"),
        pytest.param("molecules", "explicit_euler", marks=pytest.mark.landing),
        pytest.param("a wall of prisms", "explicit_euler", marks=pytest.mark.landing),
    ],
)
def test_f5_what_is_held_for_a_second_raises_no_alarm_of_energy(law, name):
    """By the work of its kicks explicit Euler gave away energy at rest, until its own was beyond
    what was left.
    """
    integrator = getattr(palpate.Integrator, name)
    hand = Hand(make_scene(SURFACES[law](make_ball()), integrator=integrator))

    hand.go(-5e-4, 2e-3, 0.05).stay(2e-3, 1.0)

    assert not hand.world.alarm


def test_f5_implicit_euler_feels_a_held_press_as_symplectic_euler_does():
    tissue = SURFACES["springs"](make_ball())

    def hold(which: palpate.Integrator) -> float:
        scene = make_scene(tissue, integrator=which)
        return Hand(scene).go(-5e-4, 2e-3, 0.05).stay(2e-3, 0.15).mean(20)

    usual = hold(palpate.Integrator.symplectic_euler)
    assert hold(palpate.Integrator.implicit_euler) == pytest.approx(usual, rel=0.02)
