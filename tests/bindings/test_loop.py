# SPDX-License-Identifier: BSD-3-Clause
"""The live loop as Python sees it, and that Python cannot hold it up."""

from __future__ import annotations

import _thread
import ctypes
import gc
import signal
import sys
import threading
import time
import weakref

import numpy as np
import palpate
import pytest
from surfaces import organ_scene, press_frames

HOLD = 0.3
"""[s] for which Python's lock is held."""
ROUNDS = 6
"""A loop that waited for Python would stand still in every one; a busy machine only in some."""
ENOUGH = 250
"""Ticks of the 300 due during the hold that must have run in the best of the rounds."""

usleep_with_lock = ctypes.PyDLL(None).usleep
"""Sleeps without letting go of Python's lock, as no Python code could."""
usleep_without_lock = ctypes.CDLL(None).usleep


def small_organ_loop(log: palpate.TickLog | None = None) -> palpate.Loop:
    """Runs until it is stopped, the hand moving to and fro above the organ and into it.

    By so little that ticks missed in a row make no impact of it.
    """
    low, high = 0.0222, 0.0232
    frames = [palpate.KeyFrame(0.1 * k, (0.0, 0.0, low if k % 2 else high)) for k in range(200)]
    return palpate.Loop(organ_scene(1), palpate.ScriptedDevice(frames), log=log)


def ticks_during(loop: palpate.Loop, sleep: ctypes._CFuncPtr) -> tuple[int, int]:
    """Ticks done and ticks missed while `sleep` lasts; both are atomics of the haptic thread."""
    before = loop.report()
    sleep(int(1e6 * HOLD))
    after = loop.report()
    return after.ticks - before.ticks, after.missed_ticks - before.missed_ticks


@pytest.fixture
def no_switches():
    """Python's threads change places only where one of them lets the lock go."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(60.0)
    yield
    sys.setswitchinterval(interval)


def test_the_sleeps_of_these_tests_do_hold_and_do_not_hold_pythons_lock(no_switches):
    counted = 0
    stop = threading.Event()

    def count() -> None:
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(1e-4)

    def count_during(sleep: ctypes._CFuncPtr) -> int:
        before = counted
        sleep(100_000)
        return counted - before

    other = threading.Thread(target=count)
    other.start()
    while counted < 3:
        time.sleep(1e-3)
    held = [count_during(usleep_with_lock) for _ in range(3)]
    free = [count_during(usleep_without_lock) for _ in range(3)]
    stop.set()
    other.join()

    assert held == [0, 0, 0]
    assert min(free) > 0


def test_holding_pythons_lock_for_300_ms_delays_no_tick():
    with small_organ_loop() as loop:
        rounds = [
            (ticks_during(loop, usleep_without_lock), ticks_during(loop, usleep_with_lock))
            for _ in range(ROUNDS)
        ]

    free_done = [done for (done, _), _ in rounds]
    held_done = [done for _, (done, _) in rounds]
    free_missed = [missed for (_, missed), _ in rounds]
    held_missed = [missed for _, (_, missed) in rounds]
    assert max(held_done) >= ENOUGH
    # what a busy machine takes, it takes from both; a loop that waits loses 300 ticks a round
    assert min(held_missed) <= min(free_missed) + 30
    assert sum(held_done) >= 0.7 * sum(free_done)
    assert loop.report().alarm.kind is palpate.AlarmKind.none


def test_the_log_shows_no_gap_as_long_as_the_hold():
    largest = []
    for _ in range(3):
        log = palpate.TickLog()
        with small_organ_loop(log) as loop:
            usleep_without_lock(50_000)
            usleep_with_lock(int(1e6 * HOLD))
            usleep_without_lock(50_000)
        ticks, _, _ = log.take()
        assert len(ticks) == loop.report().ticks
        assert (np.diff(ticks["tick"]) == 1).all()
        largest.append(np.diff(ticks["sample"]["time"]).max())

    # [s] between the due times of two ticks that followed each other, best of three
    assert min(largest) < 0.1


def test_a_run_of_a_given_length_ends_by_itself():
    options = palpate.LoopOptions(duration=0.2)
    loop = palpate.Loop(organ_scene(1), palpate.ScriptedDevice(press_frames()), options)

    assert not loop.running()
    loop.start()
    assert loop.wait(60.0)

    report = loop.report()
    assert not loop.running()
    assert report.ticks + report.missed_ticks == 200
    assert report.cost.median <= report.cost.p99 <= report.cost.max
    assert report.fault is palpate.DeviceFault.none
    assert report.realtime or report.realtime_note


def test_a_loop_runs_once():
    with small_organ_loop() as loop, pytest.raises(RuntimeError, match="second time"):
        loop.start()
    with pytest.raises(RuntimeError, match="second time"):
        loop.start()


def test_a_snapshot_is_a_copy_that_the_loop_leaves_alone():
    with small_organ_loop() as loop:
        while not (loop.take_snapshot() and loop.snapshot().tick > 150):
            loop.wait(0.01)
        first = loop.snapshot()
        kept = first.bodies[0].position.copy()
        while not (loop.take_snapshot() and loop.snapshot().tick > first.tick + 20):
            loop.wait(0.01)
        second = loop.snapshot()

    assert np.array_equal(first.bodies[0].position, kept)
    assert second.tick > first.tick
    assert not np.array_equal(first.bodies[0].position, second.bodies[0].position)


def test_a_loop_keeps_its_scene_device_and_log_alive():
    class Named(palpate.TickLog):
        """Weak references need a class that Python made."""

    log = Named()
    loop = palpate.Loop(organ_scene(1), palpate.ScriptedDevice(press_frames()), log=log)
    seen = weakref.ref(log)
    del log
    gc.collect()

    assert seen() is not None
    loop.start()
    loop.wait(0.05)
    loop.stop()
    assert loop.report().ticks > 0
    ticks, events, hashes = seen().take()
    assert len(ticks) == loop.report().ticks
    assert len(hashes) >= 1
    del loop
    gc.collect()
    assert seen() is None


def test_a_loop_that_is_dropped_stops():
    device = palpate.ScriptedDevice(press_frames())
    loop = palpate.Loop(organ_scene(1), device)
    loop.start()
    while loop.report().ticks < 5:
        loop.wait(0.01)

    del loop
    gc.collect()

    # the device hears zero last, and then nobody touches it any more
    assert device.last_command.force.tolist() == [0.0, 0.0, 0.0]


@pytest.fixture
def interruptible():
    """A shell lets its background jobs ignore interrupts."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_an_interrupt_is_heard_while_waiting(interruptible):
    with small_organ_loop() as loop:
        timer = threading.Timer(0.1, _thread.interrupt_main)
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            loop.wait(60.0)
        timer.join()


