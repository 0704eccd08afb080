# SPDX-License-Identifier: BSD-3-Clause
"""What is said of a played run: how it came out, what was felt, what it cost. Knows no Qt."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import palpate
from palpate.assessment.verdict import describe_verdict, pick_events
from palpate.command.verb import Report
from palpate.runs.felt import (
    read_all_rendered,
    read_column,
    read_felt_by_any,
    read_touched_by_any,
)
from palpate.runs.play import Play, describe_device
from palpate.runs.run import describe_costs, run_device

DONE, DEVICE_FAULT = "done", "device_fault"
"""How a run came out."""


def play_headless(play: Play) -> Report:
    """Runs a script, or a real hand, through the real 1 kHz loop and says what was felt and what it
    cost. A device that fails, or gives no force, ends the run.
    """
    path = play.name_record()
    device = play.build_device()
    safety = play.find_safety(device)
    others = play.build_others()
    driven = play.join_devices(device, others)
    costs = run_device(
        play.scenario.scene, driven, play.duration, path, play.path, safety, play.drawn
    )
    if play.drawn is not None:
        text = "the run is over; it is judged by its replay, which takes as long as it computed"
        print(text, file=sys.stderr, flush=True)
    state = describe_device(device)
    outcome = describe_outcome(costs)
    if outcome["outcome"] != DEVICE_FAULT:
        outcome = find_never_on(costs, [device, *others]) or outcome
    return {
        **outcome,
        **describe_play(play),
        "record": str(path),
        **describe_run(play, path, costs),
        "device_state": state,
        **({} if play.drawn is None else {"verdict": judge_record(play, path)}),
    }


def judge_record(play: Play, record: Path) -> Report:
    """The verdict of a recorded run: what it was judged to be while it ran, and the same again by
    its replay, from which the sums of its limits are.
    """
    assert play.drawn is not None
    rows = palpate.read_record(record)
    again = palpate.replay(play.scenario.scene, rows, play.drawn.task)
    events = pick_events(rows.events)
    assessment = json.loads(play.scenario.assessment)
    return {
        **describe_verdict(play.drawn, again.task, events, assessment),
        "outcome": palpate.find_outcome(rows).name,
        "replay_equal": again.equal and again.events_equal,
    }


def describe_outcome(costs: palpate.LoopReport) -> Report:
    """How a run came out, and why where its device failed or gave no force any more."""
    if costs.fault is not palpate.DeviceFault.none:
        return {"outcome": DEVICE_FAULT, "reason": costs.fault_reason}
    judged = costs.outcome is not palpate.Outcome.running
    return {"outcome": costs.outcome.name if judged else DONE, "reason": costs.fault_reason}


def find_never_on(
    costs: palpate.LoopReport, devices: Sequence[palpate.HapticDevice]
) -> Report | None:
    """The fault of the first device whose motors were off all the time."""
    for device, its in zip(devices, costs.devices, strict=True):
        if 0 < costs.ticks == its.unrendered_ticks:
            reason = f"the motors never came on: {describe_device(device)}"
            return {"outcome": DEVICE_FAULT, "reason": reason}
    return None


def describe_play(play: Play) -> Report:
    text = play.translation()
    return {"scenario": str(play.path), "title": text.title, "task": text.task}


def describe_run(play: Play, record: Path, costs: palpate.LoopReport) -> Report:
    """What was felt in a run, what was computed, by its record, and what it cost.

    Felt is what a device was sent while its motors were on. Peaks are of the instrument that felt
    most, times those in which any of them touched: they are no longer than the run.
    """
    rows = palpate.read_record(record)
    computed = [
        np.linalg.norm(read_column(rows, "felt", "force", each).astype(float), axis=1)
        for each in range(rows.instruments)
    ]
    rate = play.scenario.scene.rate
    return {
        **describe_costs(costs, play.scenario.scene),
        "lateness_max_us": 1e6 * costs.lateness.max,
        "record_gaps": costs.record_gaps,
        "instruments": rows.instruments,
        "peak_force_N": costs.peak_force,
        "mean_force_in_touch_N": costs.touch_force if costs.touch_ticks > 0 else None,
        "time_in_touch_s": float(read_felt_by_any(rows).sum()) / rate,
        "peak_computed_N": float(np.max(computed, initial=0.0)),
        "time_in_touch_computed_s": float(read_touched_by_any(rows).sum()) / rate,
        "motors_off_s": float((~read_all_rendered(rows)).sum()) / rate,
    }
