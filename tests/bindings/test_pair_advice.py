# SPDX-License-Identifier: BSD-3-Clause
"""Constants of two bodies that may touch, wrong by a thousand: told, with what would do."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import palpate
import pytest
from palpate.command.verb import quantity
from palpate.layout.assemble import build, read_assembly, separate_bodies
from palpate.layout.check import find_cost_problems, measure_pairs
from palpate.layout.costs import Pressed
from palpate.layout.document import Layout
from palpate.layout.layout_file import read_layout
from palpate.layout.nearest_value import find_nearest_value
from palpate.layout.pair_advice import UNITS, write_option

LAYOUT = Path(__file__).resolve().parents[2] / "meshes" / "scenes" / "liver_gallbladder.layout.json"


def press_and_check(layout: Layout) -> list[str]:
    assembly = read_assembly(LAYOUT, layout)
    separate_bodies(assembly)
    scene = build(assembly)
    found = find_cost_problems(layout, scene, measure_pairs(scene, assembly), assembly)
    return [problem.message for problem in found]


def with_pair(**fields: float) -> Layout:
    layout = read_layout(LAYOUT).now
    return replace(layout, pairs=(replace(layout.pairs[0], **fields),))


@pytest.mark.landing
@pytest.mark.parametrize(("name", "value"), [("stiffness", 4e3), ("thickness", 5e-7)])
def test_a_barrier_a_thousand_times_too_soft_or_thin_is_told_with_what_holds(name, value):
    [said] = [each for each in press_and_check(with_pair(**{name: value})) if "through" in each]

    wrong, better = said.split(": with ")
    assert wrong.endswith(f" mm through each other when pressed with {write_option(name, value)}")
    number = better.removeprefix(f"--{name} ").removesuffix(" they do not")
    limit = quantity(UNITS[name])(number)
    assert value < limit < 1e3 * value
    assert not any("through" in each for each in press_and_check(with_pair(**{name: limit})))


@pytest.mark.landing
def test_a_barrier_a_thousand_times_too_stiff_is_told_with_what_takes_fewer_substeps():
    [said] = [each for each in press_and_check(with_pair(stiffness=4e9)) if "substeps" in each]

    assert ": --stiffness 4e+09N/m3 asks for 32 substeps, --stiffness " in said


def test_the_nearest_value_that_is_borne_lies_between_what_it_is_and_what_is_usual():
    pressed = Pressed(palpate.Alarm(), -1, 0, 0.0, 1.0)
    tried = []

    def press(value: float) -> Pressed | None:
        tried.append(value)
        return pressed if value >= 2e4 else None

    found, _ = find_nearest_value(press, 4e3, 9e7)

    # by hand: usual, 4e4, then sqrt(4e3 4e4) = 13e3, then sqrt(13e3 4e4) = 23e3
    assert tried == [9e7, 4e4, 1.3e4, 2.3e4]
    assert found == 2.3e4
    assert find_nearest_value(lambda _: None, 4e3, 9e7) is None
    assert find_nearest_value(lambda _: pressed, 5e3, 5e3) == (5e3, pressed)
