# SPDX-License-Identifier: BSD-3-Clause
"""Solids pressed by up to a quarter of their thickness, against neo-Hookean finite elements.

The ellipsoid of SCIENCE 2.5, on the mesh of the reference, which so leaves only the law to differ.
"""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.study.reference import Place, Reference, read_reference
from palpate.study.statics import Press, Unbalanced, follow

PARTS = (0.05, 0.10, 0.15, 0.20, 0.25)
"""[-] of the thickness."""
REACH = 1.5e-3
"""[m] from one equilibrium to the next."""


@pytest.fixture(scope="module")
def ellipsoid() -> Reference:
    return read_reference("ellipsoid")


def build(reference: Reference, nodal_share: float) -> palpate.TissueModel:
    material = palpate.Material(
        young_modulus=reference.young_modulus, poisson_ratio=reference.poisson_ratio
    )
    options = palpate.SolidOptions(nodal_share=nodal_share, fixed=reference.held)
    solid = palpate.SolidMesh(reference.vertices, reference.tetrahedra)
    return palpate.build_solid(solid, material, options)


def without_volumes(model: palpate.TissueModel, stiffness: float) -> palpate.TissueModel:
    """Springs alone, as stiff as `stiffness` times those of the solid."""
    springs = model.springs
    bare = palpate.Links(
        springs.ends, springs.rest_length, stiffness * springs.stiffness, springs.damping
    )
    return palpate.TissueModel(
        rest_position=model.rest_position,
        mass=model.mass,
        fixed=model.fixed,
        springs=bare,
        triangles=model.triangles,
    )


def smallest_volume(reference: Reference, x: np.ndarray) -> float:
    """[-] of any tetrahedron, of its own at rest; below 0 inside out."""

    def volumes(at: np.ndarray) -> np.ndarray:
        a, b, c, d = at[reference.tetrahedra].transpose(1, 0, 2)
        return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)

    return float((volumes(x) / volumes(reference.vertices)).min())


def press(model: palpate.TissueModel, place: Place) -> Press:
    return Press(model, place.vertices, place.direction)


def find_inversion(reference: Reference, model: palpate.TissueModel, place: Place) -> float:
    """[-] of the thickness, at which a tetrahedron is inside out or no equilibrium is left."""
    parts = np.arange(0.01, 0.301, 0.01)
    found = follow(press(model, place), list(parts * place.thickness), REACH)
    try:
        for part, (x, _) in zip(parts, found, strict=True):
            if smallest_volume(reference, x) <= 0.0:
                return float(part)
    except Unbalanced:
        return float(part)
    return np.inf


def test_springs_and_volumes_stay_within_15_percent_of_neo_hookean_and_never_turn_inside_out(
    ellipsoid,
):
    place = ellipsoid.places[0]
    model = build(ellipsoid, nodal_share=0.0)
    depths = [part * place.thickness for part in PARTS]

    ratios = []
    for depth, (x, force) in zip(depths, follow(press(model, place), depths, REACH), strict=True):
        ratios.append(force / place.find("neo_hookean", "P1", depth).force)
        assert smallest_volume(ellipsoid, x) > 0.3

    assert all(0.85 <= ratio <= 1.15 for ratio in ratios), ratios
    # measured 0.88 at 5 % to 0.96 at 25 %: one factor leaves 5 % (SCIENCE 2.5 saw less on its mesh)
    assert max(ratios) - min(ratios) < 0.10, ratios


def test_springs_alone_turn_inside_out_on_the_way(ellipsoid):
    place = ellipsoid.places[0]
    solid = build(ellipsoid, nodal_share=0.0)
    # Van Gelder's E V / L² are 2 (1 + nu) / 2.5 times our 5/2 mu V / L²
    springs = without_volumes(solid, 2.0 * (1.0 + ellipsoid.poisson_ratio) / 2.5)

    alone = find_inversion(ellipsoid, springs, place)

    assert alone <= 0.20
    assert find_inversion(ellipsoid, solid, place) > 0.25 >= alone
