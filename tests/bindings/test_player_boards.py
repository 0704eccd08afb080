# SPDX-License-Identifier: BSD-3-Clause
"""Every board of the trainee's window, in each language and at 100 to 200 %: nothing is cut off."""

from __future__ import annotations

from pathlib import Path

import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.player import TraineeWindow
from palpate.player.boards import Board
from palpate.player.debrief import Debriefed
from palpate.player.moments import Moment
from palpate.player.scenario_cards import ScenariosWindow
from palpate.runs.play import open_play
from palpate.viewport.application import use_language
from PySide6.QtWidgets import QApplication, QComboBox, QLabel, QPushButton
from tiers import keep_everyday
from windows import keep_picture

MESHES = Path(__file__).resolve().parents[2] / "meshes"
SIZES = {"100": (1920, 1080), "150": (1280, 720), "200": (960, 540)}
"""[px] of a screen of 1920 x 1080 as a window has it at a scale, in per cent."""
LONG = [
    *("display", "ticks", "link_loss", "round_trip", "noise", "drift", "targets", "wall", "buzz"),
    *("force", "stop"),
]


@pytest.fixture(scope="module")
def task(tmp_path_factory) -> Path:
    path = MESHES / "scenarios" / "simple_tissue.json"
    organ = scenario.read(MESHES / "published" / "simple_tissue.palpate")
    out = tmp_path_factory.mktemp("boards") / "tissue.palpate"
    scenario.write(out, with_assessment(path, read_assessment(path), organ))
    return out


def earlier(number: int, outcome: str = "done") -> dict:
    return {
        "attempt": f"a{number}", "scenario": "simple", "level": "normal", "outcome": outcome,
        "title": {"en": "Simple tissue: touch, hold, pull, push",
                  "tr": "Basit doku: dokunma, tutma, çekme, itme"},
        "device": "mouse", "started": f"2026-11-2{number}T08:15:00.000+00:00", "ticks": 12_000,
        "time_s": 12.0 + number, "errors": 1.0, "peak_force_N": 0.75,
    }  # fmt: skip


def fill(window: TraineeWindow) -> None:
    """With as much as there can be to read."""
    over, play = window.over, window.play
    before = [earlier(number, ["done", "failed", "timed_out"][number % 3]) for number in range(5)]
    limits = play.say_limits()
    over.start.tell_brief(limits, before, False, Path("/records/of/somewhere/records/traces"))
    for button in (over.start.ghost, over.start.check, over.start.history):
        button.show()
    over.consent.tell(window.language, "ABCDEFGH")
    over.who.refuse("A code that nobody has on this computer, " * 2)
    checks = [{"name": name, "value": 0.5, "unit": "-", "bound": 1.0, "ok": False} for name in LONG]
    over.check.tell({"force": True, "checks": checks, "ok": False})
    over.history.tell(before, "dark")
    state = palpate.Progress(play.drawn.task).state
    goals = [{"metric": "time", "value": 31.0, "at_most": 30.0, "met": False},
             {"metric": "errors", "value": 1, "at_most": 0, "met": False}]  # fmt: skip
    moments = [Moment(number, 3.0, 0.4) for number in range(min(2, len(limits)))]
    kept = "/records/of/somewhere/with/a/long/name/records.sqlite"
    over.debrief.tell(Debriefed(state, goals, limits, moments, before, kept))
    over.end.tell(12.0, 0.5, "/records/of/somewhere/records/tissue-20261126-081500.prec", "", state)


def find_cut(board: Board) -> list[str]:
    """Texts of a board that have less room than they need."""
    cut = []
    room = board.viewport().width()
    if board.page.width() > room:
        cut.append(f"the page is {board.page.width()} px wide, of {room}")
    for label in board.findChildren(QLabel):
        if not label.isVisible() or not label.text():
            continue
        if label.wordWrap():
            high = label.height() < label.heightForWidth(label.width())
            wide = label.width() < label.minimumSizeHint().width()
        else:
            high = label.height() < label.sizeHint().height()
            wide = label.width() < label.sizeHint().width()
        if high or wide:
            cut.append(f"label {label.text()!r}: {label.size().toTuple()}")
    for button in board.findChildren(QPushButton):
        if button.isVisible() and button.width() < button.sizeHint().width():
            cut.append(f"button {button.text()!r}: {button.width()} of {button.sizeHint().width()}")
    return cut


