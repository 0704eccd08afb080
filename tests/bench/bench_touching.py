# SPDX-License-Identifier: BSD-3-Clause
"""What it costs that two bodies touch: a press of two layers, with their pair and without.

.venv/bin/python tests/bench/bench_touching.py [CELLS]
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import palpate

sys.path.append(str(Path(__file__).parents[1] / "scenes"))
from test_f06_layers import GAP, THICKNESS, make_layer  # noqa: E402

SIDE, RADIUS, DEPTH, TICKS, SUBSTEPS = 0.1, 0.02, 4e-3, 400, 12


def make_scene(cells: int, gap: float, paired: bool) -> palpate.Scene:
    bodies = [make_layer(SIDE, cells, z, 5e3) for z in (0.0, THICKNESS + gap)]
    for body in bodies:
        body.substeps = body.substeps_max = SUBSTEPS
    return palpate.build_scene(
        palpate.Scene(
            bodies=bodies,
            instruments=[palpate.Instrument(tool=palpate.Tool(radius=RADIUS))],
            body_pairs=[palpate.BodyPair(0, 1)] if paired else [],
        )
    )


def press(gap: float) -> list[palpate.HapticSample]:
    """Down at 20 mm/s, and a rest."""
    top = 1.5 * THICKNESS + gap + RADIUS + 1e-4
    samples = []
    for k in range(TICKS):
        sample = palpate.HapticSample()
        sample.position = (0.001, 0.002, top - min(DEPTH, 0.02 * 1e-3 * k))
        samples.append(sample)
    return samples


def time_ticks(scene: palpate.Scene, world: palpate.World, sample: palpate.HapticSample) -> float:
    """[s] of this thread's processor time, which other work on the machine leaves alone."""
    began = time.thread_time()
    palpate.tick(scene, sample, 1e-3, world)
    return time.thread_time() - began


def main() -> int:
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 29
    for name, gap in (("in touch", GAP), ("20 mm apart", 0.02)):
        scenes = [make_scene(cells, gap, paired) for paired in (True, False)]
        worlds = [palpate.World(scene) for scene in scenes]
        times = np.array(
            [
                [
                    time_ticks(scene, world, sample)
                    for scene, world in zip(scenes, worlds, strict=True)
                ]
                for sample in press(gap)
            ]
        )
        count = sum(len(b.tissue.rest_position) for b in scenes[0].bodies)
        paired, alone = 1e6 * np.median(times, axis=0)
        worst, worst_alone = 1e6 * np.quantile(times, 0.99, axis=0)
        print(
            f"{name}: {count} particles, {worlds[0].body_pairs[0].touching} vertices"
            f" touch; a tick {paired:.0f} us (p99 {worst:.0f}), without a pair {alone:.0f} "
            f"(p99 {worst_alone:.0f}): {paired - alone:.0f} us and {paired / alone:.2f} times"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
