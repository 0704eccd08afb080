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

pytestmark = pytest.mark.window


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
    return [i.data(Qt.ItemDataRole.UserRole) for i in panel.chooser.items() if not i.isHidden()]


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
    panel.chooser.mark(panel.parts.item(2))
    rest(qtbot, window)
    folder = checkout / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    assert window.grab().save(str(folder / "editor_parts.png"))

    panel.parts.item(0).setCheckState(Qt.CheckState.Unchecked)

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
    row = next(i for i in range(14) if "aortic_valve" in panel.parts.item(i).text())
    panel.parts.item(row).setCheckState(Qt.CheckState.Checked)
    click(panel.import_button)
    settle(qtbot, window)

    assert window.session.organ.source.parts == ("VH_M_aortic_valve",)
    assert "--part VH_M_aortic_valve" in log_of(window)


def test_a_part_says_how_much_of_it_there_is(heart_window):
    panel = heart_window.import_panel
    part = panel.reading.parts[0]
    words = panel.parts.item(0).text().replace("\u202f", "")

    assert words.startswith(part.name)
    x = part.surface.vertices
    assert f"{len(x)} vertices, {len(part.surface.triangles)} △" in words
    assert f"{1e3 * np.ptp(x[:, 0]):.0f} ×" in words and words.endswith("mm")


@pytest.mark.landing
def test_the_part_under_the_pointer_stands_out_until_it_leaves(heart_window):
    window, panel = heart_window, heart_window.import_panel
    click(panel.chooser.show_button)
    things = window.view.scenery._things

    panel.parts.itemEntered.emit(panel.parts.item(3))
    assert things[MARK].visible
    assert len(things[MARK].triangles) == len(panel.reading.parts[3].surface.triangles)
    panel.parts.itemEntered.emit(panel.parts.item(4))
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
    row = next(i for i in range(14) if "aortic_valve" in panel.parts.item(i).text())
    panel.parts.item(row).setCheckState(Qt.CheckState.Checked)
    click(panel.import_button)
    settle(qtbot, window)

    assert not window.context.previewing and not panel.chooser.show_button.isChecked()
    assert drawn(window) == len(window.session.organ.surface.triangles)
    click(panel.chooser.show_button)
    assert window.context.previewing
    window.show_stage("repair")
    assert not window.context.previewing
    assert drawn(window) == len(window.session.organ.surface.triangles)
