# SPDX-License-Identifier: BSD-3-Clause
"""The linear solid beside the references: exact where it must be, and where it is not."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.study.accuracy import find_rms
from palpate.study.models import material_of, solid_of
from palpate.study.reference import Place, Reference, read_reference
from palpate.study.statics import Press, respond

SOLIDS = ("block", "ellipsoid", "sphere", "spleen", "kidney", "liver")
FILE_ROUNDING = 8e-7
"""[m] of displacements, which the references keep in micrometres."""


@pytest.fixture(scope="module", params=SOLIDS)
def reference(request) -> Reference:
    return read_reference(request.param)


def build(reference: Reference, nodal_share: float) -> palpate.TissueModel:
    options = palpate.SolidOptions(nodal_share=nodal_share, fixed=reference.held)
    return palpate.build_linear_solid(solid_of(reference), material_of(reference), options)


def press(model: palpate.TissueModel, place: Place) -> Press:
    return Press(model, place.vertices, place.direction)


def compare(reference: Reference, place: Place, model) -> tuple[float, float]:
    """Force and error of the displacement beside the truth."""
    truth = place.find("linear", "P2")
    unit, stiffness = respond(press(model, place))
    error = find_rms(reference, place, truth.depth * unit[reference.surface], truth)
    return stiffness * truth.depth / truth.force, error


def test_of_single_tetrahedra_it_is_the_linear_finite_element(reference):
    """The same elements by another program: P1 of scikit-fem."""
    model = build(reference, 0.0)
    for place in reference.places:
        truth = place.find("linear", "P1")
        unit, stiffness = respond(press(model, place))

        assert stiffness * truth.depth == pytest.approx(truth.force, rel=1e-5)
        u = truth.depth * unit[reference.surface]
        assert find_rms(reference, place, u, truth) * truth.depth < FILE_ROUNDING


@pytest.mark.parametrize("name", ["block", "sphere", "liver"])
def test_averaged_around_particles_it_is_nearer_to_the_truth(name):
    """Beside P2 on the refined mesh: 18 to 45 % too stiff on all bodies, single ones 26 to 67 %."""
    reference = read_reference(name)
    single, averaged = build(reference, 0.0), build(reference, 0.9)
    for place in reference.places:
        (locked, locked_error), (ratio, error) = (
            compare(reference, place, model) for model in (single, averaged)
        )

        assert 1.15 < ratio < 1.5
        assert ratio < locked - 0.05
        assert error < locked_error


def test_up_to_its_depth_it_strays_as_is_said_from_neo_hookean_elements(reference):
    """SHALLOW: within 12 % on the same mesh, at the pointed end of the ellipsoid within 22 %."""
    for place in reference.places:
        depth = palpate.SHALLOW * place.thickness
        linear = place.find("linear", "P1", depth)
        pressed = place.find("neo_hookean", "P1", depth)
        pulled = place.find("neo_hookean", "P1", -depth)
        most = 0.22 if (reference.name, place.name) == ("ellipsoid", "side") else 0.12

        assert abs(linear.force / pressed.force - 1.0) < most
        assert abs(linear.force / -pulled.force - 1.0) < most


def test_deep_presses_are_beyond_it():
    """Its error grows with the depth: in an ellipsoid 3 % at 5 % of the thickness, 18 % at 25 %."""
    reference = read_reference("ellipsoid")
    top = next(place for place in reference.places if place.name == "top")
    short = []
    for part in (0.05, 0.1, 0.15, 0.2, 0.25):
        depth = part * top.thickness
        truth = top.find("neo_hookean", "P1", depth)
        short.append(1.0 - top.find("linear", "P1", depth).force / truth.force)

    assert short == sorted(short)
    assert short[0] < 0.04 and short[-1] > 0.13


def test_its_precomputed_response_is_the_finite_elements_answer():
    """A patch that is moved as a whole, solved from the compliance of its particles alone."""
    reference = read_reference("block")
    model = build(reference, 0.0)
    response = palpate.build_response(model)
    compliance = np.asarray(response.compliance, dtype=float)
    for place in reference.places:
        truth = place.find("linear", "P1")
        columns = (3 * np.asarray(response.column)[place.vertices][:, None] + np.arange(3)).ravel()
        rows = (3 * np.asarray(response.row)[place.vertices][:, None] + np.arange(3)).ravel()
        moved = np.tile(-truth.depth * place.direction, len(place.vertices))

        push = np.linalg.solve(compliance[columns][:, rows].T, moved)
        u = (push @ compliance[columns]).reshape(-1, 3)

        force = -push.reshape(-1, 3).sum(axis=0) @ place.direction
        assert force == pytest.approx(truth.force, rel=1e-3)
        free = np.setdiff1d(np.arange(len(reference.surface)),
                            np.flatnonzero(np.isin(reference.surface, reference.held)))  # fmt: skip
        there = np.asarray(response.row)[reference.surface[free]]
        assert np.abs(u[there] - truth.displacement[free]).max() < 1e-3 * truth.depth
