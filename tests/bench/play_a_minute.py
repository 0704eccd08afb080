# SPDX-License-Identifier: BSD-3-Clause
"""A minute of play in the trainee's window: what is missed, and through whose fault.

    .venv/bin/python tests/bench/play_a_minute.py [--seconds 60] [--vertices 5400] [--json]

A mouse strokes, presses and pulls an organ of mass and springs. Then the hand that was recorded is
played once more with no window: ticks that are missed there too are not missed through Python. A
frame counts as missed where it came more than a screen's period later than the drawing of it and
of the one before can explain.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
import palpate
from palpate import scenario
from palpate.bench import generate_ellipsoid
from palpate.player import TraineeWindow
from palpate.runs.live import LiveRun
from palpate.runs.play import open_play
from palpate.scene.scene_file import compile_scene
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile, ToolPart
from palpate.viewport import FboView, GLView
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

PERIOD = 1.0 / 60.0
"""[s] of a screen."""
MOUSE_MS = 16
LATE = 200
"""[us] behind its due time: another program had the processor."""
ROUND = 4.0
"""[s] in which the mouse goes around once; in every second of them it does something else."""


def publish_organ(path: Path, vertices: int) -> None:
    """So heavy and soft that four substeps are enough: a tick has time left in its millisecond,
    and what is missed is missed for another reason than the price of the tissue.
    """
    scene = compile_scene(
        SceneFile(
            organ=None,
            material=MaterialPart(wall_thickness=5e-2),
            model=ModelPart(stiffness=30.0, home_stiffness=3e5, drag=20.0),
            tool=ToolPart(radius=4e-3, stiffness=3e6),
            hand=HandPart(hold_stiffness=100.0),
        ),
        generate_ellipsoid(vertices),
    )
    scenario.write(path, scenario.Scenario(scene=scene, title="A minute of play"))


class Stopwatch:
    """When frames were drawn, and how long that took, from outside of the view."""

    def __init__(self, view: FboView | GLView):
        self.moments: list[float] = []
        self.costs: list[float] = []
        self._paint = view.paint_frame
        view.paint_frame = self._measure

    def _measure(self) -> bool:
        begun = time.perf_counter()
        drawn = self._paint()
        if drawn:
            self.moments.append(time.perf_counter())
            self.costs.append(self.moments[-1] - begun)
        return drawn

    def report(self) -> dict[str, Any]:
        if len(self.moments) < 2:
            return {"frames": len(self.moments)}
        gaps, costs = np.diff(self.moments), np.array(self.costs)
        explained = np.maximum(PERIOD, costs[1:] + costs[:-1]) + PERIOD
        return {
            "frames": len(self.moments),
            "frames_missed": int((gaps > explained).sum()),
            "frame_interval_p50_ms": 1e3 * float(np.median(gaps)),
            "frame_interval_p99_ms": 1e3 * float(np.percentile(gaps, 99)),
            "draw_p50_ms": 1e3 * float(np.median(costs)),
            "draw_p99_ms": 1e3 * float(np.percentile(costs, 99)),
        }


class Mouse:
    """Goes around on the organ; presses and pulls now and then."""

    def __init__(self, window: TraineeWindow):
        self._window, self._begun = window, time.perf_counter()
        self._held = Qt.MouseButton.NoButton
        self._timer = QTimer(window)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._step)
        self._timer.start(MOUSE_MS)

    def stop(self) -> None:
        self._timer.stop()

    def _step(self) -> None:
        now = time.perf_counter() - self._begun
        wanted = (
            Qt.MouseButton.NoButton,
            Qt.MouseButton.LeftButton,
            Qt.MouseButton.NoButton,
            Qt.MouseButton.RightButton,
        )[int(now) % 4]
        at = self._place(now)
        if wanted != self._held:
            if self._held != Qt.MouseButton.NoButton:
                self._send(QEvent.Type.MouseButtonRelease, at, self._held)
            if wanted != Qt.MouseButton.NoButton:
                self._send(QEvent.Type.MouseButtonPress, at, wanted)
            self._held = wanted
        self._send(QEvent.Type.MouseMove, at, Qt.MouseButton.NoButton)

    def _place(self, now: float) -> QPoint:
        view = self._window.view
        middle = view.world_to_pixel(view.scenery.centre)
        turn = 2.0 * math.pi * now / ROUND
        reach = 0.05 * view.height()
        return QPointF(
            middle.x() + reach * math.cos(turn), middle.y() + reach * math.sin(turn)
        ).toPoint()

    def _send(self, kind: QEvent.Type, at: QPoint, button: Qt.MouseButton) -> None:
        view, where = self._window.view, QPointF(at)
        held = button if kind == QEvent.Type.MouseButtonPress else self._held
        event = QMouseEvent(
            kind, where, view.mapToGlobal(where), button, held, Qt.KeyboardModifier.NoModifier
        )
        QApplication.sendEvent(view, event)


def play(path: Path, seconds: float, size: tuple[int, int]) -> dict[str, Any]:
    """A run in the window, of so many seconds of its own time."""
    app = QApplication.instance() or QApplication(["play_a_minute"])
    window = TraineeWindow(open_play(path, record=path.with_suffix(".prec"), duration=seconds))
    window.resize(*size)
    window.show()
    app.processEvents()
    window.view.grab_picture()  # programs compiled, light gathered
    watch = Stopwatch(window.view)
    window.restart()
    mouse = Mouse(window)
    while window.run is not None:
        app.processEvents()
        time.sleep(1e-3)
    mouse.stop()
    report = window.report() | watch.report()
    report["trouble"] = window.over.end.trouble.text()
    report["host"] = type(window.view).__name__
    window.close()
    window.deleteLater()
    app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return report


def play_without_window(scene: palpate.Scene, record: palpate.Record) -> palpate.LoopReport:
    """The same hand, tick by tick, in the same loop, and nothing else in this process."""
    device = palpate.ReplayDevice(record.hand)
    with LiveRun(scene, device) as run:
        while run.report().ticks < len(record.hand):
            run.wait(0.01)
    return run.finish()


def measure(
    folder: Path, seconds: float, vertices: int, size: tuple[int, int] = (1280, 800)
) -> dict[str, Any]:
    """All figures of one minute."""
    path = folder / "minute.palpate"
    publish_organ(path, vertices)
    report = play(path, seconds, size)
    record = palpate.read_record(report["record"])
    scene = scenario.read(path).scene
    alone = play_without_window(scene, record)
    replayed = palpate.replay(scene, record)
    kinds = record.events["kind"].tolist()
    return report | {
        "vertices": vertices,
        "rows": len(record.hand),
        "complete": record.complete,
        "attached": kinds.count(palpate.EventKind.attached),
        "replay_equal": replayed.equal,
        "missed_ticks_without_window": alone.missed_ticks,
        "lateness_p99_us_without_window": 1e6 * alone.lateness.p99,
        "tick_p99_us_without_window": 1e6 * alone.cost.p99,
        "ticks_started_late": int((np.asarray(record.felt["lateness_us"]) > LATE).sum()),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--vertices", type=int, default=5400)
    parser.add_argument("--json", action="store_true")
    call = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory() as folder:
        report = measure(Path(folder), call.seconds, call.vertices)
    if call.json:
        print(json.dumps(report, indent=2))
    else:
        for name, value in report.items():
            print(f"{name:32} {value:.1f}" if isinstance(value, float) else f"{name:32} {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
