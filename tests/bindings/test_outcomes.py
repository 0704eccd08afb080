# SPDX-License-Identifier: BSD-3-Clause
"""Every way in which an attempt can end: the live loop, its record and the replay agree on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.author import (
    add_limit,
    add_place,
    add_step,
    new_assessment,
)
from palpate.assessment.publish import with_assessment
from palpate.assessment.verdict import pick_events
from palpate.runs.live import LiveRun
from palpate.runs.run import describe_build
from published import publish_unstable

MESHES = Path(__file__).resolve().parents[2] / "meshes"
RADIUS = 0.007
OUTCOME = palpate.Outcome


@dataclass
class Setting:
    """A scene, what is judged in it, and where its highest point is."""

    scene: palpate.Scene
    drawn: scenario.DrawnTask
    top: np.ndarray
    path: Path


def prepare(path: Path, time_limit: float = 30.0, ends_above: float = 0.0, hold: float = 0.0):
    """Touch, or hold for so long [s], the patch round the highest point."""
    organ = scenario.read(path)
    x = np.asarray(organ.scene.bodies[0].tissue.rest_position)
    top = x[x[:, 2].argmax()]
    made = new_assessment("organ", {"en": "Short"})
    ball = [*map(float, top), 0.02]
    made, at = add_place(made, "top", {"organ": "organ", "ball": ball})
    values = {"for_s": hold} if hold else {}
    made, _ = add_step(made, "touch", at, values)
    if ends_above:
        made, _ = add_limit(made, "force", {"above": ends_above, "for_s": 0.02}, "end")
    made["finish"]["time_limit_s"] = time_limit
    published = with_assessment("short", made, organ)
    return Setting(published.scene, scenario.draw_task(published), top, path)


def press(setting: Setting, depth: float) -> list[palpate.KeyFrame]:
    """Down at half a second, and there it stays."""
    radius = setting.scene.instruments[0].tool.radius
    up, down = (setting.top + [0, 0, radius + height] for height in (0.01, -depth))
    return [palpate.KeyFrame(0.0, up), palpate.KeyFrame(0.3, down), palpate.KeyFrame(1.5, down)]


def run(
    setting: Setting,
    device: palpate.HapticDevice,
    path: Path,
    duration: float = 2.0,
    meanwhile: Callable[[], None] = lambda: None,
) -> palpate.LoopReport:
    options = palpate.LoopOptions(duration=duration, on_fault=palpate.FaultResponse.end)
    header = describe_build(setting.scene, setting.path, path, device.name(), setting.drawn)
    live = LiveRun(setting.scene, device, record=path, header=header, options=options,
                   task=setting.drawn.task)  # fmt: skip
    with live:
        meanwhile()
        assert live.wait(60.0)
    return live.report()


SIMPLE = MESHES / "published" / "simple_tissue.palpate"


def play_done(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(SIMPLE)
    device = palpate.ScriptedDevice(press(setting, 0.003))
    return setting, run(setting, device, folder / "run.prec")


def play_failed(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(SIMPLE, ends_above=0.05, hold=5.0)
    device = palpate.ScriptedDevice(press(setting, 0.006))
    return setting, run(setting, device, folder / "run.prec")


def play_timed_out(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(SIMPLE, time_limit=0.4)
    device = palpate.ScriptedDevice(press(setting, -0.01))
    return setting, run(setting, device, folder / "run.prec")


def play_left(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(SIMPLE)
    device = palpate.ScriptedDevice(press(setting, -0.01))
    return setting, run(setting, device, folder / "run.prec", 0.3)


def play_device_fault(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(SIMPLE)
    arm = palpate.SimulatedArm(palpate.ScriptedDevice(press(setting, -0.01)), setting.top)
    arm.open()
    return setting, run(setting, arm, folder / "run.prec", 30.0, arm.pull_cable)


def play_diverged(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    setting = prepare(publish_unstable(folder), hold=5.0)
    device = palpate.ScriptedDevice(press(setting, 0.01))
    return setting, run(setting, device, folder / "run.prec")


def play_interrupted(folder: Path) -> tuple[Setting, palpate.LoopReport]:
    """What a killed program leaves: the record without its last block."""
    setting, report = play_left(folder)
    path = folder / "run.prec"
    path.write_bytes(path.read_bytes()[:-400])
    return setting, report


PLAYED: dict[str, Callable[[Path], tuple[Setting, palpate.LoopReport]]] = {
    "done": play_done,
    "failed": play_failed,
    "timed_out": play_timed_out,
    "left": play_left,
    "device_fault": play_device_fault,
    "diverged": play_diverged,
    "interrupted": play_interrupted,
}


def test_every_outcome_is_played_here():
    assert set(PLAYED) == {one.name for one in OUTCOME if one is not OUTCOME.running}


@pytest.mark.parametrize("name", PLAYED)
def test_loop_record_and_replay_agree_how_an_attempt_ended(name, tmp_path):
    setting, report = PLAYED[name](tmp_path)

    record = palpate.read_record(str(tmp_path / "run.prec"))
    again = palpate.replay(setting.scene, record, setting.drawn.task)

    assert palpate.find_outcome(record).name == name
    assert again.task.outcome.name == name
    assert record.complete == (name != "interrupted")
    if name == "interrupted":
        return
    assert report.outcome.name == name
    assert again.events_equal, again.first_event_difference
    events = pick_events(record.events)
    assert int(events[-1]["kind"]) == int(palpate.TaskEvent.task_ended)
    assert int(events[-1]["tick"]) <= report.ticks
