# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C ends long calls, and arguments without sense are refused before anything is done."""

from __future__ import annotations

import signal
import subprocess
import sys

import numpy as np
import palpate
import pytest

CALLS = {
    "a simulated device that lives on": "core.advance(80000.0)",
    "a simulated device that is read": "core.read(80000.0)",
    "a check in real time": "palpate.check_conformance(device, palpate.ConformanceOptions("
    "duration=20.0, live=True))",
    "a check as fast as it goes": "palpate.check_conformance(device, palpate.ConformanceOptions("
    "duration=80000.0))",
    "a loop without tissue": "palpate.DeviceLoop(device).run(80000.0)",
    "a wait for bytes": "transport.wait(time.monotonic_ns() + 10**13)",
    "the greeting of a device that says nothing": "palpate.SerialDevice(transport).open(1000.0)",
}
PROGRAM = """
import os, pty, signal, sys, time
import palpate
core = palpate.NativeCore()
device = palpate.ScriptedDevice([palpate.KeyFrame(0.0, (0, 0, 0.05))])
signal.signal(signal.SIGALRM, signal.default_int_handler)
ours, theirs = pty.openpty()
transport = palpate.SerialTransport(os.ttyname(theirs))
try:
    signal.setitimer(signal.ITIMER_REAL, 0.2)
    {call}
except KeyboardInterrupt:
    print("heard")
else:
    print("went to its end")
"""


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS.keys())
def test_control_c_ends(call):
    program = PROGRAM.format(call=call)

    child = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8")

    assert (child.returncode, child.stdout) == (0, "heard\n"), child.stderr


def test_python_hears_signals_every_ten_milliseconds_of_a_call():
    """The handler is run within the call, not after it: it stops what would go on for a day."""
    heard = []
    core = palpate.NativeCore()

    def handle(*_: object) -> None:
        heard.append(core.time())
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, handle)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyboardInterrupt):
            core.advance(80000.0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)

    assert len(heard) == 1
    # it stopped in the piece in which it heard, no more than one piece of 5 ms on
    assert core.time() - heard[0] <= 0.0051


@pytest.mark.parametrize("time", [1e9, float("inf"), float("nan")])
def test_a_simulated_device_lives_at_most_a_day_in_one_call(time):
    core = palpate.NativeCore()

    with pytest.raises(ValueError, match=r"time \[s\]: got .*, expected at most a day after 0"):
        core.advance(time)
    with pytest.raises(ValueError, match="time"):
        core.read(time)


def test_a_device_lives_in_pieces_as_it_does_at_once():
    plant = palpate.Plant()
    whole, pieces = palpate.NativeCore(plant), palpate.NativeCore(plant)

    whole.advance(0.2)
    for k in range(1, 201):
        pieces.advance(1e-3 * k)

    assert whole.state().joints.tobytes() == pieces.state().joints.tobytes()
    assert whole.state().time == pieces.state().time


@pytest.mark.parametrize(("duration", "rate"), [(1e9, 1000.0), (1.0, 1e9)])
def test_a_check_lasts_at_most_a_day(duration, rate):
    device = palpate.ScriptedDevice([palpate.KeyFrame()])
    options = palpate.ConformanceOptions(duration=duration, rate=rate)

    with pytest.raises(ValueError, match="expected at most a day at 100000 Hz"):
        palpate.check_conformance(device, options)


def test_counts_without_sense_are_refused_before_memory_is_taken():
    for call, name in (
        (lambda: palpate.find_shells(2_000_000_000, [(0, 1, 2)]), "vertex_count"),
        (lambda: palpate.Load(2_000_000_000), "capacity"),
        (lambda: palpate.Candidates(2_000_000_000), "capacity"),
        (lambda: palpate.ToolState(2_000_000_000), "capacity"),
    ):
        with pytest.raises(ValueError, match=f"{name}: got 2000000000, expected 0 to 10000000"):
            call()
    assert palpate.find_shells(4, [(0, 1, 2)]).tolist() == [0, 0, 0, -1]


def test_a_plant_moves_at_most_a_million_steps_in_one_call():
    plant = palpate.Plant()

    with pytest.raises(ValueError, match=r"dt \[s\]: got 1e\+09, expected at most"):
        palpate.move_plant(
            plant, palpate.Drive(), palpate.HandTarget(), 1e9, palpate.PlantState(plant)
        )


def test_a_device_is_read_within_a_day_of_the_begin():
    device = palpate.SerialDevice(palpate.NativeCore())

    with pytest.raises(ValueError, match="within a day of the run's begin"):
        device.read(np.inf)
