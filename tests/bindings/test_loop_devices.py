# SPDX-License-Identifier: BSD-3-Clause
"""Runs and records of several instruments, each with a device of its own."""

from __future__ import annotations

import copy
import gc
import pickle
import weakref
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.felt import read_column, read_force
from palpate.runs.live import MOST_TICKS, LiveRun, find_longest
from palpate.runs.replay import run_replay
from palpate.runs.run import describe_build, run_device
from surfaces import organ_scene, press_frames

ASIDE = np.array([0.2, 0.0, 0.0])


def make_body(offset=(0.0, 0.0, 0.0)) -> palpate.SoftBody:
    tissue = copy.copy(organ_scene(1).bodies[0].tissue)
    np.asarray(tissue.rest_position)[:] += offset
    return palpate.SoftBody(tissue=tissue)


@pytest.fixture(scope="module")
def scene() -> palpate.Scene:
    instruments = [palpate.Instrument(), palpate.Instrument()]
    return palpate.build_scene(
        palpate.Scene(bodies=[make_body(), make_body(ASIDE)], instruments=instruments)
    )


def press(offset=(0.0, 0.0, 0.0)) -> palpate.ScriptedDevice:
    frames = press_frames()
    for frame in frames:
        frame.position = np.asarray(frame.position) + offset
    return palpate.ScriptedDevice(frames)


@pytest.fixture(scope="module")
def recorded(scene, tmp_path_factory) -> Path:
    """The record of two presses through the live loop."""
    path = tmp_path_factory.mktemp("pair") / "pair.prec"
    devices = press(), press(ASIDE)
    options = palpate.LoopOptions(duration=devices[0].duration())
    with LiveRun(scene, devices, record=path, options=options) as run:
        assert run.wait(60.0)
    costs = run.finish()
    assert costs.record_gaps == 0
    assert [device.touch_ticks > 0 for device in costs.devices] == [True, True]
    return path


def test_a_record_of_two_instruments_has_a_column_for_each(scene, recorded):
    record = palpate.read_record(recorded)

    assert record.instruments == 2
    assert record.hand.shape == record.felt.shape == (palpate.count_ticks(record), 2)
    assert np.array_equal(record.hand["time"][:, 0], record.hand["time"][:, 1])
    apart = read_column(record, "hand", "position", 1) - read_column(record, "hand", "position")
    assert np.allclose(apart, ASIDE, atol=1e-12)
    assert np.linalg.norm(read_force(record, 1), axis=1).max() > 0.05
    report = palpate.replay(scene, record)
    assert report.equal
    assert report.felt.shape == record.felt.shape
    assert repr(record) == f"Record({len(record.hand)} ticks, 2 instruments, complete)"


def test_one_changed_sample_of_the_second_hand_makes_the_comparison_fail(scene, recorded):
    record = palpate.read_record(recorded)
    deepest = int(np.linalg.norm(read_force(record, 1), axis=1).argmax())
    record.hand["position"][deepest, 1, 2] += 1e-6

    report = palpate.replay(scene, record)

    assert not report.equal
    assert report.first_difference == deepest
    with pytest.raises(ValueError, match="got a scene of 1 instruments, expected 2"):
        palpate.replay(organ_scene(1), record)


def is_same(one: palpate.Record, other: palpate.Record) -> bool:
    """Field by field: between them lie bytes that mean nothing."""
    pairs = ((one.hand, other.hand), (one.felt, other.felt))
    return all(np.array_equal(a[name], b[name]) for a, b in pairs for name in a.dtype.names)


def test_a_record_of_several_is_made_copied_pickled_and_written_whole(recorded, tmp_path):
    record = palpate.read_record(recorded)
    made = palpate.Record(
        header=record.header, hand=record.hand, felt=record.felt, hashes=record.hashes
    )
    listed = palpate.Record(
        hand=[palpate.HapticSample()] * 6, felt=[palpate.Felt()] * 6, instruments=3
    )
    palpate.write_record(tmp_path / "again.prec", made)

    for other in (copy.copy(record), pickle.loads(pickle.dumps(record)), made):
        assert other.instruments == 2
        assert is_same(other, record)
    assert is_same(palpate.read_record(tmp_path / "again.prec"), record)
    assert palpate.count_ticks(listed) == 2
    with pytest.raises(
        ValueError, match="felt: got 1 columns, expected 2, one for each instrument"
    ):
        palpate.Record(hand=record.hand, felt=record.felt[:, 0])
    with pytest.raises(ValueError, match="record: hand: got 4 samples, expected a multiple of 3"):
        palpate.Record(hand=[palpate.HapticSample()] * 4, felt=[palpate.Felt()] * 4, instruments=3)


