# SPDX-License-Identifier: GPL-3.0-or-later
"""The library of tissues: what ships is told from what is known, and a designer adds his own."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate_editor.check import assess
from palpate_editor.document import EMPTY
from palpate_editor.document.constants import find_constant
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.document.tissue_rules import find_tissue_problems
from palpate_editor.edits import EditError, SetConstant, SetTissue
from palpate_editor.tissue_library import (
    choose,
    find_named,
    find_own_file,
    find_tissue,
    read_library,
    search,
)

WANTED = {
    *("heart_muscle", "small_bowel", "large_bowel", "bladder", "pancreas", "uterus", "prostate"),
    *("lung", "muscle", "fat", "skin", "artery", "vein", "nerve", "brain", "liver", "spleen"),
    *("kidney", "gallbladder", "stomach"),
}
OWN = """
[tongue]
title = "tongue"
kind = "solid"
words = ["dil"]

[[tongue.published]]
quantity = "young_modulus"
low = 2e3
high = 8e3
method = "indentation"
setting = "ex vivo"
rate = "1 mm/s"
source = "our own laboratory, 2026"
status = "checked"
"""


@pytest.fixture(autouse=True)
def settings(tmp_path, monkeypatch):
    """The own library of the account that runs the tests is not read."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "settings"))
    return tmp_path / "settings"


@pytest.fixture
def tissues():
    return read_library()


def of(tissues, name):
    return find_tissue(tissues, name)


def report_of(capsys, *words: object) -> dict:
    assert main([*map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_the_library_has_what_a_surgeon_touches_and_every_value_says_where_it_is_from(tissues):
    assert {tissue.name for tissue in tissues} >= WANTED
    assert len({tissue.name for tissue in tissues}) == len(tissues)
    for tissue in tissues:
        assert tissue.values_of("young_modulus"), tissue.name
        for value in tissue.values:
            assert value.source and value.method and value.setting and value.rate
            assert (value.low is None) == (value.status == "unknown")


def test_what_is_quoted_from_memory_is_never_called_checked(tissues):
    for tissue in tissues:
        for value in tissue.values:
            if "memory" in value.source or "quoted" in value.source or "general" in value.source:
                assert value.status == "recalled", (tissue.name, value)


def test_all_three_statuses_are_there_and_only_checked_ones_are_taken_by_themselves(tissues):
    statuses = {"checked": 0, "recalled": 0, "unknown": 0}
    for tissue in tissues:
        statuses[tissue.status] += 1
        if tissue.status == "checked":
            assert choose(tissue).status == "checked"
        else:
            with pytest.raises(Refusal):
                choose(tissue)
    assert min(statuses.values()) >= 1


def test_a_recalled_stiffness_is_taken_where_it_is_asked_for_and_an_unknown_one_never(tissues):
    taken = choose(of(tissues, "brain"), recalled=True)

    assert taken.status == "recalled" and taken.young_modulus == pytest.approx(1658.0, rel=1e-3)
    with pytest.raises(Refusal, match="is unknown, expected --young-modulus with it"):
        choose(of(tissues, "vein"), recalled=True)
    own = choose(of(tissues, "vein"), young_modulus=3e5)
    assert (own.young_modulus, own.status, own.source) == (3e5, "unknown", "")


def test_the_default_is_the_middle_of_the_first_checked_value(tissues):
    assert choose(of(tissues, "pancreas")).young_modulus == pytest.approx(6.4e3)
    # of a wide range the geometric mean: 1 and 4.1 MPa
    assert choose(of(tissues, "bladder")).young_modulus == pytest.approx(np.sqrt(4.1) * 1e6)
    assert choose(of(tissues, "bladder")).wall_thickness == pytest.approx(2.85e-3)
    # a density that is only recalled is not taken along
    assert choose(of(tissues, "uterus")).density is None
    assert choose(of(tissues, "uterus"), recalled=True).density == 1052.0


def test_a_tissue_of_a_shipped_organ_has_the_numbers_that_were_chosen_for_it(tissues):
    taken = choose(of(tissues, "gallbladder"))

    assert (taken.young_modulus, taken.wall_thickness, taken.density) == (2.5e5, 2.5e-3, 2600.0)


def test_every_number_that_can_be_taken_is_one_that_a_material_may_have(tissues):
    for tissue in tissues:
        for value in tissue.values:
            constant = find_constant("material", value.quantity)
            assert value.low is None or (constant.allows(value.low) and constant.allows(value.high))


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("heart", "heart_muscle"),
        ("KALP", "heart_muscle"),
        ("böbrek", "kidney"),
        ("bobrek", "kidney"),
        ("BAĞIRSAK kalın", "large_bowel"),
        ("wall artery", "artery"),
        ("myometrium", "uterus"),
    ],
)
def test_a_tissue_is_found_by_words_in_either_language(tissues, words, name):
    found = [tissue.name for tissue in search(tissues, words)]

    assert name in found and len(found) < 6


