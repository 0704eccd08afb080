# SPDX-License-Identifier: BSD-3-Clause
"""A task that is judged, in the trainee's window: who, consent, brief, play, debrief, history."""

from __future__ import annotations

import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.player import TraineeWindow
from palpate.player.trainee_window import Phase
from palpate.records.people import find_person
from palpate.records.queries import list_attempts, show_attempt
from palpate.records.store import Store
from palpate.runs.play import open_play
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtTest import QTest
from short_tasks import MESHES, PATIENCE, Scripted, click, open_task, picture
from trainees import texts


def play_to_the_end(window: TraineeWindow, qtbot) -> None:
    qtbot.waitUntil(lambda: window.phase is Phase.over, timeout=PATIENCE)


@pytest.mark.parametrize("language", ["en", pytest.param("tr", marks=pytest.mark.landing)])
def test_a_walk_through_all_screens_keeps_the_attempt(
    open_window, qtbot, short_task, database, language, checkout
):
    window = open_window(open_task(short_task))
    over = window.over
    assert over.board() is over.who
    click(over.who.languages.buttons[language])
    picture(window, checkout, f"{language}_1_who")

    click(over.who.new)
    assert over.board() is over.consent
    code = window.attendance.admission.person.code
    assert any(code in text for text in texts(window))
    picture(window, checkout, f"{language}_2_consent")
    click(over.consent.agree)
    assert over.board() is over.start
    picture(window, checkout, f"{language}_3_brief")
    click(over.start.start)
    assert len(list_attempts(Store())) == 1  # before its first tick has been drawn
    qtbot.waitUntil(lambda: over.force.wrong_above == 0.2, timeout=PATIENCE)
    qtbot.waitUntil(lambda: over.force.peak > 0.1, timeout=PATIENCE)
    picture(window, checkout, f"{language}_4_play")
    play_to_the_end(window, qtbot)

    assert over.board() is over.debrief
    assert not window.attendance.signals.glow.isVisible() and not over.caption.isVisible()
    picture(window, checkout, f"{language}_5_debrief")
    (row,) = list_attempts(Store())
    assert (row["person"], row["outcome"]) == (code, "done")
    kept = show_attempt(Store(), row["attempt"])
    assert [step["outcome"] for step in kept["steps"]] == ["done", "done"]
    assert (database.parent / "traces" / row["trace"]).stat().st_size == row["trace_bytes"] > 0
    moment = over.debrief.moments[0]
    assert {"en": "beyond", "tr": "aşıldı"}[language] in moment.text()
    assert window.attendance.found[0].duration > 0.0
    click(moment)
    assert over.board() is None
    qtbot.waitUntil(lambda: over.board() is over.debrief, timeout=PATIENCE)

    dwell = window.play.drawn.task.steps[1].duration
    click(over.debrief.another)
    assert window.play.drawn.seed == 1
    assert window.play.drawn.task.steps[1].duration != dwell
    play_to_the_end(window, qtbot)
    assert over.debrief.history.isVisible()
    assert [row["seed"] for row in list_attempts(Store())] == [1, 0]
    assert len(list_attempts(Store())) == 2
    heard = window.attendance.signals.heard
    assert any(window.play.say_limits()[0] in caption for caption in heard)

    click(over.debrief.see_history)
    assert over.board() is over.history
    (trend,) = over.history.trends
    assert trend.isVisible()
    assert [done for _, done in trend.points] == [True, True]
    picture(window, checkout, f"{language}_6_history")
    QTest.keyClick(window, Qt.Key.Key_Return)
    assert over.board() is over.debrief


def test_who_comes_back_needs_a_code_and_two_clicks(open_window, qtbot, short_task, database):
    from palpate.records.people import add_person, give_consent

    who = give_consent(Store(), add_person(Store()), "en")
    window = open_window(open_task(short_task))
    over = window.over
    over.who.field.setText("nobodyxx")
    click(over.who.go)
    assert over.board() is over.who
    assert any("NOBODYXX" in text for text in texts(window))

    over.who.field.setText(who.code.lower())
    click(over.who.go)
    click(over.start.start)

    assert window.phase is Phase.running
    window.close()
    (row,) = list_attempts(Store())
    assert row["person"] == who.code
    assert row["outcome"] in ("interrupted", "left")
    assert row["ended"] is not None


