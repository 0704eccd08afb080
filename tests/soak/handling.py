# SPDX-License-Identifier: BSD-3-Clause
"""What happens to a program in a day, in seconds of it: runs with devices that fail, and saves."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
from palpate import scenario
from palpate.bench import generate_ellipsoid
from palpate.runs.live import LiveRun
from palpate.scene.scene_file import compile_scene
from palpate.scene.scene_parts import HandPart, MaterialPart, ModelPart, SceneFile, ToolPart

RADIUS = 4e-3
"""[m] of the tool."""
GRACE = 60.0
"""[s] after which a run that should have ended counts as stuck."""


class Unexpected(Exception):
    """A run that did not end as it should have."""


@dataclass
class Outcome:
    """What one run did."""

    kind: str
    ticks: int = 0
    missed: int = 0
    drift: float | None = None
    """[s] by which ticks, with the missed ones, fell behind the clock during the run; None where it
    was not measured."""


def build_scene() -> palpate.Scene:
    part = SceneFile(
        organ=None,
        material=MaterialPart(wall_thickness=5e-3),
        model=ModelPart(stiffness=50.0, home_stiffness=3e5, drag=20.0),
        tool=ToolPart(radius=RADIUS),
        hand=HandPart(),
    )
    return compile_scene(part, generate_ellipsoid(642))


def write_hand(choose: random.Random, top: float, seconds: float) -> list[palpate.KeyFrame]:
    """Presses, strokes and pulls about the organ's pole, none deeper than 4 mm."""
    frames = [palpate.KeyFrame(0.0, (0.0, 0.0, top + RADIUS + 5e-3))]
    at = 0.0
    while at < seconds:
        at += choose.uniform(0.15, 0.5)
        place = (choose.uniform(-6e-3, 6e-3), choose.uniform(-6e-3, 6e-3))
        depth = choose.uniform(-6e-3, 4e-3)
        frames.append(
            palpate.KeyFrame(at, (*place, top + RADIUS - depth), int(choose.random() < 0.2))
        )
    return frames


