# SPDX-License-Identifier: BSD-3-Clause
"""F18: links pressed to a fifth and angles turned over have a stiffness below 0; steps do not."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import SURFACES, make_ball


def crush(tissue: palpate.TissueModel) -> np.ndarray:
    """[m] every free particle where the body is a fifth as high, and its top turned over."""
    x = np.array(tissue.rest_position)
    base = x[:, 2].min()
    x[:, 2] = base + 0.2 * (x[:, 2] - base)
    top = int(np.argmax(np.asarray(tissue.rest_position)[:, 2]))
    x[top, 2] -= 0.01
    x[np.asarray(tissue.fixed, dtype=int)] = np.asarray(tissue.rest_position)[tissue.fixed]
    return x


def find_least(tissue: palpate.TissueModel, x: np.ndarray, projection: palpate.Projection):
    """Of the eigenvalues of the symmetric part [N/m]: the least, over the largest."""
    k = palpate.compute_stiffness(tissue, x, projection).toarray()
    values = np.linalg.eigvalsh(0.5 * (k + k.T))
    return values[0] / values[-1]


@pytest.mark.parametrize("law", SURFACES)
def test_f18_the_projected_stiffness_of_a_crushed_body_has_no_negative_eigenvalue(law):
    tissue = SURFACES[law](make_ball(1))
    tissue.home[:] = 0.0
    x = crush(tissue)
    none, clamped = palpate.Projection.none, palpate.Projection.positive_semidefinite

    assert find_least(tissue, x, none) < -1e-2
    assert find_least(tissue, x, clamped) > -1e-9


@pytest.mark.parametrize("law", SURFACES)
def test_f18_from_there_implicit_euler_in_long_steps_stays_finite_and_only_loses_energy(law):
    tissue = SURFACES[law](make_ball(1))
    state = palpate.State(tissue)
    state.position[:] = crush(tissue)
    stepper = palpate.ImplicitStepper(tissue, palpate.Integrator.implicit_euler_linear)
    start = palpate.compute_energy(tissue, np.zeros(3), state).total()

    for _ in range(200):
        assert stepper.step(palpate.Load(), 1e-3, state) > 0
        assert palpate.compute_energy(tissue, np.zeros(3), state).total() <= start

    assert np.isfinite(np.asarray(state.position)).all()
