# SPDX-License-Identifier: BSD-3-Clause
"""What a scripted press says of the tissue it pressed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import palpate
import pytest
from palpate.runs.press import (
    Place,
    PressScript,
    find_top,
    has_jaws,
    measure_press,
    write_script,
)
from palpate.runs.run import read_scene, run_script
from palpate.scene.scene_file import build_tool
from palpate.scene.scene_parts import ToolPart
from published import publish

PUBLISHED = Path(__file__).resolve().parents[2] / "meshes" / "published"
PLACE = Place(np.array([0.0, 0.0, 0.02]), np.array([0.0, 0.0, 1.0]))
RADIUS, DEPTH = 3e-3, 6e-3
TIMES = write_script(PLACE, RADIUS, PressScript(DEPTH))[1]
TIME = np.arange(0.0, TIMES.end, 1e-3)


def record_of(force: np.ndarray) -> SimpleNamespace:
    """A run whose tip follows the hand into the depth, with a force [N] along the normal."""
    height = np.interp(TIME, [0.05, TIMES.pressed], [4e-3, -DEPTH])
    position = PLACE.point + np.outer(height + RADIUS, PLACE.outward)
    touched = np.zeros(len(TIME), np.uint8)
    felt = {"force": np.outer(force, PLACE.outward), "position": position, "touched": touched}
    return SimpleNamespace(hand={"time": TIME}, felt=felt)


def press(force: np.ndarray) -> dict[str, float | None]:
    return measure_press(record_of(force), PLACE, RADIUS, TIMES)


def test_the_stiffness_of_tissue_at_rest_is_its_force_over_the_depth():
    found = press(np.where(TIMES.pressed <= TIME, 0.12, 0.0))

    assert found["patch_stiffness_N_per_m"] == pytest.approx(0.12 / DEPTH)
    assert found["peak_force_N"] == pytest.approx(0.12)


def test_tissue_that_creeps_to_rest_within_the_hold_has_the_stiffness_it_comes_to():
    since = np.maximum(0.0, TIME - TIMES.pressed)

    found = press(0.12 + 0.5 * np.exp(-since / 0.03))

    assert found["patch_stiffness_N_per_m"] == pytest.approx(0.12 / DEPTH, rel=0.05)
    assert found["peak_force_N"] > 0.6


def test_a_pull_that_came_out_empty_tells_at_which_force_it_slipped():
    times = write_script(PLACE, RADIUS, PressScript(DEPTH, pull=5e-3))[1]
    time = np.arange(0.0, times.end, 1e-3)
    height = np.interp(time, [0.05, times.pressed, times.held + 0.1, times.pulled],
                       [4e-3, -DEPTH, -DEPTH, 5e-3])  # fmt: skip
    for lost, pulled, slipped in ((-1e-3, 0.0, 0.3), (4e-3, 0.3, None)):
        force = np.where((time > times.held) & (height < lost), 0.3, 0.0)
        felt = {"force": np.outer(force, PLACE.outward),
                "position": PLACE.point + np.outer(height + RADIUS, PLACE.outward),
                "touched": np.zeros(len(time), np.uint8)}  # fmt: skip
        record = SimpleNamespace(hand={"time": time}, felt=felt)

        found = measure_press(record, PLACE, RADIUS, times)

        assert (found["pull_force_N"], found["slipped_at_N"]) == (pulled, slipped)


def test_an_organ_that_still_swings_as_a_whole_has_no_stiffness():
    """A solid on a small base showed 0.7 N/m or 20, by when the hold ended."""
    swing = 0.02 * (1.0 + 0.8 * np.cos(2.0 * np.pi * (TIME - TIMES.held) / 0.25))

    found = press(np.where(TIMES.pressed <= TIME, swing, 0.12))

    assert found["patch_stiffness_N_per_m"] is None
    assert found["peak_force_N"] == pytest.approx(0.12)


def test_a_hand_that_felt_nothing_has_found_no_stiffness():
    assert press(np.zeros_like(TIME))["patch_stiffness_N_per_m"] in (None, 0.0)


def test_a_press_whose_hand_the_wrapper_refuses_ends_in_its_words(tmp_path):
    path = publish(tmp_path, subdivisions=1)
    scene = read_scene(path)
    top = find_top(scene)
    in_millimetres = replace(top, point=1e3 * top.point + np.array([0.0, 0.0, 20.0]))

    with pytest.raises(
        RuntimeError, match="the device failed: the device told a hand at .* m, exp"
    ):
        run_script(scene, in_millimetres, PressScript(DEPTH), tmp_path / "a.rec", path)


def test_jaws_are_closed_in_a_press_and_close_at_the_depth_of_a_pull():
    press_down = write_script(PLACE, RADIUS, PressScript(DEPTH), has_jaws=True)[0]
    pull_up, times = write_script(PLACE, RADIUS, PressScript(DEPTH, pull=3e-3), has_jaws=True)

    assert {frame.buttons for frame in press_down} == {1}
    assert [frame.buttons for frame in pull_up if frame.time <= times.held] == [0, 0, 0, 0]
    assert 1 in {frame.buttons for frame in pull_up if frame.time > times.held}


@pytest.mark.parametrize("script", [PressScript(4e-3), PressScript(6e-3, pull=3e-3)])
def test_a_press_with_a_grasper_is_felt(script):
    scene = read_scene(PUBLISHED / "gallbladder.palpate")
    grasper = ToolPart(radius=1.2e-3, friction=0.5, length=0.02, jaw_opening=0.52, grip_force=5.0)
    scene.instruments[0].tool = build_tool(grasper)
    scene = palpate.build_scene(scene)
    frames, times = write_script(find_top(scene), grasper.radius, script, has_jaws(scene))
    device, world = palpate.ScriptedDevice(frames), palpate.World(scene)

    until = times.pulled or times.held
    felt = np.array(
        [
            palpate.tick(scene, device.read(k / scene.rate), 1.0 / scene.rate, world).force[2]
            for k in range(int(until * scene.rate))
        ]
    )

    assert not world.alarm
    assert felt.max() > 0.1 if script.pull == 0.0 else felt.min() < -0.5
