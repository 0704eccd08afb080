# SPDX-License-Identifier: BSD-3-Clause
"""The check of a device: a hand that does what it is asked passes, one that does not fails."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.runs.device_check import (
    BUZZ,
    DRIFT,
    LENGTHS,
    NOISE,
    PRESSED,
    TARGETS,
    DeviceCheck,
    Stage,
    build_wall,
    measure_rest,
)

MESHES = Path(__file__).resolve().parents[2] / "meshes"
DT = 1e-3


@pytest.fixture(scope="module")
def wall() -> palpate.Scene:
    return build_wall(scenario.read(MESHES / "published" / "simple_tissue.palpate").scene)


@dataclass
class Seen:
    """What a check reads of a frame."""

    time: float
    tool_position: np.ndarray
    force: np.ndarray
    touching: bool


class Person:
    """Goes where the check asks it to, ticks of the real scene between."""

    def __init__(self, scene: palpate.Scene):
        self.scene, self.world = scene, palpate.World(scene)
        self.check = DeviceCheck(scene)
        self.radius = scene.instruments[0].tool.radius
        self.tip = self.check.middle + [0.0, 0.0, 0.03]
        self.tick = 0

    def goal(self) -> np.ndarray:
        check = self.check
        if check.stage is Stage.targets:
            return check.place(min(check.target, 2)) + [0.0, 0.0, self.radius - 5e-4]
        if check.stage is Stage.wall:
            return check.middle + [0.0, 0.0, self.radius - 1.2e-3]
        return self.tip

    def play(self) -> None:
        force = np.zeros(3)
        while not self.check.over:
            side = self.goal() - self.tip
            far = np.linalg.norm(side[:2]) > 1e-3
            if far and self.tip[2] < self.check.middle[2] + self.radius + 0.01:
                side = np.array([0.0, 0.0, 0.01])
            elif far:
                side[2] = 0.0
            size = np.linalg.norm(side)
            self.tip = self.tip + side * min(1.0, 0.05 * DT / max(size, 1e-9))
            sample = palpate.HapticSample(time=self.tick * DT, position=self.tip)
            force = np.array(palpate.tick(self.scene, sample, DT, self.world).force)
            self.tick += 1
            if self.tick % 16 == 0:
                touching = bool(np.linalg.norm(force) > 0.0)
                now = self.tick * DT
                self.check.take(Seen(now, self.tip, force, touching), now, cut=False)


def test_a_wall_does_not_give_way_and_is_felt_as_coupling_and_tool(wall):
    person = Person(wall)
    person.tip = person.check.middle + [0.0, 0.0, person.radius - 1e-3]
    for tick in range(1000):
        sample = palpate.HapticSample(time=tick * DT, position=person.tip)
        force = palpate.tick(wall, sample, DT, person.world).force
    # 1 mm: the coupling's spring, in series with that of the touch, which is stiffer
    soft = wall.instruments[0].coupling.stiffness * 1e-3
    assert 0.5 * soft < np.linalg.norm(force) <= soft
    rest = np.asarray(wall.bodies[0].tissue.rest_position)
    assert np.array_equal(np.asarray(person.world.bodies[0].tissue.position), rest)


def test_a_hand_that_does_what_it_is_asked_is_through_in_less_than_25_seconds(wall):
    person = Person(wall)
    person.play()

    assert person.check.done == {Stage.still: True, Stage.targets: True, Stage.wall: True}
    assert person.check.target == len(TARGETS)
    assert person.tick * DT < sum(LENGTHS.values()) < 25.0
    assert list(person.check.spans) == [Stage.still, Stage.targets, Stage.wall]


def test_a_hand_that_does_nothing_fails_when_the_time_is_over(wall):
    check = DeviceCheck(wall)
    for k in range(2000):
        if check.over:
            break
        check.take(Seen(0.02 * k, check.middle, np.zeros(3), False), 0.02 * k, cut=False)
    assert check.done == {Stage.still: True, Stage.targets: False, Stage.wall: False}
    assert check.target == 0


@pytest.mark.parametrize("force", [0.9 * PRESSED[0], 1.1 * PRESSED[1]])
def test_a_press_outside_the_band_is_none(wall, force):
    check = DeviceCheck(wall, stage=Stage.wall)
    for k in range(400):
        check.take(Seen(0.02 * k, check.middle, np.array([0, 0, force]), True), 0.02 * k, False)
    assert check.over and not check.done[Stage.wall]


def test_the_stop_button_must_be_seen_pressed_and_released(wall):
    def end(cuts: list[bool]) -> bool:
        check = DeviceCheck(wall, palpate.DeviceStatus, stage=Stage.stop)
        still = np.zeros(3)
        for k, cut in enumerate(cuts):
            if cut:
                check.take_rest(0.1 * k)
            else:
                check.take(Seen(0.1 * k, check.middle, still, False), 0.1 * k, cut)
        return check.done.get(Stage.stop, False)

    assert end([False] * 5 + [True] * 5 + [False])
    assert not end([False] * 80)
    assert not end([False] * 5 + [True] * 80)


def test_noise_and_drift_are_told_apart():
    rng = np.random.default_rng(3)
    still = rng.normal(0.0, 2e-5, (2000, 3))
    noise, drift = measure_rest(still)
    assert noise == pytest.approx(2e-5 * np.sqrt(3.0), rel=0.05)
    assert noise < NOISE and drift < 1e-5
    slow = still + np.linspace(0.0, 1.0, 2000)[:, None] * [2 * DRIFT, 0.0, 0.0]
    assert measure_rest(slow)[0] < NOISE and measure_rest(slow)[1] > DRIFT
    buzzing = still + 2.0 * BUZZ * np.sin(2.0 * np.pi * 80.0 * DT * np.arange(2000))[:, None]
    assert measure_rest(buzzing)[0] > BUZZ
    assert measure_rest(still[:10]) == (float("inf"), float("inf"))


class Costs:
    """A run that was in time."""

    class lateness:  # noqa: N801, a name of LoopReport
        p99 = 5e-5

    fault = palpate.DeviceFault.none


class Gone(Costs):
    """A run whose device fell silent."""

    fault = palpate.DeviceFault.device_failed


class Cut(Costs):
    """A run that ended while the stop button was in."""

    fault = palpate.DeviceFault.motors_cut


def record_of(person: Person) -> palpate.Record:
    rows = [palpate.HapticSample(time=k * DT, position=person.tip) for k in range(person.tick)]
    return palpate.Record(header="{}", hand=rows, felt=[palpate.Felt() for _ in rows])


def test_a_report_says_each_value_with_its_bound_and_slow_pictures_fail(wall):
    person = Person(wall)
    person.play()
    record = record_of(person)

    good = person.check.describe(record, Costs, 60.0, True)
    slow = person.check.describe(record, Costs, 20.0, True)

    assert good["ok"] and not slow["ok"]
    assert [each["name"] for each in good["checks"]] == [
        *("display", "ticks", "noise", "drift", "targets", "wall", "buzz")
    ]
    failed = [each for each in slow["checks"] if not each["ok"]]
    assert [(each["name"], each["value"], each["bound"]) for each in failed] == [
        ("display", 20.0, 24.0)
    ]


def test_a_device_that_fails_ends_its_check_as_its_own_reason(wall):
    person = Person(wall)
    person.play()
    record = record_of(person)
    gone = person.check.describe(record, Gone, 60.0, True)
    assert not gone["ok"] and gone["ended_early"]
    assert gone["note"] == "ended early: device_failed"
    assert all(each["ok"] for each in gone["checks"])
    assert not person.check.describe(record, Cut, 60.0, True)["ended_early"]


def test_a_mouse_has_no_force_and_says_so(wall):
    report = DeviceCheck(wall).describe(palpate.Record(), Costs, 60.0, False)
    assert (report["force"], report["note"]) == (False, "no force; not comparable")
    assert [each["name"] for each in report["checks"]] == ["display", "ticks"]
