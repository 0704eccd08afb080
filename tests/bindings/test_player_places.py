# SPDX-License-Identifier: BSD-3-Clause
"""Where things stand in the trainee's window: on small screens, beside the organ, and in reach."""

from __future__ import annotations

import itertools
import json
import re
import subprocess
import sys
from functools import cache

import numpy as np
import palpate
import pytest
from palpate.player import cards
from palpate.player.trainee_window import Phase
from palpate.runs.play import open_play
from published import TITLE, publish
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QUrl
from PySide6.QtTest import QTest
from small_screen import list_environment
from trainees import texts
from windows import LEFT

KEY = Qt.Key
SCREENS = [((1280, 720), 1.0), ((1280, 720), 2.0), ((1920, 1080), 2.0), ((1366, 768), 1.5)]
SAMPLE_OR_ALL = [
    SCREENS[0], SCREENS[1],
    *(pytest.param(*screen, marks=pytest.mark.verify) for screen in SCREENS[2:]),
]  # fmt: skip
LONG = " ".join(["Stroke along the border, count the notches, and stay below 2 N."] * 12)
PLAY_ON_A_SCREEN = """
import json, sys
from palpate.runs.play import open_play
from palpate.player import TraineeWindow
from palpate.viewport.application import open_application
found = {}
for language in sys.argv[2:]:
    app, code = open_application(language)
    window = TraineeWindow(open_play(__import__("pathlib").Path(sys.argv[1])), language=code)
    window.show()
    app.processEvents()
    free = window.screen().availableGeometry()
    said = found[language] = []
    for show in (lambda: None, window.restart, window.open_menu, lambda: window._end("")):
        show()
        app.processEvents()
        over = window.over
        board = over.board()
        notice = over.notice.geometry()
        said.append({
            "size": [window.width(), window.height()],
            "screen": [free.width(), free.height()],
            "notice": over.notice.isVisible() and window.view.rect().contains(notice),
            "covered": board is not None and board.geometry().intersects(notice),
            "board": board is None or window.view.rect().contains(board.geometry()),
            "widest": window.minimumSizeHint().width(),
        })
    window.close()
print(json.dumps(found))
"""
LANGUAGES = ("en", "tr")


@pytest.fixture(scope="module")
def play_on_screen(tmp_path_factory):
    """play_on_screen(size, factor) gives, by language, the windows of one run as they stand on a
    screen of another size; one program opens both."""
    folder = tmp_path_factory.mktemp("screens")
    scenario = publish(folder, task=LONG)

    @cache
    def play(size: tuple[int, int], factor: float) -> dict[str, list]:
        env = list_environment(folder, size, factor)
        words = [sys.executable, "-c", PLAY_ON_A_SCREEN, scenario, *LANGUAGES]
        ran = subprocess.run(words, env=env, capture_output=True, encoding="utf-8")
        assert ran.returncode == 0, ran.stderr
        return json.loads(ran.stdout)

    return play


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("size", "factor"), SAMPLE_OR_ALL)
def test_the_window_fits_its_screen_and_shows_its_warning_on_every_board(
    play_on_screen, size, factor, language
):
    for board in play_on_screen(size, factor)[language]:
        assert board["screen"] == [round(pixels / factor) for pixels in size]
        assert all(np.array(board["size"]) <= board["screen"])
        assert board["widest"] <= board["screen"][0]
        assert board["notice"] and not board["covered"] and board["board"]


def find_organ(window) -> QRectF:
    """The box around all of the organ that is seen, in pixels."""
    view = window.view
    pixels, _ = view.camera.project(view.scenery.vertices, (view.width(), view.height()))
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    return QRectF(QPointF(*low), QPointF(*high))


@pytest.mark.parametrize("task", ["Stroke gently.", LONG])
def test_neither_the_task_nor_anything_else_covers_the_organ(open_window, tmp_path, task):
    window = open_window(open_play(publish(tmp_path, task=task)))
    for size in [(1280, 720), (960, 540), (640, 360), (600, 900)]:
        window.resize(*size)
        window.restart()

        organ, over = find_organ(window), window.over
        assert window.view.rect().toRectF().contains(organ), size
        for panel in (over.task, over.clock, over.force, over.notice):
            covered = panel.geometry().toRectF().intersects(organ)
            assert not covered, (size, panel.objectName())
        assert organ.width() > 0.15 * size[0] or organ.height() > 0.3 * size[1], size


@pytest.mark.parametrize("size", [(1280, 800), (632, 332)])
def test_the_clock_is_never_cut_off(open_window, size):
    window = open_window()
    window.resize(*size)
    window.restart()
    clock = window.over.clock.clock
    window.over.clock.show_time(599.9)
    window.over.place()
    QTest.qWait(1)

    assert clock.width() >= clock.sizeHint().width()


TASKS = [
    "Stroke gently.",
    "Follow the lower edge from the right lobe to the notch of the round ligament.",
    "Safra kesesinin dibine bastırın ve boynuna dek kenarı boyunca ilerleyin.",
]


