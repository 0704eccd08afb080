# SPDX-License-Identifier: BSD-3-Clause
"""The device window: real clicks, a simulated arm with the real firmware, and what is seen."""

from __future__ import annotations

import json
import signal

import numpy as np
import palpate
import pytest
from device_sentences import find_spoken
from device_windows import (
    PATIENCE,
    build_quick,
    build_spoilt,
    click_through,
    connect,
    texts,
    wait_for_mode,
)
from palpate import translation
from palpate.cli.main import main
from palpate.device.calibration import Stage
from palpate.device.link import hold_plant
from palpate.device_window import DeviceWindow
from PySide6.QtCore import QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from windows import LEFT, at, drag, grab, keep_picture, read_pixels

pytestmark = [pytest.mark.window, pytest.mark.landing]
Mode = palpate.DeviceMode


def test_before_a_device_is_connected_the_window_says_what_to_do(open_device):
    window = open_device()

    said = " ".join(texts(window))
    assert "Not connected" in said
    assert "Choose a device above and connect" in said
    assert "Not validated. Not a medical device." in said
    assert not window.monitor.motors.isEnabled()
    assert not window.selftest.start.isEnabled()
    assert window.bar.devices.findData("plant") >= 0
    assert window.bar.devices.findData("native") >= 0


@pytest.mark.landing
def test_joints_tip_rates_and_round_trips_are_those_of_the_device(open_device, qtbot):
    window = open_device()
    link = connect(window, qtbot)
    window.monitor.switch_motors(True)
    wait_for_mode(window, qtbot, Mode.run)

    status = link.status()
    window.monitor.show_status(status, False)
    window.scene.show_pose(status.joints, status.gimbal)

    assert [dial.angle for dial in window.monitor.dials] == pytest.approx(np.degrees(status.joints))
    assert [dial.count for dial in window.monitor.dials] == list(status.counts[:3])
    assert window.scene.tip == pytest.approx(status.tip, abs=1e-9)
    rate = window.monitor.facts.values[0].text()
    assert rate.endswith("Hz")
    assert window.monitor.histogram.counts.sum() > 0
    assert "Motors on" in window.bar.pill.text()


def test_the_mouse_takes_the_stylus_and_a_spring_pulls_it_back(open_device, qtbot):
    window = open_device()
    link = connect(window, qtbot)
    QTest.mouseClick(window.monitor.motors, LEFT)
    wait_for_mode(window, qtbot, Mode.run)
    QTest.mouseClick(window.monitor.spring, LEFT)
    before = np.array(link.status().tip)
    start = at(window.view.world_to_pixel(window.scene.tip))

    drag(window.view, start, at(window.view.world_to_pixel(before + [0.03, 0.0, 0.02])) - start)

    # the spring pulls before the hand has come all the way
    qtbot.waitUntil(lambda: np.linalg.norm(link.status().tip - before) > 0.008, timeout=PATIENCE)
    qtbot.waitUntil(lambda: np.linalg.norm(link.status().force_commanded) > 0.5, timeout=PATIENCE)
    window.follow()
    status = link.status()
    moved = status.tip - before
    assert status.force_commanded @ moved < 0.0
    assert status.force_applied == pytest.approx(status.force_commanded, abs=0.15)
    assert np.abs(window.strip.rows()[:, 1:4]).max() > 0.0
    QTest.mouseClick(window.monitor.motors, LEFT)
    wait_for_mode(window, qtbot, Mode.idle)
    assert not window.monitor.spring.isChecked()


def test_a_fault_is_told_in_words_and_cleared_once_its_cause_is_gone(open_device, qtbot):
    window = open_device()
    connect(window, qtbot)
    window.monitor.switch_motors(True)
    wait_for_mode(window, qtbot, Mode.run)

    QTest.mouseClick(window.monitor.stop, LEFT)
    wait_for_mode(window, qtbot, Mode.faulted)
    assert "Emergency stop pressed. Release the stop button" in window.alarm.label.text()
    assert window.bar.pill.property("tone") == "bad"
    assert not window.monitor.motors.isEnabled()
    QTest.mouseClick(window.monitor.stop, LEFT)
    QTest.mouseClick(window.monitor.clear, LEFT)
    wait_for_mode(window, qtbot, Mode.idle)

    assert window.alarm.isHidden()
    assert window.monitor.motors.isEnabled()


def test_a_cable_that_comes_out_is_told_and_the_window_connects_again(open_device, qtbot):
    window = open_device()
    connect(window, qtbot)

    QTest.mouseClick(window.monitor.cable, LEFT)
    qtbot.waitUntil(lambda: window.link is None, timeout=PATIENCE)

    assert "Plug it in and connect again" in window.alarm.label.text()
    assert window.bar.go.isEnabled()
    connect(window, qtbot)
    assert window.alarm.isHidden()


