# SPDX-License-Identifier: BSD-3-Clause
"""What a grasp costs, tick by tick, on every organ that ships.

    .venv/bin/python tests/bench/bench_grasps.py [--places 2] [--times 3] [ORGAN ...]

Ticks are those of `tests/meshes/test_grasped_organs.py`, in the air, as jaws go in and close, as
they pull and hold, and as they let go. A tick is the same each time it is run, so that the least of
its times is what it takes of the processor; what else the machine does is in the others.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import numpy as np
import palpate

sys.path.append(str(Path(__file__).parents[1] / "meshes"))
from test_grasped_organs import CYCLE, ORGANS, list_places, take, turn_to, write_hand  # noqa: E402

PHASES = {"air": (0.0, 0.3), "in": (0.3, 0.9), "held": (0.9, 2.1), "let go": (2.1, 2.6)}
"""[s] of a cycle."""
GOAL = 1e-3
"""[s] A loop of 1 kHz has no more."""


def list_samples(scene: palpate.Scene, places: int) -> list[palpate.HapticSample]:
    """Of as many cycles, each at a place of its own."""
    found = [place for _, place in zip(range(places), list_places(scene), strict=False)]
    hand, samples = write_hand(scene, found), []
    ticks = round(CYCLE * scene.rate)
    for tick in range(places * ticks):
        sample = hand.read(tick / scene.rate)
        sample.orientation = turn_to(np.asarray(found[tick // ticks].outward))
        samples.append(sample)
    return samples


def time_ticks(scene: palpate.Scene, samples: list[palpate.HapticSample]) -> np.ndarray:
    """[s] (ticks,) of the processor."""
    world, dt, times = palpate.World(scene), 1.0 / scene.rate, []
    for sample in samples:
        began = time.thread_time()
        palpate.tick(scene, sample, dt, world)
        times.append(time.thread_time() - began)
        if world.alarm:
            raise SystemExit(f"alarm: {world.alarm}")
    return np.array(times)


def measure(name: str, places: int, times: int) -> dict[str, np.ndarray]:
    """[s] of all ticks of each phase."""
    scene = take(name)
    samples = list_samples(scene, places)
    least = np.min([time_ticks(scene, samples) for _ in range(times)], axis=0)
    cycles = least.reshape(places, -1)
    rate = scene.rate
    return {
        phase: cycles[:, round(a * rate) : round(b * rate)].ravel()
        for phase, (a, b) in PHASES.items()
    }


def main() -> int:
    call = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    call.add_argument("organs", nargs="*", default=ORGANS)
    call.add_argument("--places", type=int, default=2)
    call.add_argument("--times", type=int, default=3)
    asked = call.parse_args()
    print(f"{'us':20} {'phase':8} {'median':>8} {'p99':>8} {'max':>8}  ticks over 1 ms")
    for name in asked.organs:
        for phase, ticks in measure(name, asked.places, asked.times).items():
            median, p99 = 1e6 * np.median(ticks), 1e6 * np.quantile(ticks, 0.99)
            late = f"{(ticks > GOAL).sum()} of {len(ticks)}"
            print(
                f"{name:20} {phase:8} {median:8.0f} {p99:8.0f} {1e6 * ticks.max():8.0f}  {late}",
                flush=True,
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
