# SPDX-License-Identifier: BSD-3-Clause
"""Playing a published scenario: its devices, its runs and their records. Knows no Qt."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import palpate
from palpate.assessment.hands import HANDS
from palpate.assessment.instruments import find_handle
from palpate.assessment.publish import refuse, take_attempt
from palpate.assessment.selfplay import attempt
from palpate.assessment.texts import find_text
from palpate.command.verb import WrongCall
from palpate.device.link import build_link
from palpate.device.names import PLANT, POINTER, find_port, split_hand
from palpate.files.refusal import Refusal
from palpate.runs.live import LiveRun
from palpate.runs.other_hands import build_other, find_centre, find_fulcrum, name_hands
from palpate.runs.run import (
    PUBLISHED,
    describe_build,
    is_published,
    join_names,
    require_recordable,
)
from palpate.runs.script_file import read_script_file
from palpate.system.data_folder import find_record_folder

LATER = "\N{EN DASH}"
MARKS = {
    palpate.StepStatus.active: "\N{BLACK RIGHT-POINTING SMALL TRIANGLE}",
    palpate.StepStatus.done: "\N{CHECK MARK}",
}
"""Before the line of a step."""
TAIL = 0.5
"""[s] that a scripted run goes on after its last key frame."""


@dataclass
class Play:
    """A scenario, whose hand it is, and where its records go."""

    path: Path
    scenario: palpate.scenario.Scenario
    frames: list[palpate.KeyFrame] | None = None
    """Of a script; None where the mouse, or a real hand, is the hand."""
    arm: str = ""
    """What the hand holds: nothing, the simulated arm PLANT, or a serial device."""
    duration: float = 0.0
    """[s] of a run; 0 for one that lasts until it is stopped."""
    record: Path | None = None
    """Of the first run; without it each run gets a name of its own in find_record_folder()."""
    records: list[Path] = field(default_factory=list)
    """Of the runs so far."""
    limit: float = field(default_factory=lambda: palpate.SafetyLimits().force_max)
    """[N] of the device of the last run."""
    language: str = ""
    """Of title and task, where the scenario has it; empty for the one it was written in."""
    drawn: palpate.scenario.DrawnTask | None = None
    """What is judged; None where the scenario has no task that can be."""
    state: palpate.TaskState | None = None
    """How far the task of the run that goes on is."""
    hand: str = ""
    """Which simulated hand plays; none of them where this is empty."""
    others: list[str] = field(default_factory=list)
    """Whose hand each of the instruments after the first is."""
    fulcrum: float = 0.0
    """[m] from tip to handle, where the stylus of the arm is the handle of an instrument through a
    trocar; 0: it is the tip."""
    published: palpate.scenario.Scenario | None = None
    """As its file has it, before an attempt was drawn."""
    samples: list[list[palpate.HapticSample]] = field(default_factory=list)
    """Of that hand, once it has played, for each instrument."""

    def has_hand(self) -> bool:
        """False for a simulated hand whose attempt has to be computed first."""
        return not self.hand or bool(self.samples)

    def build_hand(self, scene: palpate.Scene | None = None) -> palpate.HapticDevice | None:
        """What moves the tip or the stylus; None where that is a real hand. `scene` is what it
        moves in, where that is not the scenario's own.
        """
        if find_port(self.arm):
            return None
        if self.hand:
            return palpate.ReplayDevice(self.play_hand()[0])
        if self.frames is not None:
            return palpate.ScriptedDevice(self.frames)
        return palpate.SurfacePointer(scene or self.scenario.scene)

    def play_hand(self) -> list[list[palpate.HapticSample]]:
        """What the simulated hand does with each instrument."""
        if not self.has_hand():  # seconds of work: a window has it done beside it before
            assert self.drawn is not None
            self.samples = attempt(self.scenario.scene, self.drawn, self.hand).samples
        return self.samples

    def build_device(self, hand: palpate.HapticDevice | None = None) -> palpate.HapticDevice:
        """The device of one run, held by `hand` (of build_hand). Raises DeviceError, WrongCall."""
        hand = hand or self.build_hand()
        scene = self.scenario.scene
        fulcrum = find_fulcrum(scene, 0, self.fulcrum)
        if not self.arm:
            assert hand is not None
            return hand
        centre = find_centre(scene, 0, self.fulcrum)
        if self.arm == PLANT:
            assert hand is not None
            if fulcrum is not None:  # a hand knows where the tip shall be
                hand = palpate.FulcrumDevice(hand, fulcrum)
            arm = palpate.SimulatedArm(hand, centre)
            arm.open()
            return arm
        link = build_link(self.arm, centre)
        link.open()
        return link.driver

    def build_others(self) -> list[palpate.HapticDevice]:
        """The devices of the instruments after the first. Raises as build_other does."""
        scene = self.scenario.scene
        return [
            palpate.ReplayDevice(self.play_hand()[i])
            if self.hand and name == self.hand
            else build_other(name, scene, i, find_handle(self.scenario, i))
            for i, name in enumerate(self.others, start=1)
        ]

    def join_devices(
        self, device: palpate.HapticDevice, others: Sequence[palpate.HapticDevice]
    ) -> palpate.HapticDevice | list[palpate.HapticDevice]:
        """What the loop takes: a device, or one for each instrument; a handle says where its tip
        is."""
        scene = self.scenario.scene
        fulcrum = find_fulcrum(scene, 0, self.fulcrum) if self.arm else None
        first = device if fulcrum is None else palpate.FulcrumDevice(device, fulcrum)
        if not others:
            return first
        handles = [find_handle(self.scenario, i) for i in range(1, len(others) + 1)]
        held = zip(others, handles, strict=True)
        return [first, *(hold_handle(each, scene, i, h) for i, (each, h) in enumerate(held, 1))]

    def find_safety(self, device: palpate.HapticDevice) -> palpate.SafetyLimits:
        """What a device may be sent: a real arm, or a simulated one, by its calibration."""
        driver = find_driver(device)
        return (
            palpate.SafetyLimits()
            if driver is None
            else palpate.find_safety_limits(driver.calibration())
        )

    def begin(
        self,
        device: palpate.HapticDevice,
        trace: Path | None = None,
        others: Sequence[palpate.HapticDevice] = (),
    ) -> LiveRun:
        """A run that has not started yet, and the file its record will be: `trace`, where it is
        kept. `others` are those of build_others.

        Raises OSError where no record can be written.
        """
        path = self.name_record() if trace is None else trace
        names = join_names([each.name() for each in (device, *others)])
        header = describe_build(self.scenario.scene, self.path, path, names, self.drawn)
        safety = self.find_safety(device)
        options = palpate.LoopOptions(
            duration=self.duration,
            safety=safety,
            on_fault=palpate.FaultResponse.pause,
            device_safety=[safety, *map(self.find_safety, others)] if others else [],
        )
        task = None if self.drawn is None else self.drawn.task
        driven = self.join_devices(device, others)
        run = LiveRun(
            self.scenario.scene, driven, record=path, header=header, options=options, task=task
        )
        self.records.append(path)
        self.limit = safety.force_max
        return run

    def name_record(self) -> Path:
        """Where the next record goes: as asked for, numbered from the second run on."""
        if self.record is None:
            folder = self.record_folder()
            folder.mkdir(parents=True, exist_ok=True)
            return find_free(folder / f"{self.path.stem}-{time.strftime('%Y%m%d-%H%M%S')}.prec")
        if not self.records:
            return self.record
        return find_free(self.record.with_stem(f"{self.record.stem}-{len(self.records) + 1}"))

    def translation(self) -> palpate.scenario.Words:
        """Title and task in the language that was asked for, as far as the scenario has it; of a
        task that is judged its steps, with the numbers of this attempt.
        """
        words = palpate.scenario.find_words(self.scenario, self.language)
        if self.drawn is None:
            return words
        return palpate.scenario.Words(words.title, self.tell_steps())

    def tell_steps(self) -> str:
        """A line for each step: done, to be done now, or later."""
        assert self.drawn is not None
        assessment = json.loads(self.scenario.assessment)
        lines = []
        for number, step in enumerate(assessment["steps"]):
            status = None if self.state is None else self.state.steps[number].status
            said = find_text(assessment, step["say"], self.language or "en", self.drawn.values)
            lines.append(f"{MARKS.get(status, LATER)} {said}")
        return "\n".join(lines)

    def say_limits(self) -> list[str]:
        """What each limit of the task says."""
        if self.drawn is None:
            return []
        assessment, values = json.loads(self.scenario.assessment), self.drawn.values
        language = self.language or "en"
        return [
            find_text(assessment, limit["say"], language, values)
            for limit in assessment.get("limits", [])
        ]

    def title(self) -> str:
        """What a window calls it: its title, else its file."""
        return self.translation().title or self.path.stem

    def record_folder(self) -> Path:
        """Where the records go; made with the first of them."""
        return find_record_folder() if self.record is None else self.record.resolve().parent

    def force_limit(self) -> float:
        """[N] More than this no device is sent."""
        return min(self.scenario.scene.instruments[0].coupling.force_max, self.limit)


def find_driver(device: palpate.HapticDevice) -> palpate.SerialDevice | None:
    """Who speaks with an arm, a real or a simulated one; None where there is none."""
    driver = device.driver() if isinstance(device, palpate.SimulatedArm) else device
    return driver if isinstance(driver, palpate.SerialDevice) else None


def hold_handle(
    device: palpate.HapticDevice, scene: palpate.Scene, instrument: int, length: float
) -> palpate.HapticDevice:
    """The device of an instrument's tip: an arm may be its handle, `length` [m] from there."""
    fulcrum = find_fulcrum(scene, instrument, length if find_driver(device) else 0.0)
    return device if fulcrum is None else palpate.FulcrumDevice(device, fulcrum)


