# SPDX-License-Identifier: BSD-3-Clause
"""What bodies cost: one that sleeps, two beside one, and this build beside another.

    .venv/bin/python tests/bench/bench_bodies.py sleep
    .venv/bin/python tests/bench/bench_bodies.py two [ORGAN]
    .venv/bin/python tests/bench/bench_bodies.py against /path/to/other/.venv/bin/python

Times are of the tick alone, medians over blocks that take turns in one run, so that what else the
machine does falls on both sides alike.
"""

from __future__ import annotations

import argparse
import copy
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np
import palpate
from palpate.runs.cause import change_body
from palpate.runs.press import PressScript, find_top, write_script
from palpate.runs.run import read_scene

CHECKOUT = Path(__file__).resolve().parents[2]
ORGANS = CHECKOUT / "meshes" / "published"
SPRINGS = CHECKOUT / "tests" / "scenes" / "springs"
"""Organs as surfaces of springs, which later versions can be held against."""
PRESS = PressScript(depth=3e-3, speed=0.03, hold=0.2)
ROUNDS = 20
FAR = (0.0, 0.0, 0.5)
"""[m] of a hand that touches nothing."""


def open_organ(name: str) -> palpate.Scene:
    folder = SPRINGS if (SPRINGS / f"{name}.palpate").exists() else ORGANS
    return read_scene(folder / f"{name}.palpate")


def time_ticks(scene: palpate.Scene, count: int | None = None) -> list[float]:
    """[s] of each tick of a press from rest; the first `count` of them."""
    frames, times = write_script(find_top(scene), scene.instruments[0].tool.radius, PRESS)
    hand = palpate.ScriptedDevice(frames)
    dt = 1.0 / scene.rate
    samples = [hand.read(i * dt) for i in range(count or round(times.end / dt))]
    world = palpate.World(scene)
    costs = []
    for sample in samples:
        begun = perf_counter()
        palpate.tick(scene, sample, dt, world)
        costs.append(perf_counter() - begun)
    return costs


def double(scene: palpate.Scene) -> palpate.Scene:
    """The body of a scene twice, the second half a metre aside, at the same substeps."""
    (body,) = scene.bodies
    aside = copy.copy(body.tissue)
    np.asarray(aside.rest_position)[:] += (0.5, 0.0, 0.0)
    bodies = [
        palpate.SoftBody(tissue=tissue, substeps=body.substeps, substeps_max=body.substeps_max)
        for tissue in (body.tissue, aside)
    ]
    return palpate.build_scene(
        palpate.Scene(
            bodies=bodies,
            instruments=list(scene.instruments),
            gravity=scene.gravity,
            rate=scene.rate,
        )
    )


def measure_sleep() -> None:
    """A body of each kernel far from the hand: asleep, and what it costs awake."""
    stone, gallbladder = open_organ("kidney_stone"), open_organ("gallbladder")
    granted = change_body(gallbladder, force_error=0.01)
    plain = change_body(gallbladder, kernel=palpate.Kernel.reference)
    far = palpate.HapticSample(position=FAR)
    for name, scene in (
        ("kidney stone, packed", stone),
        ("gallbladder, packed", gallbladder),
        ("gallbladder, packed, 0.01 N", granted),
        ("gallbladder, reference", plain),
        ("gallbladder of two, packed", double(gallbladder)),
        ("liver of two, packed", double(open_organ("liver"))),
    ):
        world = palpate.World(scene)
        for _ in range(200):
            palpate.tick(scene, far, 1.0 / scene.rate, world)
        told = "asleep" if world.bodies[0].asleep else "awake"
        costs = palpate.measure_costs(scene, [far] * 2000)
        # a body that falls asleep has done so within 150 of the 2000 ticks
        body, pair = costs.bodies[0], costs.pairs[0]
        print(
            f"{name:28} {told:6} {1e6 * body.median:8.2f} us, its pair {1e6 * pair.median:.2f} us; "
            f"longest {1e6 * body.max:.0f} us"
        )


def measure_two(organ: str) -> None:
    """One body pressed, beside the same with a second that is not."""
    one = open_organ(organ)
    two = double(one)
    print(f"{organ}: substeps {one.bodies[0].substeps}, {two.bodies[1].substeps}")
    ratios = []
    for _ in range(ROUNDS):
        alone, both = median(time_ticks(one)), median(time_ticks(two))
        ratios.append(both / alone)
        print(f"one {1e6 * alone:7.1f} us, two {1e6 * both:7.1f} us: {both / alone:.3f}")
    print(f"median ratio {median(ratios):.3f}")


def serve(organ: str) -> None:
    """For every line read: a block of ticks, whose median [us] is written."""
    scene = open_organ(organ)
    for _ in sys.stdin:
        print(1e6 * median(time_ticks(scene)), flush=True)


def take_turns(pythons: list[str], organ: str) -> Iterator[list[float]]:
    """Medians [us] of blocks of each build, one after the other."""
    workers = [
        subprocess.Popen(
            [python, __file__, "serve", organ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )
        for python in pythons
    ]
    for turn in range(ROUNDS):
        order = workers if turn % 2 == 0 else workers[::-1]
        found = {}
        for worker in order:
            worker.stdin.write("go\n")
            worker.stdin.flush()
            found[worker] = float(worker.stdout.readline())
        yield [found[worker] for worker in workers]
    for worker in workers:
        worker.stdin.close()
        worker.wait()


def measure_against(other: str) -> None:
    """Ticks of this build over those of another, organ by organ: in the middle of the turns, and
    of the fastest block of each, which a busy machine disturbs least."""
    for organ in ("gallbladder", "kidney", "simple_tissue"):
        turns = list(take_turns([sys.executable, other], organ))
        ratio = median(ours / theirs for ours, theirs in turns)
        ours, theirs = (min(block) for block in zip(*turns, strict=True))
        print(
            f"{organ:15} {ratio:.3f} of the other's time; fastest {ours:.1f} us, {theirs:.1f} us: "
            f"{ours / theirs:.3f}"
        )


def main() -> None:
    call = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    call.add_argument("what", choices=("sleep", "two", "against", "serve"))
    call.add_argument("value", nargs="?", default="gallbladder")
    asked = call.parse_args()
    if asked.what == "sleep":
        measure_sleep()
    elif asked.what == "two":
        measure_two(asked.value)
    elif asked.what == "against":
        measure_against(asked.value)
    else:
        serve(asked.value)


if __name__ == "__main__":
    main()