@pytest.mark.landing
def test_practice_keeps_nothing_and_a_guest_can_be_linked_to_nobody(
    open_window, qtbot, short_task, database
):
    window = open_window(open_task(short_task))
    click(window.over.who.practice)
    click(window.over.start.start)
    play_to_the_end(window, qtbot)
    assert not database.exists()
    assert window.over.board() is window.over.debrief
    report = window.report()
    assert (report["record"], report["records"]) == (None, [])
    assert not window.play.record_folder().exists()
    window.close()

    window = open_window(open_task(short_task))
    click(window.over.who.guest)
    click(window.over.consent.agree)
    click(window.over.start.start)
    play_to_the_end(window, qtbot)
    (row,) = list_attempts(Store())
    assert (row["person"], row["outcome"]) == (None, "done")
    assert find_person(Store(), "") is None


def test_the_line_that_it_is_no_medical_device_is_on_every_screen(
    open_window, short_task, database
):
    window = open_window(open_task(short_task))
    for board in window.over.boards:
        window.show_board(board)
        assert window.over.notice.isVisible()
        assert not window.over.notice.geometry().intersects(board.geometry()), board


@pytest.mark.landing
def test_a_card_leads_to_its_window_and_back_with_the_attempt_on_it(
    qtbot, short_task, database, tmp_path, monkeypatch, checkout
):
    from palpate.player.card_pictures import find_picture
    from palpate.player.scenario_cards import ScenariosWindow

    folder = tmp_path / "folder"
    folder.mkdir()
    (folder / "a.palpate").write_bytes(short_task.read_bytes())
    (folder / "broken.palpate").write_bytes(b"nothing of the kind")
    window = ScenariosWindow(folder)
    qtbot.addWidget(window)
    window.show()
    card, broken = window.cards
    assert not broken.play.isEnabled()
    assert "30.0 s" in card.goal.text()
    assert card.reviews.text() == "Reviewed by nobody yet"
    assert window.notice.isVisible()
    qtbot.waitUntil(lambda: not card.picture.pixmap().isNull(), timeout=PATIENCE)
    assert find_picture(card.path).exists()

    assert window.board() is window.who
    assert not card.play.isEnabled()  # before it is known who plays
    click(window.who.new)
    click(window.consent.agree)
    assert window.board() is None
    click(card.play)
    trainee = window.window_of_play
    qtbot.addWidget(trainee)
    assert not window.isVisible()
    assert trainee.over.board() is trainee.over.start
    assert trainee.play.drawn.seed == 0
    trainee.play = Scripted(**vars(trainee.play))
    trainee.attendance.play = trainee.play
    click(trainee.over.start.start)
    play_to_the_end(trainee, qtbot)
    trainee.close()

    assert window.isVisible()
    assert "done" in card.last.text()
    folder = checkout / "build" / "screenshots" / "trainee"
    folder.mkdir(parents=True, exist_ok=True)
    window.grab().save(str(folder / "cards.png"))
    click(card.play)  # who returns: a card, and Start
    qtbot.addWidget(window.window_of_play)
    assert window.window_of_play.over.board() is window.window_of_play.over.start
    assert window.window_of_play.play.drawn.seed == 1  # practice counts up
    click(window.window_of_play.over.start.start)
    assert window.window_of_play.phase is Phase.running
    window.window_of_play.close()


def test_a_ghost_shows_the_task_before_it_is_played_and_keeps_nothing(
    open_window, qtbot, short_task, database, checkout
):
    window = open_window(open_task(short_task))
    over, ghost = window.over, window.attendance.ghost
    click(over.who.guest)
    click(over.consent.agree)
    assert over.board() is over.start
    click(over.start.ghost)
    assert over.board() is None
    qtbot.waitUntil(lambda: ghost.run is not None, timeout=PATIENCE)
    done = palpate.StepStatus.done
    qtbot.waitUntil(
        lambda: window.play.state is not None and window.play.state.steps[0].status is done,
        timeout=PATIENCE,
    )
    assert "simulated hand shows" in over.warning.sentence
    picture(window, checkout, "en_ghost")

    QTest.keyClick(window, Qt.Key.Key_Escape)

    assert over.board() is over.start
    assert (over.warning.sentence, window.play.state) == ("", None)
    assert list_attempts(Store()) == []
    assert window.play.records == []
    click(over.start.ghost)  # computed once: shown at once
    assert ghost.run is not None
    click_start(window)
    assert ghost.run is None
    window.close()


def click_start(window: TraineeWindow) -> None:
    """R, while the ghost is shown."""
    QTest.keyClick(window, Qt.Key.Key_R)
    assert window.phase is Phase.running


def test_a_simulated_hand_gets_ready_beside_the_window(open_window, qtbot, short_task):
    play = open_play(short_task, "script:careful")
    window = open_window(play)

    window.restart()

    assert window.phase is Phase.ready  # nothing was computed in the window's own thread
    assert window.preparation.running
    assert "gets ready" in window.over.warning.sentence
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert not window.preparation.running
    assert window.over.board() is window.over.start
    window.restart()
    qtbot.waitUntil(lambda: window.phase is Phase.running, timeout=PATIENCE)
    assert window.over.warning.sentence == ""
    samples = play.samples
    window.restart()  # not computed again
    assert (window.phase, play.samples) == (Phase.running, samples)
    window.close()


