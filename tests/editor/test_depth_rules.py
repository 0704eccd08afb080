# SPDX-License-Identifier: GPL-3.0-or-later
"""A press that goes deeper than what is validated is told, with both numbers and what to do."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.script_file import write_script_file
from palpate_editor.compile import compile_organ
from palpate_editor.document.depth_rules import find_depth_problems
from palpate_editor.document.files import write_organ
from palpate_editor.document.problems import PlaceFacts, PressFacts

ORGAN = replace(make_organ(), tool=replace(make_organ().tool, radius=3e-3))
THIN = PlaceFacts((1e-3, 2e-3, 30e-3), thickness=26e-3, validated=2.6e-3, bound="thickness")
THICK = PlaceFacts((0.0, 0.0, 0.0), thickness=90e-3, validated=4.5e-3, bound="radius")
WALL = PlaceFacts((0.0, 0.0, 0.0), thickness=90e-3, validated=2e-3, bound="wall")


@pytest.mark.parametrize(
    ("place", "depth", "got", "expected"),
    [
        (THIN, 3e-3, "3.0 mm deep at 1, 2, 30 mm, where 2.6 mm are validated: a tenth of the "
         "thickness of 26.0 mm", "at most 2.6 mm: deeper no truth"),
        (THICK, 6e-3, "6.0 mm deep at 0, 0, 0 mm, where 4.5 mm are validated: one and a half times "
         "the tip's radius of 3.0 mm", "at most 4.5 mm, or a tip of 4.0 mm: deeper no truth"),
        # a larger tip is no remedy where the organ itself is too thin, or no such tip validated
        (THICK, 9.5e-3, "9.5 mm deep", "at most 4.5 mm: deeper no truth"),
        (replace(THICK, thickness=None), 13e-3, "13.0 mm deep", "at most 4.5 mm: deeper no truth"),
        (WALL, 3e-3, "3.0 mm deep at 0, 0, 0 mm, where 2.0 mm are validated: the thickness of its "
         "wall, 2.0 mm", "at most 2.0 mm: deeper"),
        (PlaceFacts((0.0, 0.0, 0.0)), 3e-3, "a press of 3.0 mm with a tip of 3 mm, for which no "
         "depth is validated", "a ball of 2 to 8 mm"),
    ],
)  # fmt: skip
def test_a_deep_press_is_told_with_both_depths_and_the_remedy(place, depth, got, expected):
    [problem] = find_depth_problems(ORGAN, [PressFacts(depth, place)])

    assert (problem.key, problem.severity, problem.stage) == ("deep_press", "warning", "test")
    assert problem.got.startswith(got) and problem.expected.startswith(expected)


def test_a_press_as_deep_as_what_is_validated_is_not_told():
    presses = [PressFacts(place.validated, place) for place in (THIN, THICK, WALL)]

    assert list(find_depth_problems(ORGAN, presses)) == []
    assert list(find_depth_problems(ORGAN, [])) == []


def test_of_several_places_the_farthest_beyond_is_told():
    presses = [PressFacts(5e-3, place) for place in (THICK, THIN)]

    [problem] = find_depth_problems(ORGAN, presses)

    assert "at 1, 2, 30 mm" in problem.got


# --- the verb --------------------------------------------------------------------------------


@pytest.fixture
def organ(tmp_path):
    path = tmp_path / "a.organ"
    write_organ(path, ORGAN)
    return path


def check(capsys, *words):
    assert main(["check", *map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def keys(report):
    return [problem["problem"] for problem in report["problems"]]


def test_check_says_to_which_depth_each_place_is_validated(organ, capsys):
    report = check(capsys, organ)

    assert len(report["places"]) == 5 and "deep_press" not in keys(report)
    for place in report["places"]:
        bounds = {"thickness": 0.1 * place["thickness_m"], "radius": 1.5 * 3e-3}
        assert place["validated_depth_m"] == pytest.approx(min(bounds.values()))
        assert place["validated_by"] == min(bounds, key=bounds.get)
    assert main(["check", str(organ)]) == 0
    said = capsys.readouterr().out
    assert "validated to [mm]" in said
    for place in report["places"]:
        thickness, depth = (1e3 * place[key] for key in ("thickness_m", "validated_depth_m"))
        assert f"{thickness:.1f}  " in said and f"{depth:.1f}  " in said


def test_check_says_that_no_depth_is_validated_of_a_tip_that_was_not_compared(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", make_organ())  # a tip of 12 mm

    report = check(capsys, tmp_path / "a.organ")
    main(["check", str(tmp_path / "a.organ")])

    assert all(place["validated_depth_m"] == 0.0 for place in report["places"])
    assert "no depth is validated: only balls of 2 to 8 mm are" in capsys.readouterr().out


@pytest.mark.parametrize(("depth", "told"), [("2mm", False), ("9mm", True)])
def test_check_warns_of_a_press_that_is_meant(organ, capsys, depth, told):
    report = check(capsys, organ, "--depth", depth)

    assert ("deep_press" in keys(report)) is told
    assert [press["depth_m"] for press in report["meant_presses"]] == 5 * [float(depth[0]) * 1e-3]


@pytest.mark.parametrize(("depth", "told"), [(2e-3, False), (9e-3, True)])
def test_check_warns_of_a_script_that_goes_deeper(organ, tmp_path, capsys, depth, told):
    path, scene = tmp_path / "hand.json", compile_organ(ORGAN)
    write_script_file(path, write_script(find_top(scene), 3e-3, PressScript(depth))[0])

    report = check(capsys, organ, "--script", path)

    assert ("deep_press" in keys(report)) is told
    [press] = report["meant_presses"]
    # the nearest point of a surface of large triangles is not the one that was pressed
    assert press["depth_m"] == pytest.approx(depth, rel=0.2)


def test_a_depth_that_is_none_and_a_script_that_is_not_there_are_refused(organ, tmp_path, capsys):
    assert main(["check", str(organ), "--depth", "0mm"]) == 1
    assert "--depth: got 0 mm, expected more than 0 mm" in capsys.readouterr().err
    assert main(["check", str(organ), "--script", str(tmp_path / "no.json")]) == 1
    assert "no.json" in capsys.readouterr().err
