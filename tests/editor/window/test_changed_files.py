# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing is overwritten that was not seen: other organs, other editors, other programs."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hands import CONTROL, child, choose_file, click, find_dialogs, press
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import SetName
from palpate_editor.views.file_questions import OVERWRITE, RELOAD, SAVE_AS
from patience import settle
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox
from tiers import keep_everyday
from touch_context import build_organ

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def liver(tmp_path):
    """The working file of another organ than the mesh that comes over it."""
    path = tmp_path / "liver.organ"
    write_organ(path, replace(build_organ(vertices=100), name="liver", title="Liver"))
    return path


@pytest.fixture
def liver_window(qtbot, window, liver):
    window.files.open(liver)
    settle(qtbot, window)
    return window


def answer(window, name: str, button) -> None:
    """Presses a button of the question that is open."""
    box = child(window, name, QMessageBox)
    click(box.button(button))


def questions(window) -> list[str]:
    return [box.objectName() for box in window.findChildren(QMessageBox) if box.isVisible()]


# ---------------------------------------------------------------- importing over a document


@pytest.mark.landing
def test_a_mesh_over_an_open_document_begins_one_without_a_file(qtbot, liver_window, liver, spleen):
    window, before = liver_window, liver.read_bytes()

    window.files.import_name(str(spleen))
    settle(qtbot, window)

    session = window.session
    assert session.organ.source.file == "VH_F_Spleen.glb"
    assert (session.path, session.organ.name) == (None, "VH_F_Spleen")
    assert session.organ.title == "", "the task of the liver is none of the spleen's"
    assert window.windowTitle().startswith("VH_F_Spleen[*]") and window.isWindowModified()
    press(window, Qt.Key.Key_S, CONTROL)
    assert [d.windowTitle() for d in find_dialogs(window)] == ["Save as"]
    assert find_dialogs(window)[0].selectedFiles()[0].endswith("VH_F_Spleen.organ")
    assert liver.read_bytes() == before


@pytest.mark.parametrize(
    "action",
    keep_everyday(["chosen", "dropped", "opened"], ["chosen"]),
)
def test_a_mesh_over_unsaved_changes_asks_first(qtbot, liver_window, spleen, action):
    window = liver_window
    window.context.apply(SetName("liver, changed"))
    changed = window.session.organ
    begin = {
        "dropped": lambda: window.files.drop([spleen]),
        "opened": lambda: window.files.open(spleen),
        "chosen": lambda: window.files.import_name(str(spleen)),
    }[action]

    begin()
    assert questions(window) == ["unsaved"]
    answer(window, "unsaved", QMessageBox.StandardButton.Cancel)
    settle(qtbot, window)
    assert window.session.organ is changed

    begin()
    answer(window, "unsaved", QMessageBox.StandardButton.Discard)
    settle(qtbot, window)
    assert window.session.organ.name == "VH_F_Spleen"


def test_a_mesh_that_cannot_be_imported_leaves_the_open_document(
    qtbot, liver_window, liver, shared_data
):
    window, organ = liver_window, liver_window.session.organ

    window.files.open(shared_data("hostile/assimp_invalid_malformed.obj"))
    settle(qtbot, window)

    assert window.session.organ is organ and window.session.path == liver


@pytest.mark.landing
def test_other_parts_of_the_same_file_stay_in_its_document(qtbot, spleen_window, tmp_path):
    window, path = spleen_window, tmp_path / "mine.organ"
    window.files.write(path)
    parts = window.session.organ.source.parts_available

    window.import_panel.tick_none()
    window.import_panel.parts.tick({parts[0]})
    window.import_panel.import_parts()
    settle(qtbot, window)

    assert window.session.organ.source.parts == parts[:1]
    assert window.session.path == path and not window.session.saved
    window.session.history.undo()
    assert window.session.organ.source.parts == parts


def test_what_was_changed_while_a_mesh_was_read_stays(qtbot, liver_window, spleen):
    window = liver_window

    window.files.open(spleen)
    window.context.apply(SetName("changed meanwhile"))
    settle(qtbot, window)

    assert window.session.organ.name == "changed meanwhile"
    assert "was changed while VH_F_Spleen.glb was read" in window.messages.text


# ---------------------------------------------------------------- a file that has changed


@pytest.fixture
def overtaken(liver_window, liver):
    """An editor with changes of its own on a file that another program has written."""
    liver_window.context.apply(SetName("mine"))
    write_organ(liver, replace(read_organ(liver), name="theirs"))
    return liver_window


def test_saving_over_another_programs_work_is_asked_about(overtaken, liver):
    press(overtaken, Qt.Key.Key_S, CONTROL)

    assert questions(overtaken) == ["changed_file"]
    assert read_organ(liver).name == "theirs"
    answer(overtaken, "changed_file", QMessageBox.StandardButton.Cancel)
    assert read_organ(liver).name == "theirs" and not overtaken.session.saved


def test_it_can_be_overwritten_knowingly_and_is_ours_from_then_on(overtaken, liver):
    overtaken.files.save()
    answer(overtaken, "changed_file", OVERWRITE)
    assert read_organ(liver).name == "mine" and overtaken.session.saved

    overtaken.context.apply(SetName("mine again"))
    overtaken.files.save()

    assert questions(overtaken) == [] and read_organ(liver).name == "mine again"


@pytest.mark.landing
def test_it_can_be_read_again(qtbot, overtaken):
    overtaken.files.save()
    answer(overtaken, "changed_file", RELOAD)
    settle(qtbot, overtaken)

    assert overtaken.session.organ.name == "theirs" and overtaken.session.saved


@pytest.mark.landing
def test_both_can_be_kept(qtbot, overtaken, liver, tmp_path):
    overtaken.files.save()
    answer(overtaken, "changed_file", SAVE_AS)
    choose_file(qtbot, overtaken, tmp_path / "mine.organ")

    assert read_organ(liver).name == "theirs"
    assert read_organ(tmp_path / "mine.organ").name == "mine"
    assert overtaken.session.path == tmp_path / "mine.organ"


@pytest.mark.landing
def test_a_file_that_was_only_touched_or_is_gone_is_saved_without_a_question(liver_window, liver):
    window = liver_window
    liver.touch()
    window.context.apply(SetName("one"))
    window.files.save()
    assert questions(window) == [] and read_organ(liver).name == "one"

    liver.unlink()
    window.context.apply(SetName("two"))
    window.files.save()
    assert questions(window) == [] and read_organ(liver).name == "two"


def test_two_editors_on_one_file_know_of_each_other(qtbot, make_editor, liver):
    first, second = make_editor().window, make_editor().window
    first.files.open(liver)
    settle(qtbot, first)
    assert first.messages.text == ""

    second.files.open(liver)
    settle(qtbot, second)
    assert "liver.organ is open in another editor too" in second.messages.text

    for window, name in ((first, "first"), (second, "second")):
        window.context.apply(SetName(name))
        window.files.save()
    assert questions(first) == [] and questions(second) == ["changed_file"]
    assert read_organ(liver).name == "first"
