# SPDX-License-Identifier: GPL-3.0-or-later
"""The command palette, and that every action can be reached by keys."""

from __future__ import annotations

import pytest
from hands import CONTROL, SHIFT, press
from palpate_editor.views.palette import score
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

pytestmark = [pytest.mark.window, pytest.mark.landing]


def names(palette):
    return [palette.list.item(i).text() for i in range(palette.list.count())]


def open_palette(window):
    press(window, Qt.Key.Key_P, CONTROL | SHIFT)
    return window.palette_dialog


def test_a_few_letters_find_an_action_and_return_runs_it(window):
    palette = open_palette(window)

    QTest.keyClicks(palette.query, "wirefr")
    assert names(palette)[0] == "Wireframe"
    before = window.view.wireframe
    QTest.keyClick(palette.query, Qt.Key.Key_Return)

    assert window.view.wireframe is not before
    assert not palette.isVisible()


def test_arrows_choose_and_escape_leaves(window):
    palette = open_palette(window)
    QTest.keyClicks(palette.query, "material")
    QTest.keyClick(palette.query, Qt.Key.Key_Down)
    assert palette.list.currentRow() == 1

    QTest.keyClick(palette, Qt.Key.Key_Escape)

    assert not palette.isVisible()
    assert palette.chosen is None


def test_what_cannot_be_done_now_stands_last_and_does_nothing(window):
    palette = open_palette(window)

    QTest.keyClicks(palette.query, "fix the lowest")
    QTest.keyClick(palette.query, Qt.Key.Key_Return)

    assert palette.chosen is None
    assert window.session.history.count() == 0


def test_every_action_is_in_the_palette(window):
    palette = open_palette(window)

    found = {
        palette.list.item(i).data(Qt.ItemDataRole.UserRole) for i in range(palette.list.count())
    }
    assert set(window.actions_by_name.actions.values()) <= found


def test_every_action_has_keys_and_no_two_have_the_same(window):
    keys: dict[str, str] = {}
    for _, action in window.actions_by_name.walk():
        if action.parent() is window.actions_by_name.menus["recent"]:
            continue
        assert action.shortcuts(), f"{action.text()} has no keys"
        for sequence in action.shortcuts():
            assert sequence.toString() not in keys, (action.text(), keys[sequence.toString()])
            keys[sequence.toString()] = action.text()


def test_letters_in_a_row_and_beginnings_of_words_count_more():
    assert score("dec", "Decimate") > score("dec", "Side: once")
    assert score("sa", "Save as") > score("sa", "Mesh: again")
    assert score("xyz", "Decimate") is None
    assert score("", "anything") is not None
