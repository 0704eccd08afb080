# SPDX-License-Identifier: BSD-3-Clause
"""A record replays to the same bits, in this process and in a new one."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.replay import follow_header
from surfaces import organ_scene, press_frames, run_frames

REPLAY = """
import json, sys
import palpate
from surfaces import organ_scene
report = palpate.replay(organ_scene(stiffness=float(sys.argv[2])), palpate.read_record(sys.argv[1]))
print(json.dumps({"equal": report.equal, "ticks": report.ticks,
                  "first_difference": report.first_difference,
                  "largest_force_difference": report.largest_force_difference}))
"""


def replay_in_a_new_process(path: Path, stiffness: float = 50.0) -> dict:
    package = Path(palpate.__file__).parents[1]
    search = f"import sys; sys.path[:0] = [{str(package)!r}, {str(Path(__file__).parent)!r}]\n"
    done = subprocess.run(
        [sys.executable, "-c", search + REPLAY, str(path), str(stiffness)],
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    return json.loads(done.stdout)


def live_record(path: Path) -> palpate.LoopReport:
    """The press of press_frames() through the live loop and a recorder."""
    recorder = palpate.Recorder(path, json.dumps({"organ": "ellipsoid"}))
    device = palpate.ScriptedDevice(press_frames())
    options = palpate.LoopOptions(duration=device.duration())
    loop = palpate.Loop(organ_scene(), device, options, recorder.log())
    loop.start()
    assert loop.wait(60.0)
    recorder.finish()
    return loop.report()


def test_a_live_record_replays_to_the_same_bits_in_a_new_process(tmp_path):
    report = live_record(tmp_path / "live.prec")
    record = palpate.read_record(tmp_path / "live.prec")

    told = replay_in_a_new_process(tmp_path / "live.prec")

    assert record.complete
    assert json.loads(record.header)["organ"] == "ellipsoid"
    assert len(record.hand) == len(record.felt) == report.ticks
    assert np.abs(record.felt["force"]).max() > 0.05
    assert told == {
        "equal": True,
        "ticks": report.ticks,
        "first_difference": -1,
        "largest_force_difference": 0.0,
    }


def test_one_changed_sample_makes_the_comparison_fail(tmp_path):
    record = run_frames(organ_scene(), press_frames())
    deepest = int(record.felt["force"][:, 2].argmax())
    palpate.write_record(tmp_path / "true.prec", record)
    record.hand["position"][deepest, 2] += 1e-6
    palpate.write_record(tmp_path / "changed.prec", record)

    true = replay_in_a_new_process(tmp_path / "true.prec")
    changed = replay_in_a_new_process(tmp_path / "changed.prec")

    assert true["equal"]
    assert not changed["equal"]
    assert changed["first_difference"] == deepest
    assert changed["largest_force_difference"] > 0.0


def test_another_organ_does_not_replay_to_the_same_bits(tmp_path):
    palpate.write_record(tmp_path / "a.prec", run_frames(organ_scene(), press_frames()))

    assert not replay_in_a_new_process(tmp_path / "a.prec", stiffness=51.0)["equal"]


def test_a_record_of_a_tip_that_rubs_replays_to_the_same_bits_and_not_without_friction():
    def build(friction: float) -> palpate.Scene:
        scene = organ_scene()
        scene.instruments[0].tool.friction = friction
        return palpate.build_scene(scene)

    over, down = (0.0, 0.0, 0.028), (0.0, 0.0, 0.017)
    frames = [
        palpate.KeyFrame(time, position)
        for time, position in ((0.0, over), (0.15, down), (0.3, (0.004, 0.002, 0.017)), (0.4, over))
    ]
    record = run_frames(build(0.2), frames)

    assert palpate.replay(build(0.2), record).equal
    assert palpate.replay(build(0.0), record).largest_force_difference > 1e-3


@pytest.mark.parametrize("codec", palpate.RecordCodec)
def test_a_record_comes_back_from_its_file_bit_by_bit(tmp_path, codec):
    record = run_frames(organ_scene(1), press_frames())
    palpate.write_record(tmp_path / "a.prec", record, codec)

    back = palpate.read_record(str(tmp_path / "a.prec"))

    for table in ("hand", "felt"):
        for name in getattr(record, table).dtype.names:
            assert np.array_equal(getattr(record, table)[name], getattr(back, table)[name])
    assert np.array_equal(record.hashes["hash"], back.hashes["hash"])


def test_replay_tells_what_any_hand_would_feel():
    scene = organ_scene(1)
    record = run_frames(scene, press_frames())
    made_up = palpate.Record(hand=record.hand, felt=np.zeros(len(record.hand), palpate.Felt.dtype))

    felt = palpate.replay(scene, made_up).felt

    assert np.array_equal(felt["force"], record.felt["force"])
    assert felt["force"][:, 2].max() > 0.05


def test_a_replay_device_gives_back_the_recorded_hand():
    record = run_frames(organ_scene(1), press_frames())
    device = palpate.ReplayDevice(record.hand)

    positions = np.array([device.read(0.0).position.copy() for _ in range(len(record.hand))])

    assert device.finished()
    assert np.array_equal(positions, record.hand["position"])


def test_a_recorder_as_a_context_finishes_its_file(tmp_path):
    with palpate.Recorder(tmp_path / "a.prec", "{}") as recorder:
        for tick in range(10):
            recorder.log().push(palpate.TickLog.Tick(tick=tick))

    record = palpate.read_record(tmp_path / "a.prec")
    assert record.complete
    assert len(record.hand) == 10


def test_a_log_without_room_counts_its_gaps():
    log = palpate.TickLog(2)

    pushed = [log.push(palpate.TickLog.Tick(tick=tick)) for tick in range(5)]
    log.push(palpate.Event(tick=3, kind=palpate.EventKind.attached, index=1))
    ticks, events, hashes = log.take()

    assert pushed == [True, True, False, False, False]
    assert log.gap_count() == 3
    assert ticks["tick"].tolist() == [0, 1]
    assert events["kind"].tolist() == [palpate.EventKind.attached]
    assert len(hashes) == 0


def test_a_replay_takes_the_kernel_and_the_vector_target_of_the_record():
    targets = palpate.simd_targets()

    plain = follow_header(organ_scene(), {"kernel": "reference, double, symplectic Euler"})
    packed = follow_header(organ_scene(), {"kernel": "packed", "vector_target": targets[-1]})
    foreign = follow_header(
        organ_scene(), {"kernel": "packed", "vector_target": "of another machine"}
    )

    assert plain.bodies[0].kernel is palpate.Kernel.reference
    assert (packed.bodies[0].kernel, packed.bodies[0].simd_target) == (
        palpate.Kernel.packed,
        targets[-1],
    )
    assert (foreign.bodies[0].kernel, foreign.bodies[0].simd_target) == (palpate.Kernel.packed, "")
    record = run_frames(packed, press_frames())
    assert palpate.replay(packed, record).equal
    assert not palpate.replay(plain, record).equal
    assert palpate.replay(plain, record).largest_force_difference < 1e-3