def describe_device(device: palpate.HapticDevice) -> str | None:
    """What an arm says of itself, a fault that has cut its motors first of all."""
    driver = find_driver(device)
    if driver is None:
        return None
    driver.take_status()
    return palpate.describe_status(driver.status())


def find_free(path: Path) -> Path:
    """The path, or one with a number behind its name where there is such a file already."""
    free, number = path, 2
    while free.exists():
        free, number = path.with_stem(f"{path.stem}-{number}"), number + 1
    return free


def open_play(
    path: Path,
    device: str | Sequence[str] = POINTER,
    record: Path | None = None,
    duration: float | None = None,
    level: str = "",
    seed: int = 0,
    fulcrum: float | None = None,
) -> Play:
    """What `palpate play` was asked to play. `device` is that of the first instrument, or of each
    of several; `fulcrum` [m] is of the first where it is not the scenario's.

    Raises FileError, Refusal, WrongCall or OSError.
    """
    if not is_published(path):
        raise Refusal(
            path, "", f"a name ending in {path.suffix!r}", f"a published file, {PUBLISHED}"
        )
    asked = [device] if isinstance(device, str) else list(device)
    arm, script = split_hand((asked or [POINTER])[0])
    hand = script if script in HANDS and not Path(script).exists() else ""
    frames = read_script_file(Path(script)) if script and not hand else None
    if duration is None:
        duration = 0.0 if frames is None else frames[-1].time + TAIL
    if record is not None and record.exists() and record.samefile(path):
        raise WrongCall("--record: is the scenario itself")
    scenario = published = palpate.scenario.read(path)
    names = name_hands(asked, len(scenario.scene.instruments), hand)
    if fulcrum is None:
        fulcrum = find_handle(scenario, 0) if arm else 0.0
    if fulcrum > 0.0 and not arm:
        raise WrongCall("--fulcrum: got no arm, expected --device plant or serial:PATH beside it")
    find_fulcrum(scenario.scene, 0, fulcrum)
    require_recordable(scenario.scene, duration)
    drawn = draw_attempt(path, scenario, level, seed)
    if hand and drawn is None:
        raise Refusal(path, "assessment", "none", f"a task, which is what the {hand} hand plays")
    try:
        scenario = take_attempt(scenario, drawn)
    except ValueError as problem:
        raise Refusal(path, "assessment", str(problem), "an inclusion that can be built") from None
    return Play(
        path,
        scenario,
        frames,
        arm,
        duration,
        record,
        drawn=drawn,
        hand=hand,
        others=names[1:],
        published=published,
        fulcrum=fulcrum,
    )


def draw_attempt(
    path: Path, scenario: palpate.scenario.Scenario, level: str, seed: int
) -> palpate.scenario.DrawnTask | None:
    """The task of an attempt, None where there is none. Raises WrongCall for another level, and
    Refusal where what this seed draws cannot be judged.
    """
    if not scenario.assessment:
        if level or seed:
            raise WrongCall(f"--level or --seed: {path.name} has no task that is judged")
        return None
    levels = palpate.scenario.list_levels(scenario)
    if level and level not in levels:
        known = ", ".join(levels) or "none: it has no levels"
        raise WrongCall(f"--level: got {level!r}, expected {known}")
    try:
        return palpate.scenario.draw_task(scenario, level, seed)
    except ValueError as problem:
        raise refuse(path, f"seed {seed}: {problem}") from None
