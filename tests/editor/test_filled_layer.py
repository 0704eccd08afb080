# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids of springs and volumes, filled as a designer fills them, beside formulas.

A layer of 20 mm on a rigid base: its response to a flat punch and to a sphere, how the surface
sinks around a point force, and how fast waves cross it. The bounds are what was measured, rounded
up; references by the keys of core/README.md.
"""

from __future__ import annotations

from functools import cache
from math import inf, pi, sqrt

import numpy as np
import palpate
import pytest
from layers import RADIUS, THICKNESS, fill_layer
from palpate.study.half_space import compute_punch_force, compute_sphere_force
from scipy.sparse.linalg import eigsh, splu

YOUNG, POISSON, DENSITY = 5e3, 0.45, 1000.0
SHEAR = YOUNG / (2.0 * (1.0 + POISSON))
TISSUE = (YOUNG, POISSON)
COARSE, FINE = 5e-3, 3.2e-3
"""[m] Cells."""
PUNCH = SPHERE = 0.01
"""[m] Radius of the punch, half of that of the sphere."""


@cache
def stiffness_of(cell: float, nodal_share: float):
    """[N/m] of all particles, and their masses [kg]."""
    layer = fill_layer(cell)
    material = palpate.Material(young_modulus=YOUNG, poisson_ratio=POISSON, density=DENSITY)
    solid = palpate.SolidMesh(layer.x, layer.tetrahedra)
    model = palpate.build_solid(solid, material, palpate.SolidOptions(nodal_share=nodal_share))
    k = palpate.compute_stiffness(model, layer.x, palpate.Projection.none).tocsc()
    return k, np.asarray(model.mass)


def solve(k, free: np.ndarray, load: np.ndarray) -> np.ndarray:
    """Displacements (n, 3, loads) of the free vertices under loads alike; the others stay."""
    dofs = (3 * free[:, None] + np.arange(3)).ravel()
    factor = splu(
        k[dofs][:, dofs].tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}
    )
    u = np.zeros((k.shape[0], load.shape[2]))
    u[dofs] = factor.solve(load.reshape(len(u), -1)[dofs])
    return u.reshape(load.shape)


@cache
def find_compliance(cell: float, nodal_share: float) -> tuple[np.ndarray, np.ndarray]:
    """[m/N] of the vertices within 14 mm that may be touched, smoothly: how far each sinks under a
    force on each; and which they are."""
    layer = fill_layer(cell)
    touched = layer.top[layer.distance()[layer.top] < 0.014]
    load = np.zeros((len(layer.x), 3, len(touched)))
    load[touched, 2, np.arange(len(touched))] = 1.0
    free = np.setdiff1d(np.arange(len(layer.x)), layer.base)
    return solve(stiffness_of(cell, nodal_share)[0], free, load)[touched, 2], touched


def punch_ratio(cell: float, nodal_share: float) -> float:
    """Force of the flat punch over that of the formula, for the area that its vertices have."""
    layer = fill_layer(cell)
    compliance, touched = find_compliance(cell, nodal_share)
    inside = layer.distance()[touched] < PUNCH
    pushes = np.linalg.solve(compliance[np.ix_(inside, inside)], np.full(inside.sum(), 1e-3))
    radius = sqrt(layer.share[touched[inside]].sum() / pi)
    return pushes.sum() / compute_punch_force(1e-3, radius, THICKNESS, *TISSUE)


@cache
def sphere_force(depth: float, thickness: float) -> float:
    return compute_sphere_force(depth, 2.0 * SPHERE, thickness, *TISSUE)


def sphere_ratio(cell: float, nodal_share: float, depth: float) -> float:
    layer = fill_layer(cell)
    compliance, touched = find_compliance(cell, nodal_share)
    sink = depth - layer.distance()[touched] ** 2 / (2.0 * 2.0 * SPHERE)
    inside = sink > 0.0
    while True:
        pushes = np.linalg.solve(compliance[np.ix_(inside, inside)], sink[inside])
        if (pushes > 0.0).all():
            return pushes.sum() / sphere_force(depth, THICKNESS)
        # a sphere does not pull
        inside[np.flatnonzero(inside)[pushes <= 0.0]] = False


@pytest.mark.landing
@pytest.mark.parametrize(
    ("nodal_share", "expected"), [pytest.param(0.0, 0.965, marks=pytest.mark.verify), (0.9, 0.87)]
)
def test_a_layer_answers_a_flat_punch_as_theory_says(nodal_share, expected):
    """[Hayes72] The base adds 80 % to the half space's force. Springs relax what a continuum
    cannot, so the law is a few percent soft; averaged volumes have no stiffness at the border."""
    assert punch_ratio(FINE, nodal_share) == pytest.approx(expected, abs=0.02)
    assert compute_punch_force(1.0, PUNCH, THICKNESS, *TISSUE) > 1.7 * compute_punch_force(
        1.0, PUNCH, inf, *TISSUE
    )


@pytest.mark.landing
def test_finer_cells_bring_both_ways_of_volumes_together():
    coarse, fine = (punch_ratio(c, 0.0) - punch_ratio(c, 0.9) for c in (COARSE, FINE))

    # with the size of the cells, as at the border of any punch
    assert 0.5 * coarse < fine < 0.8 * coarse


@pytest.mark.parametrize("nodal_share", [0.0, 0.9])
@pytest.mark.parametrize("depth", [2e-3, 3e-3])
def test_a_layer_answers_a_sphere_as_theory_says_within_6_percent(nodal_share, depth):
    """[Hertz82], with what the base adds [Hayes72]: half as much again, and more."""
    assert sphere_ratio(FINE, nodal_share, depth) == pytest.approx(1.0, abs=0.06)
    assert sphere_force(depth, THICKNESS) > 1.45 * sphere_force(depth, inf)


def sink_under_a_point(offset: np.ndarray, force: float) -> np.ndarray:
    """[m] (n, 3) of a half space below z = 0 that is pushed down at its origin [Boussinesq85]."""
    r, depth = np.hypot(offset[:, 0], offset[:, 1]), -offset[:, 2]
    p = np.linalg.norm(offset, axis=1)
    scale = force / (4.0 * pi * SHEAR)
    down = scale * (depth**2 / p**3 + 2.0 * (1.0 - POISSON) / p)
    out = scale * (depth / p**3 - (1.0 - 2.0 * POISSON) / (p * (p + depth)))
    return np.column_stack([out * offset[:, 0], out * offset[:, 1], -down]) * np.where(
        r[:, None] + depth[:, None] > 0.0, 1.0, 0.0
    )


@pytest.mark.parametrize("nodal_share", [0.0, 0.9])
def test_the_surface_sinks_around_a_point_force_with_one_over_the_distance(nodal_share):
    layer, (k, _) = fill_layer(FINE), stiffness_of(FINE, nodal_share)
    centre = layer.top[np.argmin(layer.distance()[layer.top])]
    offset = layer.x - layer.x[centre]
    # side and base go as they do in the half space, which the layer is thereby a part of
    u = np.zeros_like(layer.x)
    u[layer.border] = sink_under_a_point(offset[layer.border], 0.01)
    load = -(k @ u.ravel()).reshape(-1, 3)
    load[centre, 2] -= 0.01
    free = np.setdiff1d(np.arange(len(layer.x)), layer.border)
    u += solve(k, free, load[:, :, None])[:, :, 0]

    r = np.linalg.norm(offset, axis=1)
    seen = np.intersect1d(layer.top, free)
    seen = seen[(r[seen] > 3.0 * FINE) & (r[seen] < 0.7 * RADIUS)]
    ratio = u[seen, 2] / sink_under_a_point(offset[seen], 0.01)[:, 2]
    assert len(seen) > 100
    assert np.mean(ratio) == pytest.approx(1.0, abs=0.03)
    assert np.sqrt(((ratio - 1.0) ** 2).mean()) < 0.04


@pytest.mark.parametrize("nodal_share", [0.0, 0.9])
@pytest.mark.parametrize(
    ("axis", "modulus", "bound"),
    [(0, SHEAR, 0.03), (2, 2.0 * SHEAR * (1.0 - POISSON) / (1.0 - 2.0 * POISSON), 0.02)],
    ids=["shear", "pressure"],
)
def test_a_layer_that_can_move_one_way_alone_rings_with_the_speed_of_its_waves(
    nodal_share, axis, modulus, bound
):
    """A quarter of a wave stands in the thickness: w = pi c/(2 h), c² = modulus/density."""
    layer, (k, mass) = fill_layer(FINE), stiffness_of(FINE, nodal_share)
    free = np.setdiff1d(np.arange(len(layer.x)), layer.base)
    dofs, root = 3 * free + axis, 1.0 / np.sqrt(mass[free])
    scaled = k[dofs][:, dofs].multiply(root[:, None]).multiply(root[None, :]).tocsc()

    found = sqrt(eigsh(scaled, k=1, sigma=0.0, return_eigenvectors=False)[0])

    assert found == pytest.approx(pi * sqrt(modulus / DENSITY) / (2.0 * THICKNESS), rel=bound)