def test_no_ghost_gives_away_what_is_to_be_found(open_window, database, tmp_path):
    path = MESHES / "scenarios" / "simple_tissue.json"
    assessment = read_assessment(path)
    (find,) = [step for step in assessment["steps"] if step["id"] == "touch"]
    assessment["steps"] = [{**find, "do": "find", "force_N": [0.1, "$press"]}]
    del assessment["goals"]
    organ = scenario.read(MESHES / "published" / "simple_tissue.palpate")
    out = tmp_path / "hidden.palpate"
    scenario.write(out, with_assessment(path, assessment, organ))
    window = open_window(open_play(out))
    assert not window.attendance.ghost.is_offered()
    click(window.over.who.practice)
    assert not window.over.start.ghost.isVisible()
    window.close()


def test_no_run_begins_before_it_is_known_who_plays(open_window, short_task, database):
    window = open_window(open_task(short_task))
    over = window.over
    over.who.new.setFocus()
    QTest.keyClick(window, Qt.Key.Key_R)
    assert (window.phase, over.board()) == (Phase.ready, over.who)
    click(over.who.new)
    for key in (Qt.Key.Key_R, Qt.Key.Key_Space):
        window.keyPressEvent(QKeyEvent(QEvent.Type.KeyPress, key, Qt.KeyboardModifier.NoModifier))
    assert (window.phase, over.board()) == (Phase.ready, over.consent)
    assert window.play.records == []
    window.close()


def test_keys_alone_lead_from_who_to_play_and_to_the_menu(open_window, qtbot, short_task, database):
    window = open_window(open_task(short_task))
    over = window.over

    def go_to(button) -> None:
        for _ in range(30):
            if window.focusWidget() is button:
                return
            QTest.keyClick(window.focusWidget() or window, Qt.Key.Key_Tab)
        raise AssertionError(button.text())

    go_to(over.who.new)
    QTest.keyClick(over.who.new, Qt.Key.Key_Return)
    assert over.board() is over.consent
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Return)
    assert over.board() is over.start
    go_to(over.start.check)
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: over.board() is over.check, timeout=PATIENCE)
    assert any("no force" in text for text in texts(window))
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Return)
    assert over.board() is over.start
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Return)
    assert window.phase is Phase.running
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert over.board() is over.menu
    go_to(over.menu.sounds.buttons["on"])  # of a row Tab knows the one that is down
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Right)
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Space)
    assert not window.attendance.signals.audible
    go_to(over.menu.quit)
    QTest.keyClick(window.focusWidget(), Qt.Key.Key_Return)
    assert not window.isVisible()


def test_who_returns_to_the_cards_needs_two_clicks_and_keys_do_as_well(
    qtbot, short_task, database, tmp_path, shown
):
    from palpate.player.scenario_cards import ScenariosWindow
    from palpate.records.people import add_person, give_consent

    who = give_consent(Store(), add_person(Store()), "en")
    folder = tmp_path / "folder"
    folder.mkdir()
    (folder / "a.palpate").write_bytes(short_task.read_bytes())
    window = shown(ScenariosWindow(folder))
    window.identification.take_code(who.code)  # as `palpate play FOLDER --person CODE`
    assert window.board() is None and window.see_history.isVisible()
    window.show_history()
    assert "No attempts" in window.history.note.text()
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert window.board() is None
    (card,) = window.cards
    QTest.keyClick(window, Qt.Key.Key_Return)  # the first card has the keyboard
    trainee = shown(window.window_of_play)
    QTest.keyClick(trainee, Qt.Key.Key_Return)
    assert trainee.phase is Phase.running
    trainee.close()
    (row,) = list_attempts(Store())
    assert row["person"] == who.code
    click(card.play)
    again = shown(window.window_of_play)
    assert again.play.drawn.seed == 1
    again.close()


def test_nobody_is_asked_twice_who_practises_at_the_cards(qtbot, short_task, database, shown):
    from palpate.player.scenario_cards import ScenariosWindow

    window = shown(ScenariosWindow(short_task.parent))
    click(window.who.practice)
    (card,) = window.cards
    for seed in range(2):
        click(card.play)
        trainee = shown(window.window_of_play)
        assert trainee.over.board() is trainee.over.start
        assert trainee.play.drawn.seed == seed
        trainee.close()
    assert not database.exists()
