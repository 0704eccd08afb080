# SPDX-License-Identifier: BSD-3-Clause
"""A device whose driver is written in Python."""

from __future__ import annotations

import runpy
import threading
import time
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.runs.live import LiveRun
from surfaces import organ_scene

EXAMPLE = Path(__file__).resolve().parents[1] / "examples" / "add_a_device" / "my_device.py"


class Stylus:
    """Sinks slowly from above the organ's top; what else it does at a read is up to the test."""

    def __init__(self, fail_at: int = -1):
        self.height, self.reads, self.fail_at = 0.028, 0, fail_at
        self.forces: list[np.ndarray] = []
        self.hangs = threading.Event()
        self.threads: set[int] = set()

    def read(self):
        self.reads += 1
        self.threads.add(threading.get_ident())
        while self.hangs.is_set():
            time.sleep(0.001)
        if self.reads == self.fail_at:
            raise ValueError("the stylus broke in two")
        self.height = max(0.0185, self.height - 2e-5)
        return palpate.HapticSample(position=(0.0, 0.0, self.height))

    def write(self, force):
        self.forces.append(force)


def ending() -> palpate.LoopOptions:
    return palpate.LoopOptions(on_fault=palpate.FaultResponse.end)


def test_a_driver_in_python_feels_an_organ_from_a_thread_of_its_own(tmp_path):
    scene, stylus, record = organ_scene(1), Stylus(), tmp_path / "felt.prec"
    with (
        palpate.PythonDevice(stylus) as device,
        LiveRun(scene, device, record=record, header={}) as run,
    ):
        while not any(np.linalg.norm(force) > 0.1 for force in stylus.forces[-5:]):
            assert run.running
            run.wait(0.01)
    report = run.finish()

    assert device.name() == "Stylus in Python"
    assert report.fault is palpate.DeviceFault.none
    assert report.peak_force > 0.1
    assert stylus.threads and threading.get_ident() not in stylus.threads
    assert stylus.forces[-1].tolist() == [0.0, 0.0, 0.0]
    assert palpate.replay(scene, palpate.read_record(record)).equal


def test_the_wrapper_stands_before_a_driver_in_python():
    scene, stylus = organ_scene(1), Stylus()
    options = palpate.LoopOptions(safety=palpate.SafetyLimits(force_max=0.05))
    with palpate.PythonDevice(stylus) as device, LiveRun(scene, device, options=options) as run:
        while not any(np.linalg.norm(force) > 0.04 for force in stylus.forces[-5:]):
            assert run.running
            run.wait(0.01)

    assert max(np.linalg.norm(force) for force in stylus.forces) <= 0.05 * (1 + 1e-9)


def test_an_exception_of_a_driver_becomes_a_device_fault_with_its_text():
    stylus = Stylus(fail_at=50)
    with palpate.PythonDevice(stylus) as device:
        run = LiveRun(organ_scene(1), device, options=ending())
        with run:
            assert run.wait(60.0)
        report = run.finish()

    assert report.fault is palpate.DeviceFault.device_failed
    assert report.fault_reason == "Stylus in Python: ValueError: the stylus broke in two"
    assert stylus.reads == 50
    assert stylus.forces[-1].tolist() == [0.0, 0.0, 0.0]


def test_a_driver_that_hangs_gets_no_force_and_is_a_fault_after_a_second():
    stylus = Stylus()
    with palpate.PythonDevice(stylus) as device:
        run = LiveRun(organ_scene(1), device, options=ending())
        with run:
            run.wait(0.05)
            stylus.hangs.set()
            assert run.wait(60.0)
        report = run.finish()
        stylus.hangs.clear()

    assert report.fault is palpate.DeviceFault.motors_cut
    assert report.fault_reason == "Stylus in Python: has told nothing for a second"
    assert report.unrendered_ticks > 0


def test_a_hand_out_of_reach_is_named_as_such():
    class Lost(Stylus):
        def read(self):
            super().read()
            return (1e300 if self.reads > 20 else 0.0, 0.0, 0.028)

    with palpate.PythonDevice(Lost(), name="lost") as device:
        run = LiveRun(organ_scene(1), device, options=ending())
        with run:
            assert run.wait(60.0)
        report = run.finish()

    assert report.fault is palpate.DeviceFault.sample_out_of_reach
    assert report.fault_reason == "the device told a hand at 1e+300 m, expected within 10 m"


class Clock:
    """In place of `time`: goes on by what is slept, so that a busy machine is not measured too."""

    def __init__(self):
        self.now = 100.0

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds
        time.sleep(1e-5)


def test_a_driver_that_tells_positions_alone_gets_their_velocity(monkeypatch):
    clock = Clock()

    class Slow(Stylus):
        def read(self):
            super().read()
            return None if self.reads % 3 else (0.05 * (clock.now - 100.0), 0.0, 0.028)

    monkeypatch.setattr("palpate.python_device.time", clock)
    device = palpate.PythonDevice(Slow())
    with device:
        while device.driver.reads < 300:
            time.sleep(0.01)
        sample = device.read(0.0)

    assert sample.velocity[0] == pytest.approx(0.05, rel=0.02)
    assert sample.position[0] > 0.0


def test_a_driver_that_fails_at_once_refuses_the_start_in_its_own_words():
    device = palpate.PythonDevice(Stylus(fail_at=1))
    with pytest.raises(palpate.DeviceError, match="ValueError: the stylus broke in two"):
        device.start()
    with pytest.raises(RuntimeError, match="second time"):
        device.start()


def test_a_driver_that_says_nothing_refuses_the_start():
    class Mute(Stylus):
        def read(self):
            return None

    with pytest.raises(palpate.DeviceError, match="Stylus|Mute in Python: no sample within 0.1 s"):
        palpate.PythonDevice(Mute()).start(timeout=0.1)


@pytest.mark.parametrize(
    ("driver", "words"), [(object(), "got no read"), (Stylus, "")], ids=["nothing", "a class"]
)
def test_what_is_no_driver_is_refused(driver, words):
    if not words:
        with pytest.raises(palpate.DeviceError, match="TypeError"):
            palpate.PythonDevice(driver).start()
        return
    with pytest.raises(TypeError, match=words):
        palpate.PythonDevice(driver)


def test_a_rate_that_means_nothing_is_refused():
    for rate in (0.0, -1.0, float("nan"), 1e6):
        with pytest.raises(ValueError, match="rate"):
            palpate.PythonDevice(Stylus(), rate=rate)


def test_a_device_that_was_stopped_counts_as_gone():
    device = palpate.PythonDevice(Stylus())
    device.start()
    device.stop()
    device.stop()

    assert device.failed()
    assert device.explain_fault() == "Stylus in Python: was stopped"
    assert device.motors() is palpate.MotorState.cut


def test_the_example_in_python_runs_and_is_checked(capsys):
    runpy.run_path(str(EXAMPLE), run_name="__main__")

    # how smooth its hand is depends on how busy the machine is
    said = capsys.readouterr().out
    for kept in ("every number of a sample is finite", "a failure stays one", "it has not failed"):
        assert f"ok     {kept}: " in said
