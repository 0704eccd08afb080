# SPDX-License-Identifier: GPL-3.0-or-later
"""The judged task of a scene, written in its window."""

from __future__ import annotations

import json
import shlex

import numpy as np
import pytest
from hands import click
from layouts import enter, find, log, wait
from palpate import scenario
from palpate.cli.main import main
from palpate.layout.layout_file import read_layout
from palpate_editor.views.layout.side import Side
from palpate_editor.views.scenario.step_form import Choice
from patience import PATIENCE
from PySide6.QtWidgets import QMenu, QPushButton

pytestmark = pytest.mark.window


def add(scene, verb: str) -> None:
    menu = find(scene, QMenu, "verbs")
    (action,) = [each for each in menu.actions() if each.data() == verb]
    menu.triggered.emit(action)


@pytest.fixture
def task(scene):
    find(scene, Side, "side").setCurrentIndex(1)
    click(find(scene, QPushButton, "new_task"))
    return scene.task


def read(scene) -> dict:
    return json.loads(scene.session.layout.assessment)


def test_a_task_of_organs_and_stones_is_written_step_by_step_and_undone(scene, task):
    add(scene, "touch")
    add(scene, "grasp")
    place = find(scene, Choice, "step_place")
    names = [place.itemText(row) for row in range(place.count())]
    assert {"left/top", "left/foot", "right/top", "right/foot"} <= set(names)
    add(scene, "remove")
    assert "task space" in scene.view.scenery._things
    enter(scene, "space_radius", "25")

    made = read(scene)
    assert list(made["organs"]) == ["left", "right"] and list(made["objects"]) == ["stone"]
    assert [step["do"] for step in made["steps"]] == ["touch", "grasp", "remove"]
    assert made["places"][made["steps"][0]["at"]] == {"region": "left/top"}
    assert made["places"][made["steps"][2]["at"]] == {"object": "stone"}
    x, y, z, radius = made["places"][made["steps"][2]["from"]]["space"]
    assert (x, y, z, radius) == pytest.approx((0.033, -0.035, -0.0264, 0.025))
    scene.undo()
    scene.undo()
    assert [step["do"] for step in read(scene)["steps"]] == ["touch", "grasp"]
    assert len(task.draft.steps) == 2


def test_what_is_clicked_in_the_picture_is_a_place_of_that_organ(scene, task):
    add(scene, "touch")
    click(find(scene, QPushButton, "draw_point"))
    top = np.asarray(scene.session.layout.bodies[1].position) + (0.0, 0.0, 0.02)

    scene.task.point_tool.picked.emit(top)

    made = read(scene)
    spot = made["places"][made["steps"][0]["at"]]
    assert spot["organ"] == "right"
    assert spot["ball"][:3] == pytest.approx(list(top), abs=1e-5)
    assert not find(scene, QPushButton, "draw_point").isChecked()


def test_the_log_typed_again_writes_the_same_task(scene, task, two, monkeypatch, qtbot):
    monkeypatch.chdir(two.parent)
    add(scene, "touch")
    add(scene, "remove")
    task.draft.choose("remove")
    enter(scene, "space_x", "30")
    lines = [line.partition("$ ")[2] for line in log(scene).splitlines()]
    assert main(["scene", "publish", str(two), "-o", "two.palpate"]) == 0
    for line in lines:
        if "editor" not in line.split()[:2]:
            assert main(shlex.split(line)[1:]) == 0, line

    assert json.loads(read_layout(two).now.assessment) == read(scene)


def test_a_task_is_checked_with_its_scene_and_published_in_it(qtbot, scene, task, tmp_path):
    add(scene, "touch")
    scene.do(("place", "left", "--remove"))
    wait(qtbot, scene)
    said = " ".join(row.label.text() for row in task.rows if not row.isHidden())
    assert "left" in said, said
    scene.undo()
    wait(qtbot, scene)
    out = tmp_path / "judged.palpate"

    scene.publish(str(out))
    qtbot.waitUntil(lambda: scene.jobs.current is None, timeout=PATIENCE)

    assert json.loads(scenario.read(out).assessment)["steps"][0]["do"] == "touch"
    click(find(scene, QPushButton, "remove_task"))
    assert scene.session.layout.assessment == ""
    assert find(scene, QPushButton, "new_task").isVisibleTo(scene)
