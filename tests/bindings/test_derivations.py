# SPDX-License-Identifier: BSD-3-Clause
"""What core/LAWS.md and firmware/KINEMATICS.md derive, in numbers that no other test holds."""

from __future__ import annotations

import itertools
from math import inf, pi, sqrt

import numpy as np
import palpate
import pytest
from palpate.study.reference import read_reference
from surfaces import ellipsoid

SIDE = 0.01
"""[m] of the lattice."""


def lattice(count: int) -> palpate.SurfaceMesh:
    """A flat sheet of equilateral triangles."""
    x = [(SIDE * (i + 0.5 * j), SIDE * sqrt(0.75) * j, 0.0) for j, i in np.ndindex(count, count)]
    cells = [j * count + i for j, i in np.ndindex(count - 1, count - 1)]
    triangles = [(c, c + 1, c + count) for c in cells]
    triangles += [(c + 1, c + count + 1, c + count) for c in cells]
    return palpate.SurfaceMesh(x, triangles)


@pytest.mark.parametrize(
    ("bend", "coupling"), [(0.0, 0.0), (1e-3, 0.0), (0.0, 0.05), (0.0, -0.05), (2e-3, -0.1)]
)
def test_a_lattice_stretches_as_the_sheet_that_its_constants_say(bend, coupling):
    """[laws: lattice]"""
    share = 25.0  # [N/m] of each bond, a triangle's
    material = palpate.Material(young_modulus=1e4, poisson_ratio=0.3, wall_thickness=2e-3)
    constants = palpate.MolecularConstants(
        bond_stiffness=2.0 * share, bend_stiffness=bend, stretch_coupling=coupling
    )
    model = palpate.build_molecular(lattice(4), material, constants)

    fit = palpate.compare_with_membrane(model, material)

    s = (9.0 * bend / (4.0 * SIDE**2) + 3.0 * coupling / SIDE) / share
    assert fit.poisson_ratio == pytest.approx((1.0 - s) / (3.0 + s))
    assert 2e-3 * fit.young_modulus == pytest.approx(4 * sqrt(3) * share * (1 + s) / (3 + s))


def test_the_equations_of_a_membranes_constants_are_never_singular():
    """[laws: membrane]: |det| abc is the formula, and at least 4."""
    random = np.random.default_rng(1)
    angles = random.dirichlet((0.3, 0.3, 0.3), 20000) * pi
    for cosine, sine in zip(np.cos(angles), np.sin(angles), strict=True):
        u = cosine.sum() - cosine
        system = np.full((3, 3), -1.0)
        np.fill_diagonal(system, u)
        a, b, c = sine
        if min(sine) > 1e-3:
            rows = system * sine**2 / (a * b * c)
            assert np.linalg.det(rows) * a * b * c == pytest.approx(u.prod() - u.sum() - 2.0)
        assert np.linalg.det(system) <= -4.0 + 1e-9


def find_range_of_whole(mesh: palpate.SurfaceMesh, bond: float) -> tuple[float, float]:
    """[N] K_btheta for which the tangent at rest of the mesh is definite but for rigid motion."""

    def stiffness(coupling: float) -> np.ndarray:
        constants = palpate.MolecularConstants(
            bond_stiffness=bond, bend_stiffness=0.0, stretch_coupling=coupling
        )
        material = palpate.Material(wall_thickness=2e-3)
        options = palpate.SurfaceOptions(home_stiffness=0.0)
        model = palpate.build_molecular(mesh, material, constants, options)
        none = palpate.Projection.none
        return palpate.compute_stiffness(model, model.rest_position, none).toarray()

    plain, small = stiffness(0.0), 1e-4
    values, modes = np.linalg.eigh(plain)
    assert values[5] < 1e-9 * values[6]  # six rigid motions
    scaled = modes[:, 6:] / np.sqrt(values[6:])
    m = np.linalg.eigvalsh(scaled.T @ ((stiffness(small) - plain) / small) @ scaled)
    return -1.0 / m[-1], -1.0 / m[0]


def find_range_of_triangles(mesh: palpate.SurfaceMesh, bond: float) -> tuple[float, float]:
    """[N] The same of the triangles one by one."""
    constants = palpate.MolecularConstants(bond_stiffness=bond, bend_stiffness=0.0)
    model = palpate.build_molecular(mesh, palpate.Material(wall_thickness=2e-3), constants)
    low, high = -inf, inf
    for row in range(len(mesh.triangles)):
        found = palpate.find_coupling_range(model.angles, row, (1.0, 1.0, 1.0))
        assert found is not None
        low, high = max(low, found.low), min(high, found.high)
    return low, high


@pytest.mark.parametrize(
    ("radii", "low_part", "high_part"),
    [
        ((0.03, 0.03, 0.03), 0.917, 0.706),
        ((0.05, 0.035, 0.03), 0.840, 0.504),
        ((0.05, 0.035, 0.004), 0.587, 0.253),
    ],
)
def test_the_worst_triangle_leaves_this_much_of_what_the_whole_mesh_bears(
    radii, low_part, high_part
):
    """[laws: definite]"""
    mesh = ellipsoid(radii, 1)

    low, high = find_range_of_triangles(mesh, 50.0)
    whole_low, whole_high = find_range_of_whole(mesh, 50.0)

    assert low / whole_low == pytest.approx(low_part, abs=2e-3)
    assert high / whole_high == pytest.approx(high_part, abs=2e-3)


def test_an_even_mesh_takes_the_constants_that_the_page_says():
    """[laws: definite]"""
    low, high = find_range_of_triangles(ellipsoid((0.03, 0.03, 0.03), 2), 50.0)

    assert (low, high) == (pytest.approx(-0.0583, abs=5e-5), pytest.approx(54.4, abs=0.05))


def test_near_a_poisson_ratio_of_a_half_the_stable_step_of_a_solid_shrinks():
    """[laws: solid]"""
    for body in ("ellipsoid", "spleen"):
        reference = read_reference(body)
        solid = palpate.SolidMesh(reference.vertices, reference.tetrahedra)
        options = palpate.SolidOptions(fixed=reference.held)
        step = {
            nu: palpate.stable_step(
                palpate.build_solid(
                    solid, palpate.Material(poisson_ratio=nu, damping_ratio=0.0), options
                )
            )
            for nu in (0.45, 0.49)
        }
        assert 2.1 < step[0.45] / step[0.49] < 2.4


def test_the_arm_pushes_every_way_all_over_its_box_with_what_the_page_says():
    """[kinematics: workspace]"""
    arm, box = palpate.Arm(), palpate.Workspace()
    parts = itertools.product(np.linspace(-0.5, 0.5, 9), repeat=3)
    joints = [palpate.find_joints(arm, box.center + np.array(p) * box.size) for p in parts]
    jacobians = [palpate.compute_jacobian(arm, q) for q in joints]
    longest = np.array([np.linalg.norm(j, axis=0).max() for j in jacobians])

    force = 0.235 / longest  # [N] of 0.235 N·m
    assert [force.min(), force.mean(), force.max()] == pytest.approx([1.09, 1.45, 1.57], abs=6e-3)
    assert max(np.linalg.cond(j) for j in jacobians) == pytest.approx(4.0, abs=5e-3)
    assert longest.max() == pytest.approx(0.215, abs=5e-4)
    margin = min(min((q - arm.joint_min).min(), (arm.joint_max - q).min()) for q in joints)
    assert np.degrees(margin) == pytest.approx(3.0, abs=0.05)
    assert np.degrees(max(abs(q[1] - q[2]) for q in joints)) == pytest.approx(62.0, abs=0.1)
