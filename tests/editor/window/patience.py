# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a test of the window waits, and for what."""

from __future__ import annotations

from palpate_editor.views.window import MainWindow
from PySide6.QtWidgets import QApplication

PATIENCE = 60_000
"""[ms] A loaded machine may take long; nothing is judged by it."""


def settle(qtbot, window: MainWindow) -> None:
    """Waits until no work is under way and the open organ has been looked at."""
    qtbot.waitUntil(lambda: window.context.jobs.current is None, timeout=PATIENCE)
    qtbot.waitUntil(
        lambda: window.context.assessor.is_current and not window.context.assessor.busy,
        timeout=PATIENCE,
    )


def rest(qtbot, window: MainWindow) -> None:
    """Waits until the view has drawn what it shows as finely as it does while nothing moves."""
    timers = (window.view._rest, window.view._pause, window.view._light)

    def is_at_rest() -> bool:
        QApplication.processEvents()  # a frame that is asked for starts them
        return not any(timer.isActive() for timer in timers)

    qtbot.waitUntil(is_at_rest, timeout=PATIENCE)
