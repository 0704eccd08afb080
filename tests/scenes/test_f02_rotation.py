# SPDX-License-Identifier: BSD-3-Clause
"""F2: a body that is turned and moved as a whole, before it is built and after."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from failure_scenes import SOLIDS, SURFACES, hold_lowest, make_ball, make_block, make_solid

SHIFT = np.array([0.4, -0.2, 0.3])


def turn() -> np.ndarray:
    """A rotation by 2.2 rad about no axis of the frame."""
    axis = np.array([1.0, 0.4, -0.7]) / np.linalg.norm([1.0, 0.4, -0.7])
    cross = np.cross(np.eye(3), axis)
    return np.eye(3) - np.sin(2.2) * cross + (1 - np.cos(2.2)) * cross @ cross


def build(law: str, rotation: np.ndarray, shift: np.ndarray) -> palpate.TissueModel:
    """Held where the body is lowest before it is turned."""
    mesh = make_ball() if law in SURFACES else make_block()
    held, x = hold_lowest(mesh.vertices), np.asarray(mesh.vertices) @ rotation.T + shift
    if law in SURFACES:
        return SURFACES[law](palpate.SurfaceMesh(x, mesh.triangles), held)
    return make_solid(SOLIDS[law], palpate.SolidMesh(x, mesh.tetrahedra), held)


def strain(tissue: palpate.TissueModel, rotation: np.ndarray):
    """Forces [N] and energy [J] of a tissue that is strained and moves, the same but turned."""
    random = np.random.default_rng(3)
    x = np.asarray(tissue.rest_position)
    moved, speed = random.normal(0, 5e-4, x.shape), random.normal(0, 0.05, x.shape)
    state = palpate.State(tissue)
    state.position[:], state.velocity[:] = x + moved @ rotation.T, speed @ rotation.T
    force = np.zeros_like(x)
    palpate.compute_forces(tissue, palpate.Load(), state.position, state.velocity, force)
    return force, palpate.compute_energy(tissue, np.zeros(3), state).total()


@pytest.mark.parametrize("law", [*SURFACES, *SOLIDS])
def test_f2_forces_and_energy_of_a_turned_body_are_the_same_turned(law):
    rotation = turn()

    force, energy = strain(build(law, np.eye(3), np.zeros(3)), np.eye(3))
    turned_force, turned_energy = strain(build(law, rotation, SHIFT), rotation)

    assert np.abs(turned_force - force @ rotation.T).max() < 1e-9 * np.abs(force).max()
    assert turned_energy == pytest.approx(energy, rel=1e-9)


@pytest.mark.parametrize("law", [law for law in (*SURFACES, *SOLIDS) if law != "linear"])
def test_f2_a_body_that_is_turned_from_its_rest_feels_nothing(law):
    tissue = build(law, np.eye(3), np.zeros(3))
    tissue.home[:] = 0.0  # these know where rest is
    x = np.asarray(tissue.rest_position)
    force, strained = np.zeros_like(x), np.zeros_like(x)

    palpate.compute_forces(tissue, palpate.Load(), x @ turn().T + SHIFT, 0.0 * x, force)
    palpate.compute_forces(tissue, palpate.Load(), 1.01 * x, 0.0 * x, strained)

    assert np.abs(force).max() < 1e-9 * np.abs(strained).max()


def test_f2_a_linear_solid_alone_feels_being_turned():
    tissue = build("linear", np.eye(3), np.zeros(3))
    x = np.asarray(tissue.rest_position)
    force = np.zeros_like(x)

    palpate.compute_forces(tissue, palpate.Load(), x @ turn().T, 0.0 * x, force)

    assert np.abs(force).max() > 0.01
