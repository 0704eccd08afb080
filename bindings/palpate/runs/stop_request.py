# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl+C or a termination signal as the regular end of what has no other."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM)


@contextmanager
def hear_stop() -> Iterator[threading.Event]:
    """An event that is set by the first of SIGNALS; later ones do what they did before. In a thread
    other than the main one, where Python hears no signals, nothing sets it.
    """
    stopped = threading.Event()
    before = {}

    def restore() -> None:
        for number, handler in before.items():
            signal.signal(number, handler)
        before.clear()

    def handle(number: int, frame: FrameType | None) -> None:
        del number, frame
        restore()
        stopped.set()

    try:
        if threading.current_thread() is threading.main_thread():
            for number in SIGNALS:
                before[number] = signal.signal(number, handle)
        yield stopped
    finally:
        restore()
