# SPDX-License-Identifier: BSD-3-Clause
"""`palpate scene` with stones and scenery: from meshes to a file that is played."""

from __future__ import annotations

import contextlib
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import palpate
import pytest
from palpate.assessment.check_problem import Problem
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.layout.check import check
from palpate.layout.layout_file import ADDED, read_layout
from stones import HALF, make_stone_mesh, make_table
from test_layout import write_organ
from test_scene_verb import say


def write_mesh(path: Path, mesh: palpate.SurfaceMesh) -> Path:
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(mesh.vertices).tolist()]
    rows += [f"f {a} {b} {c}" for a, b, c in (np.asarray(mesh.triangles) + 1).tolist()]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def layout(tmp_path, capsys) -> Path:
    """An organ, a stone on the table beside it, and the table, which stops the organ."""
    organ, path = write_organ(tmp_path), tmp_path / "stone.layout.json"
    stone = write_mesh(tmp_path / "stone.obj", make_stone_mesh())
    table = write_mesh(tmp_path / "table.obj", make_table())
    say(capsys, "new", "-o", path, "--title", "A stone")
    say(capsys, "add", path, organ, "--name", "organ")
    told = say(capsys, "add", path, stone, "--as", "stone", "--unit", "mm", "--at", "50,0,-55.9",
               "--density", "1900kg/m3", "--friction", 0.4)  # fmt: skip
    assert told["code"] == 0
    assert say(capsys, "add", path, table, "--as", "scenery")["code"] == 0
    assert say(capsys, "pair", path, "organ", "table")["code"] == 0
    return path


def test_from_meshes_to_a_file_that_is_pressed_and_replays(layout, tmp_path, capsys):
    out, record = tmp_path / "stone.palpate", tmp_path / "stone.prec"

    told = say(capsys, "publish", layout, "-o", out)

    assert (told["code"], told["out"]) == (0, str(out))
    scene = palpate.scenario.read(out).scene
    (stone,), (table,) = scene.rigid, scene.scenery
    volume = 4.0 / 3.0 * np.pi * 1e-9 * HALF.prod()
    assert stone.mass == pytest.approx(1900.0 * volume, rel=0.06)
    assert told["stones"][0]["mass_kg"] == stone.mass
    assert 0.0 < told["stones"][0]["hull_gap_m"] < 8e-4
    assert len(stone.sphere_radii) == 14 and stone.friction == 0.4
    assert list(table.bodies) == [0]
    assert np.allclose(stone.position, (0.05, 0.0, -0.0559), atol=1e-6)
    kept = json.loads(palpate.scenario.read(out).authored)["content"]["layout"]
    assert kept["stones"][0]["name"] == "stone" and kept["scenery"][0]["stops"] == ["organ"]
    assert main(["press", str(out), "--at", "0,0,80", "--record", str(record)]) == 0
    assert main(["replay", str(record)]) == 0
    assert "the same bits" in capsys.readouterr().out


def test_each_pair_of_instrument_and_surface_has_a_coefficient_of_its_own(layout, tmp_path, capsys):
    out = tmp_path / "stone.palpate"
    say(capsys, "tool", layout, "--kind", "grasper", "--friction", 0.5)
    assert say(capsys, "publish", layout, "-o", out)["code"] == 0
    assert palpate.scenario.read(out).scene.instruments[0].pair_friction == []

    told = say(capsys, "place", layout, "stone", "--tool-friction", 0.3)
    assert told["stones"][0]["tool_friction"] == [0.3]
    say(capsys, "place", layout, "organ", "--tool-friction", 0.05)
    assert main(["scene", "place", str(layout), "organ", "--by", "0,0,0"]) == 0
    assert "; instruments rub with 0.05" in capsys.readouterr().out
    assert say(capsys, "publish", layout, "-o", out)["code"] == 0

    (instrument,) = palpate.scenario.read(out).scene.instruments
    assert instrument.pair_friction == [0.05, 0.5, 0.3]  # organ, table, stone
    told = say(capsys, "place", layout, "stone", "--tool-friction", "own")
    assert told["stones"][0]["tool_friction"] == []


def test_a_coefficient_of_a_tool_that_slides_on_everything_is_refused(layout, capsys):
    say(capsys, "tool", layout, "--kind", "ball", "--friction", 0)
    say(capsys, "place", layout, "organ", "--tool-friction", 0.05)

    problems = say(capsys, "check", layout, "--quick")["problems"]

    assert any("pair_friction [-]: got 0.05, expected 0 for all" in p["message"] for p in problems)
    assert main(["scene", "place", str(layout), "organ", "--tool-friction", "wet"]) == 2
    assert "got 'wet', expected 0 to 2, or own" in capsys.readouterr().err


