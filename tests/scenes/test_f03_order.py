# SPDX-License-Identifier: BSD-3-Clause
"""F3: vertices, triangles and tetrahedra in another order, and wound the other way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from failure_scenes import SOLIDS, SURFACES, Hand, make_ball, make_block, make_scene, make_solid
from palpate.runs.press import Place
from palpate_editor.check import assess
from palpate_editor.document import Surface
from palpate_editor.shipped import make_organ


def shuffle(count: int) -> np.ndarray:
    return np.random.default_rng(5).permutation(count)


def press(tissue: palpate.TissueModel, place: Place) -> np.ndarray:
    """[N] (n, 3) of a press 2 mm deep in 0.1 s, tick by tick."""
    scene = make_scene(tissue, kernel=palpate.Kernel.automatic)
    return np.array(Hand(scene, place).go(-1e-3, 2e-3, 0.1).force)


def reorder(vertices: np.ndarray, elements: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    order = shuffle(len(vertices))
    place = np.empty(len(order), dtype=int)
    place[order] = np.arange(len(order))
    renamed = place[np.asarray(elements)][shuffle(len(elements))]
    return np.asarray(vertices)[order], renamed


@pytest.mark.parametrize("law", [*SURFACES, *SOLIDS])
def test_f3_in_another_order_a_body_feels_the_same(law):
    if law in SURFACES:
        mesh = make_ball()
        one = SURFACES[law](mesh)
        other = SURFACES[law](palpate.SurfaceMesh(*reorder(mesh.vertices, mesh.triangles)))
    else:
        mesh = make_block((4, 4, 3))
        one = make_solid(SOLIDS[law], mesh)
        other = make_solid(SOLIDS[law], palpate.SolidMesh(*reorder(mesh.vertices, mesh.tetrahedra)))
    top = np.asarray(mesh.vertices)[:, 2].max()
    place = Place(np.array([1e-3, 2e-3, top]), np.array([0.0, 0.0, 1.0]))

    felt, again = press(one, place), press(other, place)

    assert palpate.compute_total_mass(other) == pytest.approx(
        palpate.compute_total_mass(one), rel=1e-9
    )
    assert np.abs(felt).max() > 1e-3
    assert np.abs(again - felt).max() < 1e-3 * np.abs(felt).max()


@pytest.mark.parametrize("law", SURFACES)
def test_f3_a_closed_surface_that_faces_inwards_is_refused_or_has_its_mass(law):
    mesh = make_ball()
    inwards = palpate.SurfaceMesh(mesh.vertices, np.asarray(mesh.triangles)[:, ::-1])

    try:
        tissue = SURFACES[law](inwards)
    except ValueError as refusal:
        assert "expected" in str(refusal)
        return
    mass = palpate.compute_total_mass(SURFACES[law](mesh))
    # a wall then lies outside of the surface, which is a little more of it
    assert palpate.compute_total_mass(tissue) == pytest.approx(mass, rel=0.2)


@pytest.mark.parametrize("law", SOLIDS)
def test_f3_a_tetrahedron_that_is_inside_out_is_refused_by_its_row(law):
    block = make_block()
    rows = np.array(block.tetrahedra)
    rows[7] = rows[7][[1, 0, 2, 3]]

    with pytest.raises(ValueError, match=r"\b7\b.*got .*, expected "):
        make_solid(SOLIDS[law], palpate.SolidMesh(block.vertices, rows))


def test_f3_an_organ_that_faces_inwards_is_told_with_what_turns_it():
    organ = make_organ("spleen", 300)
    model = replace(organ.model, kind="mass_spring", contact_law="hard")
    organ = replace(organ, model=model)
    surface = Surface(organ.surface.vertices, organ.surface.triangles[:, ::-1])
    inwards = replace(organ.with_surface(surface), imported=surface, decimation=None)

    [problem] = [p for p in assess(inwards).problems if p.key == "inward"]

    assert problem.severity == "error"
    assert not [p for p in assess(problem.fix(inwards)).problems if p.key == "inward"]
