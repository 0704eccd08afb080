# SPDX-License-Identifier: BSD-3-Clause
"""The trainee's window with a short task: what its tests share."""

from __future__ import annotations

from pathlib import Path

import palpate
from palpate.player import TraineeWindow
from palpate.runs.play import Play, open_play
from PySide6.QtTest import QTest
from windows import LEFT, grab

MESHES = Path(__file__).resolve().parents[2] / "meshes"
PATIENCE = 60_000
"""[ms] A run on a machine that has much else to do."""


class Scripted(Play):
    """A mouse's window, whose hand is a careful one."""

    def build_hand(self, scene: palpate.Scene | None = None) -> palpate.HapticDevice:
        from palpate.assessment.selfplay import attempt

        if scene is not None:  # of the check of the device
            return palpate.SurfacePointer(scene)
        assert self.drawn is not None
        return palpate.ReplayDevice(attempt(self.scenario.scene, self.drawn, "careful").samples[0])


def open_task(short_task: Path) -> Play:
    play = open_play(short_task)
    return Scripted(**vars(play))


def click(button) -> None:
    assert button.isVisible(), button.text()
    QTest.mouseClick(button, LEFT)


def picture(window: TraineeWindow, checkout: Path, name: str) -> None:
    folder = checkout / "build" / "screenshots" / "trainee"
    folder.mkdir(parents=True, exist_ok=True)
    assert grab(window) is not None
    window.grab().save(str(folder / f"{name}.png"))
