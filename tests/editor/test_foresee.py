# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid that would be far too slow is refused before it is filled."""

from __future__ import annotations

from dataclasses import replace

import palpate
import pytest
from organs import make_organ
from palpate.cli.main import main
from palpate_editor.compile import build_organ
from palpate_editor.document.files import write_organ
from palpate_editor.foresee import FORESEEN_FROM, foresee_too_slow

SOLID = replace(make_organ(), model=replace(make_organ().model, kind="solid", constants="tissue"))


def ask_for(tetrahedra: int, **material: float):
    return replace(
        SOLID,
        fill=replace(SOLID.fill, tetrahedra=tetrahedra),
        material=replace(SOLID.material, **material),
    )


def test_a_solid_that_no_machine_ticks_in_time_is_refused_before_it_is_filled(
    tmp_path, capsys, monkeypatch
):
    def judge(*words, **more):
        raise AssertionError("it was filled and tried")

    monkeypatch.setattr("palpate_editor.verbs.tissue.assess", judge)
    file = tmp_path / "a.organ"
    write_organ(file, SOLID)
    before = file.read_bytes()
    words = ["--tetrahedra", "40000", "--young-modulus", "100kPa", "-o", str(file)]

    assert main(["material", str(file), *words]) == 1

    said = capsys.readouterr().err
    assert "fill.tetrahedra: got 40000, which asks for about" in said
    assert "% of the time there is, judged by a filling of 1000, expected fewer than" in said
    assert file.read_bytes() == before


def test_what_may_do_and_what_is_soon_known_is_not_foreseen(monkeypatch):
    stiff = {"young_modulus": 1e6}
    assert foresee_too_slow(ask_for(FORESEEN_FROM, young_modulus=100.0)) is None

    def build(*words):
        raise AssertionError("it was filled")

    monkeypatch.setattr("palpate_editor.foresee.build_organ", build)
    assert foresee_too_slow(ask_for(FORESEEN_FROM - 1, **stiff)) is None
    linear = replace(SOLID.model, kind="linear_solid")
    assert foresee_too_slow(replace(ask_for(40_000, **stiff), model=linear)) is None
    implicit = replace(SOLID.model, integrator="implicit_euler_linear")
    assert foresee_too_slow(replace(ask_for(40_000, **stiff), model=implicit)) is None


@pytest.mark.landing
def test_the_steps_foreseen_are_those_of_the_filling_within_a_third():
    organ = ask_for(FORESEEN_FROM, young_modulus=1e6)
    slow = foresee_too_slow(organ)

    assert slow is not None and slow.most < FORESEEN_FROM
    needed = 1.0 / (organ.hand.rate * palpate.stable_step(build_organ(organ)))
    assert slow.substeps == pytest.approx(needed, rel=0.33)
