# SPDX-License-Identifier: BSD-3-Clause
"""With an ideal device the passivity controller is silent on every scene that ships."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import palpate
import palpate_meshes
import pytest
from palpate.runs.press import (
    Place,
    PressScript,
    find_top,
    find_top_on,
    take_surface,
    write_script,
)
from palpate.runs.run import read_scene
from scripted_hands import PUBLISHED, open_organ_scene
from tiers import keep_everyday

SCENES = Path(palpate_meshes.__file__).parent / "scenes"
STONE = "kidney_stone"
ORGANS = sorted(path.stem for path in PUBLISHED.glob("*.palpate"))
PRESS = PressScript(depth=5e-3, pull=3e-3, speed=0.05, hold=0.1)
WAIT = 0.25
"""[s] before it: in the first 0.2 s the force fades in, and a hand gets back more than it gave."""
LONG = PressScript(depth=12e-3, speed=0.03, hold=2.0)
FLICK = PressScript(depth=8e-3, speed=0.5, hold=0.02)


def feel(name: str, script: PressScript) -> palpate.SafeDevice:
    """The link to a hand that follows a script and is never moved by what it is sent."""
    scene = open_organ_scene(name)
    return follow(scene, find_top(scene), script)[0]


def follow(
    scene: palpate.Scene, place: Place, script: PressScript
) -> tuple[palpate.SafeDevice, float]:
    """That link, and the least energy [J] that the hand was given: what it had put in, negative."""
    frames, times = write_script(place, scene.instruments[0].tool.radius, script)
    for frame in frames:
        frame.time += WAIT
    safe, least = palpate.SafeDevice(palpate.ScriptedDevice(frames)), 0.0
    world, dt = palpate.World(scene), 1.0 / scene.rate
    for tick in range(round((WAIT + times.end) * scene.rate)):
        felt = palpate.tick(scene, safe.read(tick * dt), dt, world)
        safe.set_tool(world.instruments[0].tool.position)
        safe.write(felt)
        least = min(least, safe.given_energy())
    assert not world.alarm
    return safe, least


def some(names: list[str]) -> list[object]:
    """The first of them every day, all at a landing."""
    return keep_everyday(names, names[:1])


@pytest.mark.parametrize("name", some(ORGANS))
def test_a_press_and_a_pull_of_a_shipped_organ_are_not_damped(name):
    safe = feel(name, PRESS)

    assert safe.damped_count() == 0
    assert safe.given_energy() < palpate.SafetyLimits().energy_max


@pytest.mark.landing
@pytest.mark.parametrize("name", [name for name in ORGANS if name != STONE])
def test_nor_is_a_flick_of_an_organ(name):
    assert feel(name, FLICK).damped_count() == 0


def test_nor_is_a_long_hold_where_an_organ_is_held():
    """14 mJ are in the wall of a gallbladder that is pressed beside its attachment, and come back
    however long that is held."""
    scene = read_scene(SCENES / "liver_gallbladder.palpate")
    place = find_top_on(*take_surface(scene, 0))

    safe, least = follow(scene, place, replace(PRESS, depth=6e-3, pull=0.0, hold=1.0))

    assert least < -0.01
    assert safe.damped_count() == 0


@pytest.mark.landing
@pytest.mark.parametrize("name", ["spleen", "gallbladder"])
def test_nor_is_a_deep_press_that_is_held_for_seconds(name):
    assert feel(name, LONG).damped_count() == 0


def test_nor_is_a_stone_that_is_struck():
    """Nothing gives way but the hand's spring, K of 1 N/mm, which is held for T: at speeds v of up
    to 0.9 m/s it gives K T times the integral of v² more than it takes, some 8 mJ. No force moves
    a scripted hand, so none of it counts."""
    safe = feel(STONE, FLICK)

    assert safe.dynamics().position_source
    assert safe.damped_count() == 0
