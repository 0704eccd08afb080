# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines that edits leave in an organ: what begins them, what is folded, what is none."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from organs import make_organ, same, surface_of
from palpate.files.refusal import Refusal
from palpate_editor import edits
from palpate_editor.document import EMPTY, History, Line, Organ
from palpate_editor.document.files import pack_organ, read_organ, write_organ
from palpate_editor.document.history import MOST_LINES
from palpate_editor.edits import LINES, EditError
from palpate_editor.rebuild import find_difference, read_steps, rebuild
from palpate_editor.shipped import make_organ as make_shipped


def test_an_import_begins_the_history_again_with_the_constants_of_before():
    organ = edits.ImportMesh("dalak", make_organ().source, surface_of(150))(EMPTY)
    organ = edits.SetConstant("material", "young_modulus", 9e3)(edits.DecimateTo(90)(organ))

    again = edits.ImportMesh("liver", make_organ().source, surface_of(120))(organ)

    assert len(again.history.lines) == 1
    begin = again.history.begin
    assert begin.surface is None and begin.imported is None and not begin.regions
    assert begin.material.young_modulus == 9e3
    assert find_difference(rebuild(again, read_steps(again, Path("a")), Path("a")), again) is None


def test_undone_work_is_in_no_history():
    from palpate_editor.app.session import Session

    session = Session(make_organ())
    session.apply(edits.SetName("one"))
    session.apply(edits.SetName("two"))
    session.history.undo()
    session.apply(edits.SetTask("title"))

    lines = session.organ.history.lines
    assert [line.edit for line in lines] == ["SetName", "SetTask"]
    assert lines[0].values == {"name": "one"}


def test_an_edit_that_calls_others_leaves_one_line():
    organ = edits.FixLowest(0.2)(replace(make_organ(), fixed=np.zeros(60, bool)))

    assert [line.edit for line in organ.history.lines] == ["FixLowest"]


def test_a_refused_edit_leaves_no_line():
    organ = edits.SetName("one")(make_organ())

    with pytest.raises(EditError):
        edits.FixLowest(2.0)(organ)

    assert len(organ.history.lines) == 1


def test_more_lines_than_a_file_has_room_for_are_folded_into_the_beginning(tmp_path):
    organ = make_organ()
    for row in range(MOST_LINES + 5):
        organ = edits.SetName(f"{row}")(organ)

    assert (organ.history.folded, len(organ.history.lines)) == (MOST_LINES, 5)
    assert organ.history.begin.name == f"{MOST_LINES - 1}"
    write_organ(tmp_path / "a.organ", organ)
    assert same(read_organ(tmp_path / "a.organ"), organ)
    assert same(rebuild(organ, read_steps(organ, Path("a")), Path("a")), organ)


def test_long_texts_and_long_strokes_are_folded_too():
    organ = make_organ()
    for row in range(12):
        organ = edits.SetTask(task=f"{row}" + "ı" * 9990)(organ)

    assert organ.history.folded > 0 and sum(line.text for line in organ.history.lines) < 500_000


def test_what_is_published_says_nothing_of_how_it_was_made(tmp_path):
    from palpate_editor.open_organ import open_organ
    from palpate_editor.publish import publish

    organ = edits.SetName("kidney stone")(make_shipped("kidney_stone"))
    publish(organ, tmp_path / "a.palpate")

    assert open_organ(tmp_path / "a.palpate").history is None
    assert b"history" not in (tmp_path / "a.palpate").read_bytes()


def test_lines_are_those_of_all_edits_but_what_holds_another():
    assert set(LINES) == {kind.__name__ for kind in edits.EVERY_EDIT} - {"Prepared", "Decimate"}


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"vertices": np.array([1], np.int32), "fixed": 1}, "at.fixed: got 1"),
        ({"vertices": [1, 2], "fixed": True}, "at.vertices: got [1, 2], expected an array"),
        ({"vertices": surface_of(50), "fixed": True}, "at.vertices: got a surface"),
    ],
)
def test_values_of_another_kind_are_refused(values, sentence):
    with pytest.raises(Refusal) as refused:
        edits.read_line(Line("FixVertices", values), LINES, "a.organ", "at")

    assert sentence in str(refused.value)


def test_an_organ_of_an_older_file_begins_as_it_was(tmp_path):
    organ: Organ = read_organ(Path(__file__).parents[1] / "scenes" / "published" / "v1.organ")

    changed = edits.SetName("liver")(organ)

    assert isinstance(changed.history, History)
    assert same(replace(changed.history.begin, history=None), organ)
    assert "history" not in pack_organ(organ)[0]