@pytest.mark.parametrize(
    ("name", "sentence"),
    [("serial:/dev/none", "No such file"), ("/dev/null", "expected a serial port")],
)
def test_what_is_no_device_is_refused_in_a_sentence(open_device, qtbot, name, sentence):
    window = open_device()
    window.bar.devices.setEditText(name)

    QTest.mouseClick(window.bar.go, LEFT)
    qtbot.waitUntil(lambda: bool(window.alarm.label.text()), timeout=PATIENCE)

    assert sentence in window.alarm.label.text()
    assert window.link is None
    assert window.bar.go.isEnabled()


# ---------------------------------------------------------------- calibration


@pytest.mark.landing
def test_a_guided_calibration_finds_angles_and_torques_and_shows_how_far_off_home_it_is(
    open_device, qtbot
):
    window = open_device(build=build_spoilt)
    link = connect(window, qtbot)
    page = window.calibrate
    window.pages.open("calibrate")
    QTest.mouseClick(page.go, LEFT)
    for number in range(1, 8):
        assert f"Pose {number} of 7" in page.explained.text()
        assert window.view.scenery._things["ghost"].visible
        link.run(1.0)
        click_through(window, qtbot)
        assert page._problem == ""
    assert page.run.stage is Stage.angles
    assert np.degrees(page.run.fit.residual).max() < 0.3
    click_through(window, qtbot)
    assert page.run.stage is Stage.forces
    link.run(1.0)
    for _ in range(3):
        for _ in range(3):  # pushed weakly, read, pushed strongly; read
            click_through(window, qtbot)
            assert page._problem == ""
    assert page.run.stage is Stage.motors
    click_through(window, qtbot)
    link.run(1.0)
    click_through(window, qtbot)

    assert page.run.stage is Stage.done
    assert np.degrees(np.abs(page.run.home_offset).max()) < 0.3
    assert "off home at most" in page.headline.text()
    assert link.status().mode is Mode.idle
    assert_calibrated(link.driver.calibration())


def assert_calibrated(found: palpate.Calibration) -> None:
    right = palpate.find_calibration(palpate.Plant())
    assert np.array(found.torque_full) == pytest.approx(np.array(right.torque_full), rel=0.04)
    for j in range(3):
        for count in (right.joints[j].min, 512, right.joints[j].max):
            angles = [palpate.compute_angles(each, [count] * 6)[j] for each in (found, right)]
            assert abs(np.degrees(angles[0] - angles[1])) < 0.3


def test_an_arm_that_moves_while_it_is_read_is_refused_in_a_sentence(open_device, qtbot):
    window = open_device(build=build_spoilt)
    link = connect(window, qtbot)
    page = window.calibrate
    QTest.mouseClick(page.go, LEFT)
    link.run(1.0)
    click_through(window, qtbot)

    click_through(window, qtbot)  # on its way to the first stop

    assert "moved by" in page.problem.text()
    assert "hold it still and try again" in page.problem.text()
    assert len(page.run.guide.counts) == 1
    QTest.mouseClick(page.back, LEFT)
    assert page.run.guide.counts == {}
    QTest.mouseClick(page.leave, LEFT)
    assert page.run.stage is Stage.begin
    assert not window.calibrate.busy


@pytest.mark.parametrize(
    ("memory", "language", "state", "advice"),
    [
        ({"calibrated": False}, "en", "Blank board", "No calibration was ever stored in it"),
        pytest.param(
            {"calibrated": False},
            "tr",
            "Boş kart",
            "İçine hiç kalibrasyon yazılmamış",
            marks=pytest.mark.landing,
        ),
        pytest.param(
            {"damaged": True},
            "en",
            "Calibration damaged",
            "in its EEPROM is damaged",
            marks=pytest.mark.landing,
        ),
        ({"damaged": True}, "tr", "Kalibrasyon bozuk", "en yeni kopyası bozuk"),
    ],
)
def test_a_device_without_a_calibration_opens_on_it_and_says_why_it_has_none(
    open_device, qtbot, memory, language, state, advice
):
    options = palpate.NativeCoreOptions(**memory)
    window = open_device(build=lambda name: hold_plant(palpate.Plant(), options))
    connect(window, qtbot)
    window.use_language(language)

    assert window.pages.seen() is window.calibrate
    qtbot.waitUntil(lambda: state in window.bar.pill.text(), timeout=PATIENCE)
    qtbot.waitUntil(lambda: advice in window.alarm.label.text(), timeout=PATIENCE)
    assert not window.monitor.motors.isEnabled()
    keep_picture(window, f"device_{'_'.join(memory)}_{language}")
    window.use_language("en")


# ---------------------------------------------------------------- self-test