def test_words_that_none_has_find_none_and_no_words_find_all(tissues):
    assert search(tissues, "zzz") == []
    assert search(tissues, "  ") == tissues


# ---------------------------------------------------------------- a designer's own


def test_a_file_in_the_folder_of_settings_adds_tissues(settings):
    assert find_own_file() == settings / "palpate" / "tissues.toml"
    find_own_file().parent.mkdir(parents=True)
    find_own_file().write_text(OWN, encoding="utf-8")

    tongue = of(read_library(), "tongue")

    assert (tongue.origin, choose(tongue).young_modulus) == ("tissues.toml", 4e3)


def test_a_library_named_on_the_command_line_is_used(tmp_path, capsys):
    (tmp_path / "mine.toml").write_text(OWN, encoding="utf-8")

    found = report_of(capsys, "tissues", "dil", "--library", tmp_path / "mine.toml")

    assert [row["name"] for row in found["tissues"]] == ["tongue"]
    assert found["tissues"][0]["default"]["young_modulus"] == 4e3


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("", "", "got nothing, expected who published it"),
        ("[tongue]", "[liver]", "a name that ships"),
        ('kind = "solid"', 'kind = "jelly"', "tongue.kind"),
        ("low = 2e3", "low = -1.0", "published[0].low"),
        ("low = 2e3", "low = 9e3", "the lower end first"),
        ("low = 2e3", "low = nan", "published[0].low"),
        ("low = 2e3\n", "", "published[0].low"),
        ('status = "checked"', 'status = "sure"', "published[0].status"),
        ('status = "checked"', 'status = "unknown"', "a number that is unknown"),
        ('quantity = "young_modulus"', 'quantity = "colour"', "published[0].quantity"),
        ('rate = "1 mm/s"\n', "", "no rate"),
        ('words = ["dil"]', 'words = "dil"', "tongue.words"),
        ('words = ["dil"]', 'sound = "wet"', "tongue.sound"),
        ("[tongue]", "[tongue", "no TOML"),
        ('title = "tongue"\n', "", "tongue.title"),
    ],
)
def test_a_damaged_library_is_refused_with_a_place(old, new, sentence, tmp_path):
    text = OWN.replace("our own laboratory, 2026", " ") if not old else OWN
    text = text.replace(old, new) if old else text
    if new == "[liver]":
        text = text.replace("[[tongue.", "[[liver.")
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")

    with pytest.raises(Refusal) as refused:
        read_library(tmp_path / "mine.toml")

    assert sentence in str(refused.value) and str(tmp_path) in str(refused.value)


@pytest.mark.parametrize("data", [b"\xff\xfe\x00", b"a" * 2_000_000, b"x = 1\n"])
def test_bytes_that_are_no_library_are_refused(data, tmp_path):
    (tmp_path / "mine.toml").write_bytes(data)

    with pytest.raises(Refusal):
        read_library(tmp_path / "mine.toml")


# ---------------------------------------------------------------- given to an organ


def plain():
    return replace(make_organ(), tissues=(), stiffness_scale=np.ones(60))


def test_a_tissue_gives_an_organ_its_constants_and_a_region_its_stiffness(tissues):
    organ = SetTissue(choose(of(tissues, "liver")))(plain())
    organ = SetTissue(choose(of(tissues, "muscle"), "hilum"))(organ)

    assert (organ.material.young_modulus, organ.material.density) == (5e3, 1060.0)
    factor = choose(of(tissues, "muscle")).young_modulus / 5e3
    assert organ.stiffness_scale[[1, 4, 7]] == pytest.approx([factor] * 3)
    assert (organ.stiffness_scale != 1.0).sum() == 3
    assert [(t.name, t.region) for t in organ.tissues] == [("liver", ""), ("muscle", "hilum")]


def test_a_region_keeps_its_stiffness_where_that_of_the_rest_changes(tissues):
    organ = SetTissue(choose(of(tissues, "muscle"), "hilum"))(plain())

    organ = SetTissue(choose(of(tissues, "spleen")))(organ)

    felt = organ.material.young_modulus * organ.stiffness_scale[[1, 4, 7]]
    assert felt == pytest.approx([choose(of(tissues, "muscle")).young_modulus] * 3)


def test_a_region_takes_another_tissue_in_the_place_of_its_first(tissues):
    organ = SetTissue(choose(of(tissues, "muscle"), "hilum"))(plain())
    organ = SetTissue(choose(of(tissues, "fat"), "hilum"))(organ)

    assert [t.name for t in organ.tissues] == ["fat"]


@pytest.mark.parametrize(
    ("region", "words"), [("apex", "no region apex"), ("alt uç", "has no vertices")]
)
def test_a_region_that_is_not_there_is_refused(region, words, tissues):
    with pytest.raises(EditError, match=words):
        SetTissue(choose(of(tissues, "fat"), region))(plain())


