# SPDX-License-Identifier: BSD-3-Clause
"""The contact references that ship: whole, of the shapes that ship, and refused when damaged."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy as np
import pytest
from palpate.files.refusal import Refusal
from palpate.runs.press import find_place
from palpate.runs.run import read_scene
from palpate.scene.mesh_file import read_mesh_file
from palpate.study.contact_reference import (
    FOLDER,
    ContactReference,
    list_contact_references,
    read_contact_file,
    read_contact_reference,
)
from palpate.study.tool import open_pressed

ORGANS = {"spleen", "kidney", "liver", "gallbladder", "stomach"}
BUILT = [
    pytest.param(name, marks=pytest.mark.landing) if name == "liver" else name
    for name in sorted(ORGANS)
]
"""Where each is built; the largest solid takes a second for its near field."""
PUBLISHED = Path(__file__).parents[3] / "meshes" / "published"


@pytest.fixture(scope="module", params=list_contact_references())
def reference(request) -> ContactReference:
    return read_contact_reference(request.param)


def test_the_block_a_layer_and_the_shipped_organs_are_there():
    assert set(list_contact_references()) == ORGANS | {"block", "layer"}


@pytest.mark.parametrize("name", sorted(ORGANS))
def test_a_contact_reference_was_solved_on_the_shape_that_ships(name):
    shape = read_contact_reference(name).shape

    found = hashlib.sha256((PUBLISHED / shape.file).read_bytes()).hexdigest()

    assert found == shape.sha256, (
        f"{shape.file} has changed: run tests/references/fill_contacts.py {name}, then "
        f"solve_contacts.py {name}, and write core/ACCURACY.md again"
    )


@pytest.mark.parametrize("name", sorted(ORGANS | {"block"}))
def test_balls_of_two_to_eight_millimetres_are_pressed_at_three_places(name):
    reference = read_contact_reference(name)

    found = {(case.place, case.radius) for case in reference.list_cases("linear")}

    places = {spot.name for spot in reference.places}
    assert len(places) == 3
    assert found >= {(place, radius) for place in places for radius in (2e-3, 3e-3, 5e-3, 8e-3)}


@pytest.mark.parametrize("name", BUILT)
def test_the_ball_of_the_shipped_scene_is_among_them(name):
    radius = read_scene(PUBLISHED / f"{name}.palpate").instruments[0].tool.radius

    found = {case.radius for case in read_contact_reference(name).list_cases("linear")}

    assert radius in found


@pytest.mark.parametrize("name", BUILT)
def test_a_contact_reference_is_held_where_the_shipped_scene_is(name):
    # refuses any other; a decimated wall is held where its mesh is
    assert open_pressed(PUBLISHED / f"{name}.palpate").reference == read_contact_reference(name)


@pytest.mark.parametrize("name", BUILT)
def test_a_place_is_on_the_surface_and_away_from_what_is_held(name):
    reference = read_contact_reference(name)
    scene = read_scene(PUBLISHED / f"{name}.palpate")
    x = np.asarray(read_mesh_file(PUBLISHED / reference.shape.file).vertices)

    for spot in reference.places:
        found = find_place(scene, np.array(spot.point))
        off = np.linalg.norm(x[list(reference.fixed)] - np.array(spot.point), axis=1)

        # a wall is decimated, and lies so far off
        assert np.linalg.norm(found.point - np.array(spot.point)) < 3e-4
        assert found.outward @ np.array(spot.direction) > 0.9
        assert off.min() > 0.01


def test_a_ball_goes_to_a_tenth_of_the_thickness_or_one_and_a_half_of_its_radius(reference):
    for case in reference.cases:
        thickness = reference.find_place(case.place).thickness

        assert case.results[-1].depth == pytest.approx(
            min(0.1 * thickness, 1.5 * case.radius), rel=1e-4
        )


def test_the_last_refinement_changed_every_force_by_less_than_three_per_cent(reference):
    for case in reference.cases:
        # neo-Hookean forces are of the coarsest mesh: it tells a ball's first touch less well
        most = 0.03 if case.law == "linear" else 0.05
        assert max(result.force_error for result in case.results) < most, case


def test_a_ball_that_goes_deeper_feels_more_and_touches_more(reference):
    for case in reference.list_cases("linear"):
        found = np.array([[r.depth, r.force, r.contact_radius] for r in case.results])

        assert (np.diff(found, axis=0) > 0.0).all()


def test_a_larger_ball_feels_more_at_the_same_depth(reference):
    for place in reference.places:
        cases = {c.radius: c for c in reference.list_cases("linear") if c.place == place.name}
        small, large = cases[min(cases)], cases[max(cases)]
        depth = min(small.results[-1].depth, large.results[-1].depth)

        assert large.find_force(depth) > small.find_force(depth)


def test_a_force_between_two_depths_is_between_their_forces():
    case = read_contact_reference("spleen").cases[0]
    shallow, deep = case.results[:2]

    found = case.find_force(0.5 * (shallow.depth + deep.depth))

    assert shallow.force < found < deep.force


def test_a_force_at_a_depth_that_was_solved_is_the_one_of_the_file():
    case = read_contact_reference("spleen").cases[0]

    for result in case.results:
        assert case.find_force(result.depth) == pytest.approx(result.force, rel=1e-12)


def test_no_force_is_told_beyond_what_was_solved():
    case = read_contact_reference("spleen").cases[0]

    with pytest.raises(ValueError, match="expected up to"):
        case.find_force(1.1 * case.results[-1].depth)


def write_spleen(path: Path, change) -> Path:
    """The spleen's file after a change, with the hash of what it then says."""
    data = json.loads((FOLDER / "spleen.json").read_bytes())
    change(data)
    whole = json.dumps([data["places"], data["cases"]], sort_keys=True, separators=(",", ":"))
    data["sha256"] = hashlib.sha256(whole.encode()).hexdigest()
    path.write_text(json.dumps(data), encoding="utf-8")
    return path


