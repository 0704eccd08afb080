# SPDX-License-Identifier: BSD-3-Clause
"""The references that ship: whole, what they say they are, and of the physics they claim."""

from __future__ import annotations

import hashlib
import json
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from palpate.files.refusal import Refusal
from palpate.study import reference as module
from palpate.study.models import compute_volumes, find_outside
from palpate.study.reference import Reference, list_references, read_reference

ALL = list_references()
SOLIDS, WALLS = {"spleen", "kidney", "liver"}, {"gallbladder", "stomach"}
MESHES = Path(__file__).parents[3] / "meshes"


@pytest.fixture(scope="module", params=ALL)
def reference(request) -> Reference:
    return read_reference(request.param)


def test_simple_bodies_and_the_shipped_organs_are_there():
    assert {"block", "ellipsoid", "sphere"} | SOLIDS | WALLS == set(ALL)


@pytest.mark.parametrize("name", sorted(SOLIDS | WALLS))
def test_the_reference_of_a_shipped_organ_was_solved_on_the_shape_that_ships(name):
    shape = read_reference(name).shape

    found = hashlib.sha256((MESHES / "published" / shape.file).read_bytes()).hexdigest()

    assert found == shape.sha256, (
        f"{shape.file} has changed: run tests/references/fill_organs.py {name}, then "
        f"solve_references.py {name}, and write core/ACCURACY.md again"
    )


@pytest.mark.parametrize("name", sorted(SOLIDS | WALLS))
def test_a_hollow_organ_is_a_wall_of_its_thickness_and_a_solid_one_is_not(name):
    reference = read_reference(name)
    tissue = tomllib.loads((MESHES / "tissues.toml").read_text("utf-8"))[name]["material"]

    # any Young's modulus: forces are in proportion to it
    assert reference.poisson_ratio == tissue["poisson_ratio"]
    assert reference.wall_thickness == (tissue["wall_thickness"] if name in WALLS else None)


@pytest.mark.parametrize("name", sorted(WALLS))
def test_a_wall_has_its_volume_between_two_faces(name):
    reference = read_reference(name)
    outside = reference.vertices[find_outside(reference)]
    area = 0.5 * np.linalg.norm(
        np.cross(outside[:, 1] - outside[:, 0], outside[:, 2] - outside[:, 0]), axis=1
    )

    found = compute_volumes(reference.vertices, reference.tetrahedra).sum()

    # thinner where the inner face would fold, smaller inside than outside
    assert 0.75 < found / (area.sum() * reference.wall_thickness) < 1.0


def test_a_body_is_pressed_at_three_places(reference):
    assert len({place.name for place in reference.places}) == 3


def test_a_body_is_made_of_tetrahedra_the_right_side_out(reference):
    a, b, c, d = (reference.vertices[reference.tetrahedra[:, k]] for k in range(4))

    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) > 0.0).all()
    assert np.array_equal(np.unique(reference.tetrahedra), np.arange(len(reference.vertices)))


def test_a_patch_is_on_the_surface_and_free(reference):
    for place in reference.places:
        assert np.isin(place.vertices, reference.surface).all()
        assert not np.isin(place.vertices, reference.held).any()
        assert np.linalg.norm(place.direction) == pytest.approx(1.0, abs=1e-5)


def test_every_place_is_pressed_and_pulled_to_three_depths(reference):
    for place in reference.places:
        for part in (0.03, 0.08, 0.15, -0.03, -0.08, -0.15):
            for elements in ("P1", "P2"):
                found = place.find("neo_hookean", elements, part * place.thickness)
                assert found.force * part > 0.0


def test_what_is_moved_moves_by_the_depth_and_what_is_held_does_not(reference):
    for place in reference.places:
        for result in place.results:
            patch = np.isin(reference.surface, place.vertices)
            expected = -result.depth * place.direction
            assert np.abs(result.displacement[patch] - expected).max() < 1e-6
            assert not result.displacement[np.isin(reference.surface, reference.held)].any()


def test_the_linear_answer_is_the_tangent_of_the_neo_hookean_one(reference):
    for place in reference.places:
        shallow = 0.03 * place.thickness
        line = place.find("linear", "P1", shallow).force
        press = place.find("neo_hookean", "P1", shallow).force
        pull = -place.find("neo_hookean", "P1", -shallow).force

        # what is even in the depth cancels between press and pull; what is left is of third order
        assert 0.5 * (press + pull) == pytest.approx(line, rel=0.01)


def test_plain_elements_are_too_stiff_and_the_truth_says_how_far_it_may_be_off(reference):
    for place in reference.places:
        truth = place.find("linear", "P2")
        plain = place.find("linear", "P1", truth.depth)

        assert truth.refinements == 1
        assert plain.force > truth.force
        assert 0.0 < truth.force_error < 0.15
        assert 0.0 < truth.displacement_error < 0.05


def test_linear_answers_are_known_at_every_depth(reference):
    place = reference.places[0]
    truth = place.find("linear", "P2")

    half = place.find("linear", "P2", -0.5 * truth.depth)

    assert half.force == pytest.approx(-0.5 * truth.force)
    assert half.displacement == pytest.approx(-0.5 * truth.displacement)


def test_an_answer_that_is_not_there_is_not_made_up(reference):
    with pytest.raises(KeyError, match="no result of P1 neo_hookean"):
        reference.places[0].find("neo_hookean", "P1", 0.123)


def test_a_reference_that_does_not_exist_is_refused_with_those_that_do():
    with pytest.raises(Refusal, match="expected one of .*ellipsoid"):
        read_reference("pancreas")


@pytest.mark.parametrize(
    ("damage", "where"),
    [
        (lambda data: data["mesh"]["vertices"].__setitem__(5, 1), "mesh.sha256"),
        (lambda data: data["mesh"]["tetrahedra"].reverse(), "mesh.sha256"),
        (lambda data: data.update(version=2), "format"),
        (lambda data: data.update(format="palpate-scene"), "format"),
    ],
)
def test_a_damaged_reference_is_refused(tmp_path, monkeypatch, damage, where):
    data = json.loads((module.FOLDER / "ellipsoid.json").read_bytes())
    damage(data)
    (tmp_path / "ellipsoid.json").write_text(json.dumps(data), encoding="utf-8")
    monkeypatch.setattr(module, "FOLDER", tmp_path)

    with pytest.raises(Refusal, match=where):
        read_reference("ellipsoid")


def test_a_ball_that_is_pressed_from_above_moves_to_no_side():
    truth = read_reference("sphere").places[0].find("linear", "P2")

    assert np.abs(truth.displacement[:, 2]).mean() > 0.05 * truth.depth
    assert np.abs(truth.displacement[:, :2].mean(axis=0)).max() < 1e-3 * truth.depth


def test_answers_are_values():
    result = read_reference("ellipsoid").places[0].results[0]

    assert replace(result, depth=1.0).force == result.force
