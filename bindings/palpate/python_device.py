# SPDX-License-Identifier: BSD-3-Clause
"""A haptic device whose driver is written in Python."""

from __future__ import annotations

import threading
import time
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate._sim import HapticSample, MailboxDevice, VelocityWindow
from palpate.error import DeviceError

RATE = 1000.0
"""[Hz] at which a driver is asked, as far as Python and its library get there."""
STEP = 1e-5
"""[m] between two positions that a driver can tell apart, if it does not say."""


class Driver(Protocol):
    """What PythonDevice asks of a driver. Its own thread calls both, one after the other."""

    def read(self) -> HapticSample | ArrayLike | None:
        """Where the hand is: a sample, a position [m] (3,) alone, or None where it is as before.
        The time of a sample does not matter.
        """

    def write(self, force: NDArray[np.float64]) -> None:
        """Pushes the hand with a force [N] (3,) until the next one."""


class PythonDevice(MailboxDevice):
    """A haptic device whose driver is a Python object with read() and write(force).

    A thread of its own asks the driver as often as it can, up to `rate`, and passes on what it says
    through a mailbox: the haptic thread never waits for Python. The loop puts a SafeDevice around
    it as around any other. An exception of the driver, or a stop of its thread, is a fault of the
    device, which ends or pauses a run with its text; the last thing a driver is told is no force.

    Outside of real time: Python may be late by milliseconds at any moment, so what is felt may buzz
    on stiff tissue. For training, write the driver in C++ (tests/examples/add_a_device).

        with PythonDevice(Stylus()) as device, LiveRun(scene, device) as run:
            run.wait(10.0)
    """

    def __init__(
        self, driver: Driver, *, name: str = "", rate: float = RATE, step: float = STEP
    ) -> None:
        """`rate` [Hz]; `step` [m]: how far two neighbouring positions are apart, by which the speed
        is found where the driver tells positions alone.
        """
        if not 0.0 < rate <= 10_000.0:
            raise ValueError(f"rate [Hz]: got {rate:g}, expected more than 0, at most 10000")
        for call in ("read", "write"):
            if not callable(getattr(driver, call, None)):
                raise TypeError(
                    f"{type(driver).__name__}: got no {call}(), expected a driver with read() "
                    "and write(force)"
                )
        super().__init__(name or f"{type(driver).__name__} in Python")
        self.driver, self._period = driver, 1.0 / rate
        self._speeds = [VelocityWindow(step) for _ in range(3)]
        self._last: HapticSample | None = None
        self._stopping, self._heard = threading.Event(), threading.Event()
        self._thread: threading.Thread | None = None

    def start(self, timeout: float = 3.0) -> None:
        """Begins to ask the driver, and waits for its first sample.

        Raises DeviceError where the driver fails or none comes within `timeout` [s], RuntimeError
        the second time.
        """
        if self._thread is not None:
            raise RuntimeError(f"{self.name()}: got start() a second time, expected it once")
        self._thread = threading.Thread(target=self._work, name=self.name(), daemon=True)
        self._thread.start()
        heard = self._heard.wait(timeout)
        if self.failed() or not heard:
            reason = self.explain_fault() or f"{self.name()}: no sample within {timeout:g} s"
            self.stop()
            raise DeviceError(reason)

    def stop(self) -> None:
        """The driver is told no force, and then nothing any more. For good; may be repeated."""
        self._stopping.set()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join()
        self.fail("was stopped")

    def __enter__(self) -> PythonDevice:
        self.start()
        return self

    def __exit__(self, *problem: object) -> None:
        self.stop()

    def _work(self) -> None:
        try:
            self._ask_until_stopped()
        except BaseException as problem:  # also an exit of the driver: nobody else would hear of it
            self.fail(f"{type(problem).__name__}: {problem}")
        finally:
            self._heard.set()
            self._let_go()

    def _ask_until_stopped(self) -> None:
        due = time.monotonic()
        while not self._stopping.is_set():
            told = self.driver.read()
            if told is not None:
                self._last = self._build_sample(told)
            if self._last is not None:
                self.tell(self._last)
                self._heard.set()
            self.driver.write(np.array(self.take_command().force))
            due = max(due + self._period, time.monotonic())
            time.sleep(max(0.0, due - time.monotonic()))

    def _build_sample(self, told: HapticSample | ArrayLike) -> HapticSample:
        if isinstance(told, HapticSample):
            return told
        place = np.asarray(told, dtype=float)
        if place.shape != (3,):
            raise ValueError(f"read(): got a shape of {place.shape}, expected a position (3,)")
        now = time.monotonic()
        speed = [window.add(now, x) for window, x in zip(self._speeds, place, strict=True)]
        return HapticSample(position=place, velocity=speed)

    def _let_go(self) -> None:
        try:
            self.driver.write(np.zeros(3))
        except Exception as problem:
            self.fail(f"{type(problem).__name__}: {problem}")
