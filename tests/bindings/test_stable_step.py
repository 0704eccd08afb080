# SPDX-License-Identifier: BSD-3-Clause
"""stable_step against the exact limit of symplectic Euler, found by eigenvalue solvers.

One step is v' = v - dt M⁻¹(K x + C v), x' = x + dt v'. Put z for the factor of an eigenvector u:

    (z - 1)² m + dt² k z + dt c (z - 1) = 0,   m, k, c = u*Mu, u*Ku, u*Cu, none negative,

whose roots lie in the unit circle exactly while dt² k + 2 dt c < 4 m. The first z to leave it is
-1, real, so the limit is where the largest eigenvalue of (dt² K + 2 dt C) u = 4 M u reaches 4: a
quadratic eigenproblem in dt, solved by a root finder around a sparse symmetric solver.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import palpate
import pytest
import scipy.optimize
import scipy.sparse
import scipy.sparse.linalg
from surfaces import MEMBRANE, chain, ellipsoid, sheet, tube

LOW, HIGH = 0.6, 1.0
SMALL = 80
"""Particles up to which the whole step matrix is taken apart, as a check on the argument above."""


def free_matrices(model: palpate.TissueModel, coupling: float = 0.0, at: int = -1):
    """M⁻½ K M⁻½ and M⁻½ C M⁻½ at rest, free particles only; `coupling` holds particle `at`."""
    count = palpate.particle_count(model)
    free = np.repeat(~np.isin(np.arange(count), model.fixed), 3)
    x = model.rest_position
    stiffness = palpate.compute_stiffness(model, x, palpate.Projection.none)
    if at >= 0:
        extra = np.zeros(3 * count)
        extra[3 * at : 3 * at + 3] = coupling
        stiffness = stiffness + scipy.sparse.diags(extra)
    damping = palpate.compute_damping(model, x)
    root = scipy.sparse.diags(np.repeat(model.mass, 3)[free] ** -0.5)
    return [
        (root @ scipy.sparse.csc_matrix(m)[free][:, free] @ root).tocsc()
        for m in (stiffness, damping)
    ]


def largest_eigenvalue(matrix: scipy.sparse.csc_matrix) -> float:
    if matrix.shape[0] <= 3 * SMALL:
        return float(np.linalg.eigvalsh(matrix.toarray())[-1])
    start = np.cos(np.arange(matrix.shape[0]))
    return float(
        scipy.sparse.linalg.eigsh(
            matrix, k=1, which="LA", v0=start, tol=1e-6, return_eigenvectors=False
        )[0]
    )


def exact_limit(stiffness: scipy.sparse.csc_matrix, damping: scipy.sparse.csc_matrix) -> float:
    def excess(dt: float) -> float:
        return largest_eigenvalue(dt * dt * stiffness + 2.0 * dt * damping) - 4.0

    # each term alone gives a bound from above, both at half strength one from below
    k, c = largest_eigenvalue(stiffness), largest_eigenvalue(damping)
    bounds = [2.0 / k**0.5 if k > 0 else np.inf, 2.0 / c if c > 0 else np.inf]
    high = 1.0001 * min(bounds)
    low = 0.4 * min(bounds)
    return float(scipy.optimize.brentq(excess, low, high, rtol=1e-6))


def spectral_radius(stiffness, damping, dt: float) -> float:
    k, c = stiffness.toarray(), damping.toarray()
    one = np.eye(len(k))
    kick = np.block([[one, np.zeros_like(k)], [-dt * k, one - dt * c]])
    drift = np.block([[one, dt * one], [np.zeros_like(k), one]])
    return float(np.abs(np.linalg.eigvals(drift @ kick)).max())


def molecular(mesh: palpate.SurfaceMesh, material: palpate.Material) -> palpate.TissueModel:
    constants = palpate.MolecularConstants(
        bond_stiffness=52.0, bend_stiffness=2e-5, stretch_coupling=0.01
    )
    return palpate.build_molecular(mesh, material, constants)


def named_surfaces() -> dict[str, tuple[palpate.SurfaceMesh, palpate.Material]]:
    solid = palpate.Material(damping_ratio=0.1)
    stiff = palpate.Material(damping_ratio=2.0, wall_thickness=1e-3)
    return {
        "solid-42": (ellipsoid((0.05, 0.04, 0.03), 1), solid),
        "hollow-162": (ellipsoid((0.05, 0.04, 0.03), 2), MEMBRANE),
        "solid-642": (ellipsoid((0.05, 0.04, 0.03), 3), solid),
        "tube": (tube(0.012, 0.08, 16, 20), MEMBRANE),
        "overdamped-tube": (tube(0.012, 0.08, 12, 10), stiff),
        "sheet": (sheet(12, 0.05), MEMBRANE),
    }


def assert_between(model: palpate.TissueModel) -> None:
    exact = exact_limit(*free_matrices(model))
    ratio = palpate.stable_step(model) / exact
    assert LOW <= ratio <= HIGH


# the parts of a file that together are one surface: whole, some files hold walls that share edges
SHARED_ORGANS = {
    "F_Kidney_L": ["VH_F_kidney_capsule_L"],
    "F_Liver": ["VH_F_capsule_of_the_liver"],
    "F_Pancreas": [],
    "F_Spleen": [],
    "M_Heart": ["VH_M_heart_left_ventricle"],
}

SAMPLE = ("F_Pancreas", "F_Spleen", "M_Heart")
"""Of them, what every run reads."""

BUILDERS = {
    "mass_spring": lambda mesh, material: palpate.build_mass_spring(mesh, material, 52.0),
    "molecular": molecular,
}


@pytest.mark.parametrize("kind", BUILDERS)
@pytest.mark.parametrize("name", named_surfaces())
def test_stable_step_lies_between_0_6_and_1_of_the_exact_limit(name, kind):
    assert_between(BUILDERS[kind](*named_surfaces()[name]))


@pytest.mark.parametrize("kind", BUILDERS)
@pytest.mark.parametrize("name", ["ellipsoid", "sheet", "tube"])
def test_stable_step_lies_between_0_6_and_1_on_generated_organs(name, kind):
    assert_between(BUILDERS[kind](generate_organ(name), MEMBRANE))


@cache
def generate_organ(name: str) -> palpate.SurfaceMesh:
    generate = pytest.importorskip("palpate_meshes.generate")
    return palpate.SurfaceMesh(*getattr(generate, name)(vertices=300))


@pytest.mark.parametrize("kind", BUILDERS)
@pytest.mark.parametrize(
    "name",
    [
        name if name in SAMPLE else pytest.param(name, marks=pytest.mark.verify)
        for name in SHARED_ORGANS
    ],
)
def test_stable_step_lies_between_0_6_and_1_on_shared_organs(name, kind, shared_data):
    mesh = decimate_organ(shared_data(f"organs/VH_{name}.glb"), tuple(SHARED_ORGANS[name]))

    assert_between(BUILDERS[kind](mesh, MEMBRANE))


@cache
def decimate_organ(path: Path, parts: tuple[str, ...]) -> palpate.SurfaceMesh:
    authoring = pytest.importorskip("palpate_editor.authoring")
    return authoring.decimate(authoring.import_mesh(path, parts=parts).mesh, 600).mesh


@pytest.mark.parametrize("damping", [0.0, 0.1, 2.0])
def test_stable_step_of_a_chain_with_and_without_damping(damping):
    assert_between(chain(30, damping=damping))


def test_the_limit_is_where_the_step_matrix_leaves_the_unit_circle():
    model = BUILDERS["mass_spring"](*named_surfaces()["solid-42"])
    matrices = free_matrices(model)

    limit = exact_limit(*matrices)

    # modes of rigid motion stay on the circle: double roots at 1, which solvers blur
    blur = 1e-6
    assert spectral_radius(*matrices, 0.999 * limit) <= 1.0 + blur
    assert spectral_radius(*matrices, 1.001 * limit) > 1.0 + 100 * blur
    assert spectral_radius(*matrices, palpate.stable_step(model)) <= 1.0 + blur


def test_stable_step_leaves_room_for_a_tool_held_to_any_one_particle():
    coupling = 500.0
    model = BUILDERS["mass_spring"](ellipsoid((0.05, 0.04, 0.03), 1), MEMBRANE)

    worst = min(
        exact_limit(*free_matrices(model, coupling, i))
        for i in range(palpate.particle_count(model))
    )

    assert worst < exact_limit(*free_matrices(model))
    assert LOW <= palpate.stable_step(model, coupling) / worst <= HIGH


def test_the_spectrum_holds_the_largest_eigenvalues_from_above_and_near():
    model = BUILDERS["molecular"](*named_surfaces()["hollow-162"])
    stiffness, damping = (largest_eigenvalue(m) for m in free_matrices(model))

    spectrum = palpate.estimate_spectrum(model)

    assert spectrum.stiffness == pytest.approx(stiffness, rel=0.3)
    assert spectrum.damping == pytest.approx(damping, rel=0.3)
