# SPDX-License-Identifier: GPL-3.0-or-later
"""Instruments of capsules: chosen by a designer, published, and told by the command line."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
import pytest
from organs import make_organ
from palpate import scenario
from palpate.cli.main import main
from palpate.runs.costs import press_costs
from palpate_editor.chart import keep_known
from palpate_editor.compile import compile_organ
from palpate_editor.document.files import pack_organ, read_organ, unpack_organ, write_organ
from palpate_editor.publish import publish
from palpate_editor.truth import TruthError, solve_truth

SPLEEN = make_organ()
ROOT = Path(__file__).resolve().parents[2]


def with_tool(length: float, **fields):
    return replace(SPLEEN, tool=replace(SPLEEN.tool, length=length, **fields))


def test_a_length_makes_a_capsule_that_a_trocar_over_the_organ_turns():
    scene = compile_organ(with_tool(0.02, trocar_height=0.1, friction=0.1))
    instrument = scene.instruments[0]

    (capsule,) = instrument.tool.capsules
    assert capsule.from_ == pytest.approx([0, 0, 0])
    assert capsule.to == pytest.approx([0, 0, 0.02])
    x = SPLEEN.surface.vertices
    middle = 0.5 * (x.min(axis=0) + x.max(axis=0))
    assert instrument.trocar[:2] == pytest.approx(middle[:2], abs=0.01)
    assert instrument.trocar[2] == pytest.approx(x[:, 2].max() + 0.1, abs=1e-3)
    assert instrument.tool.friction == 0.1

    assert compile_organ(with_tool(0.02, trocar_height=0.0)).instruments[0].trocar is None
    ball = compile_organ(SPLEEN).instruments[0]
    assert ball.tool.capsules == [] and ball.trocar is None


def test_the_command_line_makes_an_instrument_and_refuses_what_has_no_effect(tmp_path, capsys):
    source, made = tmp_path / "spleen.organ", tmp_path / "probe.organ"
    write_organ(source, SPLEEN)
    call = ["material", str(source), "--out", str(made)]

    assert main([*call, "--tool-length", "20mm", "--trocar-height", "90mm"]) == 0
    tool = read_organ(made).tool
    assert (tool.length, tool.trocar_height) == pytest.approx((0.02, 0.09))
    capsys.readouterr()
    assert main([*call, "--trocar-height", "90mm"]) == 1
    assert "a ball has no shaft that would pass a trocar" in capsys.readouterr().err
    assert main([*call, "--tool-length", "80mm"]) == 1
    assert "length" in capsys.readouterr().err


def test_documents_of_before_have_balls_and_charts_of_them_keep_their_key():
    content, arrays = pack_organ(SPLEEN)
    content = json.loads(json.dumps(content))
    del content["tool"]["jaw_opening"], content["tool"]["grip_force"]
    assert unpack_organ(content, arrays, 15, "old.organ").tool == SPLEEN.tool
    del content["tool"]["length"], content["tool"]["trocar_height"]
    assert unpack_organ(content, arrays, 14, "old.organ").tool == SPLEEN.tool

    known, _ = pack_organ(SPLEEN)
    keep_known(known)
    assert "length" not in known["tool"] and "trocar_height" not in known["tool"]
    other, _ = pack_organ(with_tool(0.02))
    keep_known(other)
    assert other["tool"]["length"] == 0.02


def test_a_published_instrument_is_read_as_it_was_and_damage_is_refused(tmp_path):
    path = tmp_path / "probe.palpate"
    publish(with_tool(0.02, friction=0.1), path)

    read = scenario.read(path).scene.instruments[0]

    assert [list(c.to) for c in read.tool.capsules] == [[0, 0, 0.02]]
    assert read.trocar == pytest.approx(
        compile_organ(with_tool(0.02)).instruments[0].trocar, abs=1e-12
    )


def test_a_jaw_opening_makes_a_grasper_and_what_has_none_closes_on_nothing(tmp_path, capsys):
    scene = compile_organ(with_tool(0.02, radius=0.0012, jaw_opening=0.5, grip_force=4.0))
    tool = scene.instruments[0].tool
    assert [list(c.from_) for c in tool.capsules] == [[0, 0.0012, 0], [0, -0.0012, 0]]
    assert tool.jaws.hinge[2] == pytest.approx(0.02 + 2 * 0.0012)
    assert (tool.jaws.open, tool.jaws.grip) == (0.5, 4.0)
    path = tmp_path / "grasper.palpate"
    publish(with_tool(0.02, radius=0.0012, jaw_opening=0.5), path)
    assert scenario.read(path).scene.instruments[0].tool.jaws.open == 0.5

    source = tmp_path / "spleen.organ"
    write_organ(source, SPLEEN)
    assert main(["tool", str(source), "probe", "--grip-force", "3N"]) == 1
    assert "what has no jaws closes on nothing" in capsys.readouterr().err
    assert main(["tool", str(source), "--jaw-opening", "0.4"]) == 1
    assert "a ball has no jaws" in capsys.readouterr().err
    made = tmp_path / "grasper.organ"
    assert main(["tool", str(source), "grasper", "-o", str(made)]) == 0
    assert "two jaws of 1.2 mm, 20 mm long" in capsys.readouterr().out
    assert read_organ(made).tool.jaw_opening == 0.52


def test_the_truth_of_a_ball_is_not_given_for_an_instrument():
    with pytest.raises(TruthError, match="tool.length: got 0.02 m, expected 0"):
        solve_truth(with_tool(0.02))


def test_a_probe_presses_the_organ_through_its_trocar():
    scene = compile_organ(with_tool(0.02, trocar_height=0.1, radius=0.004))
    world = palpate.World(scene)
    top = SPLEEN.surface.vertices[SPLEEN.surface.vertices[:, 2].argmax()]
    felt = np.zeros(3)
    for k in range(400):
        height = 0.006 - 2e-5 * k
        sample = palpate.HapticSample(position=top + [0, 0, 0.004 + height])
        felt = np.array(palpate.tick(scene, sample, 1e-3, world).force)

    tool = world.instruments[0].tool
    assert not world.alarm
    assert felt[2] > 0.01
    x, y, z, w = tool.orientation
    along = np.array([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)])
    away = np.array(scene.instruments[0].trocar) - tool.position
    assert np.linalg.norm(np.cross(along, away)) < 1e-3 * np.linalg.norm(away)


def test_what_an_instrument_costs_is_told_of_ticks_in_which_it_touches(tmp_path, capsys):
    """Most of a grasp goes by in the air, where jaws cost next to nothing."""
    source, made = ROOT / "meshes" / "published" / "spleen.organ", tmp_path / "made.organ"

    assert main(["tool", str(source), "grasper", "-o", str(made), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    grasp = press_costs(compile_organ(read_organ(made)))
    assert told["contact_us"] > 3e6 * grasp.pairs[0].median
    assert not told["ended_by_alarm"]

    for kind, while_it in (("grasper", "holds"), ("ball", "touches")):
        assert main(["tool", str(source), kind]) == 0
        assert f" us while it {while_it}: " in capsys.readouterr().out
