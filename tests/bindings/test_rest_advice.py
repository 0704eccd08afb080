# SPDX-License-Identifier: BSD-3-Clause
"""Of a scene with a stone: what is wrong by a thousand and ends a run before any hand comes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import palpate
import pytest
from palpate.layout.assemble import Assembly, build, read_assembly
from palpate.layout.document import Layout
from palpate.layout.hard_checks import find_unsettled
from palpate.layout.layout_file import read_layout
from palpate.layout.rest_advice import with_density, with_fluid, with_gravity

LAYOUT = Path(__file__).resolve().parents[2] / "meshes/scenes/kidney_stone_removal.layout.json"
SECONDS = 60.0
"""[s] without a hand that what is offered bears."""


@pytest.fixture(scope="module")
def layout() -> Layout:
    return read_layout(LAYOUT).now


def list_wrong(layout: Layout) -> dict[str, Layout]:
    [stone], [kidney] = layout.stones, layout.bodies
    # a weightless kidney bears any gravity, and a stone of 3 N as well
    heavy = replace(layout, bodies=(replace(kidney, weightless=False),))
    return {
        "--density 2e+06kg/m3": replace(layout, stones=(replace(stone, density=2e6),)),
        "--density 2kg/m3": replace(layout, stones=(replace(stone, density=2.0),)),
        "--gravity=0,0,-9.8e+03": replace(heavy, gravity=(0.0, 0.0, -9810.0)),
        "--fluid 1e+06,0.001": replace(layout, fluid=(1e6, 1e-3)),
    }


def tell(layout: Layout) -> str:
    assembly = read_assembly(LAYOUT, layout)
    [problem] = find_unsettled(layout, build(assembly), assembly)
    return f"{problem.where}: {problem.message}"


def put(layout: Layout, option: str) -> Assembly:
    """As `palpate scene place` and `set` do."""
    assembly = read_assembly(LAYOUT, layout)
    name, value = option.replace("=", " ").split()
    if name == "--density":
        return with_density(assembly, 0, float(value.removesuffix("kg/m3")))
    numbers = [float(each) for each in value.split(",")]
    if name == "--fluid":
        return with_fluid(assembly, *numbers)
    return with_gravity(assembly, -numbers[2])


def rests(scene: palpate.Scene, seconds: float) -> bool:
    world, away = palpate.World(scene), palpate.HapticSample(position=(0.0, 0.0, 0.9))
    for _ in range(round(seconds * scene.rate)):
        palpate.tick(scene, away, 1.0 / scene.rate, world)
        if world.alarm:
            return False
    return True


@pytest.mark.landing
@pytest.mark.parametrize("number", range(4))
def test_what_lets_no_scene_rest_is_named_with_the_nearest_value_that_does(layout, number):
    now, wrong = list(list_wrong(layout).items())[number]

    told = tell(wrong)

    where = "stone" if "density" in now else "scene"
    begin = f"{where}: without any hand, with {now} and not with "
    assert told.startswith(begin)
    option = told.removeprefix(begin).split(": ")[0]
    assert option.startswith(now.replace("=", " ").split()[0])
    assert rests(build(put(wrong, option)), 1.0)


@pytest.mark.verify
@pytest.mark.parametrize("number", range(4))
def test_with_that_it_rests_for_a_minute(layout, number):
    wrong = list(list_wrong(layout).values())[number]

    option = tell(wrong).split(" not with ")[1].split(": ")[0]

    assert rests(build(put(wrong, option)), SECONDS)


def test_a_density_weighs_mass_and_inertia_and_leaves_the_stone_that_was(layout):
    assembly = read_assembly(LAYOUT, layout)
    stone = assembly.stones[0].body

    other = with_density(assembly, 0, 4000.0).stones[0].body

    assert other.mass == pytest.approx(2.0 * stone.mass)
    assert other.inertia == pytest.approx(2.0 * stone.inertia)
    assert stone.mass == pytest.approx(0.309e-3, rel=1e-2)
