# SPDX-License-Identifier: BSD-3-Clause
"""An organ played and felt through the low-cost device without its metal."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
import pytest
from device_runs import press_through
from palpate import scenario
from palpate.cli.main import main
from palpate.cli.play import describe_play_report
from palpate.command.verb import WrongCall
from palpate.device.names import split_hand
from palpate.runs.felt import read_column
from palpate.runs.play import Play, open_play
from palpate.runs.play_report import play_headless
from palpate.runs.run import run_device
from published import publish, write_press
from surfaces import organ_scene

GALLBLADDER = Path(__file__).resolve().parents[1] / "scenes" / "springs" / "gallbladder.palpate"


def test_devices_are_named_by_what_is_held_and_who_moves_it():
    assert split_hand("pointer") == ("", "")
    assert split_hand("script:a.json") == ("", "a.json")
    assert split_hand("plant") == ("plant", "")
    assert split_hand("plant:script:a:b.json") == ("plant", "a:b.json")
    assert split_hand("serial:/dev/ttyUSB0") == ("serial:/dev/ttyUSB0", "")
    for wrong in ("glove", "plant:", "plant:pointer", "plants", "script", "serial:", ""):
        with pytest.raises(WrongCall):
            split_hand(wrong)


def test_a_scenario_is_played_on_the_simulated_arm_and_its_record_replays(tmp_path, capsys):
    path, script, record = publish(tmp_path), write_press(tmp_path), tmp_path / "arm.prec"
    words = ("--device", f"plant:script:{script}", "--headless", "--duration", "1200ms")

    code = main(["play", str(path), *map(str, words), "--record", str(record), "--json"])

    out, err = capsys.readouterr()
    assert code == 0, err
    assert json.loads(out)["ticks"] > 0
    assert json.loads(out)["device_state"] == "run"
    header = json.loads(palpate.read_record(record).header)
    assert header["device"] == "simulated arm held by script"
    assert main(["replay", str(record), "--json"]) == 0
    assert json.loads(capsys.readouterr()[0])["equal"]


def test_a_run_whose_device_cut_its_motors_ends_in_a_report_that_says_so(tmp_path, monkeypatch):
    play = open_play(publish(tmp_path), f"plant:script:{write_press(tmp_path)}", duration=0.3)
    build = Play.build_device

    def build_stopped(self, hand=None):
        arm = build(self, hand)
        arm.press_stop(True)
        return arm

    monkeypatch.setattr(Play, "build_device", build_stopped)

    report = play_headless(play)

    assert report["device_state"].startswith("motors off: stop pressed")
    assert "device       motors off: stop pressed" in describe_play_report(report)
    assert report["outcome"] == "device_fault"
    assert describe_play_report(report).startswith("device fault: motors off: stop pressed")
    assert report["peak_force_N"] == 0.0


def publish_grasper(folder: Path) -> Path:
    """An organ under a grasper whose jaws are those of tools.toml."""
    scene, r = organ_scene(2), 0.0012
    scene.instruments[0].tool = palpate.Tool(
        radius=r,
        friction=0.5,
        capsules=[palpate.Capsule(from_=(0.0, y, 0.0), to=(0.0, y, 0.02)) for y in (r, -r)],
        jaws=palpate.Jaws(),
    )
    path = folder / "grasper.palpate"
    scenario.write(path, scenario.Scenario(scene=palpate.build_scene(scene), title="Grasper"))
    return path


def turn_and_close(tick: int) -> palpate.HapticSample:
    """A hand above the organ turns its stylus by 0.6 rad in 0.3 s, then presses its button."""
    angle = 0.6 * min(tick / 300, 1.0)
    return palpate.HapticSample(
        position=(0.0, 0.0, 0.05),
        orientation=(0.0, 0.0, np.sin(0.5 * angle), np.cos(0.5 * angle)),
        buttons=palpate.ATTACH_BUTTON if tick >= 400 else 0,
    )


def find_turn(quaternions: np.ndarray, other: np.ndarray) -> np.ndarray:
    """[rad] (n,) between quaternions (n, 4) and another."""
    cosine = np.clip(np.abs(np.asarray(quaternions, dtype=float) @ np.asarray(other)), 0.0, 1.0)
    return 2.0 * np.arccos(cosine)


def find_resolution() -> float:
    """[rad] of an orientation: half a count of yaw, forearm and the three of the gimbal."""
    plant = palpate.Plant()
    return plant.count + 1.5 * plant.gimbal_count


def test_the_gimbal_and_the_button_of_the_simulated_arm_reach_the_instrument(tmp_path):
    play = open_play(publish_grasper(tmp_path), "plant")
    scene = play.scenario.scene
    ticks = 600
    hand = palpate.ReplayDevice([turn_and_close(k) for k in range(ticks + 1)])
    arm = play.build_device(hand)
    safe = palpate.SafeDevice(arm, play.find_safety(arm))
    world = palpate.World(scene)
    angles, orientations = [], []

    for k in range(ticks):
        sample = safe.read(k * 1e-3)
        safe.write(palpate.tick(scene, sample, 1e-3, world))
        angles.append(world.instruments[0].tool.jaw_angle)
        orientations.append(np.array(world.instruments[0].tool.orientation))

    wanted = turn_and_close(ticks).orientation
    assert np.abs(np.array(arm.core().state().gimbal)).max() > 0.5
    assert find_turn(orientations, wanted)[350:].max() < find_resolution()
    assert find_turn(orientations, wanted)[0] == pytest.approx(0.6, abs=find_resolution())
    pressed = int(np.argmax(np.array(angles) < angles[0]))
    assert 395 <= pressed < 405
    assert np.diff(angles[pressed : pressed + 50]) == pytest.approx(-0.01)  # 1 rad in 100 ms
    assert angles[0] == pytest.approx(0.52) and angles[-1] == 0.0


def test_a_record_keeps_how_the_gimbal_was_turned_and_replays_to_the_bit(tmp_path):
    record = tmp_path / "turned.prec"
    play = open_play(publish_grasper(tmp_path), "plant", record=record, duration=0.8)
    scene = play.scenario.scene
    arm = play.build_device(palpate.ReplayDevice([turn_and_close(k) for k in range(801)]))

    run_device(scene, arm, play.duration, record, play.path, play.find_safety(arm))

    rows = palpate.read_record(record)
    turned = find_turn(read_column(rows, "hand", "orientation"), np.array([0.0, 0.0, 0.0, 1.0]))
    assert turned[0] < find_resolution()
    assert turned[-1] == pytest.approx(0.6, abs=find_resolution())
    assert abs(turned[-1] - 0.6) > 1e-6  # as counts have it
    assert read_column(rows, "hand", "buttons")[-1] == palpate.ATTACH_BUTTON
    assert palpate.replay(scene, rows).equal


def test_the_mouse_holds_the_simulated_arm_with_the_limits_of_its_motors(tmp_path):
    play = open_play(publish(tmp_path), "plant")
    hand = play.build_hand()

    device = play.build_device(hand)

    assert isinstance(hand, palpate.SurfacePointer)
    assert isinstance(device, palpate.SimulatedArm)
    safety = play.find_safety(device)
    assert 1.0 < safety.force_continuous < safety.force_max < 5.0


@pytest.mark.landing
def test_an_organ_felt_through_the_whole_device_is_the_one_the_ideal_device_feels():
    scene = palpate.scenario.read(GALLBLADDER).scene

    ideal = press_through(scene, "ideal")
    arm = press_through(scene, "plant")

    assert arm.fault is palpate.DeviceFault.none
    held = (ideal.time > ideal.pressed) & (ideal.time < ideal.held)
    asked, felt = arm.asked[held].mean(axis=0), arm.motor[held].mean(axis=0)
    assert np.linalg.norm(asked) > 0.1
    assert np.linalg.norm(felt - asked) < 0.05 * np.linalg.norm(asked) + 0.02
    # the hand gives way by what its own spring yields, so a little less is felt, never more
    strongest = np.linalg.norm(ideal.asked, axis=1).max()
    assert 0.5 * strongest < np.linalg.norm(arm.asked, axis=1).max() < 1.1 * strongest
    free = ideal.time > ideal.end - 0.05
    assert np.linalg.norm(arm.motor[free], axis=1).max() < 0.1


def test_the_tip_has_no_force_25_ms_after_the_host_dies_in_the_middle_of_a_press():
    scene = palpate.scenario.read(GALLBLADDER).scene

    run = press_through(scene, "plant", host_dies_at=1.6)

    dead = run.time > 1.6 + 25e-3
    before = (run.time > 1.5) & (run.time < 1.6)
    assert np.linalg.norm(run.motor[before], axis=1).max() > 0.1
    assert np.linalg.norm(run.motor[dead], axis=1).max() <= 0.1
