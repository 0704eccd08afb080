# SPDX-License-Identifier: BSD-3-Clause
"""Of scenes of several bodies, and of scenarios with jaws: no alarm where nothing is wrong, and
with an ideal device nothing that the passivity controller would damp."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import palpate
import palpate_meshes
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.runs.press import CLEARANCE, Place, find_place
from palpate.runs.run import read_scene
from random_hand import ABOVE, RandomHand

MESHES = Path(palpate_meshes.__file__).parent
SCENES = sorted(path.stem for path in (MESHES / "scenes").glob("*.palpate"))
WITH_JAWS = {
    "gallbladder_grasp": "published/gallbladder",
    "gallbladder_retract": "published/gallbladder",
    "stomach_two_graspers": "published/stomach",
    "kidney_stone_removal": "scenes/kidney_stone_removal",
}
"""Scenarios that bring instruments of their own, and what they are put into."""
EVERYDAY = ("peritoneum",)
NONE = palpate.AlarmKind.none
DEEP, FAST = 10e-3, 0.1
"""[m], [m/s] as a hand explores that means it."""
LIMIT_SHARE = 0.9
"""[-] of the limit, that palpate.stable_step gives."""
FACES = 0.7
"""[-] Cosine between a place's outward direction and the way to the trocar, at least."""
ASIDE = 0.3
"""[m] of the other hands from the first."""
WAIT = 0.25
"""[s] In the first 0.2 s the force fades in, and a hand gets back more than it gave."""


def open_scenario(name: str) -> palpate.Scene:
    organ = scenario.read(MESHES / f"{WITH_JAWS[name]}.palpate")
    path = MESHES / "scenarios" / f"{name}.json"
    return with_assessment(path, read_assessment(path), organ).scene


def open_scene(name: str) -> palpate.Scene:
    if name in SCENES:
        return read_scene(MESHES / "scenes" / f"{name}.palpate")
    return open_scenario(name)


def step_at(scene: palpate.Scene, share: float) -> palpate.Scene:
    """A scene of which no substep in the air is longer than that part of the longest that is
    stable, and that of one body just so long."""
    slower, rates = copy.copy(scene), []
    for body in scene.bodies:
        limit = palpate.stable_step(body.tissue) / LIMIT_SHARE
        rates.append(1.0 / (body.substeps * share * limit))
    slower.rate = max(rates)
    return slower


@dataclass
class Poking:
    """Hands of which the first presses one place after another."""

    scene: palpate.Scene
    frames: list[palpate.KeyFrame] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.hand = RandomHand(self.scene, 0)
        self.radius = self.scene.instruments[0].tool.radius
        # closed, as open jaws leave what is between them untouched
        self.buttons = int(self.scene.instruments[0].tool.jaws is not None)

    def list_places(self) -> Iterator[Place]:
        """That an instrument comes to straight from outside, without an end."""
        trocar = self.scene.instruments[0].trocar
        while True:
            point, out = self.hand.find_place()
            way = out if trocar is None else np.asarray(trocar) - point
            if out @ way > FACES * np.linalg.norm(way):
                yield Place(point, out)

    def go(self, time: float, at: np.ndarray) -> None:
        self.frames.append(palpate.KeyFrame(time, at, buttons=self.buttons))

    def lift(self, place: Place, height: float) -> np.ndarray:
        return place.point + (self.radius + height) * place.outward

    def go_over(self, time: float, place: Place) -> None:
        """In 0.25 s from where it is to high above a place, around all bodies."""
        if self.frames and self.scene.instruments[0].trocar is None:
            at = np.asarray(self.frames[-1].position)
            way = self.hand.go_around(at, self.lift(place, ABOVE))[:3]
            for share, corner in zip((0.02, 0.09, 0.16), way, strict=True):
                self.go(time + share, corner)
        self.go(time + 0.25, self.lift(place, ABOVE))

    def press(self, time: float, place: Place, depth: float, speed: float) -> float:
        """[s] when it is high above the place again."""
        self.go_over(time, place)
        self.go(time + 0.4, self.lift(place, CLEARANCE))
        deep = time + 0.4 + (CLEARANCE + depth) / speed
        self.go(deep, self.lift(place, -depth))
        self.go(deep + 0.2, self.lift(place, -depth))
        self.go(deep + 0.35, self.lift(place, CLEARANCE))
        self.go(deep + 0.45, self.lift(place, ABOVE))
        return deep + 0.45

    def run(self) -> tuple[palpate.World, palpate.SafeDevice]:
        """Up to the end or the first alarm, the first hand with an ideal device."""
        for frame in self.frames:
            frame.time += WAIT
        scene, dt = self.scene, 1.0 / self.scene.rate
        safe = palpate.SafeDevice(palpate.ScriptedDevice(self.frames))
        world = palpate.World(scene, recovers=False)
        for tick in range(round(self.frames[-1].time * scene.rate)):
            first = safe.read(tick * dt)
            others = [copy.copy(first) for _ in scene.instruments[1:]]
            for k, sample in enumerate(others):
                trocar = scene.instruments[k + 1].trocar
                away = np.asarray(first.position) + ASIDE if trocar is None else trocar
                sample.position = away
            felt = palpate.tick(scene, [first, *others], dt, world)
            safe.set_tool(world.instruments[0].tool.position)
            safe.write(felt[0])
            if world.alarm:
                break
        return world, safe


