# SPDX-License-Identifier: BSD-3-Clause
"""What a tick costs part by part, bodies that sleep, and integrators, as Python has them."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.cause import change_body
from palpate.runs.costs import press_costs
from palpate.runs.live import LiveRun
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import read_scene
from stones import make_stone_scene
from surfaces import organ_scene

DT = 1e-3
STONE = Path(__file__).resolve().parents[2] / "meshes" / "published" / "kidney_stone.palpate"
SHEET = Path(__file__).resolve().parents[1] / "scenes" / "springs" / "simple_tissue.palpate"
TOUCH = PressScript(depth=2e-3, speed=0.1, hold=0.05)


@pytest.fixture(scope="module")
def scene() -> palpate.Scene:
    return organ_scene(1)


def test_a_press_has_the_cost_of_every_part(scene):
    costs = press_costs(scene, TOUCH)

    assert costs.ticks > 300
    assert not costs.alarm
    assert len(costs.bodies) == len(costs.instruments) == len(costs.pairs) == 1
    for part in (*costs.bodies, *costs.instruments, *costs.pairs):
        assert 0.0 < part.median <= part.p99 <= part.max <= costs.tick.max
    assert pickle.loads(pickle.dumps(costs)).bodies[0].median == costs.bodies[0].median


def test_scenery_and_stones_have_costs_of_their_own(scene):
    costs = press_costs(make_stone_scene(), TOUCH)

    assert not costs.alarm
    assert len(costs.scenery) == 1
    assert 0.0 < costs.rigid.median <= costs.rigid.max <= costs.tick.max
    assert pickle.loads(pickle.dumps(costs)).rigid.max == costs.rigid.max
    without = press_costs(scene, TOUCH)
    assert (without.scenery, without.rigid.max) == ((), 0.0)


def test_a_live_run_measures_its_parts_only_where_it_is_asked_to(scene):
    frames, times = write_script(find_top(scene), scene.instruments[0].tool.radius, TOUCH)
    for asked in (False, True):
        options = palpate.LoopOptions(duration=times.end, measures_costs=asked)
        with LiveRun(scene, palpate.ScriptedDevice(frames), options=options) as run:
            assert run.wait(60.0)
        report = run.finish()

        assert report.part_costs.ticks == (report.ticks if asked else 0)
        assert len(report.part_costs.pairs) == (1 if asked else 0)


def test_samples_are_some_of_each_instrument(scene):
    expected = "one of each instrument for every tick, a multiple of 1"
    with pytest.raises(ValueError, match=f"samples: got 0, expected {expected}"):
        palpate.measure_costs(scene, [])


@pytest.mark.parametrize("path", [STONE, SHEET], ids=["held everywhere", "swings"])
def test_an_organ_sleeps_where_its_plain_code_rests_and_wakes_for_the_tool(path):
    organ = change_body(read_scene(path), kernel=palpate.Kernel.reference)
    frames, times = write_script(find_top(organ), organ.instruments[0].tool.radius, TOUCH)
    hand = palpate.ScriptedDevice(frames)
    sleepy, fresh = palpate.World(organ), palpate.World(organ)
    for _ in range(120):
        palpate.tick(organ, hand.read(0.0), DT, sleepy)
    # one that never rests trembles by rounding
    assert sleepy.bodies[0].asleep == (path == STONE)
    still, time = np.array(sleepy.bodies[0].tissue.position), sleepy.bodies[0].tissue.time
    palpate.tick(organ, hand.read(0.0), DT, sleepy)
    assert sleepy.bodies[0].tissue.time == pytest.approx(time + DT)
    if sleepy.bodies[0].asleep:
        assert (sleepy.bodies[0].tissue.position == still).all()

    touched = 0
    for tick in range(round(0.5 * times.end / DT)):
        sample = hand.read(tick * DT)
        felt = palpate.tick(organ, sample, DT, sleepy).force
        expected = palpate.tick(organ, sample, DT, fresh).force
        assert np.linalg.norm(felt - expected) <= 1e-9
        touched += np.linalg.norm(felt) > 0.0
        assert not (sleepy.instruments[0].tool.touching and sleepy.bodies[0].asleep)
    assert touched > 50


def test_an_integrator_is_a_field_of_the_body(scene):
    tissue = copy.copy(scene.bodies[0].tissue)
    body = palpate.SoftBody(tissue=tissue, integrator=palpate.Integrator.implicit_euler)
    built = palpate.build_scene(palpate.Scene(bodies=[body]))

    assert built.bodies[0].kernel is palpate.Kernel.reference
    assert built.bodies[0].substeps == 1
    assert pickle.loads(pickle.dumps(built)).bodies[0].integrator is body.integrator
    body.kernel = palpate.Kernel.packed
    with pytest.raises(ValueError, match="kernel: got packed, expected automatic or reference"):
        palpate.build_scene(palpate.Scene(bodies=[body]))
    assert palpate.is_implicit(body.integrator)
    assert palpate.stable_step(tissue, body.integrator) == float("inf")
    assert palpate.stable_step(tissue, palpate.Integrator.runge_kutta_4) > 0.0


def test_a_body_has_the_iterations_of_its_integrator_and_a_file_holds_them(scene, tmp_path):
    tissue = copy.copy(scene.bodies[0].tissue)
    for name, usual in (("xpbd", 5), ("projective_dynamics", 10)):
        body = palpate.SoftBody(tissue=tissue, integrator=palpate.Integrator[name])
        assert palpate.build_scene(palpate.Scene(bodies=[body])).bodies[0].iterations == usual
        body.iterations = 7
        built = palpate.build_scene(palpate.Scene(bodies=[body]))
        palpate.scenario.write(tmp_path / "one.palpate", palpate.scenario.Scenario(scene=built))
        assert palpate.scenario.read(tmp_path / "one.palpate").scene.bodies[0].iterations == 7
        assert pickle.loads(pickle.dumps(built)).bodies[0].iterations == 7
    body.iterations = 1001
    with pytest.raises(ValueError, match="iterations: got 1001, expected 0 to 1000"):
        palpate.build_scene(palpate.Scene(bodies=[body]))
    usual_step = palpate.SoftBody(tissue=tissue, iterations=7)
    with pytest.raises(ValueError, match="iterations: got 7, expected 0 with symplectic_euler"):
        palpate.build_scene(palpate.Scene(bodies=[usual_step]))


@pytest.mark.parametrize("name", [each.name for each in palpate.Integrator])
def test_a_file_holds_the_integrator_of_a_body(scene, tmp_path, name):
    tissue = copy.copy(scene.bodies[0].tissue)
    tissue.drag = 400.0  # explicit Euler and midpoint need it
    body = palpate.SoftBody(tissue=tissue, integrator=palpate.Integrator[name])
    built = palpate.build_scene(palpate.Scene(bodies=[body]))
    made = palpate.scenario.Scenario(scene=built)

    palpate.scenario.write(tmp_path / "one.palpate", made)

    read = palpate.scenario.read(tmp_path / "one.palpate").scene.bodies[0]
    assert read.integrator is body.integrator
    assert read.substeps == made.scene.bodies[0].substeps
