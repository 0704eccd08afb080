# SPDX-License-Identifier: BSD-3-Clause
"""Tasks at stones, in spaces and with a laparoscope: written, read, judged and refused."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment import author, author_tools
from palpate.assessment.author import AuthorError
from palpate.assessment.publish import with_assessment
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.render import place_scope
from stones import START, make_stone_scene

SCHEMA = Path(palpate.__file__).parent / "schemas" / "assessment.schema.json"
LIMITS = {"loose": "stone", "out_of_view": "there", "object_force": "stone", "strain": "stone"}


@pytest.fixture(scope="module")
def organ() -> scenario.Scenario:
    """A stone that falls beside an organ, a tool of the kind that its scene has."""
    return scenario.Scenario(scene=make_stone_scene(), title="A stone")


def made() -> author.Json:
    new = author.new_assessment("organ", {"en": "Stone", "tr": "Taş"}, stones=["stone"])
    new["tools"] = {"tip": {"kind": "grasper", "radius_m": 1.2e-3, "length_m": 0.02,
                            "jaw_opening_rad": 0.5, "friction": 0.6}}  # fmt: skip
    new = author_tools.set_kind(new, "scope", "laparoscope")
    new, stone = author.add_place(new, "stone", {"object": "stone"})
    new, there = author.add_place(new, "there", {"space": [*START, 0.02]})
    new, _ = author.add_step(new, "look", stone, {"distance_m": [None, 0.08]})
    new, _ = author.add_step(new, "grasp", stone)
    new, _ = author.add_step(new, "remove", stone, {"from": there})
    new, _ = author.add_step(new, "carry", stone, {"to": there})
    new, _ = author.add_step(new, "release", None)
    for measure, place in LIMITS.items():
        new, identity = author.add_limit(new, measure, {"place": place, "tool": "tip"})
    return new


def test_what_is_written_is_of_the_schema_and_comes_to_the_tables_it_stands_for(organ):
    written = made()
    jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(
        written
    )

    drawn = scenario.draw_task(with_assessment("mine", written, organ))

    verbs, measures = palpate.TaskVerb, palpate.TaskMeasure
    places = dict(zip(drawn.places, drawn.task.places, strict=True))
    assert places["stone"].kind is palpate.PlaceKind.object
    assert places["stone"].body == 0
    assert places["there"].kind is palpate.PlaceKind.space
    np.testing.assert_allclose(places["there"].points, [START])
    assert [step.verb for step in drawn.task.steps] == [
        verbs.look, verbs.grasp, verbs.remove, verbs.carry, verbs.release,
    ]  # fmt: skip
    assert [step.instrument for step in drawn.task.steps] == [1, 0, 0, 0, 0]
    assert [step.space >= 0 for step in drawn.task.steps] == [False, False, True, True, False]
    assert [limit.measure for limit in drawn.task.limits] == [
        measures.loose, measures.out_of_view, measures.object_force, measures.strain,
    ]  # fmt: skip
    assert palpate.watches_sight(drawn.task)
    assert written["texts"]["tr"]["step-carry"] == "Yerine götürün: stone"


def test_a_file_keeps_it_and_one_that_is_damaged_is_refused(organ, tmp_path):
    published = with_assessment("mine", made(), organ)
    path = tmp_path / "stone.palpate"
    scenario.write(path, published)
    read, was = (scenario.draw_task(each) for each in (scenario.read(path), published))
    assert read.sha256 == was.sha256
    assert str(read.task.steps + read.task.limits) == str(was.task.steps + was.task.limits)

    for change, sentence in (
        (lambda a: a["objects"]["stone"].update(rigid=1), "objects.stone.rigid"),
        (lambda a: a["objects"]["stone"].update(x=1), "an unknown member"),
        (lambda a: a["places"]["there"].update(space=[0, 0, 0]), "\\[x, y, z, radius\\]"),
        (lambda a: a["places"]["there"].update(space=[0, 0, 0, 2]), "places.there.radius"),
        (lambda a: a["places"]["stone"].update(object="sand"), "an object of the scenario"),
        (lambda a: a["steps"][3].pop("to"), "steps\\[3\\].to"),
        (lambda a: a["steps"][3].update(to="stone"), "expected a space"),
        (lambda a: a["steps"][0].update(tool="tip"), "a tool of the kind laparoscope"),
        (lambda a: a["steps"][1].update(tool="scope"), "a tool of the kind grasper"),
        (lambda a: a["steps"][1].update(do="touch"), "got an object, expected a place on a tissue"),
        (lambda a: a["limits"][0]["when"].update(above=1), "above"),
        (lambda a: a["limits"][2]["when"].update(place="there"), "expected an object"),
    ):
        wrong = made()
        change(wrong)
        with pytest.raises(Refusal, match=sentence):
            with_assessment("mine", wrong, organ)


def test_the_camera_that_is_judged_is_the_one_that_is_shown(organ):
    """Lens, direction and angle of the picture are those of the drawn laparoscope."""
    published = with_assessment("mine", made(), organ)
    (camera,) = scenario.draw_task(published).task.cameras
    tool = published.scene.instruments[1].tool
    shown = place_scope(tool, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))

    assert camera.instrument == 1
    assert camera.field_of_view == pytest.approx(shown.field_of_view)
    np.testing.assert_allclose(camera.forward, shown.axes[2], atol=1e-9)
    lens = np.asarray(shown.target) - shown.distance * shown.axes[2]
    np.testing.assert_allclose(camera.at, lens, atol=1e-9)


def test_an_object_that_is_moved_needs_a_space():
    new = author.new_assessment("organ", {"en": "Stone"}, stones=["stone"])
    new, stone = author.add_place(new, "stone", {"object": "stone"})

    with pytest.raises(AuthorError, match="to: got none, expected a space to carry it to"):
        author.add_step(new, "carry", stone)


def test_the_verbs_write_it(tmp_path, capsys):
    path = tmp_path / "task.json"
    new = author.new_assessment("organ", {"en": "Stone"}, stones=["stone"])
    path.write_text(json.dumps(new), encoding="utf-8")

    def call(*words: str) -> int:
        return main(["scenario", *words])

    step = ["step", str(path), "--add"]
    assert call(*step, "carry", "--at", "object:stone", "--space", "space:0,0,0.1,0.02") == 0
    assert call(*step, "remove", "--at", "stone", "--space", "space-2") != 0
    assert "expected region:" in capsys.readouterr().err
    assert call(*step, "touch", "--at", "object:sand") != 0
    assert "expected object: and one of stone" in capsys.readouterr().err
    assert call(*step, "grasp", "--at", "stone", "--space", "space") != 0
    assert "--space: got one to grasp, expected none" in capsys.readouterr().err
    assert call("limit", str(path), "--add", "loose", "--at", "stone") == 0
    written = json.loads(path.read_text(encoding="utf-8"))
    assert written["places"] == {"stone": {"object": "stone"},
                                 "space": {"space": [0.0, 0.0, 0.1, 0.02]}}  # fmt: skip
    assert written["steps"][0]["to"] == "space"
    assert written["limits"][0]["when"] == {"measure": "loose", "place": "stone"}
    assert author.remove_unused_places(written)["places"] == written["places"]
