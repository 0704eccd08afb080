# SPDX-License-Identifier: BSD-3-Clause
"""Live runs: what a window sees of them, their pauses and their records."""

from __future__ import annotations

import copy
import json
import signal
import sys
import time

import numpy as np
import palpate
import pytest
from palpate.cli import device
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.runs import live, script_file
from palpate.runs.live import Frame, LiveRun
from palpate.runs.script_file import read_script_file, write_script_file
from published import publish, write_press
from surfaces import organ_scene, press_frames


def script() -> palpate.ScriptedDevice:
    return palpate.ScriptedDevice(press_frames())


def options() -> palpate.LoopOptions:
    """As long as the script."""
    return palpate.LoopOptions(duration=0.4)


def run_with_pauses(run: LiveRun, at: tuple[float, ...]) -> list[Frame]:
    """Runs to the end, with a pause at each of some times [s]; returns a frame of each pause."""
    seen = []
    run.start()
    for moment in at:
        while run.running:
            frame = run.take_frame()
            if frame is not None and frame.time >= moment:
                break
            run.wait(0.001)
        run.pause()
        # the frame that the pause itself leaves behind, for its force
        run.wait(0.05)
        seen.append(run.take_frame())
        run.wait(0.05)
        assert run.take_frame() is None
        assert run.running and run.paused
        run.resume()
    assert run.wait(60.0)
    return seen


def test_a_run_is_followed_by_frames_that_get_newer_and_belong_to_the_caller():
    run = LiveRun(organ_scene(1), script(), options=options())
    assert not run.running

    frames = []
    with run:
        while run.running:
            frame = run.take_frame()
            if frame is not None:
                frames.append((frame, frame.positions[0].copy()))
            run.wait(0.004)
    report = run.finish()

    ticks = [frame.tick for frame, _ in frames]
    assert ticks == sorted(set(ticks))
    assert len(frames) > 3
    assert all(np.array_equal(frame.positions[0], copy) for frame, copy in frames)
    assert any(frame.touching and np.linalg.norm(frame.force) > 0.0 for frame, _ in frames)
    assert report.ticks + report.missed_ticks == 400


def test_a_pause_costs_no_tick_and_its_force_is_zero():
    # so thick that a press lies on it without a bounce
    tissue = copy.copy(organ_scene(1).bodies[0].tissue)
    tissue.drag = 200.0
    scene = palpate.build_scene(palpate.make_scene(tissue))
    run = LiveRun(scene, script(), options=options())

    during = run_with_pauses(run, (0.1, 0.2))

    report = run.finish()
    assert report.ticks + report.missed_ticks == 400
    assert [frame.force.tolist() for frame in during] == [[0.0] * 3] * 2
    # deep in the tissue, where the script stands still; a hand that a starved loop sees leap there
    # may have passed the wall
    assert during[1].touching or report.missed_ticks > 0
    assert not run.paused


def test_a_record_with_pauses_replays_bit_by_bit_and_tells_of_them(tmp_path):
    scene = organ_scene(1)
    path = tmp_path / "paused.prec"
    run = LiveRun(scene, script(), record=path, header={"device": "script"}, options=options())

    run_with_pauses(run, (0.1, 0.2))
    report = run.finish()

    record = palpate.read_record(path)
    assert json.loads(record.header)["device"] == "script"
    assert record.complete
    assert len(record.hand) == report.ticks
    told = record.events[record.events["kind"] == palpate.EventKind.paused]
    assert len(told) == 2
    assert (told["value"] > 0.0).all()
    replayed = palpate.replay(scene, record)
    assert replayed.equal
    assert replayed.ticks == report.ticks
    # the script's time stood still: no two ticks are further apart than the ticks between them
    assert np.diff(record.hand["time"]).max() < 1e-3 * (1.5 + report.missed_ticks)