def test_stones_and_scenery_are_changed_undone_and_removed(layout, capsys):
    before = json.loads(layout.read_text(encoding="utf-8"))["now"]

    moved = say(capsys, "place", layout, "stone", "--by", "0,10,0", "--turn", "0,0,90",
                "--spheres", 20, "--density", "2500kg/m3")  # fmt: skip

    (stone,) = moved["stones"]
    assert stone["position_m"] == pytest.approx([0.05, 0.01, -0.0559])
    assert (stone["spheres"], stone["density_kg_per_m3"]) == (20, 2500.0)
    say(capsys, "undo", layout)
    assert json.loads(layout.read_text(encoding="utf-8"))["now"] == before
    assert say(capsys, "redo", layout)["stones"] == moved["stones"]
    assert say(capsys, "pair", layout, "table", "organ", "--remove")["scenery"][0]["stops"] == []
    say(capsys, "pair", layout, "table", "organ")
    assert say(capsys, "place", layout, "organ", "--remove")["scenery"][0]["stops"] == []
    assert say(capsys, "place", layout, "stone", "--remove")["stones"] == []
    assert say(capsys, "place", layout, "table", "--remove")["scenery"] == []


def test_what_begins_in_something_is_told_by_its_name(layout, capsys):
    say(capsys, "place", layout, "stone", "--at", "0,0,0")
    (problem,) = say(capsys, "check", layout, "--quick")["problems"]
    assert problem["severity"] == "error"
    assert "rigid[0] (stone): got sphere" in problem["message"]
    assert "deep in body 0 (organ)" in problem["message"]
    say(capsys, "place", layout, "stone", "--at", "50,0,-55.9")
    say(capsys, "place", layout, "table", "--at", "0,0,45")
    (problem,) = say(capsys, "check", layout, "--quick")["problems"]
    assert "scenery[0] (table): got vertex" in problem["message"]


def test_a_stone_that_nothing_bears_and_scenery_that_stops_nothing_are_told(layout, capsys):
    say(capsys, "pair", layout, "table", "organ", "--remove")
    say(capsys, "place", layout, "stone", "--at", "300,0,0")

    floats = say(capsys, "check", layout)
    falls = say(capsys, "check", layout, "--gravity", "0,0,-9.81")

    said = {problem["where"]: problem for problem in floats["problems"]}
    assert floats["code"] == falls["code"] == 0
    assert said["table"]["severity"] == "note"
    assert "stops instruments and stones alone" in said["table"]["message"]
    assert "stones float" in said["scene"]["message"] and "stone" not in said
    said = {problem["where"]: problem for problem in falls["problems"]}
    assert said["stone"]["severity"] == "warning" and "it falls" in said["stone"]["message"]
    assert "scene" not in said


def test_an_organ_that_gravity_pulls_far_from_where_it_was_scanned_is_told(layout, capsys):
    say(capsys, "pair", layout, "table", "organ", "--remove")

    def weigh() -> list[Problem]:
        heavy = replace(read_layout(layout).now, gravity=(0.0, 0.0, -2000.0))
        return [each for each in check(layout, heavy).problems if each.where == "organ"]

    usual = say(capsys, "check", layout, "--gravity", "0,0,-9.81")

    (said,) = weigh()
    assert said.severity == "warning" and "it was scanned as it lies" in said.message
    assert "organ" not in {each["where"] for each in usual["problems"]}
    assert "place LAYOUT organ --weightless" in said.message
    assert say(capsys, "place", layout, "organ", "--weightless")["bodies"][0]["weightless"]
    assert weigh() == []


def test_gravity_acts_on_a_stone_but_not_on_a_weightless_organ(layout, tmp_path, capsys):
    out = tmp_path / "stone.palpate"
    assert main(["scene", "place", str(layout), "stone", "--weightless"]) == 2
    assert "expected it for a body: this keeps its shape" in capsys.readouterr().err
    say(capsys, "place", layout, "organ", "--weightless")
    say(capsys, "place", layout, "stone", "--by", "0,0,5")
    say(capsys, "set", layout, "--gravity", "0,0,-9.81")
    assert say(capsys, "publish", layout, "-o", out)["code"] == 0
    assert main(["scene", "place", str(layout), "organ", "--at", "0,0,1"]) == 0
    assert "; weightless" in capsys.readouterr().out

    scene = palpate.scenario.read(out).scene
    world = palpate.World(scene)
    for _ in range(20):
        palpate.tick(scene, palpate.HapticSample(position=(0.0, 0.0, 0.2)), 1e-3, world)

    assert scene.bodies[0].weightless
    moved = np.asarray(world.bodies[0].tissue.position) - scene.bodies[0].tissue.rest_position
    assert np.abs(moved).max() < 1e-7  # of rounding
    assert world.rigid[0].velocity[2] < -0.05