def test_a_pointer_moves_the_hand_from_python():
    scene = organ_scene(1)
    device = palpate.PointerDevice()
    device.set(palpate.HapticSample(position=(0.0, 0.0, 0.04)))

    with palpate.Loop(scene, device) as loop:
        while not (loop.take_snapshot() and loop.snapshot().tick > 50):
            loop.wait(0.01)
        device.set(palpate.HapticSample(position=(0.0, 0.0, 0.018)))
        while not (loop.take_snapshot() and loop.snapshot().touching):
            loop.wait(0.01)
        while device.take_command().force[2] < 0.05:
            loop.wait(0.01)

    assert loop.report().fault is palpate.DeviceFault.none


def test_a_pause_stops_the_ticks_and_the_force_and_misses_none():
    device = palpate.ScriptedDevice(press_frames())
    loop = palpate.Loop(organ_scene(1), device, palpate.LoopOptions(duration=0.4))
    loop.start()
    while loop.report().ticks < 200:
        loop.wait(0.002)

    loop.pause()
    while not loop.paused():
        loop.wait(0.001)
    before = loop.report().ticks
    loop.wait(0.1)

    assert loop.running()
    assert loop.report().ticks == before
    assert device.last_command.force.tolist() == [0.0, 0.0, 0.0]
    loop.resume()
    assert loop.wait(60.0)
    assert not loop.paused()
    assert loop.report().ticks + loop.report().missed_ticks == 400


def test_a_safe_device_limits_what_it_passes_on():
    script = palpate.ScriptedDevice(press_frames())
    safe = palpate.SafeDevice(script, palpate.SafetyLimits(force_max=1.0, ramp_time=0.001))
    del script
    gc.collect()

    for k in range(2000):
        safe.read(1e-3 * k)
        # the motors start with a small force only
        safe.write(palpate.HapticCommand((0.0, 0.0, 30.0 if k > 0 else 0.0)))

    assert safe.name() == "script"
    assert np.linalg.norm(safe.sent().force) == pytest.approx(1.0)
    assert safe.limited_count() > 0
    safe.rest()
    assert safe.sent().force.tolist() == [0.0, 0.0, 0.0]
    safe.write(palpate.HapticCommand((np.nan, 0.0, 0.0)))
    assert safe.fault() is palpate.DeviceFault.force_not_finite
    assert safe.sent().force.tolist() == [0.0, 0.0, 0.0]
