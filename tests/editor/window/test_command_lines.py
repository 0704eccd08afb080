# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in the log can be typed: the command lines do what was done in the window."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hands import action, child, log_of, type_into
from palpate.cli.main import build_parser, load_verbs, main
from palpate_editor.argument_text import read_factors, write_factors
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.edits import (
    EVERY_EDIT,
    FixVertices,
    PaintStiffness,
    RemoveRegion,
    SetName,
    SetRegion,
    SetTask,
    UseImported,
)
from palpate_editor.views.command_lines import FINDERS
from patience import settle

sys.path.append(str(Path(__file__).resolve().parents[1]))
from organs import make_organ, same  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]


def commands(window) -> list[list[str]]:
    lines = [line.split("$ ", 1) for line in log_of(window).splitlines()]
    return [shlex.split(line[1]) for line in lines if len(line) == 2]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_log_typed_again_makes_the_same_organ(qtbot, window, spleen, folder, capsys):
    window.files.open(spleen)
    settle(qtbot, window)
    window.tasks.decimate(600)
    settle(qtbot, window)
    window.show_stage("material")
    action(window, "fix_lowest").trigger()
    window.menu_actions.use_mms()
    type_into(child(window, "model.stretch_coupling"), "-0.01")
    type_into(child(window, "model.drag"), "6,5")
    type_into(child(window, "tool.radius"), "3.5")
    child(window, "gravity").click()
    settle(qtbot, window)

    for words in commands(window):
        assert main(words[1:]) == 0, words
    capsys.readouterr()

    again, organ = read_organ(folder / "VH_F_Spleen.organ"), window.session.organ
    assert np.array_equal(again.surface.vertices, organ.surface.vertices)
    assert np.array_equal(again.fixed, organ.fixed)
    for part in ("material", "model", "fill", "tool", "hand"):
        assert getattr(again, part) == getattr(organ, part)


@pytest.mark.landing
def test_a_part_and_a_unit_that_were_asked_for_stand_in_the_line(qtbot, window, shared_data):
    heart = shared_data("organs/VH_M_Heart.glb")
    window.tasks.import_mesh(heart, ["VH_M_aortic_valve"])
    settle(qtbot, window)
    window.import_panel.set_unit(2)

    call = build_parser(load_verbs()).parse_args(commands(window)[-1][1:])

    assert call.part == ["VH_M_aortic_valve"]
    assert call.unit == "mm"
    assert os.fspath(call.file) == str(heart)


@pytest.mark.landing
def test_a_pasted_material_is_one_line_with_all_its_numbers(qtbot, spleen_window):
    window = spleen_window
    window.menu_actions.use_mms()
    action(window, "copy").trigger()
    window.menu_actions.use_mss()
    action(window, "paste").trigger()

    call = build_parser(load_verbs()).parse_args(commands(window)[-1][1:])

    assert call.kind == "mms"
    assert getattr(call, "material.density") == window.session.organ.material.density


def test_every_edit_has_a_line():
    without = {edit.__name__ for edit in EVERY_EDIT} - {edit.__name__ for edit in FINDERS}

    # one holds another edit, the other's lines are those of `palpate scenario`
    assert without == {"Prepared", "SetAssessment"}


def test_strokes_regions_and_words_typed_again_make_the_same_organ(qtbot, window, folder, capsys):
    organ = make_organ()
    write_organ(folder / "a.organ", organ)
    window.files.open(folder / "a.organ")
    settle(qtbot, window)
    rng = np.random.default_rng(7)
    ids = np.sort(rng.choice(organ.vertex_count, 30, replace=False))
    free = np.flatnonzero(~organ.fixed)[:7]
    for edit in (
        PaintStiffness(ids, rng.uniform(0.1, 9.0, 30)),
        PaintStiffness(np.arange(5), 2.0),
        FixVertices(free),
        FixVertices(free[:2], False),
        SetRegion("lower = pole", np.array([4, 5, 6, 9])),
        SetRegion("gone", np.array([4])),
        RemoveRegion("gone"),
        SetName("dalağım"),
        SetTask("The spleen", 'Press it, and say "when".'),
        SetTask("Dalak", None, "tr"),
        UseImported(),
    ):
        assert window.context.apply(edit)

    lines = [words for words in commands(window) if words[1] != "editor"]
    assert len(lines) == 11
    for words in lines:
        words = [str(folder / "b.organ") if w == str(folder / "a.organ") else w for w in words]
        if not (folder / "b.organ").exists():
            write_organ(folder / "b.organ", organ)
        assert main(words[1:]) == 0, words
    capsys.readouterr()

    typed, clicked = read_organ(folder / "b.organ"), window.session.organ
    # the same steps; where a verb takes lists, values of one number are written as one
    steps = [[line.edit for line in organ.history.lines] for organ in (typed, clicked)]
    assert steps[0] == steps[1]
    assert same(replace(typed, history=None), replace(clicked, history=None))


@pytest.mark.landing
def test_a_stroke_over_a_large_organ_fits_the_arguments_of_a_command():
    ids = np.arange(0, 200_000, 2)
    values = np.linspace(1.0, 2.0, len(ids))

    pieces = list(write_factors(ids, values))

    assert max(map(len, pieces)) < 128 * 1024
    back = [read_factors(piece) for piece in pieces]
    assert np.array_equal(np.concatenate([b[0] for b in back]), ids)
    assert np.array_equal(np.concatenate([b[1] for b in back]), values)


@pytest.mark.parametrize("text", ["", "a", "3-", "9-3", "-1", "1:", ":2", "1:x", "1:nan", "1;2"])
def test_vertices_that_are_none_are_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="expected"):
        read_factors(text)


def test_what_is_undone_stands_in_the_log_behind_the_sign_of_a_remark(qtbot, window):
    window.context.apply(SetName("one"))
    action(window, "undo").trigger()
    action(window, "redo").trigger()

    lines = [line.split("  ", 1)[1] for line in log_of(window).splitlines()]
    assert lines[1:] == ["# undone: Name the organ: one", "# done again: Name the organ: one"]
