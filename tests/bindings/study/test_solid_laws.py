# SPDX-License-Identifier: BSD-3-Clause
"""Solids of springs and volumes beside formulas: waves in columns, energies of uniform strains."""

from __future__ import annotations

import sys
from math import pi, sqrt
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.study.models import compute_volumes
from palpate.study.reference import read_reference
from scipy.sparse.linalg import eigsh

sys.path.insert(0, str(Path(__file__).parents[2] / "references"))
from bodies import build_block  # noqa: E402

YOUNG, DENSITY = 5e3, 1000.0


def make_solid(x, t, poisson: float, held, nodal_share: float = 0.9) -> palpate.TissueModel:
    material = palpate.Material(young_modulus=YOUNG, poisson_ratio=poisson, density=DENSITY)
    options = palpate.SolidOptions(nodal_share=nodal_share, fixed=np.flatnonzero(held))
    return palpate.build_solid(palpate.SolidMesh(x, t), material, options)


def stiffness_of(model: palpate.TissueModel):
    rest = np.asarray(model.rest_position)
    return palpate.compute_stiffness(model, rest, palpate.Projection.none).tocsc()


def make_column(pieces: int, poisson: float) -> palpate.TissueModel:
    x, t = build_block((0.02, 0.02, 0.1), (3, 3, pieces))
    return make_solid(x, t, poisson, x[:, 2] < 1e-9)


def lowest_frequency(model: palpate.TissueModel, axis: int) -> float:
    """[rad/s] of motion along one axis alone, as in a column whose sides cannot move otherwise."""
    free = np.setdiff1d(np.arange(palpate.particle_count(model)), model.fixed)
    dofs = 3 * free + axis
    k = stiffness_of(model)[dofs][:, dofs]
    root = 1.0 / np.sqrt(np.asarray(model.mass)[free])
    scaled = k.multiply(root[:, None]).multiply(root[None, :]).tocsc()
    return sqrt(eigsh(scaled, k=1, sigma=0.0, return_eigenvectors=False)[0])


def lame(poisson: float) -> tuple[float, float]:
    first = YOUNG * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    return first, YOUNG / (2.0 * (1.0 + poisson))


@pytest.mark.parametrize("poisson", [0.25, 0.35, 0.45])
def test_a_column_that_cannot_spread_rings_with_the_speed_of_pressure_waves(poisson):
    first, shear = lame(poisson)
    speed = sqrt((first + 2.0 * shear) / DENSITY)

    found = lowest_frequency(make_column(15, poisson), axis=2)

    assert found == pytest.approx(pi * speed / 0.2, rel=0.10)


@pytest.mark.parametrize("nodal_share", [0.0, 0.9])
@pytest.mark.parametrize("axis", [0, 2], ids=["shear", "pressure"])
def test_a_solid_converges_with_the_size_of_its_cells(axis, nodal_share):
    coarse, middle, fine = (
        lowest_frequency(make_solid(x, t, 0.35, x[:, 2] < 1e-9, nodal_share), axis)
        for x, t in (build_block((0.02, 0.02, 0.06), (n, n, 3 * n)) for n in (2, 4, 8))
    )

    # the second order of linear elements inside, the first along the surface, whose layer of cells
    # springs hold otherwise than what lies inside: 1.1 to 1.3 measured
    assert 1.0 < np.log2((coarse - middle) / (middle - fine)) < 2.0
    assert middle - fine < 0.004 * fine


STRAINS = {
    "stretch": np.diag([1.0, 0.0, 0.0]),
    "swelling": np.eye(3),
    "shear": np.array([[0.0, 0.0, 0.5], [0.0, 0.0, 0.0], [0.5, 0.0, 0.0]]),
    "stretch without swelling": np.diag([1.0, -1.0, 0.0]),
}


def energy_over_elasticity(x, t, poisson: float, strain: np.ndarray) -> float:
    """What a solid stores in a uniform strain, over what the material does."""
    model = make_solid(x, t, poisson, np.zeros(len(x), dtype=bool))
    first, shear = lame(poisson)
    u = (x @ strain).ravel()
    density = shear * (strain**2).sum() + 0.5 * first * np.trace(strain) ** 2
    return 0.5 * float(u @ (stiffness_of(model) @ u)) / (density * compute_volumes(x, t).sum())


@pytest.mark.parametrize("strain", STRAINS)
@pytest.mark.parametrize("organ", ["spleen", "kidney", "liver"])
def test_a_filled_organ_stores_in_every_uniform_strain_what_its_material_does(organ, strain):
    body = read_reference(organ)

    found = energy_over_elasticity(body.vertices, body.tetrahedra, 0.45, STRAINS[strain])

    assert found == pytest.approx(1.0, abs=0.03)


def test_tetrahedra_that_all_lie_one_way_shear_a_third_too_softly():
    x, t = build_block((0.04, 0.04, 0.04), (4, 4, 4))

    # of the face diagonals 4/6 · 2.5/4, of the body diagonal 2.5/9: what is inside is 0.694
    assert energy_over_elasticity(x, t, 0.25, STRAINS["shear"]) == pytest.approx(0.69, abs=0.02)
    assert energy_over_elasticity(x, t, 0.25, STRAINS["swelling"]) == pytest.approx(1.0, abs=1e-6)
