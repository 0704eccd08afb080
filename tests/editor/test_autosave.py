# SPDX-License-Identifier: GPL-3.0-or-later
"""What a crash leaves: every edit, told apart from what a living editor is at work on."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from datetime import datetime
from pathlib import Path

import pytest
from organs import make_organ, same
from palpate_editor.app.autosave import Autosave
from palpate_editor.app.recovery import (
    RecoveryFile,
    find_recoveries,
    find_recovery_folder,
    lock,
)
from palpate_editor.app.session import Session
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import SetName, SetTask

HERE = Path(__file__).parent
PATIENCE = 30_000  # [ms] for a thread or a child to do what it does in a few


@pytest.fixture
def context(qapp, tmp_path):
    """A session with its autosave, in a folder of the test's own."""
    session = Session(make_organ())
    folder = tmp_path / "recovery"
    folder.mkdir()
    autosave = Autosave(session, folder, delay=1)
    yield session, autosave, folder
    autosave.finish()


def keep(context, qtbot, *edits) -> None:
    session, autosave, _ = context
    with qtbot.waitSignal(autosave.saved, timeout=PATIENCE):
        for edit in edits:
            session.apply(edit)


def files_of(folder: Path) -> set[str]:
    return {path.suffix for path in folder.iterdir()}


def kill_an_editor(folder: Path, edits: int, *document: Path) -> None:
    """Lets a process edit until autosave has it all, and kills it without a word of warning."""
    command = [sys.executable, HERE / "edit_and_hang.py", folder, edits, *document]
    left_by_others = find_recoveries(folder)
    with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, encoding="utf-8") as child:
        said = child.stdout.readline()
        while_it_lives = find_recoveries(folder)
        os.kill(child.pid, signal.SIGKILL)
    assert said == "kept\n"
    assert while_it_lives == left_by_others
    assert len(find_recoveries(folder)) == len(left_by_others) + 1


def test_nothing_is_written_while_nothing_is_unsaved(context, qtbot):
    session, autosave, folder = context

    autosave.keep()
    session.apply(SetName("one"))
    session.history.undo()
    qtbot.wait(50)

    assert files_of(folder) == set()


def test_an_unsaved_edit_is_kept_and_told_of(context, qtbot):
    session, autosave, folder = context
    told = []
    autosave.saved.connect(told.append)

    keep(context, qtbot, SetName("one"), SetTask(task="two"))

    [file] = folder.glob("*.organ")
    assert same(read_organ(file), session.organ)
    assert isinstance(told[0], datetime)
    assert files_of(folder) == {".organ", ".json", ".lock"}


def test_an_edit_made_during_a_write_is_kept_too(context, qtbot):
    session, autosave, folder = context
    keep(context, qtbot, SetName("one"))

    session.apply(SetName("two"))
    autosave.keep()  # the thread is at work on this one
    session.apply(SetName("three"))
    qtbot.waitUntil(lambda: autosave.kept is session.organ and not autosave.busy, timeout=PATIENCE)

    [file] = folder.glob("*.organ")
    assert read_organ(file).name == "three"


def test_saving_leaves_nothing_to_recover(context, qtbot, tmp_path):
    session, autosave, folder = context
    keep(context, qtbot, SetName("one"))

    session.save(tmp_path / "a.organ")

    assert files_of(folder) == set()
    keep(context, qtbot, SetName("two"))
    assert files_of(folder) == {".organ", ".json", ".lock"}


def test_saving_during_a_write_leaves_nothing_to_recover(context, qtbot, tmp_path):
    session, autosave, folder = context
    session.apply(SetName("one"))
    autosave.keep()

    session.save(tmp_path / "a.organ")
    qtbot.waitUntil(lambda: not autosave.busy, timeout=PATIENCE)

    assert files_of(folder) == set()


def test_closing_leaves_nothing_to_recover(qapp, qtbot, tmp_path):
    session = Session(make_organ())
    autosave = Autosave(session, tmp_path, delay=1)
    keep((session, autosave, tmp_path), qtbot, SetName("one"))

    autosave.finish()

    assert files_of(tmp_path) == set()


def test_what_a_living_editor_keeps_is_not_offered(context, qtbot):
    keep(context, qtbot, SetName("one"))

    assert find_recoveries(context[2]) == []


