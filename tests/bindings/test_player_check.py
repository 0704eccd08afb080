# SPDX-License-Identifier: BSD-3-Clause
"""The check of the device before a task, in the trainee's window."""

from __future__ import annotations

import time

import palpate
import pytest
from palpate.player.trainee_window import Phase
from palpate.records.queries import list_attempts
from palpate.records.store import Store
from palpate.runs.device_check import Stage
from palpate.runs.play import open_play
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from short_tasks import PATIENCE, click, open_task, picture
from tiers import keep_everyday


@pytest.mark.parametrize("language", keep_everyday(["en", "tr"], ("en",)))
def test_a_mouse_is_told_that_it_gives_no_force_after_three_seconds(
    open_window, qtbot, short_task, database, language, checkout
):
    window = open_window(open_task(short_task))
    over = window.over
    click(over.who.languages.buttons[language])
    click(over.who.guest)
    click(over.consent.agree)
    surface = len(window.view.scenery.triangles)
    click(over.start.check)
    assert over.board() is None
    assert len(window.view.scenery.triangles) == 288  # the wall, 12 by 12 squares
    picture(window, checkout, f"{language}_check_running")
    qtbot.waitUntil(lambda: over.board() is over.check, timeout=PATIENCE)

    assert len(window.view.scenery.triangles) == surface
    picture(window, checkout, f"{language}_check")
    assert {"en": "not comparable", "tr": "karşılaştırılamaz"}[
        language
    ] in over.check.summary.text()
    keeper = window.attendance.keeper
    with keeper.store.begin() as connection:
        kept = connection.exec_driver_sql('select "check" from session').scalar_one()
    assert "no force; not comparable" in kept
    click(over.check.go)
    assert over.board() is over.start
    window.close()


@pytest.mark.landing
def test_an_arm_is_checked_before_it_is_played_and_a_failed_check_leaves_practice(
    open_window, qtbot, short_task, database, checkout
):
    play = open_play(short_task, "plant")
    window = open_window(play)
    over, check = window.over, window.attendance.admission.check
    arms, build = [], play.build_device
    play.build_device = lambda hand: arms.append(build(hand)) or arms[-1]
    click(over.who.guest)
    click(over.consent.agree)
    assert check.busy and over.board() is None

    def asks_for_stop() -> bool:
        return check.check is not None and check.check.stage is Stage.stop

    # on a busy machine the emulated cable may fall silent, which ends a check: asked for again
    for _ in range(5):
        qtbot.waitUntil(lambda: not check.busy or asks_for_stop(), timeout=5 * PATIENCE)
        if asks_for_stop():
            break
        assert window.attendance.admission.checked["ended_early"]
        assert "before its check was over" in over.check.summary.text()
        click(over.check.again)
    picture(window, checkout, "en_check_stop")
    arms[-1].press_stop(True)
    qtbot.waitUntil(lambda: check.check is None or check.check.stopped, timeout=PATIENCE)
    arms[-1].press_stop(False)
    qtbot.waitUntil(lambda: over.board() is over.check, timeout=PATIENCE)

    # the mouse did not move: nothing was touched
    report = window.attendance.admission.checked
    failed = {each["name"] for each in report["checks"] if not each["ok"]}
    assert {"targets", "wall"} <= failed
    assert "stop" in {each["name"] for each in report["checks"]} - failed
    assert not over.check.go.isVisible()
    picture(window, checkout, "en_check_failed")
    QTest.keyClick(window, Qt.Key.Key_R)
    assert window.phase is Phase.ready
    click(over.check.practice)
    click(over.start.start)
    assert window.phase is Phase.running
    assert list_attempts(Store()) == []
    window.close()


@pytest.mark.landing
def test_a_check_goes_on_after_motors_that_were_cut_and_came_back_between_two_pictures(
    open_window, qtbot, short_task, database
):
    play = open_play(short_task, "plant")
    window = open_window(play)
    check = window.attendance.admission.check
    arms, build = [], play.build_device
    play.build_device = lambda hand: arms.append(build(hand)) or arms[-1]
    click(window.over.who.guest)
    click(window.over.consent.agree)
    qtbot.waitUntil(lambda: check._frames > 20, timeout=PATIENCE)
    arms[-1].press_stop(True)  # no picture is drawn meanwhile
    since = time.monotonic()
    while check.run.report().fault is not palpate.DeviceFault.motors_cut:
        assert time.monotonic() - since < 1e-3 * PATIENCE
        time.sleep(1e-3)
    arms[-1].press_stop(False)
    time.sleep(0.5)
    qtbot.waitUntil(lambda: check.check is None or check.check.stage is not Stage.still,
                    timeout=PATIENCE)  # fmt: skip
    window.close()
