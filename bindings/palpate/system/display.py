# SPDX-License-Identifier: BSD-3-Clause
"""Whether there is a display for a window, found out before Qt ends the program over it."""

from __future__ import annotations

import os
import subprocess
import sys

from palpate.system.isolated import build_command

PROBE = "from PySide6.QtGui import QGuiApplication; QGuiApplication([])"


def require_display(instead: str) -> None:
    """Raises RuntimeError, saying what can be done `instead`, where no window can be opened.

    PySide6 must be installed.
    """
    if not sys.platform.startswith("linux") or os.environ.get("QT_QPA_PLATFORM"):
        return
    name = os.environ.get("WAYLAND_DISPLAY") or os.environ.get("DISPLAY")
    if not name:
        raise RuntimeError(f"there is no display to open a window on; {instead}")
    # another user's display, or one that is gone: only another process survives finding out
    probe = subprocess.run(build_command("-c", PROBE), capture_output=True, check=False)
    if probe.returncode != 0:
        raise RuntimeError(f"the display {name} cannot be reached; {instead}")