def test_a_signal_ends_a_replay():
    scene, rows = organ_scene(1), palpate.Record()
    # a second of work, for timers of processor time may be late by tens of milliseconds
    still = np.zeros(400_000, rows.hand.dtype), np.zeros(400_000, rows.felt.dtype)
    record = palpate.Record(hand=still[0], felt=still[1])

    def measure() -> float:
        start = time.process_time()
        palpate.replay(scene, record)
        return time.process_time() - start

    whole = min(measure() for _ in range(2))  # a machine that stands still counts as work

    def end(number: int, frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGPROF, end)
    try:
        # after a tenth of the processor time
        start = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, 0.1 * whole)
        with pytest.raises(KeyboardInterrupt):
            palpate.replay(scene, record)
        spent = time.process_time() - start
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)

    assert spent < 0.7 * whole


def test_a_finished_run_is_not_started_again_and_finishes_as_often_as_one_likes(tmp_path):
    run = LiveRun(organ_scene(1), script(), record=tmp_path / "a.prec", options=options())
    run.start()

    first, second = run.finish(), run.finish()

    assert first.ticks == second.ticks
    assert palpate.read_record(tmp_path / "a.prec").complete
    with pytest.raises(RuntimeError, match="second time"):
        run.start()


def test_a_record_that_cannot_be_written_is_refused_before_anything_runs(tmp_path):
    with pytest.raises(OSError, match="nowhere"):
        LiveRun(organ_scene(1), script(), record=tmp_path / "nowhere" / "a.prec")


def test_a_live_run_needs_no_qt():
    import subprocess

    words = "import sys, palpate.runs.live; sys.exit(any('PySide' in m for m in sys.modules))"
    assert subprocess.run([sys.executable, "-c", words], check=False).returncode == 0


def test_a_run_without_an_end_ends_when_its_record_is_full(tmp_path, monkeypatch):
    monkeypatch.setattr(live, "MOST_TICKS", 40)
    path = tmp_path / "run.prec"

    with LiveRun(organ_scene(0), palpate.ScriptedDevice(press_frames()), record=path) as run:
        assert run.wait(60.0)

    record = palpate.read_record(path)
    assert record.complete
    assert 0 < len(record.hand) <= 40


def test_a_run_that_no_record_holds_is_refused_before_it_begins(tmp_path):
    scene, path = organ_scene(0), tmp_path / "run.prec"
    device = palpate.ScriptedDevice(press_frames())

    with pytest.raises(ValueError, match="expected at most 8388.61 s, which a record holds"):
        LiveRun(scene, device, record=path, options=palpate.LoopOptions(duration=8389.0))

    assert not path.exists()
    # without a record it may go on
    LiveRun(scene, device, options=palpate.LoopOptions(duration=8389.0))


def test_the_longest_record_is_that_of_the_core(checkout):
    layout = (checkout / "core/sim/session/private/record_layout.h").read_text(encoding="utf-8")

    assert "kMostRows = 1 << 23;" in layout
    assert live.MOST_TICKS == 1 << 23


@pytest.mark.parametrize("words", [["--duration", "8389s"], ["--duration", "0s"]])
def test_play_refuses_a_duration_that_no_record_holds(words, tmp_path, capsys):
    device = f"script:{write_press(tmp_path)}"
    call = ["play", str(publish(tmp_path)), "--headless", "--device", device, *words]

    assert main(call) == 2

    assert "duration: got" in capsys.readouterr().err


def test_no_script_and_no_wait_for_a_device_lasts_longer_than_a_record(tmp_path, checkout):
    path = tmp_path / "press.json"
    write_script_file(path, [palpate.KeyFrame(live.LONGEST, (0.0, 0.0, 0.03))])
    assert read_script_file(path)[0].time == live.LONGEST == 8388.608

    text = path.read_text(encoding="utf-8").replace("8388.608", "8388.7")
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Refusal, match=r"frames\[0\].time: got 8388.7 s, expected 0 to 8388.61"):
        read_script_file(path)
    schema = (checkout / "bindings/palpate/schemas/script.schema.json").read_text(encoding="utf-8")
    assert f'"maximum": {live.LONGEST}' in schema
    assert device.LONGEST is script_file.LONGEST is live.LONGEST
