# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the device window: the simulated arm, its motors on, drawn away from a spring.

export QT_QPA_PLATFORM=offscreen
.venv/bin/python firmware/draw_window.py firmware/pictures/device_window.png
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import palpate
from palpate.device_window import DeviceWindow
from PySide6.QtWidgets import QApplication

SIZE = (1320, 1020)
"""[px]"""
PATIENCE = 20.0
"""[s]"""
MOVED = 6.0
"""[s] that the hand moves."""


def wait(app: QApplication, done: Callable[[], bool]) -> None:
    """Lets the window live until something has come about. Raises RuntimeError."""
    until = time.monotonic() + PATIENCE
    while not done():
        app.processEvents()
        time.sleep(2e-3)
        if time.monotonic() > until:
            raise RuntimeError("the window did not get there in time")


def find_place(seconds: float) -> np.ndarray:
    """[m] of the hand, around the middle of the workspace."""
    t = 2.0 * (MOVED - seconds)
    offset = [0.009 * np.cos(t), -0.012 * np.cos(0.7 * t), -0.014 * np.cos(1.45 * t)]
    return np.asarray(palpate.Workspace().center) + offset


def draw_window(out: Path, theme: str = "dark") -> None:
    app = QApplication.instance() or QApplication(["palpate"])
    app.setStyle("Fusion")
    window = DeviceWindow(theme)
    window.resize(*SIZE)
    window.show()
    window.connect_to("plant")
    wait(app, lambda: window.link is not None)
    link = window.link
    assert link is not None
    window.monitor.switch_motors(True)
    wait(app, lambda: link.status().mode is palpate.DeviceMode.run)
    window.monitor.switch_spring(True)
    begun = time.monotonic()

    def move() -> bool:
        passed = time.monotonic() - begun
        link.hold(find_place(min(passed, MOVED)))
        return passed > MOVED

    wait(app, move)
    window.follow()
    window.view.grab_picture()
    window.grab().save(str(out))
    window.close()


if __name__ == "__main__":
    draw_window(Path(sys.argv[1]), *sys.argv[2:3])
