# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of several organs in a window of its own, driven as a person drives it."""

from __future__ import annotations

import json
import shlex

import numpy as np
import pytest
from hands import click, log_of
from layouts import enter, find, log, part, wait
from palpate import scenario
from palpate.cli.main import main
from palpate.layout.layout_file import read_layout
from palpate_editor.layout_shapes import find_degrees
from palpate_editor.views import file_questions
from palpate_editor.views.layout.layout_window import LayoutWindow
from palpate_editor.views.layout.move_gizmo import AXES, Handle
from patience import PATIENCE
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QMessageBox,
    QPushButton,
)

pytestmark = pytest.mark.window
LEFT, NO_KEYS = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


def handle_pixel(window: LayoutWindow, handle: Handle) -> QPoint:
    """A pixel of a handle that no other is nearer to."""
    for point in reversed(window.mover._points(handle)):
        pixel = window.view.world_to_pixel(point)
        if window.mover.find(pixel) == handle:
            return pixel.toPoint()
    raise AssertionError(handle)


def drag(window: LayoutWindow, start: QPoint, end: QPoint, release: bool = True) -> None:
    view = window.view
    QTest.mousePress(view, LEFT, NO_KEYS, start)
    for share in (0.3, 0.7, 1.0):
        QTest.mouseMove(view, start + (end - start) * share)
    if release:
        QTest.mouseRelease(view, LEFT, NO_KEYS, end)


