# SPDX-License-Identifier: BSD-3-Clause
"""Work that takes its time, in a thread of its own; the window asks whether it is done."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

PATIENCE = 2.0
"""[s] that a window waits for its work when it closes."""


class Job:
    """Runs at once. Nothing of it touches a widget."""

    def __init__(self, work: Callable[[], Any]):
        self._work = work
        self.result: Any = None
        self.problem: Exception | None = None
        """What it ended with instead of a result."""
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    @property
    def done(self) -> bool:
        return not self._thread.is_alive()

    def wait(self) -> None:
        self._thread.join(PATIENCE)

    def _run(self) -> None:
        try:
            self.result = self._work()
        except Exception as problem:
            self.problem = problem