def test_a_frame_and_a_report_tell_of_every_instrument(scene):
    high = palpate.KeyFrame(position=(0.2, 0.0, 0.1))
    with LiveRun(scene, [press(), palpate.ScriptedDevice([high])]) as run:
        frame = None
        while frame is None or not frame.instruments[0].touching:
            run.wait(0.01)
            frame = run.take_frame() or frame
    costs = run.finish()

    assert len(frame.instruments) == 2
    assert frame.touching
    assert not frame.instruments[1].touching
    assert frame.instruments[1].tool_position[0] == pytest.approx(0.2)
    assert costs.devices[1].touch_ticks == 0
    assert costs.touch_ticks == costs.devices[0].touch_ticks > 0
    assert costs.alarm_body == -1


def test_a_loop_keeps_its_devices_alive_whatever_becomes_of_their_list(scene):
    class Named(palpate.PointerDevice):
        """Weak references need a class that Python made."""

    devices = [Named(), Named()]
    seen = [weakref.ref(device) for device in devices]
    loop = palpate.Loop(scene, devices, palpate.LoopOptions(duration=0.1))
    devices.clear()
    gc.collect()
    assert all(device() is not None for device in seen)
    loop.start()
    assert loop.wait(60.0)
    del loop
    gc.collect()
    assert all(device() is None for device in seen)


def test_a_log_has_the_rows_of_every_instrument_together(scene):
    log = palpate.TickLog(100, instruments=2)
    options = palpate.LoopOptions(duration=0.05)
    loop = palpate.Loop(scene, (press(), press(ASIDE)), options, log)
    loop.start()
    assert loop.wait(60.0)

    assert log.instruments() == 2
    assert not log.push(palpate.TickLog.Tick(tick=1))
    assert log.push([palpate.TickLog.Tick(tick=100)] * 2)
    ticks, _, _ = log.take()
    assert ticks.shape == (loop.report().ticks + 1, 2)
    assert np.array_equal(ticks["tick"][:, 0], ticks["tick"][:, 1])


@pytest.mark.parametrize(
    ("devices", "problem", "sentence"),
    [
        (lambda: [palpate.PointerDevice()], ValueError, "devices: got 1, expected 2, one for each"),
        (lambda: [palpate.PointerDevice()] * 2, ValueError, "got a device that drives another"),
        (lambda: [palpate.PointerDevice(), 7], TypeError, r"devices\[1\]: got 7, expected a Hap"),
        (lambda: [palpate.PointerDevice(), None], TypeError, r"devices\[1\]: got None"),
    ],
    ids=["few", "twice", "none of them", "nothing"],
)
def test_other_devices_than_one_for_each_instrument_are_refused(scene, devices, problem, sentence):
    with pytest.raises(problem, match=sentence):
        palpate.Loop(scene, devices())


def test_several_instruments_share_the_rows_of_a_record(scene):
    assert find_longest(scene) == MOST_TICKS / 2 / scene.rate
    assert find_longest(organ_scene(1)) == MOST_TICKS / 1000


def test_the_verb_replays_a_record_of_two_bodies_and_instruments(scene, tmp_path):
    path = tmp_path / "pair.palpate"
    palpate.scenario.write(path, palpate.scenario.Scenario(scene=scene, title="Pair"))
    costs = run_device(scene, [press(), press(ASIDE)], 0.3, tmp_path / "pair.prec", path)

    report = run_replay(tmp_path / "pair.prec")

    assert report["equal"]
    assert report["ticks"] == costs.ticks
    header = describe_build(scene, path, tmp_path / "pair.prec", "script")
    assert header["kernel"] in {"packed", "reference"}  # one word, as the bodies agree
