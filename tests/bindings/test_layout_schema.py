# SPDX-License-Identifier: BSD-3-Clause
"""A layout as it is written keeps to its schema, and what does not is refused."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import palpate
import pytest
from palpate.files.refusal import Refusal
from palpate.layout import document, layout_file
from palpate.layout.document import (
    History,
    Layout,
    LayoutError,
    PlacedBody,
    PlacedScenery,
    PlacedStone,
    SceneTool,
    TouchingPair,
)
from palpate.layout.layout_file import read_layout, write_layout

SHIPPED = Path(__file__).resolve().parents[2] / "meshes" / "scenes"
SCHEMA = Path(palpate.__file__).parent / "schemas" / "layout.schema.json"
LAYOUT = Layout(
    title="Kidney",
    bodies=(
        PlacedBody("kidney", "kidney.palpate", "0" * 64, weightless=True, tool_friction=(0.05,)),
        PlacedBody("bowel", "b.palpate", ""),
    ),
    pairs=(TouchingPair("kidney", "bowel", thickness=4e-4, friction=0.05),),
    stones=(PlacedStone("stone", "stone.obj", "1" * 64, scale=1e-3),),
    scenery=(PlacedScenery("tray", "tray.obj", "2" * 64, stops=("kidney",)),),
    gravity=(0.0, 0.0, -9.81),
    fluid=(1000.0, 1e-3),
    tools=(SceneTool("grasper", 1.2e-3, 0.01, 0.4, 0.3, trocar=(0.0, 0.0, 0.2)),),
)


@pytest.fixture(scope="module")
def schema() -> jsonschema.Draft202012Validator:
    rules = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(rules)
    return jsonschema.Draft202012Validator(rules)


def write(folder: Path) -> tuple[Path, dict[str, Any]]:
    path = folder / "two.layout.json"
    history = document.apply(History(Layout()), LAYOUT)
    history = document.apply(history, document.remove_part(LAYOUT, "stone"))
    write_layout(path, document.apply(document.undo(history), LAYOUT))
    return path, json.loads(path.read_text(encoding="utf-8"))


def test_what_is_written_is_as_the_schema_says(schema, tmp_path):
    path, data = write(tmp_path)

    schema.validate(data)

    assert data["before"] and data["now"]["stones"] and data["now"]["scenery"]
    assert read_layout(path).now == LAYOUT


def test_the_layouts_that_ship_are_as_the_schema_says_once_they_are_written(schema, tmp_path):
    for path in SHIPPED.glob("*.layout.json"):
        write_layout(tmp_path / path.name, read_layout(path))

        schema.validate(json.loads((tmp_path / path.name).read_text(encoding="utf-8")))


DAMAGES: dict[str, Callable[[dict[str, Any]], Any]] = {
    "now.title": lambda data: data["now"].update(title=3),
    "now.bodies": lambda data: data["now"].update(bodies="kidney"),
    "now.extra": lambda data: data["now"].update(extra=1),
    "no gravity": lambda data: data["now"].pop("gravity"),
    "kidney.position": lambda data: data["now"]["bodies"][0].update(position=[0.0, 0.0]),
    "weightless": lambda data: data["now"]["bodies"][0].update(weightless=9.8),
    "kidney.tool_friction": lambda data: data["now"]["bodies"][0].update(tool_friction=[-0.1]),
    "tray.tool_friction": lambda data: data["now"]["scenery"][0].update(tool_friction=[0.1, 0.2]),
    "kidney.rotation": lambda data: data["now"]["bodies"][0].update(rotation=[0.0, 0.0, 1e9]),
    "a/b.name": lambda data: data["now"]["stones"][0].update(name="a/b"),
    "stone.position": lambda data: data["now"]["stones"][0].update(position=[1e300, 0.0, 0.0]),
    "0.name": lambda data: data["now"]["bodies"][0].update(name=""),
    "stone.density": lambda data: data["now"]["stones"][0].update(density=0.0),
    "stone.scale": lambda data: data["now"]["stones"][0].update(scale=-1.0),
    "stone.spheres": lambda data: data["now"]["stones"][0].update(spheres=3),
    "tray.friction": lambda data: data["now"]["scenery"][0].update(friction=-0.1),
    "scenery[0].stops": lambda data: data["now"]["scenery"][0].update(stops=["kidney"] * 2),
    "pairs[0].thickness": lambda data: data["now"]["pairs"][0].update(thickness=-1e-4),
    "pairs[0].stiffness": lambda data: data["now"]["pairs"][0].update(stiffness=1e14),
    "pairs[0].damping": lambda data: data["now"]["pairs"][0].update(damping=1.5),
    "pairs[0].friction": lambda data: data["now"]["pairs"][0].update(friction=-0.1),
    "gravity": lambda data: data["now"].update(gravity=[1.0]),
    "gravity ": lambda data: data["now"].update(gravity=[0.0, 0.0, -1e9]),
    "fluid": lambda data: data["now"].update(fluid=[1000.0, -1.0]),
    "tools[0].kind": lambda data: data["now"]["tools"][0].update(kind="spoon"),
    "tools[0].radius": lambda data: data["now"]["tools"][0].update(radius=0.0),
    "before": lambda data: data.update(before={}),
    "assessment": lambda data: data["now"].update(assessment=3),
}


@pytest.mark.parametrize("where", DAMAGES)
def test_a_damaged_layout_is_refused_by_schema_and_reader_alike(schema, tmp_path, where):
    path, data = write(tmp_path)
    DAMAGES[where](data)
    path.write_text(json.dumps(data), encoding="utf-8")

    assert not schema.is_valid(data)
    with pytest.raises(Refusal, match=where.removeprefix("no ").strip().split("[")[0]):
        read_layout(path)


UNREADABLE = {
    "pairs[0].damping": {"pairs": (TouchingPair("kidney", "bowel", damping=math.inf),)},
    "gravity": {"gravity": (0.0, 0.0, math.nan)},
    "fluid": {"fluid": (math.inf, 0.0)},
    "tools[0].jaw_opening": {"tools": (replace(LAYOUT.tools[0], jaw_opening=math.nan),)},
    "kidney.position": {"bodies": (replace(LAYOUT.bodies[0], position=(math.nan, 0.0, 0.0)),)},
    "stone.scale": {"stones": (replace(LAYOUT.stones[0], scale=math.inf),)},
    "layout: got '\\udcff'": {"title": "\udcff"},
}


@pytest.mark.parametrize("where", UNREADABLE)
def test_what_could_not_be_read_again_is_not_written(tmp_path, where):
    path, _ = write(tmp_path)
    before = path.read_bytes()
    wrong = replace(LAYOUT, **{"pairs": (), "scenery": (), **UNREADABLE[where]})

    for history in (History(wrong), History(Layout(), (wrong,)), History(Layout(), (), (wrong,))):
        with pytest.raises(LayoutError, match=f"^(input: )?{re.escape(where)}"):
            write_layout(path, history)

    assert path.read_bytes() == before


def test_of_more_steps_than_a_file_has_room_for_the_older_half_is_forgotten(tmp_path, monkeypatch):
    monkeypatch.setattr(layout_file, "MOST_BYTES", 10_000)
    path, steps = tmp_path / "a.layout.json", [Layout(title=str(n) * 1000) for n in range(10)]

    write_layout(path, History(Layout(), tuple(steps)))

    assert read_layout(path).before == tuple(steps[5:])
    with pytest.raises(LayoutError, match="bytes, expected at most 10000"):
        write_layout(path, History(Layout(title="a" * 10_000)))


def make_older(data: dict[str, Any]) -> None:
    """Without what was placed says since versions 5 and 6, and pairs since 7."""
    for layout in (data["now"], *data["before"], *data["undone"]):
        for pair in layout["pairs"]:
            del pair["friction"]
        for part in (*layout["bodies"], *layout["stones"], *layout["scenery"]):
            part.pop("weightless", None)
            del part["tool_friction"]


def test_organs_of_a_layout_of_version_6_slide_on_each_other(tmp_path):
    path, data = write(tmp_path)
    data["version"] = 6
    for layout in (data["now"], *data["before"], *data["undone"]):
        for pair in layout["pairs"]:
            del pair["friction"]
    path.write_text(json.dumps(data), encoding="utf-8")

    assert [pair.friction for pair in read_layout(path).now.pairs] == [0.0]
    data["now"]["pairs"][0]["friction"] = 0.0
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(Refusal, match="pairs.friction: got one in a layout of version 6"):
        read_layout(path)


def test_a_layout_of_version_5_rubs_alike_on_all(tmp_path):
    path, data = write(tmp_path)
    data["version"] = 5
    for layout in (data["now"], *data["before"], *data["undone"]):
        for pair in layout["pairs"]:
            del pair["friction"]
        for part in (*layout["bodies"], *layout["stones"], *layout["scenery"]):
            del part["tool_friction"]
    path.write_text(json.dumps(data), encoding="utf-8")

    read = read_layout(path).now
    assert read.bodies[0].weightless and {part.tool_friction for part in read.parts} == {()}
    data["now"]["stones"][0]["tool_friction"] = []
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(Refusal, match="stones.tool_friction: got one in a layout of version 5"):
        read_layout(path)


def test_a_layout_of_version_3_has_no_task(tmp_path):
    path, data = write(tmp_path)
    data["version"] = 3
    make_older(data)
    for layout in (data["now"], *data["before"], *data["undone"]):
        del layout["assessment"]
    path.write_text(json.dumps(data), encoding="utf-8")

    assert read_layout(path).now.assessment == ""
    data["now"]["assessment"] = ""
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(Refusal, match="assessment: got some in a layout of version 3"):
        read_layout(path)


def test_a_task_that_is_no_assessment_is_refused(tmp_path):
    path, data = write(tmp_path)
    data["now"]["assessment"] = "{}"
    path.write_text(json.dumps(data), encoding="utf-8")

    with pytest.raises(Refusal, match="assessment: got no assessment, expected JSON that says"):
        read_layout(path)


def test_a_layout_of_version_4_has_no_weightless_bodies(tmp_path):
    path, data = write(tmp_path)
    data["version"] = 4
    make_older(data)
    path.write_text(json.dumps(data), encoding="utf-8")

    assert [body.weightless for body in read_layout(path).now.bodies] == [False, False]
    data["now"]["bodies"][0]["weightless"] = True
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(Refusal, match="weightless: got one in a layout of version 4"):
        read_layout(path)
