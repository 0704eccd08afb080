# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scene`: what a layout needs from nothing to a file that is played."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import matplotlib.image
import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.render.authored_appearance import find_colours
from palpate.scene.scene_parts import AppearancePart
from test_layout import write_organ


def say(capsys, *words: object) -> dict:
    code = main(["scene", *map(str, words), "--json"])
    told = json.loads(capsys.readouterr().out)
    return {**told, "code": code}


@pytest.fixture
def layout(tmp_path, capsys) -> Path:
    """Two organs, the second laid with its foot on the top of the first."""
    organ, path = write_organ(tmp_path), tmp_path / "two.layout.json"
    say(capsys, "new", "-o", path, "--title", "Two", "--title-tr", "İki")
    say(capsys, "add", path, organ, "--name", "low")
    say(capsys, "add", path, organ, "--name", "high", "--at", "0,0,100")
    say(capsys, "pair", path, "low", "high", "--damping", 0.2)
    say(capsys, "place", path, "high", "--snap", "foot", "--onto", "low/top", "--gap", "0.3mm")
    return path


def test_from_nothing_to_a_file_that_is_pressed_and_replays(layout, tmp_path, capsys):
    out, record = tmp_path / "two.palpate", tmp_path / "two.prec"

    told = say(capsys, "publish", layout, "-o", out)

    assert (told["code"], told["out"]) == (0, str(out))
    assert told["costs"][0]["most_touching"] > 0
    found = palpate.scenario.read(out)
    assert found.title == "Two" and found.languages["tr"].title == "İki"
    assert len(found.scene.bodies) == 2
    (pair,) = found.scene.body_pairs
    assert (pair.first, pair.second, pair.damping) == (0, 1, 0.2)
    assert json.loads(found.authored)["content"]["layout"]["bodies"][1]["name"] == "high"
    colours = find_colours(found)
    assert colours is not None and colours.shape == (2 * 162, 3)
    assert main(["press", str(out), "--at", "0,0,80", "--record", str(record)]) == 0
    assert main(["replay", str(record)]) == 0
    assert "the same bits" in capsys.readouterr().out


def test_organs_rub_on_each_other_where_their_pair_says_so(layout, tmp_path, capsys):
    out = tmp_path / "rubs.palpate"
    told = say(capsys, "pair", layout, "low", "high", "--friction", 0.05)
    assert (told["pairs"], told["pair_friction"]) == ([["low", "high"]], [0.05])
    assert main(["scene", "set", str(layout), "--title", "Rubs"]) == 0
    assert "low and high may touch, and rub with 0.05" in capsys.readouterr().out

    told = say(capsys, "publish", layout, "-o", out)

    assert (told["code"], told["costs"][0]["friction"]) == (0, 0.05)
    (pair,) = palpate.scenario.read(out).scene.body_pairs
    assert pair.friction == 0.05
    assert main(["press", str(out), "--at", "0,0,80", "--record", str(tmp_path / "a.prec")]) == 0
    assert main(["replay", str(tmp_path / "a.prec")]) == 0
    assert "the same bits" in capsys.readouterr().out
    told = say(capsys, "pair", layout, "low", "high")
    assert told["pair_friction"] == [0.0]


@pytest.mark.parametrize("friction", [-0.1, 2.5])
def test_a_coefficient_that_no_file_can_hold_is_refused(layout, capsys, friction):
    assert main(["scene", "pair", str(layout), "low", "high", f"--friction={friction}"]) == 2
    assert f"friction: got {friction:g}, expected 0" in capsys.readouterr().err


def test_a_change_is_undone_and_made_again_by_later_calls(layout, capsys):
    before = json.loads(layout.read_text(encoding="utf-8"))["now"]

    moved = say(capsys, "place", layout, "high", "--by", "0,0,2", "--turn", "0,0,90", "--fold")
    assert moved["bodies"][1]["may_fold"]
    assert moved["bodies"][1]["rotation_rad"] == pytest.approx([0.0, 0.0, np.pi / 2])
    assert moved["can_undo"] == 5

    undone = say(capsys, "undo", layout)
    assert json.loads(layout.read_text(encoding="utf-8"))["now"] == before
    assert (undone["can_undo"], undone["can_redo"]) == (4, 1)
    assert say(capsys, "redo", layout)["bodies"] == moved["bodies"]


def test_errors_keep_a_scene_from_being_written(layout, tmp_path, capsys):
    say(capsys, "place", layout, "high", "--at", "0,0,5")
    out = tmp_path / "two.palpate"

    told = say(capsys, "publish", layout, "-o", out)

    assert (told["code"], told["out"]) == (1, None)
    assert not out.exists()
    assert main(["scene", "publish", str(layout), "-o", str(out)]) == 1
    said = capsys.readouterr().out
    assert "error: high: is " in said and said.endswith("not published\n")


@pytest.mark.usefixtures("little_sky")
def test_each_organ_is_drawn_in_its_own_colour(tmp_path, capsys):
    path, out, picture = (tmp_path / name for name in ("l.json", "l.palpate", "l.png"))
    say(capsys, "new", "-o", path)
    for name, colour, x in (("red", (0.8, 0.1, 0.1), -40), ("green", (0.1, 0.7, 0.1), 40)):
        look = asdict(AppearancePart(colour, colour, 1e-3, 0.0, colour, 0.0, 0.0, 0.3, 0.3, 0.2))
        organ = write_organ(tmp_path, name, appearance=look)
        say(capsys, "add", path, organ, f"--at={x},0,0")
    assert say(capsys, "publish", path, "-o", out)["code"] == 0

    words = ["--azimuth=-90", "--elevation=0", "--no-wireframe", "--size", "320x180"]
    assert main(["render", str(out), "-o", str(picture), *words]) == 0

    red, green, _ = np.moveaxis(matplotlib.image.imread(picture)[..., :3], 2, 0)
    for half, other, columns in ((red, green, slice(60, 140)), (green, red, slice(180, 260))):
        middle = half[70:110, columns], other[70:110, columns]
        assert np.median(middle[0]) > np.median(middle[1]) + 0.1


