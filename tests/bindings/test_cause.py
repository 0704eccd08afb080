# SPDX-License-Identifier: BSD-3-Clause
"""Each constant that alone is pushed over its limit is what the advice after the alarm names."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
import palpate
import pytest
from palpate.runs.alarms import CAUSES, OPTIONS, tell_alarm
from palpate.runs.cause import HARD, find_cause
from palpate.runs.press import PressScript, find_top, write_script
from palpate.scene.scene_file import build_tissue, compile_scene
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile, ToolPart
from surfaces import ellipsoid

MESH = ellipsoid((0.03, 0.025, 0.02), 2)
SOUND = SceneFile(
    organ=None,
    material=MaterialPart(damping_ratio=0.3, wall_thickness=2.5e-3),
    model=ModelPart(stiffness=60.0, home_stiffness=3e5, drag=8.0),
    tool=ToolPart(),
    hand=HandPart(),
)
MOLECULES = replace(
    SOUND, model=replace(SOUND.model, kind="molecular", bend_stiffness=1e-5, stretch_coupling=1e-4)
)
WALL = replace(
    SOUND,
    material=replace(SOUND.material, young_modulus=2e5),
    model=replace(SOUND.model, kind="shell"),
)


def push(parts: SceneFile, key: str, value: object) -> SceneFile:
    """The same with one constant changed."""
    part, field = key.split(".")
    return replace(parts, **{part: replace(getattr(parts, part), **{field: value})})


def keep_substeps(parts: SceneFile, usual: palpate.Scene) -> palpate.Scene:
    """A scene with the substeps of another, as a program may set them after build_scene."""
    scene = palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=build_tissue(parts, MESH))],
            instruments=list(usual.instruments),
        )
    )
    return take_substeps(scene, usual)


def take_substeps(scene: palpate.Scene, usual: palpate.Scene) -> palpate.Scene:
    scene.bodies[0].substeps = usual.bodies[0].substeps
    scene.bodies[0].substeps_max = usual.bodies[0].substeps_max
    return scene


def press(scene: palpate.Scene, pull: float = 4e-3) -> palpate.Alarm:
    """The alarm of a press of 4 mm and a pull, if it raises one."""
    frames, times = write_script(
        find_top(scene), scene.instruments[0].tool.radius, PressScript(4e-3, pull)
    )
    device, world, dt = (
        palpate.ScriptedDevice(frames),
        palpate.World(scene, recovers=False),
        1.0 / scene.rate,
    )
    for tick in range(round(times.end * scene.rate)):
        palpate.tick(scene, device.read(tick * dt), dt, world)
        if world.alarm:
            break
    return world.alarm


def check_named(scene: palpate.Scene, cause: str, option: str) -> None:
    alarm = press(scene)

    assert alarm, "no alarm"
    found = find_cause(scene, alarm)
    assert found is not None and found.name == cause
    told = tell_alarm(alarm, scene)
    assert option in told
    assert "%" not in told.replace(" %", "")


@pytest.mark.parametrize("parts", [SOUND, MOLECULES, WALL])
def test_what_the_constants_were_pushed_from_raises_no_alarm(parts):
    assert not press(compile_scene(parts, MESH))


@pytest.mark.parametrize(
    ("parts", "key", "value", "cause"),
    [
        (SOUND, "model.stiffness", 1e6, "stiffness"),
        (SOUND, "model.home_stiffness", 1e12, "home"),
        (SOUND, "material.damping_ratio", 60.0, "damping"),
        (SOUND, "model.drag", 3e5, "drag"),
        (MOLECULES, "model.stiffness", 1e6, "stiffness"),
        (MOLECULES, "model.bend_stiffness", 10.0, "bend"),
        (WALL, "material.young_modulus", 2e9, "modulus"),
    ],
)
def test_what_of_a_tissue_needs_more_substeps_than_there_are_is_named(parts, key, value, cause):
    usual = compile_scene(parts, MESH)
    scene = keep_substeps(push(parts, key, value), usual)

    check_named(scene, cause, OPTIONS[key])
    found = find_cause(scene, press(scene))
    assert found.limit == usual.bodies[0].substeps_max < found.value


@pytest.mark.parametrize("pressure", [1e4, 1e5, -1e4, -1e5])
def test_a_pressure_that_bursts_or_crushes_an_organ_is_named(pressure):
    scene = compile_scene(push(SOUND, "model.pressure", pressure), MESH)

    check_named(scene, "pressure", "--pressure")


def test_a_pressure_that_is_borne_is_not_blamed_for_a_contact_that_is_too_stiff():
    parts = push(SOUND, "model.pressure", 1e3)
    assert not press(compile_scene(parts, MESH))

    check_named(compile_scene(push(parts, "tool.stiffness", 3e9), MESH), "contact", "--tool-stiff")


@pytest.mark.parametrize("stiffness", [3e9, 3e10, 1e12])
def test_a_contact_stiffness_that_makes_energy_is_named_with_one_that_does_not(stiffness):
    parts = push(SOUND, "tool.stiffness", stiffness)
    scene = compile_scene(parts, MESH)

    check_named(scene, "contact", "--tool-stiffness")
    found = find_cause(scene, press(scene))
    assert found.value == stiffness
    assert not press(compile_scene(push(parts, "tool.stiffness", found.limit), MESH))


def test_a_grip_that_is_too_stiff_for_the_steps_is_named():
    scene = compile_scene(SOUND, MESH)
    scene.instruments[0].hold_stiffness = 1e9  # no file may have it, a program may

    check_named(scene, "grip", "--grip")


@pytest.mark.parametrize("stiffness", [1e4, 1e6, 1e15])
def test_no_coupling_is_so_stiff_that_the_tissue_blows_up(stiffness):
    scene = compile_scene(SOUND, MESH)
    coupling = copy.copy(scene.instruments[0].coupling)
    coupling.stiffness = stiffness
    scene.instruments[0].coupling = coupling

    assert not press(scene)


def test_eq_10_that_makes_energy_by_itself_is_named():
    parts = push(push(MOLECULES, "model.stretch_coupling", 0.0), "model.angle_law", "eq10")
    scene = compile_scene(push(parts, "model.bend_stiffness", 1e3), MESH)

    check_named(scene, "eq10", "--angle-law")
    assert not press(compile_scene(parts, MESH))


def test_more_substeps_are_advised_where_they_alone_end_the_alarm():
    parts = push(SOUND, "model.home_stiffness", 3e8)
    scene = compile_scene(parts, MESH)

    check_named(scene, "finer", "--substeps")
    more = find_cause(scene, press(scene)).limit
    assert not press(compile_scene(push(parts, "hand.substeps", int(more)), MESH))


def test_a_sound_scene_that_was_strained_too_far_is_blamed_for_nothing():
    scene = compile_scene(SOUND, MESH)
    alarm = palpate.Alarm()
    for kind in (palpate.AlarmKind.overstretched, palpate.AlarmKind.energy):
        alarm.kind = kind
        assert find_cause(scene, alarm) is None


def test_every_cause_has_been_driven_to_its_alarm_here():
    tissue = {"stiffness", "bend", "home", "modulus", "damping", "drag"}
    assert set(CAUSES) == tissue | {"pressure", "eq10", "finer"} | {hard.name for hard in HARD}


def make_pair(first: palpate.Scene, second: palpate.Scene) -> palpate.Scene:
    """The bodies of two scenes, 20 cm apart, each with the instrument it had."""
    pair = []
    for k, scene in enumerate((first, second)):
        (body,) = scene.bodies
        tissue = copy.copy(body.tissue)
        np.asarray(tissue.rest_position)[:] += 0.2 * k
        pair.append(palpate.SoftBody(tissue=tissue))
    both = palpate.build_scene(
        palpate.Scene(bodies=pair, instruments=[*first.instruments, *second.instruments])
    )
    for body, scene in zip(both.bodies, (first, second), strict=True):
        body.substeps = scene.bodies[0].substeps
        body.substeps_max = scene.bodies[0].substeps_max
    return both


def press_both(scene: palpate.Scene) -> palpate.World:
    """The world after both hands pressed 4 mm into the top of their bodies, or an alarm."""
    devices, script = [], PressScript(4e-3, 4e-3)
    for k, instrument in enumerate(scene.instruments):
        frames, times = write_script(find_top(scene, k), instrument.tool.radius, script)
        devices.append(palpate.ScriptedDevice(frames))
    world, dt = palpate.World(scene, recovers=False), 1.0 / scene.rate
    for tick in range(round(times.end * scene.rate)):
        palpate.tick(scene, [device.read(tick * dt) for device in devices], dt, world)
        if world.alarm:
            break
    return world


SHAKEN = [
    ("model.stiffness", 1e6, "stiffness"),
    ("model.pressure", 1e5, "pressure"),
    ("tool.stiffness", 3e10, "contact"),
]


@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize(("key", "value", "cause"), SHAKEN)
def test_of_several_bodies_the_one_that_blew_up_is_examined_and_named(which, key, value, cause):
    sound = compile_scene(SOUND, MESH)
    shaken = push(SOUND, key, value)
    wrong = keep_substeps(shaken, compile_scene(replace(SOUND, tool=shaken.tool), MESH))
    scene = make_pair(*((wrong, sound) if which == 0 else (sound, wrong)))

    world = press_both(scene)

    assert world.alarm_body == which
    found = find_cause(scene, world.alarm, world.alarm_body)
    assert found is not None and (found.name, found.body) == (cause, which)
    if not key.startswith("tool."):  # what a hand holds may touch any of them
        assert find_cause(scene, world.alarm, 1 - which) is None
    told = tell_alarm(world.alarm, scene, world.alarm_body)
    assert told.startswith(f"body {which + 1} (bodies[{which}] of 2): ")
    assert OPTIONS[key] in told


def test_where_the_body_is_not_known_each_is_examined_and_only_one_with_a_cause_is_named():
    sound = compile_scene(SOUND, MESH)
    wrong = keep_substeps(push(SOUND, "model.stiffness", 1e6), sound)
    scene = make_pair(sound, wrong)
    alarm = press_both(scene).alarm

    found = find_cause(scene, alarm)

    assert found is not None and (found.name, found.body) == ("stiffness", 1)
    assert tell_alarm(alarm, scene).startswith("body 2 (bodies[1] of 2): ")
    alarm = copy.copy(alarm)
    alarm.kind = palpate.AlarmKind.overstretched
    assert not tell_alarm(alarm, make_pair(sound, sound)).startswith("body")


def test_a_body_that_a_scene_has_not_is_refused():
    scene = compile_scene(SOUND, MESH)
    alarm = press(compile_scene(push(SOUND, "tool.stiffness", 3e10), MESH))

    with pytest.raises(ValueError, match="body: got 1, expected 0"):
        find_cause(scene, alarm, 1)