class Operator:
    """A scene, a folder, and a hand that does something else every time."""

    def __init__(self, folder: Path, seed: int):
        self.folder, self.choose = folder, random.Random(seed)
        self.scene = build_scene()
        self.top = float(self.scene.bodies[0].tissue.rest_position[:, 2].max())
        self.saves = 0

    def run_once(self) -> Outcome:
        """One run of one to five seconds, by chance of any kind, and a save beside it."""
        kinds: list[Callable[[palpate.HapticDevice, float], Outcome]] = [
            self.run_script,
            self.run_paused,
            self.run_arm,
            self.run_faulty_wire,
            self.run_unplugged,
        ]
        seconds = self.choose.uniform(1.0, 5.0)
        hand = palpate.ScriptedDevice(write_hand(self.choose, self.top, seconds))
        return self.choose.choice(kinds)(hand, seconds)

    def run_script(self, hand: palpate.HapticDevice, seconds: float) -> Outcome:
        """A run that is recorded, read back and, where it is short, run again to the same bits."""
        path = self.folder / "run.prec"
        with LiveRun(self.scene, hand, record=path, header={}, options=limited(seconds)) as run:
            run.wait(0.2)
            early = read_clocks(run)
            self.save()
            run.wait(0.5 * seconds)
            late = read_clocks(run)
            drift = late - early if run.running else None
            ended = run.wait(seconds + GRACE)
        report = run.finish()
        self.check(ended, report, "script")
        record = palpate.read_record(path)
        rows = len(record.hand) + report.record_gaps
        if not record.complete or rows != report.ticks:
            raise Unexpected(f"a record of {rows} rows, complete: {record.complete}")
        short = seconds < 1.5 and not report.record_gaps
        if short and not palpate.replay(self.scene, record).equal:
            raise Unexpected("a replay that differs")
        return Outcome("script", report.ticks, report.missed_ticks, drift)

    def run_paused(self, hand: palpate.HapticDevice, seconds: float) -> Outcome:
        """A run that is paused and resumed, then stopped before its end."""
        run = LiveRun(self.scene, hand, options=limited(seconds))
        with run:
            for _ in range(3):
                run.wait(seconds / 8)
                run.pause()
                self.save()
                run.resume()
                run.take_frame()
        report = run.finish()
        self.check(True, report, "paused")
        return Outcome("paused", report.ticks, report.missed_ticks)

    def run_arm(self, hand: palpate.HapticDevice, seconds: float) -> Outcome:
        """The device's firmware on a simulated arm, whose stop is pressed or sensor cut."""
        arm = palpate.SimulatedArm(hand, (0.0, 0.0, self.top))
        arm.open()
        fault = self.choose.choice(["none", "stop", "sensor", "cable"])
        with LiveRun(self.scene, arm, options=limited(seconds)) as run:
            run.wait(seconds / 3)
            if fault == "stop":
                arm.press_stop(True)
            elif fault == "sensor":
                arm.cut_sensor(self.choose.randrange(3), True)
            elif fault == "cable":
                arm.pull_cable()
            self.save()
            run.wait(seconds / 3)
            arm.press_stop(False)
            for joint in range(3):
                arm.cut_sensor(joint, False)
            arm.driver().clear_fault()
            ended = run.wait(seconds + GRACE)
        report = run.finish()
        # a hand that is said to be elsewhere drags the tissue there: an alarm is no wonder
        broken = fault in ("sensor", "cable")
        self.check(ended, report, f"arm, {fault}", may_fail=broken)
        return Outcome(f"arm, {fault}", report.ticks, report.missed_ticks)

    def run_faulty_wire(self, hand: palpate.HapticDevice, seconds: float) -> Outcome:
        """The driver over a wire that loses, damages and swaps frames."""
        core = palpate.NativeCore()
        faults = palpate.Faults(drop=0.05, corrupt=0.05, reorder=0.05, seed=self.chance())
        driver = palpate.SerialDevice(palpate.FaultyTransport(core, faults), (0.0, 0.0, self.top))
        driver.open()
        with LiveRun(self.scene, driver, options=limited(seconds)) as run:
            self.save()
            ended = run.wait(seconds + GRACE)
        report = run.finish()
        self.check(ended, report, "faulty wire", may_fail=True)
        return Outcome("faulty wire", report.ticks, report.missed_ticks)

    def run_unplugged(self, hand: palpate.HapticDevice, seconds: float) -> Outcome:
        """A device that says what is not finite, hangs, or is gone in the middle of a run."""
        at = self.choose.uniform(0.0, seconds)
        faults = self.choose.choice(
            [
                palpate.Faults(unplug_at=at, seed=self.chance()),
                palpate.Faults(stick_at=at, drop=0.1, delay=5e-3, seed=self.chance()),
                palpate.Faults(corrupt=2e-3, seed=self.chance()),
            ]
        )
        device = palpate.FaultyDevice(hand, faults)
        with LiveRun(self.scene, device, options=limited(seconds)) as run:
            self.save()
            ended = run.wait(seconds + GRACE)
        report = run.finish()
        self.check(ended, report, "faulty device", may_fail=True)
        return Outcome("faulty device", report.ticks, report.missed_ticks)

    def save(self) -> None:
        """A published file and a working one, over those of before; read back as they went."""
        self.saves += 1
        published, working = self.folder / "scene.palpate", self.folder / "working.organ"
        title = f"Save {self.saves}"
        scenario.write(published, scenario.Scenario(scene=self.scene, title=title))
        if scenario.read(published).title != title:
            raise Unexpected("a published file that is not what was saved")
        values = np.arange(self.saves % 1000, dtype=np.float64)
        content = scenario.Container(format="organ", version=3, content="{}", arrays={"a": values})
        scenario.write_container(working, content)
        found = scenario.read_container(working, "organ", 3).arrays["a"]
        if not np.array_equal(found, values):
            raise Unexpected("a working file that is not what was saved")

    def chance(self) -> int:
        return self.choose.randrange(1, 2**31)

    def check(
        self, ended: bool, report: palpate.LoopReport, kind: str, may_fail: bool = False
    ) -> None:
        if not ended:
            raise Unexpected(f"{kind}: the run did not end")
        if report.alarm.kind != palpate.AlarmKind.none and not may_fail:
            raise Unexpected(f"{kind}: alarm {report.alarm.kind.name} at {report.alarm.time:.3f} s")
        # a machine that stood still for 20 ms was silent, and the arm cut its motors
        may_fail = may_fail or report.fault is palpate.DeviceFault.motors_cut
        if report.fault != palpate.DeviceFault.none and not may_fail:
            raise Unexpected(f"{kind}: device fault {report.fault.name}")


def read_clocks(run: LiveRun) -> float:
    """[s] that the machine's clock is ahead of the run's."""
    report = run.report()
    return time.perf_counter() - 1e-3 * (report.ticks + report.missed_ticks)


def limited(seconds: float) -> palpate.LoopOptions:
    return palpate.LoopOptions(duration=seconds)
