# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a test of the window waits, and for what."""

from __future__ import annotations

from palpate_editor.views.window import MainWindow

PATIENCE = 60_000
"""[ms] A loaded machine may take long; nothing is judged by it."""


def settle(qtbot, window: MainWindow) -> None:
    """Waits until no work is under way and the open organ has been looked at."""
    qtbot.waitUntil(lambda: window.context.jobs.current is None, timeout=PATIENCE)
    qtbot.waitUntil(
        lambda: window.context.assessor.is_current and not window.context.assessor.busy,
        timeout=PATIENCE,
    )