def test_a_file_that_is_written_again_says_the_same(tmp_path):
    path = write_spleen(tmp_path / "spleen.json", lambda data: None)

    assert read_contact_file(path) == read_contact_reference("spleen")


def test_a_name_that_no_reference_has_is_refused_with_those_there_are():
    with pytest.raises(Refusal, match="'heart', expected one of block"):
        read_contact_reference("heart")


def test_a_force_that_was_changed_by_hand_is_refused(tmp_path):
    text = (FOLDER / "spleen.json").read_text(encoding="utf-8")
    force = read_contact_reference("spleen").cases[0].results[0].force
    path = tmp_path / "spleen.json"
    path.write_text(text.replace(f'"force": {force}', f'"force": {2 * force}'), encoding="utf-8")

    with pytest.raises(Refusal, match="sha256"):
        read_contact_file(path)


def test_half_a_file_is_refused(tmp_path):
    path = tmp_path / "spleen.json"
    path.write_bytes((FOLDER / "spleen.json").read_bytes()[:3000])

    with pytest.raises(Refusal, match="no JSON"):
        read_contact_file(path)


def set_version(data):
    data["version"] = 2


def name_another_place(data):
    data["cases"][0]["place"] = "nowhere"


def name_another_law(data):
    data["cases"][0]["law"] = "plastic"


def add_a_case_twice(data):
    data["cases"].append(data["cases"][0])


def lose_a_field(data):
    del data["cases"][0]["touch"]


def lose_the_results(data):
    del data["cases"][0]["results"]


def let_a_force_fall(data):
    data["cases"][0]["results"][1]["force"] = 0.0


def write_a_number_as_text(data):
    data["young_modulus"] = "10 kPa"


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (set_version, "version 2"),
        (name_another_place, r"cases\[0\].place: got 'nowhere'"),
        (name_another_law, r"cases\[0\].law: got 'plastic'"),
        (add_a_case_twice, "a second time"),
        (lose_a_field, r"cases\[0\]: got no touch"),
        (lose_the_results, r"cases\[0\].results: got nothing"),
        (let_a_force_fall, "rising ones"),
        (write_a_number_as_text, 'young_modulus: got "10 kPa", expected a number'),
    ],
)
def test_a_file_that_contradicts_itself_is_refused(tmp_path, change, sentence):
    path = write_spleen(tmp_path / "spleen.json", change)

    with pytest.raises(Refusal, match=sentence):
        read_contact_file(path)
