# SPDX-License-Identifier: BSD-3-Clause
"""A stone through a device that bears soft tissue only: a trainee is told how much is missing."""

from __future__ import annotations

from pathlib import Path

import palpate
import pytest
from palpate.runs.coupling import FELT_WITHIN
from palpate.runs.play import open_play
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.script_file import write_script_file
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from windows import keep_picture

STONE = Path(__file__).resolve().parents[2] / "meshes" / "published" / "kidney_stone.palpate"
PATIENCE = 60_000
"""[ms]"""


def write_slow_press(folder: Path) -> Path:
    """From above, 2 mm beyond the first touch, after the arm has come to rest."""
    scene = palpate.scenario.read(STONE).scene
    press = PressScript(depth=2e-3, speed=0.01, hold=2.0)
    frames, _ = write_script(find_top(scene), scene.instruments[0].tool.radius, press)
    later = [palpate.KeyFrame(0.8 + each.time, each.position) for each in frames]
    path = folder / "press.json"
    write_script_file(path, [palpate.KeyFrame(0.0, frames[0].position), *later])
    return path


@pytest.mark.window
@pytest.mark.landing
def test_what_a_weak_device_takes_of_a_stiffness_stands_in_the_picture(
    open_window, qtbot, tmp_path
):
    script = write_slow_press(tmp_path)
    window = open_window(open_play(STONE, f"plant:script:{script}"))
    window.restart()

    def find_softer() -> float:
        """[%] That is told."""
        told = dict(window.view.hud.rows).get("Feels softer", "0 %")
        return float(told.removesuffix(" %"))

    assert find_softer() == 0.0  # nothing is touched
    qtbot.waitUntil(lambda: find_softer() > 100 * FELT_WITHIN, timeout=PATIENCE)
    assert window.view.hud.isVisible()
    keep_picture(window, "player_feels_softer")
    window.use_language("tr")
    qtbot.waitUntil(lambda: "Daha yumuşak" in str(window.view.hud.rows), timeout=PATIENCE)
    most = window.run.report().devices[0].stiffness_error
    assert find_softer() <= 100 * most + 1.0
    QTest.keyClick(window, Qt.Key.Key_Escape)
    window.close()
