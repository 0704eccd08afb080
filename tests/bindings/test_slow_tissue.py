# SPDX-License-Identifier: BSD-3-Clause
"""A scene whose tissue ticks in a thread of its own, from Python and from its file."""

from __future__ import annotations

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.runs.coupling import describe_couplings, find_borne, say_couplings
from palpate.runs.live import LiveRun
from surfaces import organ_scene, press_frames


def slow_scene(exchange_rate: float = 50.0) -> palpate.Scene:
    scene = organ_scene(2)
    scene.exchange_rate = exchange_rate
    return palpate.build_scene(scene)


def press() -> palpate.ScriptedDevice:
    return palpate.ScriptedDevice(press_frames())


def test_a_live_run_with_a_slow_tissue_is_felt_and_replays_to_the_bit(tmp_path):
    scene, path = slow_scene(), tmp_path / "slow.prec"
    options = palpate.LoopOptions(duration=0.6, realtime=False)
    with LiveRun(scene, press(), record=path, options=options) as run:
        run.wait(30.0)
    report = run.finish()

    record = palpate.read_record(str(path))
    told = [e for e in record.events if e["kind"] == palpate.EventKind.tissue_exchanged]
    assert report.exchanges == len(told) > 5
    assert report.exchange_cost.median > 0.0
    assert report.peak_force > 0.0
    assert report.interventions == report.damped_ticks == 0
    assert palpate.replay(scene, record).equal


def test_a_file_keeps_the_rate_and_one_without_has_none(tmp_path):
    for rate in (0.0, 50.0):
        path = tmp_path / f"{rate:g}.palpate"
        made = palpate.scenario.Scenario(scene=slow_scene(rate), title="a", task="b")
        palpate.scenario.write(path, made)

        assert palpate.scenario.read(path).scene.exchange_rate == rate


def test_a_rate_that_the_ticks_cannot_keep_is_refused():
    with pytest.raises(ValueError, match="as 250 or 333.333"):
        slow_scene(300.0)


def test_what_a_slow_tissue_cannot_be_touched_with_is_refused(tmp_path, capsys):
    """It read beyond what it had kept room for."""
    scene = organ_scene(2)
    scene.instruments[0].tool.capsules = [palpate.Capsule((0, 0, 0), (0, 0, 0.02))]
    scene = palpate.build_scene(scene)
    with pytest.raises(ValueError, match=r"tool\.capsules: got 1, expected none"):
        palpate.SlowTissue(scene, 1000.0, 10)
    path = tmp_path / "probe.palpate"
    palpate.scenario.write(path, palpate.scenario.Scenario(scene=scene))

    assert main(["multirate", str(path)]) == 1

    assert "between two exchanges a ball is felt" in capsys.readouterr().err


def test_a_device_that_declares_nothing_keeps_nothing_passive_and_an_arm_does():
    assert press().dynamics().damping == 0.0
    assert palpate.find_passive_stiffness(press().dynamics(), 1e-3) == 0.0
    assert press().dynamics().position_source
    arm = palpate.SimulatedArm(press())
    arm.open()

    dynamics = arm.dynamics()

    assert not dynamics.position_source
    assert 0.05 < dynamics.damping < 1.0
    assert 0.0 < dynamics.delay < 0.01
    found = palpate.find_passive_stiffness(dynamics, 1e-3)
    assert found == pytest.approx(dynamics.damping / (0.5e-3 + dynamics.delay))


def test_a_run_says_up_to_where_its_device_is_passive_and_what_its_coupling_takes():
    scene = organ_scene(2)
    scene.instruments[0].coupling.stiffness = 900.0
    scene = palpate.build_scene(scene)
    options = palpate.LoopOptions(duration=0.05, realtime=False)
    arm = palpate.SimulatedArm(press())
    arm.open()
    with LiveRun(scene, arm, options=options) as run:
        run.wait(30.0)
    costs = run.finish()

    (row,) = describe_couplings(costs, scene)["couplings"]
    lines = "\n".join(say_couplings({"couplings": [row]}))

    passive = costs.devices[0].passive_stiffness
    assert row["passive_N_per_m"] == passive
    assert 0.0 < passive < 900.0
    # k / (k + K) is 0.9 of K up to either of them
    assert row["felt_within_a_tenth_N_per_m"] == pytest.approx(min(100.0, passive / 0.9))
    assert f"coupling     900 N/m; the device is passive up to {passive:.0f} N/m" in lines
    assert f"no more than {passive:.0f} N/m is felt" in lines
    assert "feels a tenth too soft" in lines


def test_the_hands_spring_before_a_tissue_is_what_the_device_bears_or_nine_times_the_tissue():
    fit = palpate.fit_coupling
    assert palpate.COUPLING_SHARE == 9.0
    assert fit(500.0, 150.0, 0.0) == 150.0
    assert fit(500.0, 150.0, 30.0) == 270.0
    assert fit(500.0, 150.0, 600.0) == pytest.approx(200.0)
    for tissue in (1.0, 20.0, 100.0, 166.0, 1e4):
        spring = fit(900.0, 150.0, tissue)
        felt = spring * tissue / (spring + tissue)
        assert felt <= 150.0 * (1 + 1e-12)
        borne = find_borne(900.0, 150.0)
        assert (felt >= 0.9 * tissue * (1 - 1e-12)) == (tissue <= borne)


def test_a_world_that_is_told_of_a_weak_device_feels_through_it():
    scene = organ_scene(2)
    scene.instruments[0].coupling.stiffness = 900.0
    scene = palpate.build_scene(scene)
    own, weak = palpate.World(scene), palpate.World(scene)
    weak.bound_coupling(0, 20.0, 2e-3)
    script = press()

    felt, tissue = [], 0.0
    for t in range(300):
        sample = script.read(1e-3 * t)
        commands = [palpate.tick(scene, sample, 1e-3, world) for world in (own, weak)]
        felt.append([float(np.linalg.norm(command.force)) for command in commands])
        device = weak.instruments[0].device
        assert device.stiffness >= 20.0
        tissue = max(tissue, device.tissue)

    assert own.instruments[0].device.stiffness == 0.0
    assert tissue > 0.0
    with pytest.raises(ValueError, match="before its first tick"):
        weak.bound_coupling(0, 30.0, 2e-3)
    with pytest.raises(ValueError, match="at least 0"):
        palpate.World(scene).bound_coupling(0, float("nan"), 0.0)
    assert 0.0 < max(force for _, force in felt) < max(force for force, _ in felt)


def test_a_device_that_declares_no_damping_is_not_said_to_be_passive():
    scene = slow_scene()
    options = palpate.LoopOptions(duration=0.05, realtime=False)
    with LiveRun(scene, press(), options=options) as run:
        run.wait(30.0)

    assert describe_couplings(run.finish(), scene) == {}
