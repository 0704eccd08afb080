# SPDX-License-Identifier: BSD-3-Clause
"""What a trainee is told of a device that gives no force while the run goes on."""

from __future__ import annotations

import palpate
import pytest
from palpate import player
from palpate.cli import play as play_verb
from palpate.cli.main import main
from palpate.player import TraineeWindow
from palpate.player.device_watch import PATIENCE, DeviceWatch
from palpate.player.trainee_window import Phase
from palpate.runs.play import open_play
from published import publish
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from trainees import texts
from windows import LEFT, keep_picture

MODE = palpate.DeviceMode
SOON = 20_000
"""[ms]"""


@pytest.fixture
def played(open_window, qtbot, tmp_path):
    """A window whose run is on the simulated arm, and that arm, its motors on."""
    play, arms = open_play(publish(tmp_path), "plant"), []
    build = play.build_device
    play.build_device = lambda hand: arms.append(build(hand)) or arms[-1]
    window = open_window(play)
    window.restart()
    qtbot.waitUntil(lambda: arms[0].driver().status().mode is MODE.run, timeout=SOON)
    return window, arms[0]


def test_a_device_that_cut_its_motors_pauses_says_why_and_a_key_brings_them_back(played, qtbot):
    window, arm = played
    told = window.over.device.label
    assert told.text() == ""

    arm.press_stop(True)
    qtbot.waitUntil(lambda: "Emergency stop pressed" in told.text(), timeout=SOON)
    qtbot.waitUntil(lambda: window.phase is Phase.paused, timeout=SOON)
    stopped = window.run.report().ticks
    assert told.text() in texts(window)
    assert told.text().startswith("Paused: no force from the device.")
    assert told.text().endswith("C clears the fault.")
    assert "Paused. Space goes on." not in texts(window)
    QTest.keyClick(window, Qt.Key.Key_C)
    QTest.keyClick(window, Qt.Key.Key_Space)
    qtbot.wait(100)
    assert "Emergency stop pressed" in told.text()  # for its cause remains
    assert window.phase is Phase.paused
    assert window.run.report().ticks == stopped

    def clear() -> bool:
        QTest.keyClick(window, Qt.Key.Key_C)
        return not told.isVisible()

    arm.press_stop(False)  # heard by the haptic thread, sooner or later
    qtbot.waitUntil(clear, timeout=SOON)
    qtbot.waitUntil(lambda: arm.driver().status().mode is MODE.run, timeout=SOON)
    assert "Paused. Space goes on." in texts(window)
    QTest.keyClick(window, Qt.Key.Key_Space)
    assert window.phase is Phase.running
    qtbot.waitUntil(lambda: window.run.report().ticks > stopped + 100, timeout=SOON)
    assert window.phase is Phase.running
    window.close()

    report = window.report()
    assert report["outcome"] == "done"
    assert report["motors_off_s"] > 0.0


def play_and_close(window: TraineeWindow, monkeypatch, capsys) -> tuple[int, str]:
    """Exit code and words of the program whose window this was."""

    def close(play, language=None, theme="dark"):
        window.close()
        return window.report()

    monkeypatch.setattr(player, "play_in_window", close)
    monkeypatch.setattr(play_verb, "require_display", lambda words: None)
    code = main(["play", str(window.play.path)])
    return code, capsys.readouterr().out


def test_a_run_that_is_ended_while_its_device_gives_no_force_was_a_device_fault(
    played, qtbot, monkeypatch, capsys
):
    window, arm = played
    arm.press_stop(True)
    qtbot.waitUntil(lambda: window.phase is Phase.paused, timeout=SOON)
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert window.phase is Phase.paused

    code, said = play_and_close(window, monkeypatch, capsys)

    assert code == 1
    assert said.startswith("device fault: motors off: stop pressed; release the emergency stop")
    report = window.report()
    assert report["outcome"] == "device_fault"
    record = palpate.read_record(report["record"])
    assert record.complete
    assert record.felt["touched"][-1] & palpate.NOT_RENDERED
    assert palpate.replay(window.scene, record).equal


def test_a_device_that_is_unplugged_is_a_pause_that_ends_as_a_device_fault(
    played, qtbot, monkeypatch, capsys
):
    window, arm = played
    arm.pull_cable()
    qtbot.waitUntil(lambda: window.phase is Phase.paused, timeout=SOON)
    qtbot.waitUntil(lambda: "The device is gone" in window.over.device.label.text(), timeout=SOON)
    keep_picture(window, "player_device_gone")
    QTest.keyClick(window, Qt.Key.Key_Space)
    qtbot.wait(50)
    assert window.phase is Phase.paused

    code, said = play_and_close(window, monkeypatch, capsys)

    assert code == 1
    assert said.startswith("device fault: lost: the cable is out")


def test_a_run_with_a_fault_can_be_started_again_and_the_last_one_counts(played, qtbot):
    window, arm = played
    arm.pull_cable()
    qtbot.waitUntil(lambda: window.phase is Phase.paused, timeout=SOON)

    QTest.keyClick(window, Qt.Key.Key_R)  # another arm, which nobody has unplugged
    assert window.phase is Phase.running
    qtbot.waitUntil(lambda: window.run.report().ticks > 100, timeout=SOON)
    window.close()

    assert window.report()["outcome"] == "done"


def test_the_fault_of_a_device_is_told_in_the_windows_language_and_goes_with_the_run(played, qtbot):
    window, arm = played
    arm.press_stop(True)
    window.use_language("tr")
    qtbot.waitUntil(lambda: "Acil" in window.over.device.label.text(), timeout=SOON)
    keep_picture(window, "player_device_fault")

    QTest.keyClick(window, Qt.Key.Key_Escape)
    QTest.mouseClick(window.over.menu.restart, LEFT)

    # another run has another arm, on which nobody has pressed the stop
    qtbot.waitUntil(lambda: not window.over.device.isVisible(), timeout=SOON)


def test_what_lasts_less_than_a_fifth_of_a_second_is_not_told():
    hand = palpate.ScriptedDevice([palpate.KeyFrame(0.0)])
    arm = palpate.SimulatedArm(hand)
    arm.open()
    watch = DeviceWatch(arm)

    said = [watch.say() for _ in range(PATIENCE)]

    assert said[:-1] == [""] * (PATIENCE - 1)
    assert said[-1] == "Motors off. Its joints are read; nothing can push."


def test_a_mouse_has_no_motors_to_speak_of():
    watch = DeviceWatch(palpate.PointerDevice())

    watch.clear_fault()

    assert [watch.say() for _ in range(2 * PATIENCE)] == [""] * 2 * PATIENCE
