# SPDX-License-Identifier: BSD-3-Clause
"""A published scenario and a script for it, as the tests of playing use them."""

from __future__ import annotations

from pathlib import Path

import palpate
from palpate import scenario
from palpate.runs.script_file import write_script_file
from surfaces import organ_scene, press_frames

TITLE, TASK = "Spleen: find the firm spot", "Stroke gently. Stay below 2 N."


def publish(folder: Path, title: str = TITLE, task: str = TASK, subdivisions: int = 2) -> Path:
    path = folder / "spleen.palpate"
    scene = organ_scene(subdivisions)
    scenario.write(path, scenario.Scenario(scene=scene, title=title, task=task))
    return path


def publish_unstable(folder: Path) -> Path:
    """An organ that blows up as soon as it is touched: its contact is far too stiff."""
    scene = organ_scene(2, stiffness=400.0)
    scene.instruments[0].tool.stiffness = 3e10
    path = folder / "unstable.palpate"
    scenario.write(path, scenario.Scenario(scene=scene, title="Unstable"))
    return path


def write_press(folder: Path) -> Path:
    path = folder / "press.json"
    write_script_file(path, press_frames())
    return path


def read_peak(record: Path) -> float:
    """[N]"""
    rows = palpate.read_record(record)
    return float((rows.felt["force"].astype(float) ** 2).sum(axis=1).max() ** 0.5)
