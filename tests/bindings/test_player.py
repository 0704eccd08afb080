# SPDX-License-Identifier: BSD-3-Clause
"""The trainee's window: real clicks and keys, and what a person sees of it."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.player import TraineeWindow, play_in_window, trainee_window
from palpate.player.force_bar import choose_range
from palpate.player.sentences import format_clock, say_fault, say_notice
from palpate.player.trainee_window import Phase
from palpate.runs.play import open_play
from published import TASK, TITLE, publish, publish_unstable, read_peak, write_press
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from trainees import middle, press_and_wait, texts
from windows import LEFT, grab, move, turn_wheel

KEY = Qt.Key
PLAYER = Path(palpate.__file__).parent / "player"
WAIT_TO_BE_SEEN = """
import threading, time
from palpate.player import start
class Seen(start.Watch):
    def __enter__(self):
        super().__enter__()
        threading.Timer(8.0, print, ["shown"], {"flush": True}).start()
start.Watch = Seen
""".strip()
"""Says so when the window has come to rest and waits for nothing but its user."""


# ---------------------------------------------------------------- the run of things


def test_before_the_start_the_task_and_the_gestures_can_be_read(open_window):
    window = open_window()

    said = texts(window)
    assert window.phase is Phase.ready
    assert window.run is None
    assert {TITLE, TASK, "Start", "Left button", "press"} <= set(said)
    assert window.windowTitle().startswith(TITLE)
    assert not window.play.record_folder().exists()


def test_a_trainee_starts_presses_feels_and_leaves_a_record(open_window, qtbot):
    window = open_window()

    QTest.mouseClick(window.over.start.start, LEFT)
    assert window.phase is Phase.running
    assert not window.over.start.isVisible()
    rest = window.view.scenery.vertices.copy()
    press_and_wait(window, qtbot)
    assert not np.array_equal(window.view.scenery.vertices, rest)
    assert window.over.clock.clock.text() != format_clock(0.0)
    QTest.mouseRelease(window.view, LEFT, Qt.KeyboardModifier.NoModifier, middle(window))
    qtbot.waitUntil(lambda: window.over.force.force == 0.0, timeout=20_000)
    window.close()

    report = window.report()
    record = palpate.read_record(report["record"])
    assert record.complete
    assert report["peak_force_N"] >= window.over.force.peak > 0.0
    assert report["ticks"] == len(record.hand)
    assert palpate.replay(palpate.scenario.read(window.play.path).scene, record).equal


def test_space_pauses_and_goes_on(open_window, qtbot):
    window = open_window()
    QTest.keyClick(window, KEY.Key_Return)  # of the button that has the keyboard
    QTest.keyClick(window, KEY.Key_Space)
    if window.phase is not Phase.running:
        window.restart()
    qtbot.waitUntil(lambda: window.over.clock.time > 0.05, timeout=20_000)

    QTest.keyClick(window, KEY.Key_Space)
    assert window.phase is Phase.paused
    assert "Paused. Space goes on." in texts(window)
    qtbot.wait(60)
    window.follow()
    stopped = window.run.report().ticks
    qtbot.wait(100)
    assert window.run.report().ticks == stopped
    QTest.keyClick(window, KEY.Key_Space)
    assert window.phase is Phase.running
    qtbot.waitUntil(lambda: window.run.report().ticks > stopped, timeout=20_000)
    assert "Paused. Space goes on." not in texts(window)


def test_escape_opens_a_menu_that_pauses_and_closes_it_again(open_window, qtbot):
    window = open_window()
    window.restart()

    QTest.keyClick(window, KEY.Key_Escape)
    assert window.phase is Phase.paused
    assert window.over.menu.isVisible()
    assert {"Resume", "Restart", "Full screen on or off", "Quit", "English", "Türkçe"} <= set(
        texts(window)
    )
    QTest.keyClick(window, KEY.Key_Escape)
    assert window.phase is Phase.running
    assert not window.over.menu.isVisible()
    QTest.keyClick(window, KEY.Key_Escape)
    QTest.mouseClick(window.over.menu.resume, LEFT)
    assert window.phase is Phase.running


def test_r_starts_over_and_keeps_the_record_of_the_first_run(open_window, qtbot):
    window = open_window()
    window.restart()
    press_and_wait(window, qtbot)

    QTest.keyClick(window, KEY.Key_R)

    assert window.phase is Phase.running
    assert window.over.force.peak == 0.0
    assert len(window.play.records) == 2
    assert palpate.read_record(window.play.records[0]).complete
    QTest.keyClick(window, KEY.Key_Escape)
    QTest.mouseClick(window.over.menu.restart, LEFT)
    assert window.phase is Phase.running
    assert len(window.play.records) == 3


def test_the_menu_quits_and_the_last_record_is_whole(open_window, qtbot):
    window = open_window()
    window.restart()
    QTest.keyClick(window, KEY.Key_Escape)
    QTest.mouseClick(window.over.menu.quit, LEFT)

    assert not window.isVisible()
    assert palpate.read_record(window.play.records[-1]).complete


def test_f11_fills_the_screen_and_gives_it_back(open_window):
    window = open_window()
    QTest.keyClick(window, KEY.Key_F11)
    assert window.isFullScreen()
    QTest.keyClick(window, KEY.Key_F11)
    assert not window.isFullScreen()


def test_a_script_runs_to_its_end_and_the_window_says_how_it_went(open_window, qtbot, tmp_path):
    play = open_play(publish(tmp_path), f"script:{write_press(tmp_path)}")
    window = open_window(play)
    window.restart()

    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=30_000)

    said = " ".join(texts(window))
    assert "Finished" in said
    assert f"Record: {play.records[-1]}" in said
    assert window.over.force.force == 0.0
    assert window.over.end.restart.isVisible()
    assert window.run is None
    QTest.keyClick(window, KEY.Key_Space)  # the button has the keyboard
    assert window.phase is Phase.running


# ---------------------------------------------------------------- what must always be seen


@pytest.mark.parametrize("language", ["en", "tr"])
def test_that_it_is_no_medical_device_stands_on_every_screen(
    open_window, qtbot, tmp_path, language
):
    play = open_play(publish(tmp_path), f"script:{write_press(tmp_path)}")
    window = open_window(play)
    window.use_language(language)
    notice = say_notice()

    def is_seen() -> bool:
        panel = window.over.notice
        above = [window.over.start, window.over.menu, window.over.end]
        covered = any(b.isVisible() and b.geometry().intersects(panel.geometry()) for b in above)
        inside = window.view.rect().contains(panel.geometry())
        return notice in texts(window) and inside and not covered

    for size in ((960, 640), (1600, 900), (800, 600)):
        window.resize(*size)
        qtbot.wait(10)
        assert is_seen()
    window.restart()
    assert is_seen()
    window.pause()
    assert is_seen()
    window.open_menu()
    assert is_seen()
    window.resume()
    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=30_000)
    assert is_seen()


def test_a_tissue_that_blows_up_ends_the_run_with_a_sentence(open_window, qtbot, tmp_path):
    path = publish_unstable(tmp_path)
    window = open_window(open_play(path, f"script:{write_press(tmp_path)}", duration=20.0))
    window.restart()

    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=30_000)

    said = " ".join(texts(window))
    assert "The run was ended" in said
    assert "The force was switched off after" in said and "the tissue blew up: " in said
    assert "Press R to start again." in said
    assert palpate.read_record(window.play.records[-1]).complete


def test_every_fault_has_words_of_its_own():
    faults = [k for k in palpate.DeviceFault if k is not palpate.DeviceFault.none]

    assert len({say_fault(kind) for kind in faults}) == len(faults)


def test_missed_ticks_are_told_while_they_are_missed(open_window, monkeypatch):
    window = open_window()
    window.restart()
    window._timer.stop()
    frame = None
    while frame is None:
        frame = window.run.take_frame()

    def show(time: float, missed: int) -> str:
        changes = {"time": time, "missed_ticks": missed}
        fields = {name: getattr(frame, name) for name in frame.__slots__} | changes
        window.shown.show(type(frame)(**fields))
        return window.over.warning.label.text() if window.over.warning.isVisible() else ""

    assert show(0.5, 0) == ""
    assert "120 of the last 1000" in show(1.01, 120)
    assert show(1.5, 300) != ""
    assert "180 of the last 1000" in show(2.01, 300)
    assert show(3.01, 305) == ""


def test_a_folder_without_room_for_a_record_is_said_and_nothing_is_started(open_window, tmp_path):
    play = open_play(publish(tmp_path), record=tmp_path / "none" / "a.prec")
    window = open_window(play)

    QTest.mouseClick(window.over.start.start, LEFT)

    assert window.phase is Phase.ready
    assert any(text.startswith("No record can be written") for text in texts(window))
    assert window.report()["record"] is None


def test_a_defect_becomes_a_sentence(open_window, qtbot):
    window = open_window()
    window.tell_unexpected(ZeroDivisionError("division by zero"))

    assert "Something went wrong that should not: ZeroDivisionError: division by zero" in " ".join(
        texts(window)
    )


# ---------------------------------------------------------------- force and time


def test_the_column_of_force_grows_up_to_the_limit_and_keeps_the_peak(open_window):
    bar = open_window().over.force
    assert bar.limit == 5.0
    assert choose_range(0.0, 5.0) == 0.5
    assert choose_range(0.5, 5.0) == 1.0
    assert choose_range(3.9, 5.0) == 5.0
    assert choose_range(9.0, 5.0) == 5.0

    quiet = grab(bar)
    for _ in range(30):
        bar.show_force(3.0)
    loud = grab(bar)
    assert (np.abs(loud - quiet).sum(axis=-1) > 60).sum() > 500
    bar.show_force(0.0)
    assert bar.peak == 3.0
    assert bar.range == 5.0
    bar.reset()
    assert bar.peak == 0.0


def test_times_are_minutes_seconds_and_tenths_cut_off():
    assert format_clock(0.0) == "0:00.0"
    assert format_clock(59.99) == "0:59.9"
    assert format_clock(61.3) == "1:01.3"
    assert format_clock(3600.0) == "60:00.0"


def test_the_wheel_presses_deeper_into_the_organ(open_window, qtbot):
    window = open_window()
    window.restart()
    move(window.view, middle(window))
    turn_wheel(window.view, middle(window), 10)
    qtbot.waitUntil(lambda: window.over.force.force > 0.0, timeout=20_000)


# ---------------------------------------------------------------- the command


def test_the_command_opens_the_window_and_reports_when_it_is_closed(
    qtbot, tmp_path, user_data, capsys, monkeypatch
):
    path, script = publish(tmp_path), write_press(tmp_path)
    seen = []

    class Watched(TraineeWindow):
        def _end(self, trouble: str) -> None:
            super()._end(trouble)
            seen.append(self.phase)
            QTimer.singleShot(0, self.close)

    monkeypatch.setattr("palpate.player.start.TraineeWindow", Watched)

    code = main(["play", str(path), "--device", f"script:{script}", "--language", "en"])

    assert code == 0
    assert seen == [Phase.over]
    out = capsys.readouterr().out
    record = next((user_data / "palpate" / "records").glob("spleen-*.prec"))
    assert str(record) in out
    assert f"{read_peak(record):.3f} N" in out
    QApplication.sendPostedEvents(None, 52)


def test_a_lost_record_is_an_error_of_the_command(open_window, monkeypatch):
    window = open_window()
    window.restart()
    run = window.run

    def fail():
        type(run).finish(run)
        raise OSError(28, "No space left on device", "a.prec")

    monkeypatch.setattr(run, "finish", fail)
    window.pause()
    window.restart()

    assert any(text.startswith("The record could not be completed") for text in texts(window))
    with pytest.raises(OSError, match="No space left"):
        window.report()
    assert play_in_window.__module__ == "palpate.player.start"
    assert trainee_window.FRAME_MS <= 17


def test_ctrl_c_closes_a_window_in_which_nothing_happens(tmp_path):
    program = "import sys; from palpate.cli.main import run_main; sys.exit(run_main())"
    # a process of its own, as from a shell: whether the test's own parent ignores the signal is
    # inherited otherwise
    with subprocess.Popen(
        [sys.executable, "-c", f"{WAIT_TO_BE_SEEN}\n{program}", "play", publish(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        encoding="utf-8",
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as process:
        try:
            assert process.stdout.readline() == "shown\n"
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=30.0) == 0
        finally:
            process.kill()