def test_a_region_that_would_be_stone_beside_the_rest_is_refused(tissues):
    organ = SetTissue(choose(of(tissues, "fat")))(plain())

    with pytest.raises(EditError, match="between 0.05 and 20"):
        SetTissue(choose(of(tissues, "bladder"), "hilum"))(organ)


def test_a_recalled_stiffness_is_said_as_long_as_it_is_in_force(tissues):
    organ = SetTissue(choose(of(tissues, "brain"), recalled=True))(plain())

    (problem,) = find_tissue_problems(organ)
    assert (problem.key, problem.severity) == ("recalled_tissue", "warning")
    assert "1.65831 kPa of brain, recalled and not looked up (Budday" in problem.got
    assert problem in assess(organ).problems
    assert not list(find_tissue_problems(SetConstant("material", "young_modulus", 2e3)(organ)))
    checked = SetTissue(choose(of(tissues, "fat")))(organ)
    assert not list(find_tissue_problems(checked))


def test_a_recalled_stiffness_of_a_region_is_said_too(tissues):
    organ = SetTissue(choose(of(tissues, "breast"), "hilum", recalled=True))(plain())

    assert [problem.where for problem in find_tissue_problems(organ)] == ["tissues.hilum"]
    softer = replace(organ, stiffness_scale=np.ones(60))
    assert not list(find_tissue_problems(softer))


# ---------------------------------------------------------------- verbs


@pytest.fixture
def file(tmp_path):
    write_organ(tmp_path / "a.organ", replace(plain(), title="", languages={}))
    return tmp_path / "a.organ"


def test_a_tissue_is_given_by_name_and_a_region_by_its_own(file, capsys):
    report_of(capsys, "material", file, "--tissue", "liver", "--tissue", "hilum=fat", "-o", file)

    organ = read_organ(file)
    assert organ.material.young_modulus == 5e3
    assert [(t.name, t.region) for t in organ.tissues] == [("liver", ""), ("fat", "hilum")]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--tissue", "brain"], "only recalled (Budday"),
        (["--tissue", "vein", "--recalled"], "is unknown, expected --young-modulus"),
        (["--tissue", "lvier"], "--tissue: got lvier, expected one of liver"),
        (["--tissue", "apex=fat"], "There is no region apex"),
    ],
)
def test_a_tissue_that_cannot_be_taken_is_refused(words, sentence, file, capsys):
    before = file.read_bytes()

    assert main(["material", str(file), *words, "-o", str(file)]) == 1

    assert sentence in capsys.readouterr().err
    assert file.read_bytes() == before


def test_options_of_a_tissue_without_one_are_a_wrong_call(file, capsys):
    assert main(["material", str(file), "--recalled", "-o", str(file)]) == 2

    assert "--recalled needs --tissue" in capsys.readouterr().err


def test_check_and_publish_say_what_was_only_recalled(file, tmp_path, capsys):
    words = ["--tissue", "brain", "--recalled", "--kind", "mss"]
    report_of(capsys, "material", file, *words, "-o", file)

    assert main(["check", str(file)]) == 1  # it has no title
    assert "recalled and not looked up (Budday" in capsys.readouterr().out
    out = tmp_path / "a.palpate"
    published = report_of(capsys, "publish", file, "--title", "Brain", "-o", out)
    assert any("recalled and not looked up" in problem["got"] for problem in published["problems"])


@pytest.mark.parametrize(
    ("name", "tissue"),
    [
        ("VH_F_Spleen", "spleen"),
        ("VH_M_Heart", "heart_muscle"),
        ("KidneyLeft_1", "kidney"),
        ("kidney stone 3", "stone"),
        ("gallbladder", "gallbladder"),
        ("dtm-prostat", "prostate"),
        ("böbrek", "kidney"),
        ("OpenHELPliver", None),
        ("part 7", None),
        ("", None),
    ],
)
def test_an_organ_is_of_the_tissue_that_its_name_says(name, tissue):
    found = find_named(read_library(own=False), name)

    assert (found and found.name) == tissue


def test_the_verb_lists_all_and_shows_one_in_full(capsys):
    assert main(["tissues"]) == 0
    listed = capsys.readouterr().out
    assert main(["tissues", "prostate"]) == 0
    shown = capsys.readouterr().out

    assert listed.count("\n") > 20 and "RECALLED" in listed and "UNKNOWN" in listed
    assert "Young's modulus 11.1 to 15.3 kPa" in shown and "s43055-021-00679-8" in shown
    assert main(["tissues", "zzz"]) == 1
    assert "which none is called" in capsys.readouterr().err


def test_an_organ_without_tissues_has_no_word_of_them(tmp_path):
    write_organ(tmp_path / "a.organ", EMPTY)

    assert read_organ(tmp_path / "a.organ").tissues == ()
