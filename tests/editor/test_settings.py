# SPDX-License-Identifier: GPL-3.0-or-later
"""What the editor remembers between two starts, in a file of the test's own."""

from __future__ import annotations

from pathlib import Path

import pytest
from palpate_editor.app.settings import RECENT, Settings
from PySide6.QtCore import QByteArray, QSettings, QSize


@pytest.fixture
def open_settings(tmp_path):
    """Opens the same file again, as another start of the editor does."""
    return lambda: Settings(QSettings(str(tmp_path / "editor.ini"), QSettings.Format.IniFormat))


def test_a_first_start_has_sensible_answers(open_settings):
    settings = open_settings()

    assert settings.recent_files() == []
    assert (settings.theme, settings.language, settings.layout) == ("system", None, None)
    assert settings.last_folder is None


def test_recent_files_are_told_apart_from_those_that_are_gone(open_settings, tmp_path):
    there = tmp_path / "dalağı.organ"
    there.write_bytes(b"")
    open_settings().add_recent(there)
    open_settings().add_recent(tmp_path / "gone.organ")

    found = open_settings().recent_files()

    assert [(file.path.name, file.exists) for file in found] == [
        ("gone.organ", False),
        ("dalağı.organ", True),
    ]


def test_ten_recent_files_are_kept_each_once_the_newest_first(open_settings, tmp_path):
    for number in [*range(12), 5]:
        open_settings().add_recent(tmp_path / f"{number}.organ")

    names = [file.path.stem for file in open_settings().recent_files()]

    assert names == ["5", "11", "10", "9", "8", "7", "6", "4", "3", "2"]
    assert len(names) == RECENT


def test_a_relative_name_is_remembered_as_a_whole_one(open_settings):
    open_settings().add_recent(Path("a.organ"))

    assert open_settings().recent_files()[0].path == Path("a.organ").absolute()


def test_recent_files_can_be_forgotten(open_settings, tmp_path):
    for name in ("a", "b"):
        open_settings().add_recent(tmp_path / name)

    open_settings().forget_recent(tmp_path / "a")
    left = [file.path.name for file in open_settings().recent_files()]
    open_settings().clear_recent()

    assert left == ["b"]
    assert open_settings().recent_files() == []


def test_theme_and_language_are_kept(open_settings):
    settings = open_settings()
    settings.theme, settings.language = "light", "tr"

    assert (open_settings().theme, open_settings().language) == ("light", "tr")
    settings.language = None
    assert open_settings().language is None


def test_a_theme_there_is_not_is_refused_and_one_in_the_file_is_passed_over(open_settings):
    with pytest.raises(ValueError, match="expected one of system, dark, light"):
        open_settings().theme = "pink"

    open_settings().store.setValue("theme", "pink")
    assert open_settings().theme == "system"


def test_the_layout_comes_back_whole_or_not_at_all(open_settings):
    open_settings().layout = (QByteArray(b"\0geometry"), QByteArray(b"docks\xff"))

    geometry, docks = open_settings().layout
    settings = open_settings()
    settings.store.setValue("window/version", 99)
    of_another_version = open_settings().layout

    assert (bytes(geometry), bytes(docks)) == (b"\0geometry", b"docks\xff")
    assert of_another_version is None
    settings.layout = None
    assert open_settings().layout is None


def test_a_view_keeps_its_choice_among_those_there_are(open_settings):
    open_settings().set_choice("navigation", "blender")

    assert open_settings().choice("navigation", ("slicer", "blender")) == "blender"
    assert open_settings().choice("navigation", ("slicer", "cad")) == "slicer"


def test_the_last_folder_is_offered_while_it_is_there(open_settings, tmp_path):
    folder = tmp_path / "organs"
    folder.mkdir()
    open_settings().last_folder = folder

    assert open_settings().last_folder == folder
    folder.rmdir()
    assert open_settings().last_folder is None


def test_the_sizes_of_docks_come_back_and_what_is_no_size_is_left_out(open_settings):
    settings = open_settings()
    settings.layout = (QByteArray(b"geometry"), QByteArray(b"docks"))
    settings.dock_sizes = {"force": QSize(380, 226), "log": QSize(440, 226)}
    settings.store.setValue("window/sizes/log", "wide")
    settings.store.sync()

    assert open_settings().dock_sizes == {"force": QSize(380, 226)}

    settings.layout = None
    assert open_settings().dock_sizes == {}
