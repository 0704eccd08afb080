# SPDX-License-Identifier: BSD-3-Clause
"""A device of your own, in Python: to try a device out, not to train with, for Python is outside of
real time. As it stands it is a mass on a spring; the two places marked FILL IN are yours.

    python tests/examples/add_a_device/my_device.py
"""

from __future__ import annotations

import time

import numpy as np
import palpate


class MyDriver:
    """A thread of PythonDevice calls read and write, one after the other."""

    def __init__(self) -> None:
        self._position, self._velocity = np.array([0.01, 0.0, 0.0]), np.zeros(3)
        self._force, self._time = np.zeros(3), time.monotonic()

    def read(self) -> palpate.HapticSample:
        # FILL IN 1: where the hand is [m], and its velocity [m/s], buttons and orientation where
        # your device knows them. Positions alone will do: return them as an array (3,), and None
        # where nothing is new. Here, a mass of 100 g swings under the last force.
        now = time.monotonic()
        dt, self._time = min(now - self._time, 2e-3), now
        pull = self._force - 50.0 * self._position - 1.0 * self._velocity
        self._velocity += dt / 0.1 * pull
        self._position += dt * self._velocity
        return palpate.HapticSample(position=self._position, velocity=self._velocity)

    def write(self, force: np.ndarray) -> None:
        # FILL IN 2: push the hand with this force [N] until the next one.
        self._force = force


if __name__ == "__main__":
    with palpate.PythonDevice(MyDriver()) as device:
        safe = palpate.SafeDevice(device, palpate.SafetyLimits(force_max=3.0))
        for check in palpate.check_conformance(safe, palpate.ConformanceOptions(live=True)):
            print(f"{'ok' if check.passed else 'FAILED':6} {check.name}: {check.detail}")
