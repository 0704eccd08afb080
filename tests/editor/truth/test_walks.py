# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations of drags and scripts on an ellipsoid, and what is refused of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.runs.press import PressScript, write_script
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.edits import FixLowest, decimate_organ
from palpate_editor.truth import Drag, Press, Pull, Script, TruthError
from palpate_editor.truth.paths import choose_depths, choose_place, find_stations
from palpate_editor.truth.subject import find_whole, take_subject
from palpate_meshes.generate import ellipsoid

RADIUS = 4e-3
AXES = np.array([50e-3, 35e-3, 30e-3])


def make_organ(vertices: int = 600) -> Organ:
    surface = Surface(*ellipsoid(vertices, tuple(AXES), bow=0.0, hollow=0.0, notches=0.0))
    return FixLowest(0.3)(replace(EMPTY.with_surface(surface), imported=surface))


ORGAN = make_organ()
SUBJECT = take_subject(ORGAN)


def find_way(path):
    return find_stations(ORGAN, SUBJECT, RADIUS, path)


def measure_level(points) -> np.ndarray:
    """1 on the ellipsoid."""
    return np.sqrt(((np.asarray(points) / AXES) ** 2).sum(axis=1))


def test_a_drag_passes_three_edges_of_the_surface_in_equal_steps_along_it():
    way = find_way(Drag())
    points = np.array([station.point for station in way.stations])
    x, triangles = ORGAN.surface.vertices, ORGAN.surface.triangles
    edge = np.linalg.norm(x[triangles] - x[np.roll(triangles, 1, axis=1)], axis=2).mean()

    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)

    assert way.path == "drag" and len(points) >= 4
    assert steps.sum() == pytest.approx(max(3.0 * edge, 2.0 * RADIUS), rel=0.03)
    assert steps.max() < 1.1 * steps.min() and steps.max() < 1.05 * RADIUS
    # between vertices of the ellipsoid the surface is a little inside
    assert (np.abs(measure_level(points) - 1.0) < 0.03).all()
    held = x[ORGAN.fixed]
    assert (np.linalg.norm(points[:, None] - held, axis=2) > RADIUS).all()


def test_a_drag_heads_for_the_point_that_is_asked_for():
    way = find_way(Drag((0.0, 0.0, 0.03), (0.05, 0.0, 0.03), 15e-3))
    points = np.array([station.point for station in way.stations])

    assert (np.diff(points[:, 0]) > 1e-3).all()
    assert np.abs(points[:, 1]).max() < 2e-3
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(15e-3, rel=0.03)


@pytest.mark.parametrize(
    ("path", "sentence"),
    [
        (Drag(length=0.0), "length: got 0 mm, expected one above 0 and up to 40 mm"),
        (Drag(length=0.041), "length: got 41 mm"),
        (Drag(length=float("nan")), "length: got nan mm"),
        (Drag((0.0, 0.0, 0.03), (0.0, 0.0, 0.05)), "to head for, expected one beside it"),
        (Drag((0.05, 0.0, 0.0), (0.05, 0.0, -0.05), 0.03), "expected 30 mm: begin elsewhere"),
        (Pull(grip=0.0), "grip: got 0 mm, expected one above 0"),
        (Pull(grip=0.1), "grip: got 100 mm, expected one above 0 and up to .* of the thickness"),
        (Script([palpate.KeyFrame(0.0, [0.0, 0.0, 0.2], 0)]), "got one that touches nothing"),
        (Script([palpate.KeyFrame(0.0, [0.0, 0.0, 0.03], 1)]), "got one that takes hold"),
    ],
)
def test_a_path_that_cannot_be_gone_is_refused_in_a_sentence(path, sentence):
    with pytest.raises(TruthError, match=sentence):
        find_way(path)


def test_a_script_that_presses_once_has_one_station_there_and_its_own_depth():
    place = choose_place(SUBJECT, (0.0, 0.0, 0.03))
    frames, _ = write_script(place, RADIUS, PressScript(2e-3))

    way = find_way(Script(frames))
    depths, remarks = choose_depths(way, None)

    assert len(way.stations) == 1
    assert way.stations[0].point == pytest.approx(place.point, abs=1e-4)
    assert depths[-1] == pytest.approx(2e-3, rel=0.02)
    assert remarks == ()


def test_a_script_that_goes_deeper_than_linear_truth_is_solved_so_far_and_it_is_said():
    place = choose_place(SUBJECT, (0.0, 0.0, 0.03))
    frames, _ = write_script(place, RADIUS, PressScript(9e-3))

    way = find_way(Script(frames))
    depths, (remark,) = choose_depths(way, None)

    assert depths[-1] == pytest.approx(6e-3, rel=0.03)
    assert "the script goes 9 mm deep" in remark or "the script goes 8.9" in remark


def test_a_script_that_slides_has_stations_along_its_way():
    """A hand 1 mm deep, from side to side over the top."""
    height = 0.03 + RADIUS - 1e-3
    ends = [palpate.KeyFrame(t, [x, 0.0, height], 0) for t, x in ((0.0, -6e-3), (1.0, 6e-3))]

    points = np.array([station.point for station in find_way(Script(ends)).stations])

    assert len(points) >= 3
    assert (np.diff(points[:, 0]) > 2e-3).all()
    assert np.abs(points[:, 1]).max() < 1e-3


def test_a_pull_goes_up_from_its_grip_by_the_hold_of_the_hand():
    way = find_way(Pull())
    depths, _ = choose_depths(way, None)

    assert way.stations[0].hold.stiffness == ORGAN.hand.hold_stiffness
    assert (depths < 0.0).all() and (np.diff(depths) < 0.0).all()
    assert choose_depths(way, np.array([1e-3, 2e-3]))[0].tolist() == [-1e-3, -2e-3]


def test_a_truth_is_of_the_surface_that_was_imported_and_not_of_a_coarser_one():
    coarse = decimate_organ(ORGAN, 150)(ORGAN)

    whole = find_whole(coarse)

    assert whole.surface is ORGAN.surface
    assert abs(whole.fixed.mean() - ORGAN.fixed.mean()) < 0.1
    assert find_whole(ORGAN) is ORGAN


def test_a_press_begins_where_a_check_does():
    from palpate.runs.trial import choose_places
    from palpate_editor.compile import compile_organ

    place = choose_places(compile_organ(replace(ORGAN, tool=replace(ORGAN.tool, radius=RADIUS))))[0]

    assert find_way(Press()).stations[0].point == pytest.approx(place.point, abs=1e-9)
    assert find_way(Press()).stations[0].direction == pytest.approx(place.outward, abs=1e-9)
