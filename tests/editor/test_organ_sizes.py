# SPDX-License-Identifier: GPL-3.0-or-later
"""A wrong unit is told by the organ's name: guessed again, or said before it is published."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import palpate
import pytest
from foreign_files import write_glb, write_obj
from palpate_editor import shipped
from palpate_editor.check import assess
from palpate_editor.document import EMPTY
from palpate_editor.document.organ_sizes import SIZES, find_fitting_unit, find_range, find_word
from palpate_editor.edits import import_file
from palpate_meshes.generate import ellipsoid


def long_organ(size: float) -> tuple[np.ndarray, np.ndarray]:
    """`size` [any unit] from corner to corner."""
    x, triangles = ellipsoid(60)
    return size / palpate.compute_diagonal(x) * x, np.asarray(triangles)


@pytest.mark.parametrize(
    ("name", "size", "unit"),
    [
        ("organ", 0.12, "m"), ("organ", 12.0, "cm"), ("organ", 120.0, "mm"),
        ("organ", 120_000.0, "um"),
        # by size alone it was centimetres: a prostate of 45 cm
        ("prostate", 45.0, "mm"), ("gallbladder_visual", 58.0, "mm"), ("Left Kidney", 11.0, "cm"),
        ("VH_F_Kidney_L", 110.0, "mm"), ("colon_8", 55_000.0, "mm"),
    ],
)  # fmt: skip
def test_the_guess_of_a_unit_heeds_the_name(name, size, unit, tmp_path):
    path = tmp_path / f"{name}.obj"
    write_obj(path, *long_organ(size))

    read = import_file(path)

    assert read.source.unit_guessed and read.source.unit_reason
    length = palpate.compute_diagonal(read.surface.vertices)
    assert length == pytest.approx(size * {"m": 1, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}[unit])
    assert read.source.unit == unit


def test_a_unit_that_was_asked_for_stays(tmp_path):
    write_obj(tmp_path / "prostate.obj", *long_organ(45.0))

    assert import_file(tmp_path / "prostate.obj", unit="cm").source.unit == "cm"


def test_a_stated_unit_that_makes_a_colon_of_five_metres_keeps_it_from_being_published(tmp_path):
    x, triangles = long_organ(1.0)
    write_glb(tmp_path / "colon.glb", x, triangles, scale=5.0)
    organ = import_file(tmp_path / "colon.glb")(EMPTY)
    assert organ.source.unit == "m" and not organ.source.unit_guessed

    [problem] = [p for p in assess(organ).problems if p.key == "size"]

    assert problem.severity == "error"
    assert "5000 mm" in problem.got and "colon" in problem.got
    assert problem.fix is None, "5 fits no other unit: millimetres of it would be a crumb"


def test_a_stated_unit_ten_times_off_is_mended_by_the_fix_that_is_offered(tmp_path):
    x, triangles = long_organ(1.0)
    write_glb(tmp_path / "kidney.glb", x, triangles, scale=110.0)
    organ = import_file(tmp_path / "kidney.glb")(EMPTY)

    [problem] = [p for p in assess(organ).problems if p.key == "size"]

    repaired = problem.fix(organ)
    assert palpate.compute_diagonal(repaired.surface.vertices) == pytest.approx(0.11)
    assert "size" not in [p.key for p in assess(repaired).problems]


def test_a_part_may_be_smaller_than_the_whole(tmp_path):
    write_obj(tmp_path / "heart.obj", *long_organ(20.0))
    organ = import_file(tmp_path / "heart.obj", unit="mm")(EMPTY)
    assert "size" in [p.key for p in assess(organ).problems]
    valve = replace(organ, source=replace(organ.source, parts=("valve",)))

    assert "size" not in [p.key for p in assess(valve).problems]


@pytest.mark.parametrize("name", [entry.name for entry, _ in shipped.list_organs()])
def test_the_organs_that_ship_are_as_large_as_their_names_say(name):
    organ = shipped.make_organ(name)
    word = find_word((name,))
    least, most = find_range(word)

    assert word is None or least <= palpate.compute_diagonal(organ.surface.vertices) <= most


@pytest.mark.parametrize("name", ["VH_F_Spleen", "VH_F_Pancreas", "hra_VH_F_Urinary_Bladder"])
def test_real_organs_are_as_large_as_their_names_say(name, shared_data):
    read = import_file(shared_data(f"organs/{name}.glb"))
    least, most = find_range(find_word((name,)))

    assert least <= palpate.compute_diagonal(read.surface.vertices) <= most


def test_no_two_units_fit_an_organ_of_a_known_name():
    for word, (least, most) in SIZES.items():
        assert most / least < 10.0
        middle = (least * most) ** 0.5
        for unit, size in (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6)):
            assert find_fitting_unit(middle / size, word) == unit


def test_words_are_whole_words():
    assert find_word(("VH_F_Kidney_L",)) == "Kidney"
    assert find_word(("kidneystone", "")) is None
    assert find_word(("kidney stone",)) is None, "which is in a kidney"
    assert find_word(("organ7", "Left-Lung.obj")) == "Lung"
