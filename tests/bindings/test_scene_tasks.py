# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of scenes that hold several organs, stones and scenery."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.author import new_assessment
from palpate.assessment.instruments import shape_tools
from palpate.assessment.publish import with_assessment
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from stones import make_stone_scene
from test_layout import write_organ
from test_scene_verb import say


@pytest.fixture
def published(tmp_path, capsys) -> Path:
    """Two organs of the same file beside each other."""
    organ, path = write_organ(tmp_path), tmp_path / "two.layout.json"
    say(capsys, "new", "-o", path, "--title", "Two")
    say(capsys, "add", path, organ, "--name", "Left one")
    say(capsys, "add", path, organ, "--name", "right", "--at", "100,0,0")
    out = tmp_path / "two.palpate"
    assert say(capsys, "publish", path, "-o", out)["code"] == 0
    return out


def test_a_region_of_any_organ_of_a_scene_is_a_place_of_a_task(published, tmp_path, capsys):
    task = tmp_path / "task.json"

    assert main(["scenario", "new", str(published), "-o", str(task), "--title", "Top"]) == 0
    made = json.loads(task.read_text(encoding="utf-8"))
    assert made["organs"] == {"left-one": {"body": 0}, "right": {"body": 1}}
    made["places"] = {"foot": {"region": "right/foot"}, "top": {"region": "left-one/top"}}
    made["steps"] = [{"id": "touch", "do": "touch", "at": "foot", "say": "title"}]
    made["limits"] = [{"id": "off", "when": {"measure": "contact", "place": "top"},
                       "then": "error", "say": "title"}]  # fmt: skip

    judged = scenario.draw_task(with_assessment(task, made, scenario.read(published)), "")

    foot, top = judged.task.places
    assert (foot.body, top.body) == (1, 0)
    z = np.asarray(judged.task.surfaces[1].vertices)[:, 2]
    assert list(foot.vertices) == np.flatnonzero(z < -0.012).tolist()
    assert list(top.vertices) == np.flatnonzero(z > 0.012).tolist()


def test_a_region_that_no_organ_of_a_scene_has_is_refused_with_those_there_are(published):
    made = new_assessment("right", {"en": "Top"})
    made["places"] = {"top": {"region": "right/side"}}

    with pytest.raises(Refusal, match="left-one/top, left-one/foot, right/top"):
        with_assessment("task.json", made, scenario.read(published))


def test_a_second_instrument_leaves_stones_and_all_else_in_the_scene():
    scene = make_stone_scene()
    scene.fluid = palpate.Fluid(1000.0, 0.001)
    scene.bodies[0].may_fold = True
    scene = palpate.build_scene(scene)
    tools = {"one": {"kind": "ball"}, "two": {"kind": "ball", "instrument": 1}}

    shaped = shape_tools("task.json", {"tools": tools}, scene)

    assert len(shaped.instruments) == 2
    assert (len(shaped.rigid), len(shaped.scenery)) == (1, 1)
    assert shaped.fluid.density == 1000.0
    assert len(shaped.body_pairs) == 1


def test_surfaces_with_a_coefficient_of_their_own_keep_it_beside_that_of_an_assessment():
    scene = make_stone_scene()
    instrument = scene.instruments[0]
    instrument.tool.friction = 0.5
    instrument.pair_friction = [0.05, 0.5, 0.3]  # organ, scenery, stone

    def shape(friction: float) -> palpate.Instrument:
        tools = {"one": {"kind": "ball", "radius_m": 0.004, "friction": friction}}
        return shape_tools("task.json", {"tools": tools}, palpate.build_scene(scene)).instruments[0]

    assert shape(0.7).tool.friction == 0.7
    assert shape(0.7).pair_friction == [0.05, 0.7, 0.3]
    assert shape(0.0).pair_friction == []  # what slides on everything
