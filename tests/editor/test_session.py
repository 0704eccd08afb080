# SPDX-License-Identifier: GPL-3.0-or-later
"""The session: what changes it, what tells of it, and what counts as saved."""

from __future__ import annotations

import random

import numpy as np
import palpate
import pytest
from organs import make_organ, same
from palpate_editor.app.session import Session
from palpate_editor.document import EMPTY
from palpate_editor.document.files import write_organ
from palpate_editor.edits import (
    EditError,
    FixVertices,
    PaintStiffness,
    SetChoice,
    SetConstant,
    SetName,
    SetRegion,
    SetTask,
)
from palpate_editor.publish import publish
from palpate_editor.scene_files import write_scene


@pytest.fixture
def session(qapp):
    return Session(make_organ())


def test_views_are_told_what_was_and_what_is(session):
    told = []
    session.changed.connect(lambda before, after: told.append((before, after)))
    first = session.organ

    session.apply(SetTask(task="Push"))
    second = session.organ
    session.history.undo()

    assert told == [(first, second), (second, first)]


def test_one_stroke_is_one_step(session):
    painted = session.organ

    session.apply(PaintStiffness(np.arange(40), np.linspace(1.0, 3.0, 40)))

    assert session.history.count() == 1
    session.history.undo()
    assert session.organ is painted


def test_a_refused_edit_is_no_step(session):
    with pytest.raises(EditError):
        session.apply(PaintStiffness(np.array([99]), 2.0))

    assert session.history.count() == 0 and session.saved


def test_what_was_undone_is_forgotten_when_something_else_is_done(session):
    session.apply(SetName("one"))
    session.history.undo()
    session.apply(SetName("two"))

    assert session.organ.name == "two" and not session.history.canRedo()


def test_the_history_names_its_steps(session):
    session.apply(SetName("one"))
    assert session.history.undoText() == "Name the organ: one"

    session.apply(SetChoice("kind", "solid"))
    assert session.history.undoText() == "Model: Solid (MSS+V)"
    session.apply(SetConstant("material", "young_modulus", 4321.0))
    assert session.history.undoText() == "Young's modulus: 4.321 kPa"
    session.apply(PaintStiffness(np.array([0, 1]), np.array([1.5, 3.0])))
    assert session.history.undoText() == "Stiffness of 2 vertices: 1.5 to 3 ×"


def test_undoing_back_to_what_was_saved_is_saved_again(session, tmp_path):
    session.save(tmp_path / "a.organ")
    session.apply(SetName("one"))
    changed = session.saved
    session.history.undo()

    assert (changed, session.saved) == (False, True)


def test_saving_without_a_file_is_refused_until_one_is_named(session, tmp_path):
    with pytest.raises(ValueError, match="no file yet"):
        session.save()

    session.save(tmp_path / "a.organ")
    session.apply(SetName("one"))
    session.save()

    assert session.path == tmp_path / "a.organ" and session.saved
    other = Session()
    other.open(tmp_path / "a.organ")
    assert same(other.organ, session.organ)


def test_a_save_that_fails_leaves_everything_unsaved(session, tmp_path):
    session.apply(SetName("one"))

    with pytest.raises(palpate.FileError):
        session.save(tmp_path / "nowhere" / "a.organ")

    assert session.path is None and not session.saved


def test_what_was_edited_while_a_thread_was_saving_is_unsaved(session, tmp_path):
    session.apply(SetName("one"))
    written = session.organ
    session.apply(SetName("two"))

    session.mark_saved(written, tmp_path / "a.organ")

    assert session.path == tmp_path / "a.organ" and not session.saved


@pytest.mark.parametrize("name", ["a.palpate", "a.scene.json"])
def test_what_is_no_working_file_is_not_saved_over(session, tmp_path, name):
    publish(session.organ, tmp_path / "a.palpate")
    write_scene(tmp_path / "a.scene.json", session.organ, None)

    session.open(tmp_path / name)

    assert session.organ.vertex_count == 60
    assert session.path is None and session.saved
    with pytest.raises(ValueError, match="no file yet"):
        session.save()