def test_a_check_that_pressed_nothing_says_so(layout, capsys):
    assert main(["scene", "check", str(layout), "--quick"]) == 0
    assert capsys.readouterr().out.endswith("can be published; no pair was pressed (--quick)\n")


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["place", "none"], 2, "expected one of low, high"),
        (["place", "high", "--at", "0,1"], 2, "expected X,Y,Z"),
        (["place", "high", "--snap", "foot"], 2, "expected both"),
        (["place", "high", "--snap", "foot", "--onto", "high/top"], 2, "BODY/REGION of another"),
        (["place", "high", "--snap", "nose", "--onto", "low/top"], 1, "expected one of top, foot"),
        (["pair", "low", "low"], 2, "--fold"),
        (["pair", "high", "other", "--remove"], 2, "nothing of this name"),
        (["add", "nowhere.palpate"], 1, "No such file"),
        (["add", "two.layout.json"], 1, "expected a published organ"),
        (["redo"], 2, "nothing that was undone"),
        (["pair", "low", "high", "--damping", "inf"], 2, "damping: got inf, expected 0 to 1"),
        (["pair", "low", "high", "--damping", "1e400"], 2, "damping: got inf, expected 0 to 1"),
        (["pair", "low", "high", "--damping", "1e300"], 2, "damping: got 1e+300, expected 0 to 1"),
        (["pair", "low", "high", "--damping", "nan"], 2, "damping: got nan, expected 0 to 1"),
        (["pair", "low", "high", "--friction", "inf"], 2, "friction: got inf, expected 0 to 2"),
        (["pair", "low", "high", "--thickness", "6mm"], 2, "thickness: got 6 mm, expected 0 to 5"),
        (["tool", "--jaw-opening", "inf"], 2, "--jaw-opening: got inf, expected 0 to 1.57"),
        (["tool", "--friction", "1e300"], 2, "--friction: got 1e+300, expected 0 to 2"),
        (["tool", "--trocar=1e300,0,0"], 2, "expected X,Y,Z of up to 10000 mm each"),
        (["place", "high", "--at", "1e300,0,0"], 2, "expected X,Y,Z of up to 10000 mm each"),
        (["place", "high", "--by=-1e5,0,0"], 2, "expected X,Y,Z of up to 10000 mm each"),
        (["place", "high", "--at=9e3,0,0", "--by=9e3,0,0"], 2,
         "high: position: got 18000 mm, expected -10000 to 10000 mm"),
        (["place", "high", "--turn", "0,0,1e300"], 2, "expected X,Y,Z of up to 3600 degrees each"),
        (["set", "--gravity=0,0,-1e9"], 2, "expected X,Y,Z of up to 100 m/s² each"),
        (["place", "high", "--snap", "foot", "--onto", "low/top", "--gap=-0.1mm"], 2,
         "--gap: got -0.1 mm, expected 0 to 1000 mm"),
        (["add", "organ.palpate", "--name", "a/b"], 2, "name: got 'a/b', expected a name, without"),
        (["add", "organ.palpate", "--name", ""], 2, "name: got '', expected a name, without /"),
        (["set", "--title", "\udcff"], 2, "got '\\udcff', expected text that UTF-8 can say"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_refused_and_leaves_the_layout_as_it_was(
    words, code, said, layout, monkeypatch, capsys
):
    monkeypatch.chdir(layout.parent)
    before = layout.read_bytes()
    action, *rest = words

    assert main(["scene", action, str(layout), *rest]) == code

    assert said in capsys.readouterr().err
    assert layout.read_bytes() == before


def test_the_ends_of_what_places_and_turns_can_be_are_read_again(layout, capsys):
    at, turn = "--at=1e4,-1e4,0", "--turn=3600,-3600,3600"
    told = say(capsys, "place", layout, "high", at, turn)
    assert told["bodies"][1]["position_m"] == [10.0, -10.0, 0.0]
    assert say(capsys, "undo", layout)["code"] == 0


def test_a_scene_without_a_title_is_told_what_a_trainee_reads_and_what_gives_it_one(layout, capsys):
    def notes() -> list[str]:
        found = say(capsys, "check", layout, "--quick")["problems"]
        return [problem["message"] for problem in found if problem["where"] == "title"]

    assert notes() == []
    say(capsys, "set", layout, "--title", "")

    (said,) = notes()
    assert '"low + high"' in said and "`palpate scene set LAYOUT --title" in said


def test_a_changed_organ_is_told_and_its_new_file_can_be_taken(layout, tmp_path, capsys):
    write_organ(tmp_path, "organ", rate=800.0)
    told = say(capsys, "check", layout, "--quick")
    assert told["code"] == 1
    assert {problem["where"] for problem in told["problems"]} == {"low", "high"}

    for name in ("low", "high"):
        say(capsys, "place", layout, name, "--renew")

    assert say(capsys, "check", layout, "--quick")["code"] == 0
