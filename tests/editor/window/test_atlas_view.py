# SPDX-License-Identifier: GPL-3.0-or-later
"""The atlas of the organ on the desk: its mark follows constants, also while they are dragged."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest
from hands import action, child, choose_file, click
from made_up_atlases import make_atlas
from palpate.study.atlas_file import read_atlas, write_atlas
from palpate_editor.atlas_jobs import run_job
from palpate_editor.atlas_spots import EXPLICIT, Spot
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetChoice, SetConstant
from palpate_editor.job_pool import run_here
from palpate_editor.views.stages.constant_form import ConstantField
from palpate_editor.views.stages.drag_label import PER_DECADE
from patience import settle
from PySide6.QtCore import QPoint, Qt

sys.path.append(str(Path(__file__).resolve().parents[1]))
from charted import make_block  # noqa: E402

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture
def desk(qtbot, window, tmp_path):
    """A window with a small solid and an atlas beside it, in the Material stage."""
    organ = make_block()
    material = replace(organ.material, young_modulus=5e3, damping_ratio=0.3)
    write_organ(tmp_path / "a.organ", replace(organ, material=material, history=None))
    write_atlas(tmp_path / "a.atlas.json", make_atlas())
    window.files.open(tmp_path / "a.organ")
    settle(qtbot, window)
    window.show_stage("material")
    window.atlas.open(tmp_path / "a.atlas.json")
    qtbot.waitUntil(lambda: window.atlas.atlas is not None)
    return window


def words(window) -> str:
    return window.atlas.words.text()


def find_field(window, key: str) -> ConstantField:
    return next(
        field
        for field in window.material_panel.fields
        if isinstance(field, ConstantField) and field.constant.key == key
    )


def test_an_atlas_that_is_opened_shows_its_map_and_the_margin_of_the_scene(desk):
    assert desk.docks.docks["stability"].isVisible()
    assert [row.spot.stiffness for row in desk.atlas.plot.line] == [0.01, 0.1, 1.0, 10.0, 100.0]
    assert desk.atlas.plot.mark.stiffness == 1.0
    assert "ms used" in words(desk)


def test_the_mark_moves_as_a_constant_is_entered_and_undone(qtbot, desk):
    before = desk.atlas.plot.mark
    desk.context.apply(SetConstant("material", "young_modulus", 5e5))

    # at once, before anything was built again
    mark = desk.atlas.plot.mark
    assert mark.stiffness == pytest.approx(100.0)
    assert mark.limit == pytest.approx(0.1e-3, rel=1e-6)
    action(desk, "undo").trigger()
    settle(qtbot, desk)
    assert desk.atlas.plot.mark == before


def test_dragging_the_name_of_a_constant_moves_the_mark_live_and_is_one_edit(qtbot, desk):
    field, history = find_field(desk, "material.young_modulus"), desk.session.history
    label, start = field.label, QPoint(5, 5)
    count, seen = history.count(), []
    qtbot.mousePress(label, Qt.MouseButton.LeftButton, pos=start)
    for part in (0.25, 0.5, 1.0):
        qtbot.mouseMove(label, start + QPoint(int(part * PER_DECADE), 0))
        seen.append(desk.atlas.plot.mark.stiffness)

    assert seen == pytest.approx([10**0.25, 10**0.5, 10.0], rel=0.02)
    assert history.count() == count  # nothing is changed yet
    assert desk.session.organ.material.young_modulus == 5e3
    end = start + QPoint(int(PER_DECADE), 0)
    qtbot.mouseRelease(label, Qt.MouseButton.LeftButton, pos=end)

    assert history.count() == count + 1
    assert desk.session.organ.material.young_modulus == pytest.approx(5e4)
    assert desk.atlas.plot.mark.stiffness == pytest.approx(10.0)


def test_a_click_on_the_name_of_a_constant_changes_nothing(qtbot, desk):
    label, count = find_field(desk, "material.density").label, desk.session.history.count()

    qtbot.mouseClick(label, Qt.MouseButton.LeftButton)

    assert desk.session.history.count() == count


def test_what_never_blows_up_says_so(qtbot, desk):
    desk.context.apply(SetChoice("integrator", "implicit_euler"))
    settle(qtbot, desk)

    assert "holds every step" in words(desk)
    assert desk.atlas.plot.mark.limit is None


def test_the_limits_are_found_beside_the_window_and_saved(qtbot, desk, tmp_path, monkeypatch):
    few = [(Spot("solid", 1.0, "own", "own"), EXPLICIT[:1])]
    monkeypatch.setattr("palpate_editor.atlas.list_points", lambda organ: few)
    monkeypatch.setattr("palpate_editor.atlas.run_tissues", lambda workers: run_here(run_job))
    desk.atlas.cache = tmp_path / "cache"
    before = desk.atlas.atlas
    click(child(desk, "draw_atlas"))
    qtbot.waitUntil(lambda: desk.atlas.atlas is not before, timeout=60_000)

    assert len(desk.atlas.atlas.rows) == 1
    click(child(desk, "save_atlas"))
    choose_file(qtbot, desk, tmp_path / "b.json")
    assert read_atlas(tmp_path / "b.json") == desk.atlas.atlas


def test_without_an_atlas_it_says_where_one_comes_from(window):
    assert "find the limits" in words(window)
    assert not child(window, "save_atlas").isEnabled()
