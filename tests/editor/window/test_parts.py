# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a file are chosen by sight, by name and by size."""

from __future__ import annotations

import numpy as np
import pytest
from hands import click, log_of
from palpate_editor.views.stages.parts_preview import MARK
from palpate_editor.views.tasks import ImportWork
from patience import rest, settle
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication

pytestmark = [pytest.mark.window, pytest.mark.landing]


@pytest.fixture(scope="module")
def heart(shared_data):
    """What the window's worker reads of a heart: a value, made once."""
    path = shared_data("organs/VH_M_Heart.glb")
    return ImportWork(path)(lambda words, share: None)


@pytest.fixture
def heart_window(qtbot, window, heart):
    """A heart of 14 parts, imported whole."""
    window.tasks.on_read(heart)
    settle(qtbot, window)
    return window


def visible(panel) -> list[str]:
    return [i.data(0, Qt.ItemDataRole.UserRole) for i in panel.parts.items() if not i.isHidden()]


def drawn(window) -> int:
    """Triangles in the view."""
    return len(window.view.scenery.triangles)


def test_parts_of_what_was_imported_are_shown_to_choose_from(qtbot, heart_window, checkout):
    window, panel = heart_window, heart_window.import_panel
    parts = panel.reading.parts
    assert drawn(window) == len(window.session.organ.surface.triangles)
    assert window.welcome.isHidden()
    click(panel.chooser.show_button)
    assert drawn(window) == sum(len(part.surface.triangles) for part in parts)
    size = np.ptp(window.view.scenery.vertices, axis=0)
    assert 0.05 < size.max() < 0.3, "a heart, in metres"
    rest(qtbot, window)
    panel.parts.on_entered(panel.parts.items()[2])
    rest(qtbot, window)
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert window.grab().save(str(folder / "editor_parts.png"))

    panel.parts.items()[0].setCheckState(0, Qt.CheckState.Unchecked)

    assert drawn(window) == sum(len(part.surface.triangles) for part in parts[1:])
    click(panel.chooser.show_button)
    assert drawn(window) == len(window.session.organ.surface.triangles)


@pytest.mark.landing
def test_a_heart_of_many_parts_can_be_imported_in_part(qtbot, heart_window):
    window = heart_window
    assert "VH_M_Heart.glb imported" in window.messages.text
    panel = window.import_panel
    assert panel.parts.count() == 14

    click(panel.none_button)
    assert not panel.import_button.isEnabled()
    row = next(i for i in range(14) if panel.parts.items()[i].text(0).startswith("VH_M_aortic"))
    panel.parts.items()[row].setCheckState(0, Qt.CheckState.Checked)
    click(panel.import_button)
    settle(qtbot, window)

    assert window.session.organ.source.parts == ("VH_M_aortic_valve",)
    assert "--part VH_M_aortic_valve" in log_of(window)


def test_a_part_says_how_much_of_it_there_is(heart_window):
    panel = heart_window.import_panel
    part = panel.reading.parts[0]
    words = panel.parts.items()[0].text(0).replace("\u202f", "")

    assert words.startswith(part.name)
    x = part.surface.vertices
    size = " × ".join(f"{1e3 * length:.0f}" for length in np.ptp(x, axis=0))
    assert f"{size} mm, {len(part.surface.triangles)} △" in words
    told = panel.parts.items()[0].toolTip(0).replace("\u202f", "")
    assert f"{len(x)} vertices, {len(part.surface.triangles)} △" in told


@pytest.mark.landing
def test_the_part_under_the_pointer_stands_out_until_it_leaves(heart_window):
    window, panel = heart_window, heart_window.import_panel
    click(panel.chooser.show_button)
    things = window.view.scenery._things

    panel.parts.itemEntered.emit(panel.parts.items()[3], 0)
    assert things[MARK].visible
    assert len(things[MARK].triangles) == len(panel.reading.parts[3].surface.triangles)
    panel.parts.itemEntered.emit(panel.parts.items()[4], 0)
    assert len(things[MARK].triangles) == len(panel.reading.parts[4].surface.triangles)

    QApplication.sendEvent(panel.parts.viewport(), QEvent(QEvent.Type.Leave))
    assert MARK not in things or not things[MARK].visible


def test_a_search_leaves_what_it_finds_and_all_and_none_keep_to_that(heart_window):
    panel = heart_window.import_panel
    assert panel.chooser.search.isVisible()

    panel.chooser.search.setText("VALVE")
    found = visible(panel)
    assert 0 < len(found) < 14 and all("valve" in name.lower() for name in found)
    click(panel.none_button)
    assert set(panel.chosen_parts()) == set(p.name for p in panel.reading.parts) - set(found)

    panel.chooser.search.setText("")
    assert len(visible(panel)) == 14


@pytest.mark.landing
def test_the_organ_has_the_view_again_when_parts_were_imported(qtbot, heart_window):
    window, panel = heart_window, heart_window.import_panel
    panel.chooser.search.setText("aortic valve")
    click(panel.none_button)
    panel.chooser.search.setText("")
    click(panel.none_button)
    row = next(i for i in range(14) if panel.parts.items()[i].text(0).startswith("VH_M_aortic"))
    panel.parts.items()[row].setCheckState(0, Qt.CheckState.Checked)
    click(panel.import_button)
    settle(qtbot, window)

    assert not window.context.previewing and not panel.chooser.show_button.isChecked()
    assert drawn(window) == len(window.session.organ.surface.triangles)
    click(panel.chooser.show_button)
    assert window.context.previewing
    window.show_stage("repair")
    assert not window.context.previewing
    assert drawn(window) == len(window.session.organ.surface.triangles)


def test_parts_stand_below_the_groups_of_the_file_and_a_group_is_ticked_whole(heart_window):
    panel = heart_window.import_panel
    tree = panel.parts
    groups = {tree.topLevelItem(i).text(0): tree.topLevelItem(i) for i in range(3)}
    assert set(groups) == {
        "VH_M_heart_valve", "VH_M_papillary_muscle_of_heart", "VH_M_cardiac_chamber"
    }  # fmt: skip
    valves = groups["VH_M_heart_valve"]
    assert valves.childCount() == 4

    click(panel.none_button)
    valves.setCheckState(0, Qt.CheckState.Checked)

    assert len(panel.chosen_parts()) == 4
    assert all("valve" in name for name in panel.chosen_parts())


@pytest.mark.landing
def test_a_hidden_part_leaves_the_view_and_stays_chosen(heart_window):
    window, panel = heart_window, heart_window.import_panel
    click(panel.chooser.show_button)
    whole = drawn(window)
    first = panel.parts.items()[0]

    panel.parts.itemClicked.emit(first, 2)

    part = panel.reading.parts[0]
    assert drawn(window) == whole - len(part.surface.triangles)
    assert part.name in panel.chosen_parts()
    panel.parts.itemClicked.emit(first, 2)
    assert drawn(window) == whole


def test_a_part_that_is_taken_away_makes_solids_of_the_others(heart_window):
    panel = heart_window.import_panel
    click(panel.none_button)

    panel.parts.itemClicked.emit(panel.parts.items()[0], 1)

    name = panel.reading.parts[0].name
    asked = panel.chooser.assembling()
    assert asked.subtract == (name,) and asked.unite
    assert panel.chosen_parts() == []
    assert not panel.import_button.isEnabled()
    assert not panel.chooser.form.way.isEnabled()
    menu = panel.parts.build_menu(panel.parts.items()[0])
    assert [action.text() for action in menu.actions()][2] == "Take nothing away"
    menu.actions()[2].trigger()
    assert panel.chooser.assembling().subtract == ()