def test_a_task_that_fits_has_no_scroll_bar_beside_it(open_window, tmp_path):
    window = open_window(open_play(publish(tmp_path)))
    for size in [(1280, 800), (1272, 772), (960, 540), (632, 332)]:
        window.resize(*size)
        window.restart()
        task = window.over.task

        titles = ("Liver", "Safra kesesi: dibini ve boynunu bul")
        for title, words in itertools.product(titles, TASKS):
            task.tell(title, words)
            # a bar that was needed for a moment must not stay
            task.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
            task.resize(task.width(), 40)
            QTest.qWait(1)
            window.over.place()
            QTest.qWait(1)
            if task.height() >= task.find_height(task.width()):
                assert task.verticalScrollBar().maximum() == 0, (size, title, words)
                assert not task.verticalScrollBar().isVisible(), (size, title, words)


def test_a_task_is_folded_up_to_its_title_and_gives_its_room_to_the_organ(open_window, tmp_path):
    window = open_window(open_play(publish(tmp_path, task=LONG)))
    window.resize(1000, 500)
    window.restart()
    before = find_organ(window)

    QTest.keyClick(window, KEY.Key_T)

    assert LONG not in texts(window) and TITLE in texts(window)
    assert "T shows the task" in texts(window)
    assert not window.over.task.geometry().toRectF().intersects(find_organ(window))
    assert find_organ(window).height() >= before.height()
    QTest.mouseClick(window.over.task.viewport(), LEFT)
    assert LONG in texts(window)
    assert not window.over.task.geometry().toRectF().intersects(find_organ(window))


@pytest.mark.parametrize("key", [KEY.Key_Return, KEY.Key_Enter])
def test_enter_takes_what_a_board_offers(open_window, key):
    window = open_window()
    QTest.keyClick(window.over.start.start, key)
    assert window.phase is Phase.running
    QTest.keyClick(window.view, key)
    assert window.phase is Phase.running  # there is nothing to take while it runs
    QTest.keyClick(window, KEY.Key_Escape)
    assert window.phase is Phase.paused
    QTest.keyClick(window.over.menu.resume, key)
    assert window.phase is Phase.running
    window._end("")
    QTest.keyClick(window, key)
    assert window.phase is Phase.running
    assert len(window.play.records) == 2


def test_enter_presses_the_button_that_has_the_keyboard(open_window):
    window = open_window()
    window.activateWindow()
    turkish = window.over.start.languages.buttons["tr"]
    turkish.setFocus()

    QTest.keyClick(turkish, KEY.Key_Return)

    assert window.phase is Phase.ready
    assert "Başla" in texts(window)


def test_the_folder_of_records_is_named_and_opened_from_the_window(
    open_window, user_data, monkeypatch
):
    opened: list[QUrl] = []
    monkeypatch.setattr(cards.QDesktopServices, "openUrl", lambda url: opened.append(url) or True)
    window = open_window()
    folder = user_data / "palpate" / "records"
    assert f"Every run is recorded in {folder}" in texts(window)

    QTest.mouseClick(window.over.start.records.button, LEFT)
    assert opened == [QUrl.fromLocalFile(str(folder))] and folder.is_dir()
    window.restart()
    window._end("")
    assert f"Record: {window.play.records[-1]}" in texts(window)
    QTest.mouseClick(window.over.end.record.button, LEFT)
    assert opened[1] == opened[0]
    assert list(folder.glob("*.prec")) == window.play.records
    assert palpate.read_record(window.play.records[0]).complete


def test_a_system_that_opens_no_folder_says_where_it_is(open_window, user_data, monkeypatch):
    monkeypatch.setattr(cards.QDesktopServices, "openUrl", lambda url: False)
    window = open_window()

    QTest.mouseClick(window.over.start.records.button, LEFT)

    folder = user_data / "palpate" / "records"
    assert f"This system does not open folders. It is {folder}" in texts(window)


def test_a_window_brought_over_from_a_larger_screen_is_brought_back(qtbot):
    from palpate.viewport.screen import keep_on_screen
    from PySide6.QtWidgets import QWidget

    window = QWidget()
    qtbot.addWidget(window)
    window.setGeometry(5000, 4000, 3000, 2000)
    window.show()

    keep_on_screen(window)

    free = window.screen().availableGeometry()
    assert free.contains(window.frameGeometry()), (free, window.frameGeometry())
    assert window.size() != QSize(3000, 2000)


NAME = "a_folder_whose_name_has_no_gap_in_it_at_all/kidney-20261122-234512.prec"


def list_pieces(label) -> list[str]:
    """What a label never divides between two lines."""
    return re.split(r"[\s\N{ZERO WIDTH SPACE}]|(?<=/)", label.text())


@pytest.mark.parametrize("size", [(640, 360), (960, 540)])
def test_no_part_of_a_long_name_in_a_banner_is_cut_off(open_window, size):
    window = open_window()
    window.resize(*size)
    window.restart()

    window.over.alarm.tell(f"No record can be written: /srv/trainee/{NAME}: Permission denied")
    window.over.place()
    QTest.qWait(1)

    banner = window.over.alarm
    room = banner.label.contentsRect().width()
    widths = [banner.label.fontMetrics().horizontalAdvance(p) for p in list_pieces(banner.label)]
    assert max(widths) <= room
    assert banner.label.heightForWidth(room) <= banner.label.contentsRect().height()
    assert banner.label.text().replace("\N{ZERO WIDTH SPACE}", "") == banner.sentence
    assert NAME in banner.sentence


def test_words_of_sentences_are_not_broken():
    for sentence in ("Cihazın motorları kullanılamamaktadır.", "not validated, real-time priority"):
        assert cards.allow_breaks(sentence) == sentence