@pytest.mark.parametrize("scale", keep_everyday(SIZES, ("200",)))
@pytest.mark.parametrize("language", ["en", "tr"])
def test_no_text_of_any_board_is_cut_off(open_window, task, language, scale):
    window = open_window(open_play(task))
    window.view.setUpdatesEnabled(False)  # the picture is not what is looked at
    window.use_language(language)
    window.resize(*SIZES[scale])
    fill(window)
    cut = {}
    for board in window.over.boards:
        window.show_board(board)
        QApplication.processEvents()
        window.over.place()
        name = f"{language}_{scale}_{type(board).__name__}"
        found = find_cut(board)
        if found:
            cut[type(board).__name__] = found
        assert window.rect().contains(board.geometry()), name
        assert not board.geometry().intersects(window.over.notice.geometry()), name
        task_card = window.over.task
        assert not (task_card.isVisible() and board.geometry().intersects(task_card.geometry()))
        window.view.setUpdatesEnabled(True)
        keep_picture(board, f"board_{name}")
        window.view.setUpdatesEnabled(False)

    assert cut == {}


@pytest.mark.parametrize("language", ["en", "tr"])
def test_the_start_says_what_two_graspers_can_do(open_window, tmp_path, language):
    path = MESHES / "scenarios" / "stomach_two_graspers.json"
    organ = scenario.read(MESHES / "published" / "stomach.palpate")
    out = tmp_path / "stomach.palpate"
    scenario.write(out, with_assessment(path, read_assessment(path), organ))
    window = open_window(open_play(out))
    window.view.setUpdatesEnabled(False)
    window.use_language(language)
    window.resize(*SIZES["200"])
    window.show_board(window.over.start)
    QApplication.processEvents()
    window.over.place()

    words = {label.text() for label in window.over.start.gestures.findChildren(QLabel)}
    en = {"Right button", "close the jaws and pull", "A", "Shift + wheel", "Tab", "instrument 2"}
    tr = {"Sağ düğme", "çeneleri kapat ve çek", "A", "Shift + tekerlek", "2. alet"}
    assert words >= {"en": en, "tr": tr}[language]
    assert find_cut(window.over.start) == []


@pytest.mark.parametrize("size", [(1280, 800), (960, 540), (600, 400)])
@pytest.mark.parametrize("language", ["en", "tr"])
def test_the_line_of_keys_has_as_many_as_there_is_room_for_and_the_menu(
    open_window, task, language, size
):
    window = open_window(open_play(task))
    window.view.setUpdatesEnabled(False)
    window.use_language(language)
    window.resize(*size)
    QApplication.processEvents()
    keys, over = window.over.keys, window.over
    assert keys.isVisible()
    assert "Esc" in keys.label.text()
    assert keys.label.width() >= keys.label.sizeHint().width()
    assert window.rect().contains(keys.geometry())
    assert not keys.geometry().intersects(over.notice.geometry())
    if size == (1280, 800):
        assert "F11" in keys.label.text()


@pytest.mark.parametrize("size", [(1100, 760), (960, 540)])
@pytest.mark.parametrize("language", ["en", "tr"])
def test_no_text_of_a_card_is_cut_off(shown, task, language, size):
    window = ScenariosWindow(task.parent, language=language)
    use_language(language)
    shown(window)
    window.resize(*size)
    window.say()
    window.identification.practising.emit()
    QApplication.processEvents()
    (card,) = window.cards
    cut = [label.text() for label in card.findChildren(QLabel)
           if label.text() and label.height() < label.heightForWidth(label.width())]  # fmt: skip
    cut += [button.text() for button in window.findChildren(QPushButton)
            if button.isVisible() and button.width() < button.sizeHint().width()]  # fmt: skip
    said = window.notice.label
    cut += [said.text()] * (said.width() < said.sizeHint().width())
    cut += [said.text()] * (not window.notice.rect().contains(said.geometry()))
    cut += [box.currentText() for box in card.findChildren(QComboBox)
            if box.isVisible() and box.width() < box.sizeHint().width()]  # fmt: skip
    keep_picture(window, f"cards_{language}_{size[0]}")
    window.close()
    assert cut == []


@pytest.mark.parametrize("scale", keep_everyday(SIZES, ("200",)))
def test_every_button_of_every_board_is_reached_by_keys(open_window, task, scale):
    """By Tab; of a row of which one is down by Tab to that one."""
    window = open_window(open_play(task))
    window.view.setUpdatesEnabled(False)
    window.resize(*SIZES[scale])
    fill(window)
    for board in window.over.boards:
        window.show_board(board)
        QApplication.processEvents()
        wanted = {
            button
            for button in board.findChildren(QPushButton)
            if button.isVisible() and button.isEnabled()
            and not (button.isCheckable() and not button.isChecked())
        }  # fmt: skip
        seen = set()
        for _ in range(3 * len(wanted) + 5):
            seen.add(window.focusWidget())
            window.focusNextChild()
        missed = [button.text() for button in wanted - seen]
        assert missed == [], type(board).__name__
        unnamed = [b for b in wanted if not (b.text() or b.accessibleName())]
        assert unnamed == []
