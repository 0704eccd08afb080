# SPDX-License-Identifier: BSD-3-Clause
"""What it costs that two bodies touch: with their pair and without it in turns, tick by tick, in
one process. Two layers, the upper one pressed by a ball and the lower one from below, so that both
move in either scene; or a block that is laid down on a layer under its weight. Layers that lie on
each other begin at the thickness of the barrier over their whole faces; those that are pressed
together touch where the upper one is bent; the block is turned, so that no vertex is over another.
With a coefficient of friction a third scene takes its turn, in which they rub on each other.

.venv/bin/python tests/bench/bench_touching.py [CELLS [FRICTION]]
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import palpate

sys.path.append(str(Path(__file__).parents[1] / "scenes"))
from failure_scenes import make_block  # noqa: E402
from test_f06_layers import GAP, THICKNESS, make_layer  # noqa: E402

SIDE, RADIUS, TICKS, SUBSTEPS = 0.1, 0.02, 400, 12
SCENES = (("on each other", GAP, 4e-3), ("pressed together", 8e-4, 6e-3),
          ("20 mm apart", 0.02, 4e-3))  # fmt: skip
"""[m] The gap at rest, and how deep the ball goes."""
LAID = "laid on"
BLOCK, BLOCK_GAP, TURN = 0.045, 4e-4, 0.37
"""[m] A side of the block, and how far it is over the layer; [rad] by which it is turned."""
Pairs = list[palpate.BodyPair]
LEAST, MOST = 0.05, 0.1
"""[-] Of all particles that are vertices in touch: the share that is asked about."""


def make_scene(cells: int, gap: float, pairs: Pairs) -> palpate.Scene:
    bodies = [make_layer(SIDE, cells, z, 5e3) for z in (0.0, THICKNESS + gap)]
    balls = [palpate.Instrument(tool=palpate.Tool(radius=RADIUS)) for _ in range(2)]
    return build(bodies, balls, pairs)


def make_laid(cells: int, pairs: Pairs) -> palpate.Scene:
    """A free block as fine as the layer, which falls on it; without the pair through it."""
    fine = max(2, round(cells * BLOCK / SIDE))
    block = make_block((fine, fine, 2), (BLOCK, BLOCK, THICKNESS))
    c, s = np.cos(TURN), np.sin(TURN)
    points = np.asarray(block.vertices) @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    points += [0.0011, 0.0007, THICKNESS + BLOCK_GAP]
    material = palpate.Material(young_modulus=5e3, poisson_ratio=0.45, damping_ratio=0.2)
    tissue = palpate.build_solid(palpate.SolidMesh(points, block.tetrahedra), material)
    bodies = [make_layer(SIDE, cells, 0.0, 5e3), palpate.SoftBody(tissue=tissue)]
    balls = [palpate.Instrument(tool=palpate.Tool(radius=RADIUS)) for _ in range(2)]
    return build(bodies, balls, pairs, (0.0, 0.0, -9.81))


def build(bodies, instruments, pairs: Pairs, gravity=(0.0, 0.0, 0.0)) -> palpate.Scene:
    for body in bodies:
        body.substeps = body.substeps_max = SUBSTEPS
    return palpate.build_scene(
        palpate.Scene(
            bodies=bodies,
            instruments=instruments,
            gravity=gravity,
            body_pairs=pairs,
        )
    )


def press(gap: float, depth: float) -> list[list[palpate.HapticSample]]:
    """Both balls at 20 mm/s, and a rest: the upper one `depth` [m], the lower one a millimetre."""
    top, foot = 1.5 * THICKNESS + gap + RADIUS + 1e-4, -0.5 * THICKNESS - RADIUS - 1e-4
    samples = []
    for k in range(TICKS):
        upper, lower = palpate.HapticSample(), palpate.HapticSample()
        upper.position = (0.001, 0.002, top - min(depth, 0.02 * 1e-3 * k))
        lower.position = (0.001, 0.002, foot + min(1e-3, 0.02 * 1e-3 * k))
        samples.append([upper, lower])
    return samples


def stay_away() -> list[list[palpate.HapticSample]]:
    samples = [palpate.HapticSample() for _ in range(2)]
    samples[0].position, samples[1].position = (0.2, 0.0, 0.2), (0.2, 0.0, -0.2)
    return [samples] * TICKS


def time_ticks(scene: palpate.Scene, world: palpate.World, samples) -> float:
    """[s] of this thread's processor time, which other work on the machine leaves alone."""
    began = time.thread_time()
    palpate.tick(scene, samples, 1e-3, world)
    return time.thread_time() - began


def main() -> int:
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 29
    ways: list[Pairs] = [[palpate.BodyPair(0, 1)], []]
    if len(sys.argv) > 2:
        ways.append([palpate.BodyPair(0, 1, friction=float(sys.argv[2]))])
    todo = [
        (name, [make_scene(cells, gap, pairs) for pairs in ways], press(gap, depth))
        for name, gap, depth in SCENES
    ]
    todo.append((LAID, [make_laid(cells, pairs) for pairs in ways], stay_away()))
    for name, scenes, samples in todo:
        worlds = [palpate.World(scene) for scene in scenes]
        times, touching = [], []
        for sample in samples:
            times.append([time_ticks(s, w, sample) for s, w in zip(scenes, worlds, strict=True)])
            touching.append(worlds[0].body_pairs[0].touching)
        count = sum(len(b.tissue.rest_position) for b in scenes[0].bodies)
        share = np.array(touching) / count
        seen = (share >= LEAST) & (share <= MOST)
        tell(f"{name}, all ticks", count, share, np.array(times))
        if seen.any() and not seen.all():
            tell(f"{name}, of 5 to 10 %", count, share[seen], np.array(times)[seen])
    return 0


def tell(name: str, count: int, share: np.ndarray, times: np.ndarray) -> None:
    """One line of what ticks cost [s] (n, 2) with the pair and without; (n, 3) with friction."""
    paired, alone, *rubbing = 1e6 * np.median(times, axis=0)
    worst, worst_alone, *_ = 1e6 * np.quantile(times, 0.99, axis=0)
    print(
        f"{name}: {100 * share.mean():.1f} % of {count} touch in {len(share)} ticks; median "
        f"{paired:.0f} us with the pair, {alone:.0f} without: {paired - alone:+.0f} us, "
        f"{paired / alone:.2f} times; p99 {worst / paired:.2f} and {worst_alone / alone:.2f} of "
        "the medians"
        + "".join(f"; {us:.0f} us where they rub, {us - paired:+.0f}" for us in rubbing)
    )


if __name__ == "__main__":
    sys.exit(main())
