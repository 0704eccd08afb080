# SPDX-License-Identifier: BSD-3-Clause
"""A large body that ticks in a thread of its own, in the hand: felt beside its full model.

    .venv/bin/python tests/bench/feel_slow_body.py [--vertices 100000] [--exchange-rate 50]
    .venv/bin/python tests/bench/feel_slow_body.py --live
    .venv/bin/python tests/bench/feel_slow_body.py --live --in-tick

A hand presses, slips and releases an ellipsoid of springs (palpate.study.multirate). Without --live
all is done in one thread, so the figures are the same whatever else the machine does; the cost of
an exchange beside its interval says whether a thread has time for it. With --live it is the real
loop, on as many cores as there are, and what it recorded is held against the full model of the same
hand. With --in-tick the body is as large as a liver and ticks with the hand itself, and what is at
rest sleeps (tests/meshes/test_fine_body.py): that is the default where it fits.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import palpate
from palpate.bench.meshes import BED, generate_ellipsoid, generate_mesh, renumber
from palpate.runs.live import LiveRun
from palpate.runs.press import find_top
from palpate.scene.scene_file import compile_scene
from palpate.study.multirate import (
    PHASES,
    HandWay,
    MultirateRow,
    compare,
    feel_in_full,
    find_jump,
    list_samples,
)

MOST_ERROR, MOST_JUMP = 0.05, 10e-3
"""[-] rms of force; [N] of a tick, or twice that of the full model."""
ALLOWED, ALLOWED_IN_TICK = 1e-3, 5e-3
"""[N] by which the force may be wrong, so that tissue far from the hand may sleep."""
LARGE = 2.5
"""[-] Times as large a body that ticks with the hand is: 250 mm long."""


def build_body(vertices: int) -> palpate.Scene:
    """An ellipsoid of springs in the test bed; what is at rest may sleep."""
    scene, _ = generate_mesh(vertices).build()
    scene.bodies[0].force_error = ALLOWED
    scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0
    return palpate.build_scene(scene)


def build_large(vertices: int, force_error: float) -> palpate.Scene:
    """An ellipsoid of springs of 250 mm, which ticks with the hand."""
    mesh = generate_ellipsoid(vertices)
    large = palpate.SurfaceMesh(LARGE * np.asarray(mesh.vertices), mesh.triangles)
    ordered, parts = renumber(large, BED)
    return compile_scene(replace(parts, hand=replace(parts.hand, force_error=force_error)), ordered)


def feel_asked(
    scene: palpate.Scene, samples: list[palpate.HapticSample], ticks: int
) -> tuple[np.ndarray, float]:
    """[N] (ticks, 3), and the processor's time for an exchange [s], median."""
    slow, forces, costs = palpate.SlowTissue(scene, scene.rate, ticks), [], []
    for number, sample in enumerate(samples):
        begun = time.thread_time()
        forces.append(slow.tick(sample).force)
        if number % ticks == 0:
            costs.append(time.thread_time() - begun)
    assert not slow.alarm(), slow.alarm()
    return np.array(forces), float(np.median(costs))


def feel_live(
    scene: palpate.Scene, way: HandWay, exchange_rate: float
) -> tuple[list[palpate.HapticSample], np.ndarray, palpate.LoopReport]:
    """The hands of a live run, the forces of its ticks, and what it cost."""
    scene.exchange_rate = exchange_rate
    built = palpate.build_scene(scene)
    device = palpate.ReplayDevice(list_samples(way, scene.rate))
    options = palpate.LoopOptions(duration=PHASES["release"][1])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "slow.prec"
        run = LiveRun(built, device, record=path, options=options)
        with run:
            run.wait(60.0)
        report = run.finish()
        record = palpate.read_record(str(path))
    assert palpate.replay(built, record).equal, "the record does not replay to the bit"
    return [read_sample(row) for row in record.hand], record.felt["force"].astype(float), report


def read_sample(row: np.void) -> palpate.HapticSample:
    """A row of a record's hand."""
    sample = palpate.HapticSample(position=row["position"], velocity=row["velocity"])
    sample.time, sample.orientation, sample.grip = row["time"], row["orientation"], row["grip"]
    sample.buttons = int(row["buttons"])
    return sample


def say(row: MultirateRow, jump: float) -> dict[str, float | bool]:
    return {
        "rms": row.rms,
        "largest": row.largest,
        "press": row.press,
        "slip": row.slip,
        "release": row.release,
        "jump_mN": 1e3 * row.jump,
        "full_jump_mN": 1e3 * jump,
        "holds": row.rms <= MOST_ERROR and row.jump <= max(MOST_JUMP, 2.0 * jump),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--vertices", type=int, default=100_000)
    parser.add_argument("--exchange-rate", type=float, default=50.0)
    parser.add_argument("--depth", type=float, default=3e-3, help="[m]")
    parser.add_argument("--live", action="store_true")
    parser.add_argument("--in-tick", action="store_true", help="with --live")
    call = parser.parse_args()
    if call.in_tick and not call.live:
        parser.error("--in-tick: got no --live, expected it: without a clock nothing is late")
    scene = (
        build_large(call.vertices, ALLOWED_IN_TICK) if call.in_tick else build_body(call.vertices)
    )
    ticks = round(scene.rate / call.exchange_rate)
    way = HandWay(find_top(scene), scene.instruments[0].tool.radius, call.depth, 2e-3)
    found: dict[str, object] = {
        "vertices": len(scene.bodies[0].tissue.rest_position),
        "substeps": scene.bodies[0].substeps,
        "interval_ms": 1e3 * ticks / scene.rate,
    }
    if call.live:
        rate = 0.0 if call.in_tick else call.exchange_rate
        samples, felt, report = feel_live(scene, way, rate)
        found |= {
            "missed_ticks": report.missed_ticks,
            "late_exchanges": report.late_exchanges,
            "exchanges": report.exchanges,
            "exchange_p99_ms": 1e3 * report.exchange_cost.p99,
            "haptic_tick_p99_us": 1e6 * report.cost.p99,
        }
    else:
        samples = list_samples(way, scene.rate)
        felt, cost = feel_asked(scene, samples, ticks)
        found["exchange_ms"] = 1e3 * cost
    whole = build_large(call.vertices, 0.0) if call.in_tick else scene
    begun = time.thread_time()
    full = feel_in_full(whole, samples)
    found["full_tick_ms"] = 1e3 * (time.thread_time() - begun) / len(samples)
    found["peak_N"] = float(np.linalg.norm(full, axis=1).max())
    row = say(compare("local_stiffness", ticks, scene, samples, felt, full), find_jump(full))
    print(json.dumps(found | row, indent=2))
    return 0 if row["holds"] else 1


if __name__ == "__main__":
    sys.exit(main())