def test_a_published_stone_lies_on_its_table_under_gravity(layout, tmp_path, capsys):
    out = tmp_path / "stone.palpate"
    told = say(capsys, "publish", layout, "-o", out, "--gravity", "0,0,-9.81")
    assert (told["code"], told["out"]) == (0, str(out))
    scene = palpate.scenario.read(out).scene
    assert scene.gravity[2] == -9.81

    world, sample = palpate.World(scene), palpate.HapticSample(position=(0.0, 0.0, 0.2))
    for _ in range(600):
        palpate.tick(scene, sample, 1e-3, world)

    (stone,) = world.rigid
    lowest = np.asarray(scene.rigid[0].mesh.vertices)[:, 2].min()
    assert np.linalg.norm(stone.velocity) < 0.02
    assert stone.position[2] == pytest.approx(-0.06 - lowest, abs=7e-4)


def test_a_stone_of_a_fine_mesh_is_nothing_to_tell_of(layout, tmp_path, capsys):
    write_mesh(tmp_path / "stone.obj", make_stone_mesh(fine=3))
    say(capsys, "place", layout, "stone", "--renew")

    assert say(capsys, "check", layout, "--quick")["problems"] == []


def test_a_scene_is_in_a_fluid_and_touched_by_a_tool_that_its_layout_says(layout, tmp_path, capsys):
    out = tmp_path / "stone.palpate"
    told = say(capsys, "tool", layout, "--radius", "1.2mm", "--length", "10mm",
               "--grip-force", "3N", "--trocar", "0,0,150")  # fmt: skip
    assert told["tools"][0]["jaw_opening"] == 0.52  # as usual of a grasper
    assert read_layout(layout).now.tools[0].trocar == (0.0, 0.0, 0.15)

    say(capsys, "publish", layout, "-o", out, "--fluid", "1000,0.001")

    scene = palpate.scenario.read(out).scene
    assert (scene.fluid.density, scene.fluid.viscosity) == (1000.0, 0.001)
    (instrument,) = scene.instruments
    assert (instrument.tool.radius, instrument.tool.jaws.grip) == (0.0012, 3.0)
    np.testing.assert_array_equal(instrument.trocar, (0.0, 0.0, 0.15))
    assert say(capsys, "tool", layout, "--remove")["tools"] == []


def test_a_layout_keeps_its_words_gravity_and_fluid(layout, tmp_path, capsys):
    out = tmp_path / "stone.palpate"
    told = say(capsys, "set", layout, "--title", "A stone", "--task-tr", "Taşı alın",
               "--gravity", "0,0,-9.81", "--fluid", "1000,0.001")  # fmt: skip
    assert (told["title"], told["gravity_m_per_s2"]) == ("A stone", [0.0, 0.0, -9.81])

    say(capsys, "publish", layout, "-o", out)

    made = palpate.scenario.read(out)
    assert made.scene.gravity[2] == -9.81 and made.scene.fluid.density == 1000.0
    assert (made.title, made.languages["tr"].task) == ("A stone", "Taşı alın")
    told = say(capsys, "set", layout, "--fluid", "none", "--gravity", "none")
    assert (told["title"], told["fluid"], told["gravity_m_per_s2"]) == ("A stone", None, None)
    assert say(capsys, "undo", layout)["fluid"] == [1000.0, 0.001]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("set",), "set: got nothing to keep, expected one at least of its options"),
        (("tool", "--radius", "1m"), "--radius: got 1, expected 1e-05 to 0.2"),
        (("tool", "--kind", "ball", "--trocar", "0,0,9"), "--trocar: got one for a ball"),
        (
            ("tool", "--kind", "ball", "--length", "3mm"),
            "--length: got one for a ball, on which it has no effect, expected none",
        ),
        (("tool", "--kind", "ball", "--grip-force", "3N"), "--grip-force: got one for a ball"),
        (("tool", "--kind", "probe", "--jaw-opening", "0.3"), "--jaw-opening: got one for a probe"),
        (
            ("tool", "--kind", "syringe", "--grip-force", "3N"),
            "--grip-force: got one for a syringe",
        ),
        (("check", "--fluid", "water"), "--fluid: got 'water', expected DENSITY,VISCOSITY"),
        (("check", "--fluid=-1,0"), "--fluid: got '-1,0', expected DENSITY,VISCOSITY"),
    ],
)
def test_a_tool_or_a_fluid_that_cannot_be_is_refused(layout, capsys, words, said):
    with contextlib.suppress(SystemExit):
        assert main(["scene", words[0], str(layout), *words[1:]]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("fluid", [1000.0], "fluid: got 1 numbers, expected 2, or none"),
        ("tools", 2, "tools: got 2, expected one, or none"),
        ("kind", "spoon", "tools[0].kind: got 'spoon', expected one of"),
        ("trocar", [0.0], "tools[0].trocar: got 1 numbers, expected 3, or none"),
    ],
)
def test_a_layout_file_with_a_tool_that_cannot_be_is_refused(layout, capsys, name, value, said):
    say(capsys, "tool", layout)
    made = json.loads(layout.read_text(encoding="utf-8"))
    now = made["now"]
    if name == "tools":
        now["tools"] *= value
    else:
        (now if name == "fluid" else now["tools"][0])[name] = value
    layout.write_text(json.dumps(made), encoding="utf-8")

    with pytest.raises(Refusal, match=re.escape(said)):
        read_layout(layout)