def test_opening_forgets_the_history_and_counts_as_saved(session, tmp_path):
    write_organ(tmp_path / "b.organ", make_organ(50))
    session.apply(SetName("one"))

    session.open(tmp_path / "b.organ")

    assert session.organ.vertex_count == 50
    assert session.saved and session.history.count() == 0
    assert session.name == "b.organ"


def test_a_file_that_cannot_be_opened_changes_nothing(session, tmp_path):
    (tmp_path / "bad.organ").write_bytes(b"PK nonsense")
    session.apply(SetName("one"))
    organ = session.organ

    with pytest.raises(palpate.FileError, match=r"bad\.organ"):
        session.open(tmp_path / "bad.organ")

    assert session.organ is organ and session.history.count() == 1 and not session.saved


def test_what_was_restored_is_not_saved_until_it_is(session, tmp_path):
    seen = []
    session.title_changed.connect(lambda: seen.append(session.saved))

    session.restore(make_organ(50), tmp_path / "old.organ")

    assert not session.saved and session.path == tmp_path / "old.organ"
    assert seen and not any(seen)  # nobody was told half way that it was saved
    session.save()
    assert session.saved and (tmp_path / "old.organ").is_file()


def test_the_unsaved_marker_is_told_of(session):
    seen = []
    session.title_changed.connect(lambda: seen.append(session.saved))

    session.apply(SetTask(task="Push"))
    session.history.undo()

    assert seen == [False, True]


def test_a_new_document_is_empty(session, tmp_path):
    session.save(tmp_path / "a.organ")

    session.clear()

    assert session.organ is EMPTY and session.path is None and session.saved


def test_a_test_counts_for_the_organ_that_was_felt_and_for_no_other(session):
    before = session.is_tested
    session.mark_tested()
    felt = session.is_tested
    session.apply(PaintStiffness(np.array([9]), 2.5))
    changed = session.is_tested
    session.history.undo()

    assert (before, felt, changed, session.is_tested) == (False, True, False, True)


def test_words_about_an_organ_that_was_felt_leave_it_felt(session):
    session.mark_tested()

    session.apply(SetTask("Title", "Task"))
    session.apply(SetName("one"))

    assert session.is_tested


def test_any_number_of_edits_is_undone_to_the_very_first_and_redone_to_the_very_last(qapp):
    rng = random.Random(13)
    session = Session(make_organ())
    organs = [session.organ]
    for number in range(60):
        edit = rng.choice(
            [
                PaintStiffness(np.array([rng.randrange(60)]), rng.uniform(0.1, 9.0)),
                SetName(f"organ {number}"),
                SetConstant("model", "stiffness", rng.uniform(1.0, 1e3)),
                FixVertices(np.array([rng.randrange(60)]), rng.random() < 0.5),
                SetRegion(f"region {number % 5}", np.array([rng.randrange(60)])),
            ]
        )
        try:
            session.apply(edit)
        except EditError:  # that vertex was fixed, or free, already
            continue
        organs.append(session.organ)

    for organ in reversed(organs[:-1]):
        session.history.undo()
        assert session.organ is organ
    for organ in organs[1:]:
        session.history.redo()
        assert session.organ is organ
    assert len(organs) > 40 and not session.history.canRedo()


def test_a_file_counts_as_changed_when_it_holds_what_was_neither_read_nor_written(
    session, tmp_path
):
    path = tmp_path / "a.organ"
    assert not session.is_changed_on_disk()
    session.save(path)
    assert not session.is_changed_on_disk()

    write_organ(path, make_organ(50))
    assert session.is_changed_on_disk()
    session.open(path)
    assert not session.is_changed_on_disk()
    path.unlink()
    assert not session.is_changed_on_disk()
