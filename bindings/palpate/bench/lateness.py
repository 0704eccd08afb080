# SPDX-License-Identifier: BSD-3-Clause
"""How late the ticks of the live loop begin, with an organ pressed and let go again and again."""

from __future__ import annotations

from collections.abc import Sequence

import palpate
from palpate.bench.meshes import BenchMesh
from palpate.command.verb import Report
from palpate.runs.press import find_top

LOOP = "loop"
"""The name of the work."""
ORGAN = "gallbladder"
"""Which mesh it runs on where that is among them; else the first."""
SECONDS_PER_BUDGET = 25.0
"""[s] of the clock for each second of CPU time that a row is worth."""
PERIOD = 1.0
"""[s] of a press."""
DEPTH, LIFT = 3e-3, 5e-3
"""[m] below where the tip first touches, and above."""


def choose_mesh(meshes: Sequence[BenchMesh]) -> BenchMesh:
    return next((mesh for mesh in meshes if mesh.name == ORGAN), meshes[0])


def measure_loop(mesh: BenchMesh, scene: palpate.Scene, duration: float) -> Report:
    """The row of a run of so many seconds.

    Raises:
        RuntimeError: The run ended with an alarm or a fault.
    """
    hand = script_presses(scene, duration)
    with palpate.Loop(scene, hand, palpate.LoopOptions(duration=duration)) as loop:
        while not loop.wait(10.0):
            pass
    report = loop.report()
    if report.alarm or report.fault != palpate.DeviceFault.none:
        raise RuntimeError(f"the run ended with {report.alarm!r}, {report.fault!r}")
    late = report.lateness
    claimed = (late.median, late.p99, late.p99_9, late.max) if report.realtime else (None,) * 4
    p50, p99, p99_9, largest = (None if t is None else 1e6 * t for t in claimed)
    return {
        "work": LOOP,
        "mesh": mesh.name,
        "vertices": mesh.vertices,
        "rate_hz": scene.rate,
        "duration_s": duration,
        "ticks": report.ticks,
        "missed_ticks": report.missed_ticks,
        "realtime": report.realtime,
        "realtime_note": report.realtime_note,
        "lateness_p50_us": p50,
        "lateness_p99_us": p99,
        "lateness_p99_9_us": p99_9,
        "lateness_max_us": largest,
    }


def script_presses(scene: palpate.Scene, duration: float) -> palpate.ScriptedDevice:
    place, radius = find_top(scene), scene.instruments[0].tool.radius
    above = place.point + (radius + LIFT) * place.outward
    below = place.point + (radius - DEPTH) * place.outward
    frames = []
    for k in range(int(duration / PERIOD) + 1):
        begun = k * PERIOD
        frames += [
            palpate.KeyFrame(begun, above),
            palpate.KeyFrame(begun + 0.4 * PERIOD, below),
            palpate.KeyFrame(begun + 0.6 * PERIOD, below),
        ]
    return palpate.ScriptedDevice([*frames, palpate.KeyFrame(frames[-1].time + PERIOD, above)])


def describe_loop(row: Report) -> str:
    head = (
        f"loop at {row['rate_hz']:g} Hz on the {row['mesh']}, {row['duration_s']:g} s: "
        f"{row['missed_ticks']} of {row['ticks'] + row['missed_ticks']} ticks missed; "
    )
    if not row["realtime"]:
        return (
            f"{head}real-time priority was refused, so nothing is claimed ({row['realtime_note']})"
        )
    return (
        f"{head}with real-time priority late by {row['lateness_p50_us']:.1f} us (median), "
        f"{row['lateness_p99_us']:.1f} (99 of 100), {row['lateness_p99_9_us']:.1f} (999 of 1000), "
        f"{row['lateness_max_us']:.0f} at most"
    )