def test_a_disk_that_refuses_is_told_of(context, qtbot):
    session, autosave, folder = context
    folder.rmdir()

    with qtbot.waitSignal(autosave.failed, timeout=PATIENCE) as told:
        session.apply(SetName("one"))

    assert "recovery" in told.args[0]
    folder.mkdir()
    keep(context, qtbot, SetName("two"))  # and is tried again


def test_a_killed_editor_leaves_every_edit(context, qtbot, tmp_path):
    session, autosave, folder = context
    kill_an_editor(folder, 12)

    [left] = find_recoveries(folder)
    autosave.restore(left)

    assert session.organ.task == "0 left"
    assert session.organ.stiffness_scale[:12].tolist() == [3.0 + i for i in range(12)]
    assert not session.saved and session.path is None
    assert find_recoveries(folder) == []
    [file] = folder.glob("*.organ")  # a copy of our own, should this editor be killed too
    assert file == autosave.file.path and same(read_organ(file), session.organ)


def test_a_killed_editor_leaves_word_of_its_file(context, tmp_path):
    session, autosave, folder = context
    document = tmp_path / "dalağı.organ"
    write_organ(document, make_organ())
    kill_an_editor(folder, 2, document)

    [left] = find_recoveries(folder)
    autosave.restore(left)

    assert (left.document, left.name) == (document, "dalağı.organ")
    assert session.path == document and not session.saved
    assert read_organ(document).task == "Bas ve bırak."  # what was saved is as it was
    session.save()
    assert read_organ(document).task == "0 left"


@pytest.mark.landing
def test_restoring_over_unsaved_work_keeps_what_was_restored(context, qtbot):
    session, autosave, folder = context
    kill_an_editor(folder, 1)
    keep(context, qtbot, SetName("to be let go"))

    autosave.restore(find_recoveries(folder)[0])

    [file] = folder.glob("*.organ")
    assert read_organ(file).task == "0 left"


@pytest.mark.landing
def test_several_editors_leave_several_files_the_newest_first(context):
    folder = context[2]
    for edits in (1, 2):
        kill_an_editor(folder, edits)
    stamps = [recovery.time for recovery in find_recoveries(folder)]

    assert len(stamps) == 2 and stamps == sorted(stamps, reverse=True)


def test_a_recovery_can_be_thrown_away(context):
    folder = context[2]
    kill_an_editor(folder, 1)

    find_recoveries(folder)[0].remove()

    assert files_of(folder) == set()


def test_a_damaged_recovery_is_offered_and_refused_with_a_sentence(context):
    session, autosave, folder = context
    organ = session.organ
    (folder / "x.organ").write_bytes(b"half a fil")
    (folder / "x.json").write_bytes(b"{")

    [left] = find_recoveries(folder)
    with pytest.raises(OSError, match=r"x\.organ"):
        autosave.restore(left)

    assert (left.document, left.name) == (None, "")
    assert session.organ is organ and session.saved
    assert (folder / "x.organ").exists()


def test_a_lock_that_cannot_be_had_is_refused(qapp, tmp_path):
    one, other = RecoveryFile(tmp_path), RecoveryFile(tmp_path)
    other.held = lock(one.path)
    one.write(make_organ(), None, "")

    with pytest.raises(OSError, match="lock of recovery"):
        other.write(make_organ(), None, "")


def test_the_folder_is_the_users_own(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))

    folder = find_recovery_folder()

    assert folder == tmp_path / "palpate" / "recovery" and folder.is_dir()
    assert folder.stat().st_mode & 0o077 == 0


def test_a_home_that_cannot_be_written_keeps_nobody_from_working(monkeypatch, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "file"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))

    folder = find_recovery_folder()

    assert folder.is_dir() and folder.parent == tmp_path


def test_a_recovery_knows_whether_its_file_was_changed_since(context, tmp_path):
    session, autosave, folder = context
    document = tmp_path / "a.organ"
    write_organ(document, make_organ())
    kill_an_editor(folder, 1, document)
    [left] = find_recoveries(folder)

    autosave.restore(left)

    assert not session.is_changed_on_disk()
    write_organ(document, make_organ(50))
    assert session.is_changed_on_disk()
