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
from pathlib import Path

import numpy as np
import palpate
from tick_times import head_row, time_least, write_row

sys.path.append(str(Path(__file__).parents[1] / "meshes"))
from test_grasped_organs import CYCLE, ORGANS, list_places, take, turn_to, write_hand  # noqa: E402

PHASES = {"air": (0.0, 0.3), "in": (0.3, 0.9), "held": (0.9, 2.1), "let go": (2.1, 2.6)}
"""[s] of a cycle."""


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


def measure(name: str, places: int, times: int) -> dict[str, np.ndarray]:
    """[s] of all ticks of each phase."""
    scene = take(name)
    samples = list_samples(scene, places)
    least = time_least(times, scene, samples)
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
    print(head_row(f"{'us':20} {'phase':8}"))
    for name in asked.organs:
        for phase, ticks in measure(name, asked.places, asked.times).items():
            print(write_row(f"{name:20} {phase:8}", ticks), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
