# SPDX-License-Identifier: BSD-3-Clause
"""The low-cost device without its metal: its verbs, and an organ felt through it."""

from __future__ import annotations

import json
import threading
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from device_runs import spoil
from palpate.cli.device import ACTIONS
from palpate.cli.main import main
from palpate.command.sentence import PoorData
from palpate.device.calibrate import run_calibrate
from palpate.device.fit import Pull, fit_joints, fit_motors
from palpate.device.link import Ended, build_link, hold_plant
from palpate.device.poses import HOME, HOME_JOINTS, POSES, average_counts
from palpate.device.selftest import run_selftest

SCHEMAS = Path(palpate.__file__).parent / "schemas"
GALLBLADDER = Path(__file__).resolve().parents[1] / "scenes" / "springs" / "gallbladder.palpate"


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
    assert 0 < sum(report["round_trips"]) <= report["reports"]
    assert report["report_rate_Hz"] > 0.0
    assert (report["lost_reports"], report["damaged_frames"]) == (0, 0)
    assert np.linalg.norm(report["tip_m"]) == pytest.approx(0.158, abs=0.01)
    assert len(report["tips"]) == 30
    assert report["round_trip_median_ms"] > 0.0


def test_a_spring_is_felt_from_the_command_line_and_starts_without_a_force(capsys):
    words = ("--duration", "500ms", "--stiffness", "50N/m")
    code, report, _ = call(capsys, "device", "feel", "plant", *words, "--json")

    assert code == 0
    assert len(report["forces"]) == 5
    assert np.linalg.norm(np.array(report["forces"])[:, 1:4], axis=1).max() < 0.05
    assert main(["device", "feel", "plant", *words]) == 0
    assert "N asked at most" in capsys.readouterr().out


def test_a_fault_is_cleared_from_the_command_line_once_its_cause_is_gone(capsys, monkeypatch):
    code, report, _ = call(capsys, "device", "clear", "plant", "--json")
    assert (code, report["first_fault"]) == (0, None)

    stopped = build_link("plant")
    stopped.arm.press_stop(True)
    monkeypatch.setattr("palpate.cli.device.build_link", lambda name: stopped)
    code, report, _ = call(capsys, "device", "clear", "plant", "--json")
    assert (code, report["first_fault"]) == (1, "stop pressed")


def test_the_report_of_a_self_test_is_written_as_text_or_json(capsys, tmp_path):
    text, data = tmp_path / "report.txt", tmp_path / "report.json"

    assert main(["device", "selftest", "plant", "--no-motors", "--report", str(text)]) == 0
    assert main(["device", "selftest", "plant", "--no-motors", "--report", str(data)]) == 0

    assert "ok      report rate" in text.read_text(encoding="utf-8")
    assert json.loads(data.read_text(encoding="utf-8"))["ok"]
    assert main(["device", "selftest", "plant", "--report", str(tmp_path / "no" / "x.txt")]) == 1


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
    assert not link.arm.core().drive().enabled
    assert not any(check["name"].startswith("push") for check in report["checks"])


@pytest.mark.parametrize(
    ("break_it", "name"),
    [
        (lambda arm: arm.press_stop(True), "motors on"),
        (lambda arm: arm.cut_sensor(4, True), "motors on"),
    ],
    ids=["emergency stop", "sensor wire off"],
)
def test_a_device_that_is_not_sound_fails_its_self_test_and_is_told_why(break_it, name):
    link = build_link("plant")
    break_it(link.arm)

    report = run_selftest(link)

    failed = {check["name"]: check["detail"] for check in report["checks"] if not check["ok"]}
    assert not report["ok"]
    assert name in failed


def test_a_busy_computer_makes_no_device_fail_its_self_test():
    link, told = build_link("plant"), []

    def fall_silent_once(check):
        told.append(str(check.name))
        if told[-1] == "push right +0.4 N":
            link.fall_silent(0.03)

    report = run_selftest(link, tell=fall_silent_once)

    assert report["ok"], [check for check in report["checks"] if not check["ok"]]
    assert len(told) == len(report["checks"])


def test_a_calibration_finds_sensors_that_were_mounted_otherwise():
    link = build_link("plant")
    link.open()
    link.driver.store(spoil(link.driver.calibration()))

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
    for j in range(3, 6):  # held in line with the forearm
        assert abs(found.joints[j].zero - right.joints[j].zero) <= 2
    assert report["stored"]
    assert abs(report["joints"][0]["moved_by_degree"]) > 1.0
    assert all(row["residual_degree"] < 0.3 for row in report["joints"][:3])
    assert max(map(abs, report["home_offset_degree"])) < 0.3


