# SPDX-License-Identifier: BSD-3-Clause
"""The button of a device behind a port takes what a board offers; of consent it takes nothing."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from time import monotonic

import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.device.link import Link, build_link
from palpate.player import TraineeWindow
from palpate.player.device_button import DeviceButton, Press
from palpate.player.trainee_window import Phase
from palpate.records.store import ENVIRONMENT
from palpate.runs.play import open_play
from published import publish
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from trainees import texts
from windows import keep_picture

PATIENCE = 60_000
"""[ms] On a machine that has much else to do."""
MESHES = Path(__file__).resolve().parents[2] / "meshes"


@pytest.fixture
def port() -> Iterator[palpate.PtyDevice]:
    device = palpate.PtyDevice()
    yield device
    device.press_buttons(0)


@pytest.fixture
def press(port, qtbot):
    """press(reached) presses until what it asks is so, as a hand would, and lets go."""

    def press_until(reached) -> None:
        port.press_buttons(1)
        try:
            qtbot.waitUntil(reached, timeout=PATIENCE)
        finally:
            port.press_buttons(0)
            qtbot.wait(100)

    return press_until


def count_open(path: str) -> int:
    """How often this process has the file open."""
    handles = (Path("/proc/self/fd") / name for name in os.listdir("/proc/self/fd"))
    return sum(os.path.realpath(handle) == path for handle in handles)


def wait_until_heard(window: TraineeWindow, qtbot) -> None:
    """Until the arm has been greeted and its button looked at."""
    qtbot.waitUntil(lambda: window.button.hears, timeout=PATIENCE)


def is_cut(window: TraineeWindow) -> bool:
    """Whether the arm has cut its motors, as it does where a machine that has much else to do lets
    it wait for too long: the run rests until that is cleared.
    """
    return window.run.report().fault is palpate.DeviceFault.motors_cut


def clear_cut(window: TraineeWindow, qtbot) -> None:
    """Clears what cut the motors, as the window tells a person to. C is pressed again where it had
    no effect: before the arm has told what cut them there is nothing to clear, and they are cut
    again where the arm is let wait once more.
    """
    pressed = monotonic() - 1.0

    def try_again() -> bool:
        nonlocal pressed
        if is_cut(window) and monotonic() - pressed >= 1.0:
            QTest.keyClick(window, Qt.Key.Key_C)
            pressed = monotonic()
        return not is_cut(window)

    qtbot.waitUntil(try_again, timeout=PATIENCE)


def go_on(window: TraineeWindow, qtbot, press) -> None:
    """Presses the button in the menu until the run goes on."""
    for _ in range(20):
        clear_cut(window, qtbot)
        if window.over.board() is None:
            QTest.keyClick(window, Qt.Key.Key_Escape)
        wait_until_heard(window, qtbot)
        press(lambda: window.over.board() is None)
        if window.phase is Phase.running:
            return
    raise AssertionError(f"{window.phase} after 20 presses")


@pytest.mark.parametrize(
    ("looked_at", "went_down"),
    [((0, 1), 1), ((0, 1, 1, 0, 2), 2), ((1, 1), 0), ((1, 0, 1), 1), ((0, 4), 0), ((0, 0), 0)],
)
def test_a_press_counts_once_and_not_if_it_was_there_before(looked_at, went_down):
    press = Press()
    assert sum(press.take(buttons) for buttons in looked_at) == went_down


def test_a_press_that_was_there_before_the_first_look_is_waited_out():
    press = Press()
    assert not press.ready
    press.take(1)
    assert not press.ready
    press.take(0)
    assert press.ready


def test_only_an_arm_behind_a_port_is_listened_to(qtbot, shown):
    for name in ("", "plant"):
        button = DeviceButton(name, None)
        button.listen()
        assert not button.listening
        button.rest()


@pytest.mark.window
def test_the_button_starts_goes_on_and_starts_again(open_window, qtbot, tmp_path, port, press):
    held = count_open(port.path())
    window = open_window(open_play(publish(tmp_path), f"serial:{port.path()}"))
    assert window.over.board() is window.over.start
    wait_until_heard(window, qtbot)

    press(lambda: window.phase is Phase.running)
    assert not window.button.listening
    qtbot.waitUntil(lambda: window.run.report().ticks > 100 or is_cut(window), timeout=PATIENCE)
    assert count_open(port.path()) == held + 1
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert window.over.board() is window.over.menu
    go_on(window, qtbot, press)
    assert window.over.board() is None

    before = window.play.records[:]
    window._end("")
    assert window.phase is Phase.over
    wait_until_heard(window, qtbot)
    press(lambda: window.phase is Phase.running)
    assert len(window.play.records) == len(before) + 1
    qtbot.waitUntil(lambda: window.run.report().ticks > 100 or is_cut(window), timeout=PATIENCE)
    assert window.run.report().fault is palpate.DeviceFault.none or is_cut(window)
    assert count_open(port.path()) == held + 1
    window.close()
    assert count_open(port.path()) == held


@pytest.mark.window
def test_a_button_agrees_to_nothing(open_window, qtbot, tmp_path, monkeypatch, port, press):
    monkeypatch.setenv(ENVIRONMENT, str(tmp_path / "db" / "records.sqlite"))
    path = MESHES / "scenarios" / "simple_tissue.json"
    organ = scenario.read(MESHES / "published" / "simple_tissue.palpate")
    task = tmp_path / "task.palpate"
    scenario.write(task, with_assessment(path, read_assessment(path), organ))
    window: TraineeWindow = open_window(open_play(task, f"serial:{port.path()}"))
    over = window.over
    wait_until_heard(window, qtbot)

    over.who.guest.setFocus()
    press(lambda: over.board() is over.consent)
    port.press_buttons(1)
    qtbot.wait(300)
    port.press_buttons(0)
    qtbot.wait(100)

    assert over.board() is over.consent
    assert window.attendance.keeper is None
    window.close()


@pytest.mark.window
def test_a_device_that_is_plugged_in_later_is_heard(qtbot, monkeypatch, port):
    asked: list[str] = []

    def find(name: str) -> Link:
        asked.append(name)
        return build_link(name if len(asked) > 1 else "serial:/dev/none")

    monkeypatch.setattr("palpate.player.device_button.build_link", find)
    monkeypatch.setattr("palpate.player.device_button.TRY_EVERY", 0.05)
    button = DeviceButton(f"serial:{port.path()}", None)
    button.listen()
    qtbot.waitUntil(lambda: button.hears, timeout=PATIENCE)
    with qtbot.waitSignal(button.pressed, timeout=PATIENCE):
        port.press_buttons(1)
    assert len(asked) == 2
    button.rest()
    assert not button.hears and not button.listening


@pytest.mark.window
def test_the_start_says_what_a_stylus_does(open_window, tmp_path, port):
    path = publish(tmp_path)
    mouse, arm = (open_window(open_play(path, name))
                  for name in ("pointer", f"serial:{port.path()}"))  # fmt: skip
    said = {"Stylus", "Its button", "here and in the menu: as Enter"}

    assert not said & {*texts(mouse)}
    assert said <= {*texts(arm)} and "Left button" not in texts(arm)
    keep_picture(arm, "player_start_with_device")
    arm.use_language("tr")
    assert "burada ve menüde: Enter gibi" in texts(arm)
    keep_picture(arm, "player_start_with_device_tr")
    for window in (mouse, arm):
        window.close()
