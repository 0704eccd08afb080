# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene has beside what is placed in it, entered in its window."""

from __future__ import annotations

import numpy as np
import pytest
from hands import click
from layouts import enter, find, log, part
from palpate_editor.views.quantity_box import QuantityBox
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QPlainTextEdit

pytestmark = pytest.mark.window


def test_title_task_gravity_and_fluid_are_kept_with_the_scene(qtbot, scene):
    find(scene, QLineEdit, "title").setText("A stone")
    find(scene, QLineEdit, "title").editingFinished.emit()
    find(scene, QPlainTextEdit, "task_tr").setPlainText("Taşı alın")
    scene.panel.scene_form.enter_tasks()
    click(find(scene, QCheckBox, "gravity"))
    enter(scene, "gravity 2", "-1.62")
    click(find(scene, QCheckBox, "fluid"))
    enter(scene, "fluid 1", "3")

    layout = scene.session.layout
    assert (layout.title, layout.task_tr) == ("A stone", "Taşı alın")
    assert layout.gravity == (0.0, 0.0, -1.62) and layout.fluid == (1000.0, 0.003)
    assert "two.layout.json '--title=A stone'" in log(scene)
    click(find(scene, QCheckBox, "gravity"))
    assert scene.session.layout.gravity == ()
    scene.undo()
    assert find(scene, QuantityBox, "gravity 2").shown == -1.62


def test_a_scene_is_touched_by_the_instrument_that_is_chosen(scene):
    box = find(scene, QComboBox, "tool_kind")
    box.setCurrentIndex(box.findData("grasper"))
    box.activated.emit(box.currentIndex())
    enter(scene, "radius", "2")
    enter(scene, "jaw_opening", "20")
    click(find(scene, QCheckBox, "trocar"))
    enter(scene, "trocar 0", "12")

    (tool,) = scene.session.layout.tools
    assert (tool.kind, tool.radius, tool.grip_force) == ("grasper", 0.002, 5.0)
    assert tool.jaw_opening == pytest.approx(np.radians(20), rel=1e-8)
    np.testing.assert_allclose(tool.trocar, (0.012, 0.0, 0.15), rtol=1e-12)
    enter(scene, "radius", "900")
    assert "--radius: got 0.9, expected" in scene.messages.text
    assert find(scene, QuantityBox, "radius").shown == 0.002
    box.setCurrentIndex(0)
    box.activated.emit(0)
    assert scene.session.layout.tools == ()


def test_a_stone_is_of_the_density_and_friction_that_are_entered(scene):
    scene.choose("stone")
    enter(scene, "density", "2100")
    enter(scene, "friction", "0.4")
    enter(scene, "spheres", "9")

    stone = part(scene, "stone")
    assert (stone.density, stone.friction, stone.spheres) == (2100.0, 0.4, 9)
    scene.choose("tray")
    assert not find(scene, QuantityBox, "density").isVisibleTo(scene)
    enter(scene, "friction", "0.1")
    assert part(scene, "tray").friction == 0.1
