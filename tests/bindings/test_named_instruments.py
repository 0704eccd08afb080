# SPDX-License-Identifier: BSD-3-Clause
"""A scenario names its instruments: kinds, trocar, friction, grip limit, handle, and several."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import jsonschema
import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment import author, author_tools
from palpate.assessment.author import AuthorError
from palpate.assessment.check import find_problems
from palpate.assessment.hands import make_hands
from palpate.assessment.instruments import find_handle
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.assessment.selfplay import attempt
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.runs.costs import press_costs
from palpate.runs.play import open_play

MESHES = Path(__file__).resolve().parents[2] / "meshes"
SPLEEN = MESHES / "published" / "spleen.palpate"
PROBE = MESHES / "scenarios" / "spleen_probe.json"
SCHEMA = Path(palpate.__file__).parent / "schemas" / "assessment.schema.json"
GRASPER = {"kind": "grasper", "radius_m": 0.0012, "length_m": 0.02, "friction": 0.6}
GRASPER |= {"jaw_opening_rad": 0.4, "grip_force_N": 6.0, "trocar_height_m": 0.1}


def name_two(change: dict | None = None) -> dict:
    """A probe over the organ, and a grasper 50 mm beside it."""
    said = copy.deepcopy(read_assessment(PROBE))
    del said["tools"]["probe"]["trocar_m"]
    said["tools"]["probe"]["trocar_height_m"] = 0.12
    said["tools"] = {
        "probe": {**said["tools"]["probe"], "instrument": 0},
        "grasper": {**GRASPER, "trocar_side_m": 0.05, "instrument": 1, **(change or {})},
    }
    for row in (*said["steps"], *(limit["when"] for limit in said["limits"])):
        row["tool"] = "probe"
    return said


@pytest.fixture(scope="module")
def organ() -> scenario.Scenario:
    return scenario.read(SPLEEN)


@pytest.fixture(scope="module")
def two(organ) -> scenario.Scenario:
    return with_assessment(PROBE, name_two(), organ)


def with_other_text(made: scenario.Scenario, said: dict) -> scenario.Scenario:
    return scenario.Scenario(
        scene=made.scene, assessment=json.dumps(said), assessment_arrays=made.assessment_arrays
    )


def test_an_assessment_says_jaws_and_a_second_instrument(two):
    first, second = two.scene.instruments
    assert first.tool.jaws is None and len(first.tool.capsules) == 1
    assert (second.tool.jaws.open, second.tool.jaws.grip) == (0.4, 6.0)
    assert second.trocar[0] - first.trocar[0] == pytest.approx(0.05)
    assert scenario.draw_task(two).task.steps[0].instrument == 0
    jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(
        name_two()
    )


@pytest.mark.parametrize(
    ("member", "value", "message"),
    [
        ("grip_force_N", 7.0, "grip_force_N: got 7, expected 6"),
        ("trocar_side_m", 2.0, "trocar_side_m: got 2, expected -0.3 to 0.3"),
        ("fulcrum_m", 3.0, "fulcrum_m: got 3, expected 0 to 2"),
        ("force_max_N", 7.0, "force_max_N: got 7, expected 5"),
        ("kind", "ball", "kind: got a ball, expected another kind"),
        ("kind", "syringe", "kind: got syringe, expected a grasper: the instrument has jaws"),
        ("kind", "scalpel", "kind: got .scalpel., expected"),
        ("trocar_m", [0, 0, 0], "trocar_height_m: got one, expected none of it beside trocar_m"),
    ],
)
def test_what_a_file_says_of_an_instrument_is_that_of_its_scene(two, member, value, message):
    wrong = name_two({member: value})
    with pytest.raises(ValueError, match=message):
        scenario.draw_task(with_other_text(two, wrong))


@pytest.mark.parametrize(
    "change",
    [
        {"radius_m": -1.0},
        {"length_m": 1e308},
        {"friction": "much"},
        {"jaw_opening_rad": 3.0},
        {"grip_force_N": float("nan")},
        {"fulcrum_m": 5.0},
        {"fulcrum_m": 0.3, "trocar_height_m": 0.0},
        {"trocar_m": [0.0, 0.0]},
        {"trocar_m": [0.0, 0.0, "high"]},
        {"trocar_m": [0.0, 0.0, float("inf")]},
        {"trocar_m": [0.0, 0.0, 0.2]},
        {"instrument": 16},
        {"instrument": -1},
        {"instrument": True},
        {"kind": ["ball"]},
        {"grip": 5.0},
    ],
)
def test_a_hostile_instrument_is_refused_in_a_sentence(organ, change):
    with pytest.raises(Refusal) as refused:
        with_assessment("changed.json", name_two(change), organ)
    assert refused.value.where.startswith("tools") and refused.value.got and refused.value.expected


def test_a_place_and_a_handle_are_kept_in_the_file_and_one_of_before_has_none(organ, tmp_path):
    said = name_two()
    del said["tools"]["grasper"]["trocar_height_m"], said["tools"]["grasper"]["trocar_side_m"]
    said["tools"]["grasper"] |= {"trocar_m": [0.1, 0.02, 0.15], "fulcrum_m": 0.32}
    said["tools"]["grasper"]["force_max_N"] = 8.0
    path = tmp_path / "two.palpate"
    scenario.write(path, with_assessment(PROBE, said, organ))

    read = scenario.read(path)

    held = read.scene.instruments[1]
    assert list(held.trocar) == [0.1, 0.02, 0.15] and held.coupling.force_max == 8.0
    assert [find_handle(read, i) for i in range(2)] == [0.0, 0.32]
    scenario.write(tmp_path / "again.palpate", read)
    assert (tmp_path / "again.palpate").read_bytes() == path.read_bytes()
    assert find_handle(organ, 0) == 0.0
    assert organ.scene.instruments[0].coupling.force_max == 5.0


@pytest.mark.parametrize("kind", ["ball", "laparoscope", "syringe"])
def test_a_kind_has_its_usual_shape(organ, kind):
    said = copy.deepcopy(read_assessment(PROBE))
    said["tools"] = {"probe": {"kind": kind}}
    tool = with_assessment(PROBE, said, organ).scene.instruments[0].tool
    assert (tool.capsules == []) == (kind == "ball")
    assert tool.radius == {"ball": 3e-3, "laparoscope": 5e-3, "syringe": 4e-4}[kind]


def test_an_arm_is_the_handle_that_the_file_says_and_the_command_may_say_otherwise(organ, tmp_path):
    said = copy.deepcopy(read_assessment(PROBE))
    said["tools"]["probe"]["fulcrum_m"] = 0.32
    path = tmp_path / "handle.palpate"
    scenario.write(path, with_assessment(PROBE, said, organ))

    assert open_play(path, "plant").fulcrum == 0.32
    assert open_play(path, "plant", fulcrum=0.0).fulcrum == 0.0
    assert open_play(path, "pointer").fulcrum == 0.0
    assert open_play(path, "plant", fulcrum=0.3).fulcrum == 0.3


# ---------------------------------------------------------------- hands


def test_a_hand_moves_its_own_instrument_and_the_other_waits_beside(two):
    drawn = scenario.draw_task(two)
    first, second = make_hands("careful", two.scene, drawn.task, 0)
    state = palpate.Progress(drawn.task).state
    begun = second.position
    for tick in range(100):
        for hand in (first, second):
            hand.move(tick * 1e-3, 1e-3, np.zeros(3), state)
    assert np.linalg.norm(np.asarray(begun) - second.position) < 1e-3  # it trembles
    assert first.mine == [0, 1, 2] and second.mine == []
    again = make_hands("careful", two.scene, drawn.task, 0)[0]
    assert again.skill == first.skill != second.skill


@pytest.mark.landing
def test_a_task_of_two_instruments_is_done_in_the_live_loop_as_beside_it(two, tmp_path, capsys):
    path, record = tmp_path / "two.palpate", tmp_path / "two.prec"
    scenario.write(path, two)
    played = attempt(two.scene, scenario.draw_task(two), "careful")
    assert played.state.outcome is palpate.Outcome.done
    assert [len(samples) for samples in played.samples] == [len(played.forces)] * 2

    code = main(["play", str(path), "--headless", "--device", "script:careful", "--record",
                 str(record), "--json"])  # fmt: skip

    verdict = json.loads(capsys.readouterr().out)["verdict"]
    assert code == 0 and verdict["outcome"] == "done" and verdict["replay_equal"]
    assert [event["tick"] for event in verdict["events"]] == [
        int(event["tick"]) for event in played.events
    ]


def test_each_instrument_is_pressed_to_know_what_it_costs(two):
    costs = press_costs(two.scene)
    assert len(costs.instruments) == len(costs.pairs) == 2
    assert all(pair.median > 1e-6 for pair in costs.pairs)


# ---------------------------------------------------------------- written


def test_instruments_are_written_step_by_step(organ):
    made = author.new_assessment("spleen", {"en": "Two"})
    made, at = author.add_place(made, "lower", {"region": "spleen/lower pole"})
    made, step = author.add_step(made, "hold", at)
    made, _ = author.add_limit(made, "force")
    assert "tool" not in made["steps"][0]

    made = author_tools.set_kind(made, "left", "grasper")
    assert [row["instrument"] for row in made["tools"].values()] == [0, 1]
    assert made["steps"][0]["tool"] == made["limits"][0]["when"]["tool"] == "tip"
    made = author_tools.set_tool(made, "left", {"grip_force_N": 4.0, "trocar_side_m": -0.05})
    made = author_tools.give_step(made, step, "left")
    made, pull = author.add_step(made, "pull", at)
    assert made["steps"][-1]["tool"] == "left"
    scene = with_assessment("written.json", made, organ).scene
    assert scene.instruments[0].tool.jaws is None
    assert scene.instruments[1].tool.jaws.grip == 4.0
    assert scene.instruments[1].trocar[0] < scene.bodies[0].tissue.rest_position[:, 0].max()

    with pytest.raises(AuthorError, match="'left' is that of step hold, step pull"):
        author_tools.remove_tool(made, "left")
    made = author_tools.set_kind(made, "view", "laparoscope")
    with pytest.raises(AuthorError, match="a laparoscope, expected a grasper"):
        author_tools.give_step(made, pull, "view")
    made = author_tools.remove_tool(made, "view")
    assert list(made["tools"]) == ["tip", "left"]
    with pytest.raises(AuthorError, match="expected one of tip, left"):
        author_tools.set_tool(made, "right", {})
    with pytest.raises(AuthorError, match="got 'grip'"):
        author_tools.set_tool(made, "left", {"grip": 3.0})


def test_the_verb_writes_instruments(tmp_path, capsys):
    task, out = tmp_path / "a.json", tmp_path / "a.palpate"
    call = ["scenario", "tool", str(task)]
    assert main(["scenario", "new", str(SPLEEN), "--title", "A", "-o", str(task)]) == 0
    assert main([*call, "--set", "left"]) == 2
    assert "expected what the new instrument left is" in capsys.readouterr().err
    assert main([*call, "--set", "tip", "--kind", "probe", "--friction", "0.2"]) == 0
    assert main([*call, "--set", "left", "--kind", "grasper", "--grip-force", "3N",
                 "--trocar=-0.05,0,0.2", "--fulcrum", "320mm"]) == 0  # fmt: skip
    step = ["scenario", "step", str(task), "--add", "grasp", "--at", "region:lower pole"]
    assert main([*step, "--tool", "left"]) == 0
    assert main(["scenario", "publish", str(SPLEEN), str(task), "-o", str(out)]) == 0

    made = scenario.read(out)
    tip, left = made.scene.instruments
    assert tip.tool.friction == 0.2 and left.tool.jaws.grip == 3.0
    assert list(left.trocar) == [-0.05, 0.0, 0.2] and find_handle(made, 1) == 0.32
    assert scenario.draw_task(made).task.steps[0].instrument == 1
    assert main([*call, "--remove", "left"]) == 2
    assert main([*call, "--set", "left", "--trocar", "1,2"]) == 2


def test_a_step_that_holds_keeps_its_grasper_and_a_hand_its_force():
    made = author.new_assessment("spleen", {"en": "One"})
    made, at = author.add_place(made, "lower", {"region": "spleen/lower pole"})
    (name,) = made["tools"]
    made = author_tools.set_kind(made, name, "grasper")
    made = author_tools.set_tool(made, name, {"force_max_N": 13.0})
    made, step = author.add_step(made, "grasp", at)

    with pytest.raises(AuthorError, match=f"expected a grasper: with '{name}' hold step {step}"):
        author_tools.set_kind(made, name, "ball")
    again = author_tools.set_kind(made, name, "grasper")
    assert again["tools"][name]["force_max_N"] == 13.0
    made["steps"].clear()
    assert author_tools.set_kind(made, name, "ball")["tools"][name]["force_max_N"] == 13.0


def shape_grasper(organ, **said):
    made = author.new_assessment("spleen", {"en": "One"})
    made, at = author.add_place(made, "lower", {"region": "spleen/lower pole"})
    (name,) = made["tools"]
    made = author_tools.set_kind(made, name, "grasper")
    made["tools"][name].update(said)
    made, _ = author.add_step(made, "grasp", at)
    return made


def test_a_grip_without_jaws_is_said_to_have_no_effect(organ):
    made = shape_grasper(organ, jaw_opening_rad=0)
    said = "grip_force_N: got 5.0, which has no effect here: what has no jaws closes on nothing"
    with pytest.raises(Refusal, match=f"{said}, expected jaws that open, or none of it"):
        with_assessment("a.json", made, organ)
    with pytest.raises(Refusal, match="jaw_opening_rad: got .*: a ball has no jaws, expected a l"):
        with_assessment("a.json", shape_grasper(organ, length_m=0), organ)


@pytest.mark.parametrize(
    ("said", "where", "words"),
    [
        ({"trocar_m": [0.0, 0.0, 0.0]}, "trocar_m", "got [0, 0, 0], which lies in an organ"),
        ({"fulcrum_m": 0.05}, "fulcrum_m", "got 0.05, expected more than 0.15"),
        ({"instrument": 3}, "instrument", "got 3, expected 0: no tool has that number"),
    ],
)
def test_check_says_which_instrument_cannot_be_held(organ, said, where, words):
    whole = find_problems(with_assessment("a.json", shape_grasper(organ), organ))
    assert not any(problem.where.startswith("tools.") for problem in whole)

    problems = find_problems(with_assessment("a.json", shape_grasper(organ, **said), organ))

    (found,) = [problem for problem in problems if problem.where.startswith("tools.")]
    assert found.where.endswith(f".{where}") and found.message.startswith(words)


def test_a_plain_number_with_a_unit_is_told_what_is_expected(tmp_path, capsys):
    task = tmp_path / "a.json"
    assert main(["scenario", "new", str(SPLEEN), "--title", "A", "-o", str(task)]) == 0
    call = ["scenario", "tool", str(task), "--set", "tip", "--kind", "grasper"]
    for option, text, expected in (
        ("--jaw-opening", "30deg", "a number of rad, without the unit"),
        ("--friction", "nan", "a number"),
    ):
        capsys.readouterr()
        assert main([*call, option, text]) == 2
        assert f"got {text!r}, expected {expected}\n" in capsys.readouterr().err
    assert main([*call, "--length", "0mm", "--jaw-opening", "0"]) == 0
