# SPDX-License-Identifier: BSD-3-Clause
"""The low-cost device without its metal: its verbs, and an organ felt through it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
import pytest
from device_runs import press_through
from palpate.cli import main
from palpate.device_calibrate import fit_joints, run_calibrate
from palpate.device_link import Link, build_link
from palpate.device_selftest import run_selftest
from palpate.play import open_play, split_device
from palpate.verb import WrongCall
from published import publish, write_press

GALLBLADDER = Path(__file__).resolve().parents[2] / "meshes" / "published" / "gallbladder.palpate"


def call(capsys, *words: object) -> tuple[int, dict, str]:
    code = main([str(word) for word in words])
    out, err = capsys.readouterr()
    return code, json.loads(out) if out.startswith("{") else {}, err


# ---------------------------------------------------------------- the verb


def test_the_simulated_device_is_always_on_the_list(capsys):
    code, report, _ = call(capsys, "device", "list", "--json")

    assert code == 0
    assert report["devices"][-1]["device"] == "plant"
    assert main(["device", "list"]) == 0
    assert "simulated arm" in capsys.readouterr().out


def test_monitoring_tells_where_the_arm_is_and_how_the_link_does(capsys):
    code, report, _ = call(capsys, "device", "monitor", "plant", "--duration", "3s", "--json")

    assert code == 0
    assert report["state"] == "idle"
    assert report["report_rate_Hz"] == pytest.approx(1000.0, rel=0.01)
    assert (report["lost_reports"], report["damaged_frames"]) == (0, 0)
    assert np.linalg.norm(report["tip_m"]) == pytest.approx(0.158, abs=0.01)
    assert len(report["tips"]) == 30
    assert 0.0 < report["round_trip_median_ms"] < 10.0


def test_a_sound_device_passes_its_self_test_and_the_command_says_so(capsys):
    code, report, _ = call(capsys, "device", "selftest", "plant", "--json")

    assert report["ok"], [check for check in report["checks"] if not check["ok"]]
    assert code == 0
    names = [check["name"] for check in report["checks"]]
    assert "silence stops the motors" in names
    assert sum(name.startswith("push") for name in names) == 6


def test_a_self_test_without_motors_leaves_them_off():
    link = build_link("plant")

    report = run_selftest(link, motors=False)

    assert report["ok"]
    assert not link.core.drive().enabled
    assert not any(check["name"].startswith("push") for check in report["checks"])


@pytest.mark.parametrize(
    ("break_it", "name"),
    [
        (lambda core: core.press_stop(True), "motors on"),
        (lambda core: core.cut_sensor(4, True), "motors on"),
    ],
    ids=["emergency stop", "sensor wire off"],
)
def test_a_device_that_is_not_sound_fails_its_self_test_and_is_told_why(break_it, name):
    link = build_link("plant")
    break_it(link.core)

    report = run_selftest(link)

    failed = {check["name"]: check["detail"] for check in report["checks"] if not check["ok"]}
    assert not report["ok"]
    assert name in failed


def test_a_calibration_finds_sensors_that_were_mounted_otherwise():
    link = build_link("plant")
    link.open()
    wrong = link.driver.calibration()
    joints = wrong.joints
    for joint in joints[:3]:
        joint.zero, joint.scale = joint.zero + 40, 0.93 * joint.scale
    wrong.joints = joints
    link.driver.store(wrong)

    report = run_calibrate(link)

    right = palpate.find_calibration(palpate.Plant())
    found = link.driver.calibration()
    for j in range(3):
        for count in (right.joints[j].min, 512, right.joints[j].max):
            counts = [count] * 6
            off = (
                palpate.compute_angles(found, counts)[j] - palpate.compute_angles(right, counts)[j]
            )
            assert abs(np.degrees(off)) < 0.3
    assert report["stored"]
    assert abs(report["joints"][0]["moved_by_degree"]) > 1.0


def test_a_new_device_gets_its_first_calibration_and_is_sound_with_it():
    core = palpate.NativeCore(palpate.Plant(), palpate.NativeCoreOptions(calibrated=False))
    driver = palpate.SerialDevice(core, palpate.Workspace().center)
    link = Link("new", driver, core, core)

    assert run_calibrate(link)["stored"]

    link.driver.clear_fault()
    link.driver.enable(True)
    assert run_selftest(link)["ok"]


def test_a_dry_run_leaves_the_device_as_it_is(capsys):
    code, report, _ = call(capsys, "device", "calibrate", "plant", "--dry-run", "--json")

    assert code == 0
    assert not report["stored"]
    assert [joint["joint"] for joint in report["joints"]] == ["yaw", "elevation", "forearm"]


def test_a_sensor_that_does_not_turn_is_refused_by_its_joint():
    counts = np.array([[100.0, 900.0], [500.0, 503.0], [900.0, 100.0]])
    lower, upper = palpate.Arm().joint_min, palpate.Arm().joint_max

    with pytest.raises(RuntimeError, match="elevation: 3 counts between its stops"):
        fit_joints(palpate.Calibration(), counts, lower, upper)


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (("monitor", "glove"), 2, "expected plant or serial:PATH"),
        (("monitor", "plant", "--duration", "0s"), 2, "expected 0.1 s to a day"),
        (("monitor", "serial:/dev/none"), 1, "No such file"),
        (("selftest", "serial:/dev/null"), 1, "expected a serial port"),
        ((), 2, "required: ACTION"),
    ],
)
def test_what_is_no_device_is_refused_in_a_sentence(capsys, words, code, sentence):
    got = main(["device", *words])
    out, err = capsys.readouterr()

    assert (got, out) == (code, "")
    assert sentence in err


def test_doctor_speaks_of_serial_ports(capsys):
    _, report, _ = call(capsys, "doctor", "--json")

    assert "serial ports" in [check["name"] for check in report["checks"]]


# ---------------------------------------------------------------- play


def test_devices_are_named_by_what_is_held_and_who_moves_it():
    assert split_device("pointer") == ("", "")
    assert split_device("script:a.json") == ("", "script:a.json")
    assert split_device("plant") == ("plant", "")
    assert split_device("plant:script:a:b.json") == ("plant", "script:a:b.json")
    assert split_device("serial:/dev/ttyUSB0") == ("serial:/dev/ttyUSB0", "")
    for wrong in ("glove", "plant:", "plant:pointer", "plants", "script", "serial:", ""):
        with pytest.raises(WrongCall):
            split_device(wrong)


def test_a_scenario_is_played_on_the_simulated_arm_and_its_record_replays(tmp_path, capsys):
    path, script, record = publish(tmp_path), write_press(tmp_path), tmp_path / "arm.prec"
    words = ("--device", f"plant:script:{script}", "--headless", "--duration", "1200ms")

    code, report, err = call(capsys, "play", path, *words, "--record", record, "--json")

    assert code == 0, err
    assert report["ticks"] > 0
    header = json.loads(palpate.read_record(record).header)
    assert header["device"] == "simulated arm held by script"
    code, report, _ = call(capsys, "replay", record, "--json")
    assert code == 0
    assert report["equal"]


def test_the_mouse_holds_the_simulated_arm_with_the_limits_of_its_motors(tmp_path):
    play = open_play(publish(tmp_path), "plant")
    hand = play.build_hand()

    device = play.build_device(hand)

    assert isinstance(hand, palpate.PointerDevice)
    assert isinstance(device, palpate.SimulatedArm)
    safety = play.find_safety(device)
    assert 1.0 < safety.force_continuous < safety.force_max < 5.0


# ---------------------------------------------------------------- the closed loop


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
