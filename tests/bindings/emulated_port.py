# SPDX-License-Identifier: BSD-3-Clause
"""The low-cost device as a file that a program opens as its serial port, and what befalls it."""

from __future__ import annotations

import os
import select
import subprocess
import sys
import threading
import time
import tty
from collections import deque
from pathlib import Path

import numpy as np
import palpate
from palpate.runs.other_hands import find_centre

TICK = 1e-3
"""[s] of the device."""
PATIENCE = 30.0
"""[s] that a patient device, its motors on, waits for a word of its host."""
KEPT = 5.0
"""[s] of a device's life in which its motors come on; a hand waits no longer."""


class EmulatedPort:
    """The firmware's own code behind a pseudo terminal, in real time; what happens to it, and when
    the hand begins its way, goes by the time since its motors came on.

    A patient device lives on only when its host has spoken: it takes no busy machine for a silence.
    """

    def __init__(
        self,
        *,
        frames: list[palpate.KeyFrame] | None = None,
        scene: palpate.Scene | None = None,
        cut_after: float = np.inf,
        unplug_after: float = np.inf,
        delay: float = 0.0,
        delayed_until: float = 0.0,
    ):
        """[s] all of them; `frames` of the hand are in the frame of `scene`, each way of the wire
        takes `delay` until the device has lived for `delayed_until`.
        """
        self.core = palpate.NativeCore()
        self.patient = True
        self._cut_after, self._unplug_after = cut_after, unplug_after
        self._delay, self._delayed_until = delay, delayed_until
        self._hand = None if frames is None else palpate.ScriptedDevice(frames)
        self._to_arm = palpate.Workspace().center
        if scene is not None:
            self._to_arm = self._to_arm - find_centre(scene, 0, 0.0)
        self._clock, self._on_since = 0.0, np.inf
        self._up: deque[tuple[float, bytes]] = deque()
        self._down: deque[tuple[float, bytes]] = deque()
        self._ours, self._theirs = os.openpty()
        tty.setraw(self._theirs)
        os.set_blocking(self._ours, False)
        self.path = os.ttyname(self._theirs)
        self.came_on, self.gone = threading.Event(), threading.Event()
        self._stopping = threading.Event()
        self._thread = threading.Thread(target=self._live)

    def __enter__(self) -> EmulatedPort:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stopping.set()
        self._thread.join()
        self._unplug()

    def _unplug(self) -> None:
        if not self.gone.is_set():
            self.gone.set()
            os.close(self._ours)
            os.close(self._theirs)

    def _live(self) -> None:
        due = time.monotonic()
        while not self._stopping.is_set() and not self.gone.is_set():
            due = max(due + TICK, time.monotonic() if self.patient else 0.0)
            time.sleep(max(0.0, due - time.monotonic()))
            self._listen()
            self._live_tick()

    def _listen(self) -> None:
        heard, until = False, time.monotonic() + PATIENCE
        while self._must_wait() and not heard and time.monotonic() < until:
            heard = bool(select.select([self._ours], [], [], 0.02)[0])
        try:
            came = os.read(self._ours, 4096)
        except BlockingIOError:
            return
        self._down.append((self._arrival(self._down), came))

    def _must_wait(self) -> bool:
        return self.patient and self.core.drive().enabled and not self._stopping.is_set()

    def _arrival(self, wire: deque[tuple[float, bytes]]) -> float:
        late = self._clock
        if self._clock < self._delayed_until:
            late = min(self._clock + self._delay, self._delayed_until)
        return max(late, wire[-1][0] if wire else 0.0)

    def _live_tick(self) -> None:
        self._clock += TICK
        since = self._clock - self._on_since
        self._follow_hand(max(0.0, min(since, KEPT)))
        self.core.press_stop(since >= self._cut_after)
        while self._down and self._down[0][0] <= self._clock:
            self.core.write(self._clock, self._down.popleft()[1])
        said = self.core.read(self._clock)
        if said:
            self._up.append((self._arrival(self._up), said))
        if self.core.drive().enabled and not self.came_on.is_set():
            self._on_since = self._clock
            self.came_on.set()
        if since >= self._unplug_after:
            self._unplug()
            return
        while self._up and self._up[0][0] <= self._clock:
            # a full terminal has no reader: a wire without a reader loses bytes too
            try:
                os.write(self._ours, self._up.popleft()[1])
            except BlockingIOError:
                return

    def _follow_hand(self, since: float) -> None:
        if self._hand is not None:
            hand = self._hand.read(since)
            place = np.asarray(hand.position) + self._to_arm
            self.core.hold(palpate.HandTarget(place, np.asarray(hand.velocity), True))


def play_as_process(path: Path, port: EmulatedPort, record: Path, *more: str) -> subprocess.Popen:
    """`palpate play --headless` on the port, as a person starts it."""
    command = [sys.executable, "-P", "-m", "palpate", "play", str(path), "--headless"]
    words = ["--device", f"serial:{port.path}", "--record", str(record), *more]
    return subprocess.Popen(
        [*command, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"
    )