def test_the_force_check_finds_what_the_motors_really_give():
    link = build_link("plant")
    link.open()
    right = np.array(link.driver.calibration().torque_full)
    link.driver.store(spoil(link.driver.calibration()))

    report = run_calibrate(link)

    assert np.array(link.driver.calibration().torque_full) == pytest.approx(right, rel=0.03)
    assert report["torque_factors"] == pytest.approx([1 / 0.8, 1 / 1.3, 1 / 0.9], rel=0.03)


def test_without_a_force_check_the_motors_stay_as_they_were():
    link = build_link("plant")
    link.open()
    before = np.array(link.driver.calibration().torque_full)

    report = run_calibrate(link, forces=False)

    assert report["torque_factors"] is None
    assert np.array(link.driver.calibration().torque_full) == pytest.approx(before)


def test_a_new_device_gets_its_first_calibration_and_is_sound_with_it():
    link = hold_plant(palpate.Plant(), palpate.NativeCoreOptions(calibrated=False))

    assert run_calibrate(link)["stored"]

    assert run_selftest(link)["ok"]


def test_a_link_says_that_its_device_is_gone_and_a_calibration_cannot_be_written():
    link = build_link("plant")
    link.begin()
    link.run(0.1)
    assert not link.is_lost()
    kept = link.driver.calibration()

    link.arm.pull_cable()
    link.run(0.1)

    assert link.is_lost()
    with pytest.raises(palpate.DeviceError, match="the cable is out"):
        link.store(kept)
    link.run(0.1)  # it is kept company all the same
    link.end()


def test_who_waits_for_a_device_is_told_when_its_link_is_interrupted():
    link = build_link("plant")
    link.begin(live=True)
    threading.Timer(0.05, link.interrupt).start()

    with pytest.raises(Ended):
        link.run(60.0)
    kept = link.store(link.driver.calibration())

    assert kept.joints[0].zero == 512
    with pytest.raises(Ended):  # it is not kept company again
        link.run(0.1)
    link.end()


def test_a_dry_run_leaves_the_device_as_it_is(capsys):
    code, report, _ = call(capsys, "device", "calibrate", "plant", "--dry-run", "--json")

    assert code == 0
    assert not report["stored"]
    assert [joint["joint"] for joint in report["joints"][:3]] == ["yaw", "elevation", "forearm"]
    assert report["torque_factors"] is None


# ---------------------------------------------------------------- what cannot be used


def read_poses(**changed: tuple[int, float]) -> dict[str, np.ndarray]:
    """Counts of a faultless arm in every pose, but for pose=(joint, count) by its first word."""
    right = palpate.find_calibration(palpate.Plant())
    counts = {}
    for pose in POSES:
        angles = [*pose.joints(), 0.0, 0.0, 0.0]
        row = [j.zero + angle / j.scale for j, angle in zip(right.joints, angles, strict=True)]
        counts[pose.name] = np.array(row)
    for name, (joint, count) in changed.items():
        counts[name.replace("_", " ")][joint] = count
    return counts


def test_faultless_poses_give_the_calibration_of_the_design():
    right = palpate.find_calibration(palpate.Plant())

    fit = fit_joints(palpate.Calibration(), read_poses())

    assert np.degrees(fit.residual).max() < 1e-6
    for found, expected in zip(fit.calibration.joints[:3], right.joints[:3], strict=True):
        assert found.scale == pytest.approx(expected.scale)
        assert abs(found.zero - expected.zero) <= 1


@pytest.mark.parametrize(
    ("changed", "sentence"),
    [
        ({"elevation_upper": (1, 116.0)}, "elevation: 3 counts between its stops"),
        ({HOME: (0, 20.0)}, "yaw: home does not lie between its stops"),
        ({HOME: (2, 640.0)}, "forearm: home lies .* degrees off the line through its stops"),
    ],
    ids=["a sensor that does not turn", "another joint", "a pose that was not reached"],
)
def test_poses_that_do_not_fit_are_refused_by_their_joint(changed, sentence):
    with pytest.raises(PoorData, match=sentence):
        fit_joints(palpate.Calibration(), read_poses(**changed))