def poke(scene: palpate.Scene, seconds: int) -> Poking:
    """3 mm into a place every second, at another each time."""
    poking = Poking(scene)
    for k, place in enumerate(itertools.islice(poking.list_places(), seconds)):
        poking.press(float(k), place, 3e-3, 0.05)
    return poking


def press(scene: palpate.Scene, count: int) -> Poking:
    poking, time = Poking(scene), 0.0
    for place in itertools.islice(poking.list_places(), count):
        time = poking.press(time, place, DEEP, FAST)
    return poking


def some(names: list[str]) -> list[object]:
    return [n if n in EVERYDAY else pytest.param(n, marks=pytest.mark.landing) for n in names]


@pytest.mark.parametrize("name", some([*SCENES, *WITH_JAWS]))
def test_a_scene_that_is_pressed_10_mm_at_100_mm_s_raises_no_alarm_and_is_not_damped(name):
    world, safe = press(open_scene(name), 2).run()

    assert world.alarm.kind == NONE, (world.alarm, world.alarm_body)
    assert safe.damped_count() == 0
    assert safe.given_energy() < palpate.SafetyLimits().energy_max


@pytest.mark.parametrize("name", some(SCENES))
def test_at_098_of_its_limit_a_scene_that_is_poked_raises_no_alarm(name):
    world, _ = poke(step_at(open_scene(name), 0.98), 3).run()

    assert world.alarm.kind == NONE, (world.alarm, world.alarm_body)


@pytest.mark.verify
@pytest.mark.parametrize("name", [*SCENES, *WITH_JAWS])
def test_nor_does_one_for_a_minute(name):
    world, _ = poke(step_at(open_scene(name), 0.98), 60).run()

    assert world.alarm.kind == NONE, (world.alarm, world.alarm_body)


@pytest.mark.verify
@pytest.mark.parametrize("name", [*SCENES, *WITH_JAWS])
def test_nor_is_one_damped_at_twenty_places(name):
    world, safe = press(open_scene(name), 20).run()

    assert world.alarm.kind == NONE, (world.alarm, world.alarm_body)
    assert safe.damped_count() == 0


HELD = 0.02
"""[s] in which what is felt falls to nothing."""


@pytest.mark.landing
def test_when_a_run_of_two_hands_freezes_both_forces_fall_to_nothing_in_20_ms():
    scene = open_scenario("stomach_two_graspers")
    world, dt = palpate.World(scene), 1.0 / scene.rate
    places = [find_place(scene, np.asarray(its.trocar)) for its in scene.instruments]

    def tick(number: int, depth: float) -> np.ndarray:
        """[N] (2,)"""
        samples = []
        for place, its in zip(places, scene.instruments, strict=True):
            sample = palpate.HapticSample()
            sample.time, sample.buttons = number * dt, 1
            sample.position = place.point + (its.tool.radius - depth) * place.outward
            samples.append(sample)
        if depth > DEEP:
            samples[0].position = np.full(3, np.nan)
        return np.array([np.linalg.norm(c.force) for c in palpate.tick(scene, samples, dt, world)])

    for number in range(300):
        before = tick(number, min(5e-3, -CLEARANCE + 5e-5 * number))
    after = [tick(300, 2.0 * DEEP)] + [tick(number, 5e-3) for number in range(301, 321)]

    assert before.min() > 0.1
    assert world.alarm.kind == palpate.AlarmKind.invalid_input
    falls = -np.diff(np.vstack([before, *after]), axis=0)
    assert (falls >= 0.0).all() and (falls < 1.1 * before * dt / HELD).all()
    assert (after[round(HELD / dt) - 1] == 0.0).all()


@pytest.mark.landing
def test_two_hands_whose_tissue_safeguards_hold_together_are_replayed_to_the_bit():
    scene = open_scenario("stomach_two_graspers")
    body = scene.bodies[0]
    body.substeps = body.substeps_max = body.substeps - 1  # after the build, which refuses it
    places = [find_place(scene, np.asarray(its.trocar)) for its in scene.instruments]
    world, dt = palpate.World(scene), 1.0 / scene.rate
    hand, felt, hashes, held = [], [], [], 0
    for number in range(260):
        samples = []
        for place, its in zip(places, scene.instruments, strict=True):
            sample = palpate.HapticSample()
            sample.time, sample.buttons = number * dt, int(number > 150)
            height = its.tool.radius - min(5e-3, -CLEARANCE + 5e-5 * number)
            sample.position = place.point + height * place.outward
            samples.append(sample)
        commands = palpate.tick(scene, samples, dt, world)
        assert not world.alarm
        hand += samples
        felt += [palpate.compute_felt(command, world, k) for k, command in enumerate(commands)]
        held += int(world.bodies[0].safeguard) > 0
        if number % 50 == 0:
            hashes.append(palpate.StateHash(tick=number, hash=palpate.compute_hash(world)))

    assert held > 100
    record = palpate.Record(hand=hand, felt=felt, hashes=hashes, instruments=2)
    assert palpate.replay(scene, record).equal