def test_a_tick_has_an_organ_keep_the_shape_that_it_was_scanned_in(qtbot, scene):
    scene.choose("left")
    box = find(scene, QCheckBox, "weightless")
    assert box.isVisibleTo(scene) and not box.isChecked()

    QTest.mouseClick(box, LEFT, NO_KEYS, QPoint(8, box.height() // 2))
    wait(qtbot, scene)

    assert part(scene, "left").weightless
    assert "--weightless" in log(scene)
    assert find(scene, QCheckBox, "weightless").isChecked()
    scene.choose("stone")
    assert not find(scene, QCheckBox, "weightless").isVisibleTo(scene)


def test_a_tick_gives_instruments_a_coefficient_of_their_own_on_what_is_placed(qtbot, scene):
    scene.choose("left")
    box = find(scene, QCheckBox, "tool_friction")
    assert box.isVisibleTo(scene) and not box.isChecked()

    QTest.mouseClick(box, LEFT, NO_KEYS, QPoint(8, box.height() // 2))
    wait(qtbot, scene)

    assert part(scene, "left").tool_friction == (0.1,)
    assert "--tool-friction=0.1" in log(scene)
    QTest.mouseClick(box, LEFT, NO_KEYS, QPoint(8, box.height() // 2))
    wait(qtbot, scene)
    assert part(scene, "left").tool_friction == ()
    assert "--tool-friction=own" in log(scene)
    scene.choose("stone")
    assert find(scene, QCheckBox, "tool_friction").isVisibleTo(scene)


def test_a_layout_opens_in_a_window_that_lists_and_draws_what_is_in_it(scene):
    heads = [scene.tree.topLevelItem(i) for i in range(3)]
    names = [[head.child(i).text(0) for i in range(head.childCount())] for head in heads]

    assert names == [["left", "right"], ["stone"], ["tray"]]
    assert "two.layout.json" in scene.windowTitle()
    assert len(scene.view.scenery.vertices) == 2 * 162
    assert {"placed stone", "placed tray"} <= set(scene.view.scenery._things)


def test_a_click_chooses_what_is_under_the_pointer(qtbot, scene):
    top = np.asarray(part(scene, "right").position) + (0.0, 0.0, 0.02)
    QTest.mouseClick(scene.view, LEFT, NO_KEYS, scene.view.world_to_pixel(top).toPoint())
    assert scene.chosen == "right"
    assert scene.tree.currentItem().text(0) == "right"

    stone = np.asarray(part(scene, "stone").position) + (0.0, 0.0, 0.003)
    QTest.mouseClick(scene.view, LEFT, NO_KEYS, scene.view.world_to_pixel(stone).toPoint())
    assert scene.chosen == "stone"
    QTest.keyClick(scene.view, Qt.Key.Key_Escape)
    assert scene.chosen == ""


def test_an_arrow_moves_along_its_axis_and_the_log_says_what_does_the_same(scene, two, tmp_path):
    scene.choose("right")
    before = np.array(part(scene, "right").position)
    start = handle_pixel(scene, Handle(False, 2))
    along = scene.view.world_to_pixel(scene.mover.middle + 0.02 * AXES[2])
    way = along - scene.view.world_to_pixel(scene.mover.middle)

    drag(scene, start, start + QPointF(way).toPoint())

    moved = np.array(part(scene, "right").position) - before
    assert moved[2] == pytest.approx(0.02, rel=0.15)
    assert np.abs(moved[:2]).max() < 1e-9
    line = log(scene).splitlines()[-1].partition("$ ")[2]
    assert main(shlex.split(line)[1:]) == 0
    assert read_layout(two).now == scene.session.layout


def test_handles_of_a_small_stone_can_be_held_from_afar(qtbot, scene):
    scene.choose("stone")
    scene.view.camera.distance *= 6.0
    scene.view.update()
    stone = scene.shapes[("stone.obj", part(scene, "stone").sha256, 1e-3)]

    qtbot.waitUntil(lambda: scene.mover.reach > 4.0 * stone.radius, timeout=PATIENCE)

    size = scene.view.pixel_size_at(scene.mover.middle)
    assert scene.mover.reach / size == pytest.approx(45.0, rel=0.11)
    assert scene.mover.find(QPointF(handle_pixel(scene, Handle(False, 2)))) is not None


def test_a_ring_turns_about_the_middle_of_the_part(scene):
    scene.choose("right")
    middle = scene.mover.middle.copy()
    start = handle_pixel(scene, Handle(True, 2))

    drag(scene, start, start + QPoint(40, 0))

    x, y, z = find_degrees(part(scene, "right"))
    assert abs(z) > 3.0
    assert abs(x) < 1e-6 and abs(y) < 1e-6
    assert scene.mover.middle == pytest.approx(middle, abs=1e-9)
    assert "--turn=" in log(scene)


def test_escape_takes_a_drag_back(scene):
    scene.choose("right")
    before, shown = scene.session.layout, scene.view.scenery.vertices.copy()
    start = handle_pixel(scene, Handle(False, 0))

    drag(scene, start, start + QPoint(50, 10), release=False)
    assert not np.array_equal(scene.view.scenery.vertices, shown)
    QTest.keyClick(scene.view, Qt.Key.Key_Escape)
    QTest.mouseRelease(scene.view, LEFT, NO_KEYS, start)

    assert scene.session.layout is before
    assert np.array_equal(scene.view.scenery.vertices, shown)
    assert scene.chosen == "right"


def test_numbers_place_and_undo_is_that_of_the_file(scene, two):
    scene.choose("right")
    enter(scene, "at_x", "70")
    enter(scene, "turn_z", "15")
    assert part(scene, "right").position[0] == pytest.approx(0.07)
    assert find_degrees(part(scene, "right"))[2] == pytest.approx(15.0)

    scene.undo()
    assert find_degrees(part(scene, "right"))[2] == pytest.approx(0.0)
    scene.redo()
    assert scene.isWindowModified()
    scene.files.save()

    assert not scene.isWindowModified()
    kept = read_layout(two)
    assert kept == scene.session.history
    assert f"palpate scene undo {two}" in log(scene)


def test_a_number_that_is_no_place_is_refused_with_a_sentence(scene):
    scene.do(("pair", "left", "right", "--thickness=-1mm"))

    assert "expected 0 to 5 mm" in scene.messages.text
    assert scene.session.layout.pairs[0].thickness == 0.0


def test_pairs_are_ticked_and_have_constants(scene):
    find(scene, QCheckBox, "pair tray right").click()
    assert part(scene, "tray").stops == ("right",)
    assert log(scene).endswith("tray right")

    row = next(each for each in scene.panel.pairs.rows if each.row.is_bodies)
    row.thickness.lineEdit().setText("0.4")
    row.thickness.enter()
    assert scene.session.layout.pairs[0].thickness == pytest.approx(4e-4)
    assert row.friction.lineEdit().text() == "0"
    row.friction.lineEdit().setText("0.05")
    row.friction.enter()
    (pair,) = scene.session.layout.pairs
    assert (pair.thickness, pair.friction) == (pytest.approx(4e-4), 0.05)
    assert log(scene).endswith("--thickness=0.4mm --friction=0.05")
    row.friction.lineEdit().setText("-1")
    row.friction.enter()
    assert scene.session.layout.pairs == (pair,)
    row.tick.click()
    assert scene.session.layout.pairs == ()
    assert row.thickness.isHidden() and row.friction.isHidden()


def test_an_overlap_is_shown_where_it_is_and_parted_with_a_report(qtbot, scene):
    scene.choose("right")
    enter(scene, "at_x", "58.8")
    wait(qtbot, scene)
    row = next(each for each in scene.panel.rows if "inside of left" in each.label.text())

    click(row.look)
    assert np.linalg.norm(np.asarray(scene.view.camera.target) - (0.0294, 0, 0)) < 0.01
    assert "overlap" in scene.view.scenery._things
    click(row.button)

    assert "right was moved" in scene.messages.text
    assert part(scene, "right").position[0] > 0.0593
    assert "--by=" in log(scene)
    wait(qtbot, scene)
    assert not any(each.button.isVisible() for each in scene.panel.rows)


def test_a_region_is_laid_on_a_region(qtbot, scene):
    scene.choose("right")
    find(scene, QComboBox, "snap_region").setCurrentText("foot")
    find(scene, QComboBox, "snap_onto").setCurrentText("left/top")

    click(find(scene, QPushButton, "snap"))
    wait(qtbot, scene)

    assert part(scene, "right").position[2] > 0.039
    assert "--onto=left/top" in log(scene)


def test_organs_and_stones_are_added_under_names_of_their_own(qtbot, scene, two):
    scene.kind = "organ"
    scene.add(str(two.parent / "left.palpate"))
    qtbot.waitUntil(lambda: len(scene.session.layout.bodies) == 3, timeout=PATIENCE)
    assert scene.chosen == "left 2"
    assert "--name 'left 2'" in log(scene)

    scene.remove()
    assert len(scene.session.layout.bodies) == 2
    wait(qtbot, scene)
    scene.kind = "stone"
    scene.add(str(two.parent / "damaged.obj"))
    qtbot.waitUntil(lambda: scene.jobs.current is None, timeout=PATIENCE)
    assert "damaged.obj" in scene.messages.text


def test_each_pair_is_measured_and_the_scene_published(qtbot, scene, tmp_path):
    scene.choose("right")
    enter(scene, "at_x", "60.6")
    wait(qtbot, scene)
    scene.publish(str(tmp_path / "two.palpate"))
    qtbot.waitUntil(lambda: scene.jobs.current is None, timeout=PATIENCE)

    assert "two.palpate" in scene.messages.text
    published = scenario.read(tmp_path / "two.palpate")
    assert len(published.scene.bodies) == 2
    assert len(published.scene.rigid) == len(published.scene.scenery) == 1
    budget = scene.panel.budget.budget
    assert budget is not None
    assert budget.parts[0].name == "left and right"


def test_of_one_organ_with_a_stone_every_part_is_measured(qtbot, scene, tmp_path):
    scene.choose("right")
    scene.remove()
    wait(qtbot, scene)
    scene.publish(str(tmp_path / "one.palpate"))
    qtbot.waitUntil(lambda: scene.jobs.current is None, timeout=PATIENCE)

    budget = scene.panel.budget.budget
    assert budget is not None, scene.messages.text
    names = [part.name for part in budget.parts]
    layout = scene.session.layout
    stops = [f"left and {part.name}" for part in layout.scenery for _ in part.stops]
    assert names == ["left", "Tool", *(stone.name for stone in layout.stones), *stops]
    assert 0.0 < budget.parts[0].median <= budget.median


def test_what_a_killed_editor_left_of_a_scene_is_offered_and_taken_up(
    qtbot, make_editor, scene, two, tmp_path
):
    scene.choose("right")
    enter(scene, "at_x", "71")
    autosave = scene.autosave
    qtbot.waitUntil(lambda: autosave.kept is scene.session.history, timeout=PATIENCE)
    qtbot.waitUntil(lambda: not autosave.busy, timeout=PATIENCE)
    autosave.file.held.unlock()  # as the end of its process does

    editor = make_editor()
    qtbot.waitUntil(lambda: editor.question is not None, timeout=PATIENCE)
    assert "two.layout.json" in editor.question.text()
    click(editor.question.button(QMessageBox.StandardButton.Open))

    (window,) = editor.layouts
    assert part(window, "right").position[0] == pytest.approx(0.071)
    assert window.isWindowModified() and window.session.path == two
    window.undo()
    assert part(window, "right").position[0] == pytest.approx(0.065)
    window.redo()
    assert window.files.save()
    assert read_layout(two).now.find_part("right").position[0] == pytest.approx(0.071)
    window.close()


def test_closing_asks_about_what_is_not_saved(qtbot, editor, scene):
    scene.choose("right")
    enter(scene, "at_x", "70")
    scene.close()
    assert scene.isVisible()
    assert scene.question is not None

    scene.question.button(file_questions.BUTTONS.Discard).click()

    qtbot.waitUntil(lambda: not editor.layouts, timeout=PATIENCE)


def test_a_file_that_another_program_changed_is_not_overwritten_unasked(scene, two):
    scene.choose("right")
    enter(scene, "at_x", "70")
    assert main(["scene", "place", str(two), "left", "--at=0,0,5"]) == 0
    scene.files.save()

    assert scene.files.question is not None
    assert read_layout(two).now.find_part("left").position == (0.0, 0.0, 0.005)
    scene.files.answer_changed(file_questions.RELOAD)
    assert part(scene, "left").position == (0.0, 0.0, 0.005)


def test_a_new_scene_is_a_file_from_the_beginning(qtbot, editor, tmp_path):
    path = tmp_path / "new.layout.json"
    editor.window.files.begin_scene(str(path))
    (window,) = editor.layouts
    assert read_layout(path).now == window.session.layout
    assert f"palpate scene new --out {path}" in log(window)
    wait(qtbot, window)
    assert "add an organ" in window.panel.rows[0].label.text()
    window.close()


def test_in_another_folder_the_same_files_are_named(scene, tmp_path):
    other = tmp_path / "other"
    other.mkdir()

    scene.files.save_name(str(other / "moved"))

    layout = read_layout(other / "moved.layout.json").now
    assert layout.bodies[0].file == "../left.palpate"


def test_what_is_wrong_is_said_in_turkish(qtbot, make_editor, two):
    editor = make_editor(language="tr")
    editor.open_layout(two)
    (window,) = editor.layouts
    window.do(("place", "right", "--at=58.8,0,0"))
    wait(qtbot, window)

    said = [row.label.text() for row in window.panel.rows if row.isVisible()]

    assert any("parçasının" in words and "mm taşındı" in words for words in said)
    assert not any("stops instruments" in words for words in said)
    window.may_close = True
    window.close()


def test_a_damaged_layout_is_refused_in_the_main_window(editor, two):
    data = json.loads(two.read_text(encoding="utf-8"))
    data["now"]["bodies"] = 3
    two.write_text(json.dumps(data), encoding="utf-8")

    editor.window.files.open(two)

    assert editor.layouts == []
    assert "two.layout.json" in log_of(editor.window)