def test_the_self_test_shows_each_check_and_writes_its_report(open_device, qtbot, tmp_path):
    window = open_device(build=build_quick)
    connect(window, qtbot)
    page = window.selftest
    window.pages.open("selftest")

    QTest.mouseClick(page.start, LEFT)
    qtbot.waitUntil(lambda: page.report is not None, timeout=PATIENCE)

    assert page.report["ok"], [check for check in page.report["checks"] if not check["ok"]]
    qtbot.waitUntil(lambda: "silence stops the motors" in texts(window), timeout=PATIENCE)
    assert "It is sound" in texts(window)
    page.write(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["ok"]
    page.write(tmp_path / "no" / "report.txt")
    assert "Could not be saved" in page.explained.text()


def test_a_device_that_is_not_sound_says_so(open_device, qtbot):
    window = open_device(build=build_quick)
    link = connect(window, qtbot)
    link.arm.press_stop(True)

    QTest.mouseClick(window.selftest.start, LEFT)
    qtbot.waitUntil(lambda: window.selftest.report is not None, timeout=PATIENCE)

    assert "do not let it push anyone" in window.selftest.headline.text()


# ---------------------------------------------------------------- closing


@pytest.mark.landing
def test_a_window_that_is_closed_under_force_leaves_the_motors_off(open_device, qtbot):
    window = open_device()
    link = connect(window, qtbot)
    window.monitor.switch_motors(True)
    wait_for_mode(window, qtbot, Mode.run)
    link.push([0.0, 0.0, 0.4])
    qtbot.waitUntil(lambda: link.status().force_applied[2] > 0.2, timeout=PATIENCE)

    window.close()

    assert not link.arm.core().drive().enabled
    assert np.array(link.arm.core().motor_force()) == pytest.approx(np.zeros(3))
    assert window.report() == {"closed": True, "device": "plant"}


def test_a_window_that_is_closed_in_the_middle_of_a_self_test_ends_it(open_device, qtbot):
    window = open_device()
    link = connect(window, qtbot)
    QTest.mouseClick(window.selftest.start, LEFT)
    qtbot.waitUntil(lambda: link.time() > 0.3, timeout=PATIENCE)

    window.close()

    assert window.selftest.job is None
    assert not link.arm.core().drive().enabled


def test_the_command_opens_the_window_and_ctrl_c_closes_it(capsys):
    def close() -> None:
        window = next(w for w in QApplication.topLevelWidgets() if isinstance(w, DeviceWindow))
        if window.link is None:
            QTimer.singleShot(50, close)
        else:
            signal.raise_signal(signal.SIGINT)

    QTimer.singleShot(50, close)
    code = main(["device", "--connect", "plant", "--language", "en", "--json"])

    report = json.loads(capsys.readouterr().out)
    assert code == 0
    assert report == {"action": "window", "closed": True, "device": "plant"}


def test_a_defect_becomes_a_sentence_in_the_window(open_device):
    window = open_device()

    window.tell_unexpected(ZeroDivisionError("of something"))

    assert "ZeroDivisionError: of something" in window.alarm.label.text()


# ---------------------------------------------------------------- words and pictures


def test_every_word_of_the_window_is_translated_and_none_is_left_over():
    words = translation.read_translations("palpate.device_window", "tr")

    assert set(words) == find_spoken()
    for (_, source), said in words.items():
        for mark in ("%1", "%2", "%3", "%4"):
            assert (mark in said) == (mark in source), source


def test_the_window_changes_its_language_while_a_device_is_connected(open_device, qtbot):
    window = open_device()
    connect(window, qtbot)

    assert "in this process" in texts(window)
    window.use_language("tr")
    window.follow()

    said = texts(window)
    assert {"Aygıt", "Bağlantıyı kes", "Motorlar kapalı", "EKLEMLER"} <= set(said)
    assert "," in window.calibrate.scale.text()
    page = window.monitor
    assert page.widget().minimumSizeHint().width() <= page.viewport().width()
    assert "bu süreçte" in texts(window)
    window.use_language("en")
    assert "Disconnect" in texts(window)


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_pictures_of_the_window_are_left_in_the_build_folder(open_device, qtbot, theme):
    window = open_device(build=build_quick, theme=theme)
    keep_picture(window, f"device_idle_{theme}")
    connect(window, qtbot)
    keep_picture(window, f"device_connected_{theme}")
    dark = grab(window)[2, 2].mean() < 100
    assert dark == (theme == "dark")
    drawn = read_pixels(window.view.grab().toImage())
    orange = (drawn[..., 0] > 180) & (drawn[..., 2] < 110) & (drawn[..., 0] - drawn[..., 2] > 110)
    assert orange.sum() > 500


def test_what_came_of_asking_a_port_for_low_latency_is_read_in_turkish(open_device, qtbot, turkish):
    window = open_device()
    link = connect(window, qtbot)

    link.note = "driver set to low latency; latency timer 1 ms"
    window.monitor.say()

    assert window.monitor.note.text() == "sürücü düşük gecikmeye ayarlandı; gecikme sayacı 1 ms"
