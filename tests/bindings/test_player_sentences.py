# SPDX-License-Identifier: BSD-3-Clause
"""What the trainee's window says, in which language, and how it looks."""

from __future__ import annotations

import ast
import tomllib
import xml.etree.ElementTree as ET
from pathlib import Path

import palpate
import pytest
from palpate import translation
from palpate.cli.main import main
from palpate.player import TraineeWindow
from palpate.runs.play import open_play
from published import TITLE, publish
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from trainees import press_and_wait, texts
from windows import LEFT, grab, keep_picture

KEY = Qt.Key
PLAYER = Path(palpate.__file__).parent / "player"


def spoken() -> dict[str, set[str]]:
    """Context -> every text that the sources of player and viewport have translated."""
    found: dict[str, set[str]] = {}
    for path in [*PLAYER.glob("*.py"), *(PLAYER.parent / "viewport").glob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if name != "translate" or len(node.args) < 2:
                continue
            context, text = (ast.literal_eval(argument) for argument in node.args[:2])
            found.setdefault(context, set()).add(text)
    return found


def test_every_word_of_the_player_is_translated_and_none_is_left_over():
    file = ET.parse(PLAYER / "translations" / "palpate_player_tr.ts")
    written = {
        context.findtext("name"): {
            message.findtext("source") for message in context.iter("message")
        }
        for context in file.iter("context")
    }
    words = translation.read_translations("palpate.player", "tr")

    assert written == spoken()
    assert sum(map(len, spoken().values())) > 40
    for (context, source), said in words.items():
        assert source in written[context]
        for mark in ("%1", "%2"):
            assert (mark in said) == (mark in source), source
    assert len(words) == sum(map(len, written.values()))
    same = {source for (_, source), said in words.items() if said == source}
    assert same == set()


def test_the_window_changes_its_language_while_it_runs(open_window, qtbot):
    window = open_window()
    window.restart()
    QTest.keyClick(window, KEY.Key_Escape)
    assert "Paused" in texts(window)

    QTest.mouseClick(window.over.menu.languages.buttons["tr"], LEFT)

    said = texts(window)
    assert {"Duraklatıldı", "Devam et", "Yeniden başlat", "Çık", "Süre"} <= set(said)
    assert "Doğrulanmamıştır. Tıbbi cihaz değildir." in said
    assert "," in window.over.clock.clock.text()
    # what the scenario says is in the scenario's own language
    window.resume()
    assert TITLE in texts(window)
    QTest.keyClick(window, KEY.Key_Escape)
    QTest.mouseClick(window.over.menu.languages.buttons["en"], LEFT)
    assert "Paused" in texts(window)


def test_the_language_of_the_system_is_taken_where_it_is_ours():
    assert translation.find_language(["tr-TR", "en-US"]) == "tr"
    assert translation.find_language(["de-DE", "tr"]) == "tr"
    assert translation.find_language(["de_DE"]) == "en"
    with pytest.raises(KeyError, match="one of en, tr"):
        translation.install(QApplication.instance(), "de")


SHIPPED = Path(__file__).resolve().parents[2] / "meshes"


@pytest.mark.parametrize("name", ["gallbladder", "liver"])
def test_play_in_turkish_shows_the_turkish_title_and_task_of_a_scene_that_ships(
    qapp, shown, monkeypatch, capsys, name
):
    catalogue = tomllib.loads((SHIPPED / "CATALOGUE.toml").read_text(encoding="utf-8"))
    entry = catalogue["organs"][name]
    words = entry["languages"]["tr"]
    seen: list[str] = []

    def play_and_see(*_: object) -> int:
        window = next(top for top in qapp.topLevelWidgets() if isinstance(top, TraineeWindow))
        seen.extend(texts(window))
        window.restart()
        seen.extend(texts(window))
        window.close()
        return 0

    monkeypatch.setattr(QApplication, "exec", play_and_see)
    try:
        code = main(["play", str(SHIPPED / "published" / f"{name}.palpate"), "--language", "tr"])
    finally:
        translation.install(qapp, "en")

    assert code == 0
    assert seen.count(words["title"]) == 2 and seen.count(words["task"]) == 2
    assert entry["title"] not in seen
    assert capsys.readouterr().out.startswith(words["title"])


# ---------------------------------------------------------------- pictures for people


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_pictures_of_every_screen_are_left_in_the_build_folder(open_window, qtbot, tmp_path, theme):
    play = open_play(publish(tmp_path, subdivisions=4))
    window = open_window(play, theme=theme)
    window.resize(1280, 800)
    window.view.grab_picture()
    keep_picture(window, f"player_start_{theme}")
    window.restart()
    press_and_wait(window, qtbot)
    window.pause()
    qtbot.wait(50)
    window.over.show_pause(False)
    window.view.grab_picture()
    keep_picture(window, f"player_press_{theme}")
    dark = grab(window)[4, 4].mean() < 100
    assert dark == (theme == "dark")
    window.over.show_pause(True)
    keep_picture(window, f"player_paused_{theme}")
    window.open_menu()
    window.use_language("tr")
    keep_picture(window, f"player_menu_{theme}_tr")
    window.resume()
    window._end("")
    keep_picture(window, f"player_end_{theme}_tr")
