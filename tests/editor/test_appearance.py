# SPDX-License-Identifier: GPL-3.0-or-later
"""Every organ can look like one of those that ship, and looks like what its name says at first."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from organs import APPEARANCE, SOURCE, make_organ, surface_of
from palpate.cli.main import main
from palpate.render import build_appearance
from palpate_editor.appearance import (
    choose_appearance,
    find_named_style,
    find_style,
    make_appearance,
    read_colour,
    read_styles,
    recolour,
    write_colour,
)
from palpate_editor.document import EMPTY
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import EditError, ImportMesh, SetAppearance


@pytest.mark.parametrize(
    ("name", "style"),
    [
        ("VH_F_Spleen", "spleen"),
        ("dalağı", "spleen"),
        ("OpenHELPliver", "liver"),
        ("KARACİĞER son", "liver"),
        ("KV1_KidneyLeft", "kidney"),
        ("sağ böbrek", "kidney"),
        ("gallbladder_visual", "gallbladder"),
        ("VH_F_Urinary_Bladder", "stomach"),
        ("kidney_stone_3", "stone"),
        ("böbrek taşı", "stone"),
        ("adrenal gland", "soft_patch"),
        ("large intestine", "stomach"),
        ("mide", "stomach"),
        ("amide", None),
        ("model_final2", None),
        ("", None),
    ],
)
def test_a_name_tells_what_an_organ_looks_like(name, style):
    assert find_named_style(name) == style


def test_most_parts_decide_where_the_name_tells_nothing():
    parts = ("Left_kidney", "right kidney", "liver")

    assert find_style(choose_appearance("scan 12", parts)).name == "kidney"
    assert find_style(choose_appearance("liver", parts)).name == "liver"
    assert find_style(choose_appearance("scan 12", ("mesh_0",))).name == "soft_patch"


def test_every_style_can_be_drawn_and_is_known_again_in_any_colour():
    for style in read_styles().values():
        build_appearance(style.appearance)
        for colour in ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.2, 0.6, 0.4)):
            other = make_appearance(style.name, colour)
            build_appearance(other)
            assert other.colour == pytest.approx(colour)
            assert find_style(other) == style
    assert find_style(None) is None and find_style(APPEARANCE) is None


def test_spots_stand_out_from_another_colour_as_from_their_own():
    appearance = read_styles()["liver"].appearance

    other = recolour(appearance, (0.3, 0.4, 0.5))

    before = np.subtract(appearance.pattern_colour, appearance.colour)
    assert np.subtract(other.pattern_colour, other.colour) == pytest.approx(before)


def test_colours_are_read_as_they_are_written():
    assert write_colour(read_colour("#7a2d25")) == "#7a2d25"
    for wrong in ("red", "#12345", "#1234567", "12345g"):
        with pytest.raises(ValueError, match="expected #rrggbb"):
            read_colour(wrong)


def test_an_imported_organ_looks_like_what_its_file_is_called():
    source = replace(SOURCE, parts=("left", "right"))

    organ = ImportMesh("VH_F_Spleen", source, surface_of())(EMPTY)
    assert find_style(organ.appearance).name == "spleen"
    kept = ImportMesh("VH_F_Spleen", source, surface_of())(replace(EMPTY, appearance=APPEARANCE))
    assert kept.appearance == APPEARANCE


def test_a_style_that_is_not_there_and_a_colour_that_is_none_are_refused():
    with pytest.raises(EditError, match="one of liver, .*got velvet"):
        SetAppearance("velvet")(make_organ())
    with pytest.raises(EditError, match="0 to 1, got 2, 0, 0"):
        SetAppearance("liver", (2.0, 0.0, 0.0))(make_organ())


def test_the_verb_gives_an_appearance_and_says_which_there_is(tmp_path, capsys):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, make_organ())

    call = ["appearance", str(path), "--style", "liver", "--color", "#406080", "-o", str(out)]
    assert main(call) == 0
    assert read_organ(out).appearance == make_appearance("liver", read_colour("#406080"))
    capsys.readouterr()
    assert main(["appearance", str(out), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert (report["style"], report["colour"]) == ("liver", "#406080")
    assert report["styles"] == list(read_styles())

    assert main(["appearance", str(out), "--colour", "#102030", "-o", str(out)]) == 0
    assert read_organ(out).appearance == make_appearance("liver", read_colour("#102030"))
    assert main(["appearance", str(out), "--style", "none", "-o", str(out)]) == 0
    assert read_organ(out).appearance is None


@pytest.mark.parametrize(
    "words",
    [
        ["--colour", "#102030", "-o", "OUT"],
        ["--style", "liver"],
        ["-o", "OUT"],
        ["--style", "none", "--colour", "#102030", "-o", "OUT"],
        ["--style", "liver", "-o", "b.stl"],
    ],
)
def test_calls_that_say_too_little_or_too_much_are_refused(tmp_path, words):
    path, out = tmp_path / "a.organ", tmp_path / "b.organ"
    write_organ(path, make_organ())  # its appearance is of no style

    words = [str(out) if word == "OUT" else word for word in words]
    assert main(["appearance", str(path), *words]) == 1
    assert not out.exists()
