# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that has taken hold: beside what follows by hand where its springs are soft, and stiff."""

from __future__ import annotations

import numpy as np
import pytest
from half_spaces import SOFT, build_half_space
from palpate.study.half_space import plane_modulus
from palpate_editor.truth import hold
from palpate_editor.truth.contact import PENALTY, Patch, press_ball
from palpate_editor.truth.hold import Hold, pull_ball

RADIUS, GRIP = 5e-3, 0.5e-3
UP = np.array([0.0, 0.0, 1.0])
STIFF = PENALTY * plane_modulus(*SOFT) / RADIUS


def build_patch(count: int = 15) -> tuple[Patch, np.ndarray]:
    """Squares of one pressure each on a half space [Boussinesq85]; along the surface they do not
    move."""
    patch = build_half_space(RADIUS, 2e-3, count)
    return patch, np.kron(patch.compliance, np.outer(UP, UP))


def pull(stiffness: float, depths: list[float]) -> list:
    patch, whole = build_patch()
    return pull_ball(patch, whole, UP, Hold(stiffness, GRIP), np.array(depths), STIFF)


def press():
    patch, _ = build_patch()
    return patch, press_ball(patch, np.array([GRIP]), STIFF)[0]


def test_at_the_grip_a_hold_adds_nothing():
    _, pressed = press()

    found = pull(500.0, [GRIP])[0]

    assert found.force == pytest.approx(pressed.force, rel=1e-6)


def test_springs_too_soft_to_move_anything_are_stretched_from_the_dent_to_the_ball():
    """k (T - s), s what the surface has risen from the grip on, weighted as the pressure was."""
    patch, pressed = press()
    share = pressed.push / pressed.push.sum()
    risen = float(share @ (patch.compliance @ pressed.push))

    low, high = pull(1e-4, [-1e-3, -2e-3])

    assert low.force == pytest.approx(-1e-4 * (1e-3 + GRIP - risen), rel=1e-4)
    assert high.force - low.force == pytest.approx(-1e-4 * 1e-3, rel=1e-4)


def test_stiff_springs_tie_the_surface_to_the_ball():
    """The patch then goes with the ball as it was pressed: what it resists by adds to the press."""
    patch, pressed = press()
    tied = patch.compliance[np.ix_(pressed.on, pressed.on)]
    resisted = float(np.linalg.solve(tied, np.ones(pressed.on.sum())).sum())

    low, high = pull(1e5, [-1e-3, -2e-3])

    assert low.force == pytest.approx(pressed.force - resisted * (1e-3 + GRIP), rel=0.02)
    assert high.force - low.force == pytest.approx(-resisted * 1e-3, rel=0.02)


def test_what_a_hold_feels_is_what_it_does_to_the_nodes():
    found = pull(500.0, [-1e-3])[0]

    assert found.push.sum(axis=0) @ UP == pytest.approx(-found.force, rel=1e-6)


def test_the_force_is_the_slope_of_the_energy(monkeypatch):
    """Stored by body, contact and springs, along the way of the ball."""
    patch, whole = build_patch()
    energies = {}
    settle = hold.settle

    def keep(held, depth, force):
        force = settle(held, depth, force)
        energies[depth] = held.find_energy(force, depth)
        return force

    monkeypatch.setattr(hold, "settle", keep)
    way = np.array([-0.999e-3, -1e-3, -1.001e-3])
    found = pull_ball(patch, whole, UP, Hold(500.0, GRIP), way, STIFF)
    slope = (energies[-0.999e-3] - energies[-1.001e-3]) / 2e-6

    assert slope == pytest.approx(found[1].force, rel=1e-4)