def make_older(layout: dict[str, Any]) -> None:
    """Without what was placed says since versions 5 and 6, and pairs since 7."""
    for pair in layout["pairs"]:
        pair.pop("friction", None)
    for name in ("bodies", "stones", "scenery"):
        for part in layout.get(name, ()):
            part.pop("weightless", None)
            del part["tool_friction"]


def test_a_layout_of_version_2_is_read(layout):
    made = json.loads(layout.read_text(encoding="utf-8"))
    made["version"] = 2
    for each in (made["now"], *made["before"], *made["undone"]):
        del each["fluid"], each["tools"], each["assessment"]
        make_older(each)
    layout.write_text(json.dumps(made), encoding="utf-8")

    assert len(read_layout(layout).now.stones) == 1


def test_a_layout_of_before_there_were_stones_is_read(layout, capsys):
    made = json.loads(layout.read_text(encoding="utf-8"))
    made["version"] = 1
    for each in (made["now"], *made["before"], *made["undone"]):
        for name in ADDED[1]:
            del each[name]
        make_older(each)
    layout.write_text(json.dumps(made), encoding="utf-8")

    assert read_layout(layout).now.stones == ()
    told = say(capsys, "place", layout, "organ", "--by", "0,0,1")
    assert (told["code"], told["stones"], told["scenery"]) == (0, [], [])
    assert json.loads(layout.read_text(encoding="utf-8"))["version"] == 7


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["place", "stone", "--fold"], 2, "this keeps its shape"),
        (["place", "organ", "--density", "2000kg/m3"], 2, "organ: got --density, which it has not"),
        (["place", "table", "--spheres", "9"], 2, "table: got --spheres, which it has not"),
        (["place", "stone", "--spheres", "7"], 2, "--spheres: got 7, expected 8 to 20"),
        (["place", "stone", "--density", "0kg/m3"], 2, "--density: got 0"),
        (["place", "stone", "--friction", "nan"], 2, "--friction: got nan"),
        (["place", "stone", "--snap", "top", "--onto", "organ/top"], 2, "stone: got no organ"),
        (["pair", "stone", "organ"], 2, "a stone touches all"),
        (["pair", "table", "table"], 2, "got a body with itself"),
        (["add", "open.obj", "--as", "stone"], 1, "got an open surface, expected a closed one"),
        (["add", "stone.obj", "--as", "stone", "--name", "big"], 1, "--unit mm"),
        (["add", "tiny.obj", "--as", "stone", "--unit", "mm"], 1, "expected 0.5 mm or more"),
        (["add", "stone.obj", "--as", "stone", "--unit", "mm"], 2, "a name that is taken"),
        (["add", "organ.palpate", "--unit", "mm", "--name", "other"], 2, "an organ has its own"),
        (["add", "organ.palpate", "--as", "stone", "--name", "other"], 1, "organ.palpate: got"),
    ],
)
def test_what_cannot_be_done_is_refused_and_leaves_the_layout_as_it_was(
    words, code, said, layout, monkeypatch, capsys
):
    monkeypatch.chdir(layout.parent)
    open_one = palpate.SurfaceMesh([(0, 0, 0), (0.01, 0, 0), (0, 0.01, 0)], [(0, 1, 2)])
    write_mesh(layout.parent / "open.obj", open_one)
    write_mesh(layout.parent / "tiny.obj", make_stone_mesh(1e-3))
    before = layout.read_bytes()

    assert main(["scene", words[0], str(layout), *words[1:]]) == code

    assert said in capsys.readouterr().err
    assert layout.read_bytes() == before


def test_a_changed_mesh_is_told_and_its_new_file_can_be_taken(layout, tmp_path, capsys):
    write_mesh(tmp_path / "stone.obj", make_stone_mesh(0.5))

    (problem,) = say(capsys, "check", layout, "--quick")["problems"]
    assert problem["where"] == "stone" and "another file than was added" in problem["message"]
    say(capsys, "place", layout, "stone", "--renew")
    assert say(capsys, "check", layout, "--quick")["code"] == 0
