# SPDX-License-Identifier: BSD-3-Clause
"""Held-out presses: where they are, what the hand does there, and how they are summed up."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from palpate.files.refusal import Refusal
from palpate.study.held_out import (
    HeldOut,
    PressScore,
    Score,
    Step,
    choose_places,
    read_held_out,
    write_held_out,
)
from palpate.study.scene_chart import Cost, Errors
from palpate.study.track import CLEARANCE, Course
from palpate.study.truth import Truth

UP, SIDE, DOWN = (0.0, 0.0, 2.0), (1.0, 0.1, 0.05), (0.0, 0.0, -1.0)
PATH = HeldOut(
    note="",
    presses=2,
    facing=0.7,
    from_held_m=0.02,
    from_other_places_radii=3.0,
    speed_m_per_s=0.01,
    steps=(Step(0.5, 0.1), Step(0.8, 0.2), Step(0.4, 0.3)),
    directions=(UP, SIDE, DOWN),
)
FILE = {
    "format": "palpate held-out path",
    "version": 1,
    "note": "",
    "directions": [list(UP), list(SIDE), list(DOWN)],
    "presses": 2,
    "facing": 0.7,
    "from_held_m": 0.02,
    "from_other_places_radii": 3.0,
    "speed_m_per_s": 0.01,
    "steps": [{"part_of_depth": s.part_of_depth, "hold_s": s.hold_s} for s in PATH.steps],
}


@pytest.fixture(scope="module")
def ball():
    """An octahedron, cut three times and blown up to a ball of 50 mm around a place off zero."""
    x = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    t = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                  [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], np.int32)  # fmt: skip
    for _ in range(3):
        middles, rows = {}, []

        def cut(a, b, middles=middles):
            nonlocal x
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(x)
                x = np.vstack([x, 0.5 * (x[a] + x[b])])
            return middles[key]

        for a, b, c in t.tolist():
            ab, bc, ca = cut(a, b), cut(b, c), cut(c, a)
            rows += [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        t = np.array(rows, np.int32)
        x /= np.linalg.norm(x, axis=1)[:, None]
    return 0.05 * x + (0.1, 0.0, 0.0), t


def choose(ball, path=PATH, held=(), others=(), radius=4e-3):
    x, t = ball
    return choose_places(path, x, t, np.array(held).reshape(-1, 3), list(others), radius)


def test_places_are_the_first_where_a_ray_from_the_middle_comes_out(ball):
    places = choose(ball)

    assert len(places) == 2
    assert places[0].point == pytest.approx([0.1, 0.0, 0.05], abs=1e-4)
    along = np.array(SIDE) / np.linalg.norm(SIDE)
    assert (places[1].point - (0.1, 0.0, 0.0)) / 0.05 == pytest.approx(along, abs=0.02)
    assert places[1].outward @ along > 0.99


def test_a_place_near_what_is_held_or_charted_or_taken_is_passed_over(ball):
    top, bottom = np.array([0.1, 0.0, 0.05]), np.array([0.1, 0.0, -0.05])

    assert choose(ball, held=[top])[-1].point == pytest.approx(bottom, abs=1e-4)
    assert choose(ball, others=[top + [0.0, 0.0119, 0.0]])[0].point != pytest.approx(top, abs=1e-4)
    assert choose(ball, others=[top + [0.0, 0.0121, 0.0]])[0].point == pytest.approx(top, abs=1e-4)
    twice = replace(PATH, directions=(UP, (0.01, 0.0, 2.0), DOWN))
    assert choose(ball, twice)[1].point == pytest.approx(bottom, abs=1e-4)
    assert choose(ball, held=[top, bottom, [0.15, 0.0, 0.0]]) == []


def test_a_place_that_faces_elsewhere_is_passed_over(ball):
    x, t = ball
    flat = (x - (0.1, 0.0, 0.0)) * (1.0, 1.0, 0.1)  # a disk: a slanted ray leaves through its rim

    assert len(choose((flat, t), replace(PATH, directions=((1.0, 0.0, 0.6),)))) == 0
    assert len(choose((flat, t), replace(PATH, directions=((1.0, 0.0, 0.6),), facing=0.1))) == 1


def make_truth(depth: float) -> Truth:
    one = np.ones((1, 2))
    return Truth(
        key="0", law="linear", radius=4e-3, point=np.zeros((1, 3)),
        direction=np.array([[0.0, 0.0, 1.0]]), touch=np.array([4e-3]), thickness=np.array([0.05]),
        depth=np.array([0.5, 1.0]) * depth, force=one, force_error=0.01 * one,
        contact_radius=1e-3 * one, surface=np.zeros((0, 3)), displacement=np.zeros((1, 2, 0, 3)),
        displacement_error=0.01 * one,
    )  # fmt: skip


def test_the_hand_goes_to_each_depth_at_its_speed_and_stays():
    course = Course(make_truth(5e-3), np.array([[0.0, 0.0, 4e-3]]))
    frames = write_held_out(course, PATH)

    heights = [frame.position[2] - 4e-3 for frame in frames]
    assert heights == pytest.approx([CLEARANCE, -2.5e-3, -2.5e-3, -4e-3, -4e-3, -2e-3, -2e-3])
    spans = np.diff([frame.time for frame in frames])
    assert spans == pytest.approx([0.35, 0.1, 0.15, 0.2, 0.2, 0.3])


def press(error: float, displacement: float | None = 0.03, p99: float = 1e-4) -> PressScore:
    cost = Cost(1e-4, 1e-4, 1e-4, p99, 0.0, 100)
    return PressScore((0.0, 0.0, 0.0), 0.05, 5e-3, 2e-3, 0.1, error / 10, 0.01,
                      Errors(error, 2.0 * error, displacement), cost, "")  # fmt: skip


def test_a_score_sums_up_its_presses():
    score = Score((press(0.03, 0.04, 2e-4), press(0.04, 0.03)))

    assert score.errors.force_rms == pytest.approx(np.sqrt(12.5e-4))
    assert score.errors.force_most == pytest.approx(0.08)
    assert score.errors.displacement == pytest.approx(np.sqrt(12.5e-4))
    assert (score.force_error, score.p99) == pytest.approx((0.004, 2e-4))
    assert Score((press(0.03), press(0.04, None))).errors.displacement is None


def test_a_press_that_an_alarm_ended_leaves_no_score():
    stopped = replace(press(0.03), errors=None, cost=None, alarm="too far")

    assert Score((press(0.03), stopped)).errors is None
    assert Score((press(0.03), stopped)).p99 is None
    assert Score(()).errors is None and Score(()).p99 is None


def test_the_file_comes_back_as_it_stands(tmp_path):
    path = tmp_path / "held_out.json"
    path.write_text(json.dumps(FILE), encoding="utf-8")

    assert read_held_out(path) == PATH


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"format": "palpate script"}, "format"),
        ({"version": 2}, "format"),
        ({"directions": [[0, 0, 0]]}, "directions"),
        ({"directions": [[1, 0]]}, "directions"),
        ({"directions": []}, "directions"),
        ({"presses": 1.5}, "presses"),
        ({"steps": [{"part_of_depth": 1.0}]}, "steps"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_a_file_that_does_not_fit_is_refused(change, said, tmp_path):
    path = tmp_path / "held_out.json"
    path.write_text(json.dumps(FILE | change), encoding="utf-8")

    with pytest.raises(Refusal, match=said):
        read_held_out(path)


@pytest.mark.parametrize("data", [b"", b"[1", b"[]", b"[" * 60_000])
def test_what_is_no_held_out_path_is_refused(data, tmp_path):
    path = tmp_path / "held_out.json"
    path.write_bytes(data)

    with pytest.raises(Refusal):
        read_held_out(path)