@pytest.mark.parametrize(
    ("row", "sentence"),
    [
        (lambda k: [500 + k, *[500] * 5], "yaw moved by 39 counts"),
        (lambda k: [*[500] * 5, 1020], "gimbal roll reads 1020 of 0 to 1023"),
    ],
    ids=["not still", "wire off"],
)
def test_readings_that_are_no_average_are_refused(row, sentence):
    with pytest.raises(PoorData, match=sentence):
        average_counts([row(k) for k in range(40)], POSES[0])
    with pytest.raises(PoorData, match="Only 3 readings"):
        average_counts([[500] * 6] * 3, POSES[0])


def pull_at_home(true_factors: np.ndarray, joints: np.ndarray = HOME_JOINTS) -> list[Pull]:
    """What a scale says where each motor gives so many times what is believed."""
    before = palpate.find_calibration(palpate.Plant())
    jacobian = np.array(palpate.compute_jacobian(palpate.find_arm(before), joints))
    pulls = []
    for direction in np.eye(3):
        torque = np.array([jacobian.T @ (force * direction) for force in (0.3, 0.9)])
        felt = np.linalg.solve(jacobian.T, (true_factors * torque).T).T @ direction
        pulls.append(Pull(direction, joints, 255.0 * torque / before.torque_full, felt - 0.11))
    return pulls


def test_pulls_tell_each_motor_apart_and_a_weight_does_not_matter():
    before = palpate.find_calibration(palpate.Plant())
    truth = np.array([1.2, 0.8, 0.95])

    found, factors = fit_motors(before, pull_at_home(truth))

    assert factors == pytest.approx(truth)
    assert np.array(found.torque_full) == pytest.approx(truth * before.torque_full)


@pytest.mark.parametrize(
    ("pulls", "sentence"),
    [
        (pull_at_home(np.array([1.0, -1.0, 1.0])), "elevation motor pulls where it should push"),
        (pull_at_home(np.array([3.0, 1.0, 1.0])), "yaw motor gives 3.00 times"),
        ([pull_at_home(np.ones(3))[0]] * 3, "do not tell the motors apart"),
    ],
    ids=["wires swapped", "too strong", "one direction only"],
)
def test_pulls_that_cannot_be_believed_are_refused_by_their_motor(pulls, sentence):
    with pytest.raises(PoorData, match=sentence):
        fit_motors(palpate.find_calibration(palpate.Plant()), pulls)


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (("monitor", "glove"), 2, "expected plant, native or serial:PATH"),
        (("monitor", "plant", "--duration", "0s"), 2, "expected 0.1 to 8388.61 s"),
        (("feel", "plant", "--duration", "8388.7s"), 2, "expected 0.1 to 8388.61 s"),
        (("monitor", "serial:/dev/none"), 1, "No such file"),
        (("selftest", "serial:/dev/null"), 1, "expected a serial port"),
        (("--connect", "glove"), 2, "expected plant, native or serial:PATH"),
        (("feel", "plant", "--stiffness", "900N/m"), 2, "expected 0 to 200 N/m"),
    ],
)
def test_what_is_no_device_is_refused_in_a_sentence(capsys, words, code, sentence):
    got = main(["device", *words])
    out, err = capsys.readouterr()

    assert (got, out) == (code, "")
    assert sentence in err


@pytest.mark.parametrize(
    "words",
    [
        ("list",),
        ("monitor", "plant", "--duration", "300ms"),
        ("clear", "plant"),
        ("feel", "plant", "--duration", "300ms"),
        ("selftest", "plant", "--no-motors"),
        ("calibrate", "plant"),
        ("calibrate", "plant", "--dry-run"),
    ],
    ids=" ".join,
)
def test_what_an_action_prints_as_json_is_what_its_schema_says(capsys, words):
    schema = json.loads((SCHEMAS / "device.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)

    code, report, _ = call(capsys, "device", *words, "--json")

    assert code == 0
    jsonschema.Draft202012Validator(schema).validate(report)
    assert set(schema["$defs"]) == {*ACTIONS, "window"}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.Draft202012Validator(schema).validate({**report, "more": 1})


def test_doctor_speaks_of_serial_ports(capsys):
    _, report, _ = call(capsys, "doctor", "--json")

    assert "serial ports" in [check["name"] for check in report["checks"]]
