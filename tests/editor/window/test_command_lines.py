# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in the log can be typed: the command lines do what was done in the window."""

from __future__ import annotations

import os
import shlex

import numpy as np
import pytest
from hands import action, child, log_of, type_into
from palpate.cli import build_parser, load_verbs, main
from palpate_editor.document.files import read_organ
from palpate_editor.edits import EVERY_EDIT
from palpate_editor.views.command_lines import FINDERS
from patience import settle

pytestmark = pytest.mark.window

BY_HAND = {"FixVertices", "PaintStiffness", "SetRegion", "RemoveRegion"}
BY_HAND |= {"SetName", "SetTask", "UseImported"}
"""Edits without a verb: strokes of a brush, and words."""


def commands(window) -> list[list[str]]:
    lines = [line.split("$ ", 1) for line in log_of(window).splitlines()]
    return [shlex.split(line[1]) for line in lines if len(line) == 2]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_log_typed_anew_makes_the_same_organ(qtbot, window, spleen, folder, capsys):
    window.files.open(spleen)
    settle(qtbot, window)
    window.desk.tasks.decimate(600)
    settle(qtbot, window)
    window.show_stage("material")
    action(window, "fix_lowest").trigger()
    window.deeds.use_mms()
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


def test_a_part_and_a_unit_that_were_asked_for_stand_in_the_line(qtbot, window, shared_data):
    heart = shared_data("organs/VH_M_Heart.glb")
    window.desk.tasks.import_mesh(heart, ["VH_M_aortic_valve"])
    settle(qtbot, window)
    window.import_panel.set_unit(2)

    call = build_parser(load_verbs()).parse_args(commands(window)[-1][1:])

    assert call.part == ["VH_M_aortic_valve"]
    assert call.unit == "mm"
    assert os.fspath(call.file) == str(heart)


def test_a_pasted_material_is_one_line_with_all_its_numbers(qtbot, spleen_window):
    window = spleen_window
    window.deeds.use_mms()
    action(window, "copy").trigger()
    window.deeds.use_mss()
    action(window, "paste").trigger()

    call = build_parser(load_verbs()).parse_args(commands(window)[-1][1:])

    assert call.kind == "mms"
    assert getattr(call, "material.density") == window.session.organ.material.density


def test_every_edit_has_a_line_or_can_only_be_done_by_hand():
    without = {edit.__name__ for edit in EVERY_EDIT} - {edit.__name__ for edit in FINDERS}

    assert without <= BY_HAND | {"Prepared"}  # the latter holds another edit
