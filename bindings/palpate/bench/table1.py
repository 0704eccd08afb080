# SPDX-License-Identifier: BSD-3-Clause
"""Table 1 of the paper with figures that no timer and no screen holds back.

The paper prints 1000 Hz and 24 frames per second for every organ: what its loop and its display
were set to. Here each rate is what the work itself allows, 1 over its median.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import palpate
from palpate.bench.frames import SIZE, measure_frames
from palpate.bench.meshes import BenchMesh, find_published, read_published
from palpate.bench.rows import Options, time_work
from palpate.command.verb import Report
from palpate.render import describe_gl

PAPER = {"simple_tissue": (66, 45), "spleen": (1196, 600), "kidney": (3996, 2000)} | {
    "gallbladder": (10782, 5400)
}
"""Triangles and vertices of the organs in the paper's Table 1, in its order."""
PAPER_CONTACT_RATE, PAPER_FRAME_RATE = 1000.0, 24.0
"""[Hz] of every organ there."""
LAWS = {"MSS": "mss", "MMS": "mms"}


def measure_table1(budget: float, say: Callable[[str], None]) -> Report:
    """A row for each organ and law; under `missing` in words what could not be measured."""
    rows, missing = [], []
    for name, counts in PAPER.items():
        path = find_published() / f"{name}.palpate"
        mesh = read_published(path)
        if (mesh.triangles, mesh.vertices) != counts:
            missing.append(
                f"{name}: {mesh.triangles} triangles, {mesh.vertices} vertices, "
                f"expected {counts[0]} and {counts[1]} as in the paper"
            )
            continue
        scenes = mesh.build()
        for index, law in enumerate(LAWS):
            say(f"{name}, {law}")
            try:
                rows.append(measure_row(mesh, scenes, index, law, path, budget))
            except RuntimeError as problem:
                missing.append(f"{name}: {law}: {problem}")
    return {
        "table1": rows,
        "missing": missing,
        "frame_size": list(SIZE),
        "graphics": describe_gl(),
        "processors": os.cpu_count(),
        "paper": {"contact_rate_hz": PAPER_CONTACT_RATE, "frame_rate_hz": PAPER_FRAME_RATE},
    }


def measure_row(
    mesh: BenchMesh,
    scenes: tuple[palpate.Scene, palpate.Scene],
    index: int,
    law: str,
    path: Path,
    budget: float,
) -> Report:
    options = Options(budget=budget, air_substeps=())

    def time(work: str) -> Report:
        return time_work(mesh, scenes, work, replace(options, works=(work,)))[0]

    refit, query = time("refit"), time("sphere")
    step, tick = time(f"{LAWS[law]}_dashpot_step"), time(f"{LAWS[law]}_dashpot_tick")
    frames = measure_frames(scenes[index], path)
    contact_us = refit["median_us"] + query["median_us"]
    deformation_us = tick["substeps"] * step["median_us"]
    return {
        "organ": mesh.name,
        "law": law,
        "triangles": mesh.triangles,
        "vertices": mesh.vertices,
        "contact_rate_hz": 1e6 / contact_us,
        "contact_p99_us": refit["p99_us"] + query["p99_us"],
        "substeps": tick["substeps"],
        "deformation_rate_hz": 1e6 / deformation_us,
        "deformation_p99_us": tick["substeps"] * step["p99_us"],
        "tick_rate_hz": 1e6 / tick["median_us"],
        "tick_p99_us": tick["p99_us"],
        "frame_rate_hz": 1.0 / frames.median,
        "frame_p99_ms": 1e3 * frames.p99,
        "simd_target": tick["simd_target"],
        "compiler_flags": tick["compiler_flags"],
    }


def describe_table1(report: Report) -> str:
    width, height = report["frame_size"]
    lines = [
        f"{'organ':14} {'law':4} {'triangles':>9} {'vertices':>8} {'contact':>10} {'substeps':>8} "
        f"{'deformation':>11} {'whole tick':>10} {'p99 us':>8} {'frames':>9} {'p99 ms':>7}"
    ]
    for row in report["table1"]:
        lines.append(
            f"{row['organ']:14} {row['law']:4} {row['triangles']:9d} {row['vertices']:8d} "
            f"{row['contact_rate_hz']:7.0f} Hz {row['substeps']:8d} "
            f"{row['deformation_rate_hz']:8.0f} Hz {row['tick_rate_hz']:7.0f} Hz "
            f"{row['tick_p99_us']:8.1f} {row['frame_rate_hz']:6.0f}/s {row['frame_p99_ms']:7.2f}"
        )
    paper = report["paper"]
    lines += [
        f"the paper: {paper['contact_rate_hz']:.0f} Hz and {paper['frame_rate_hz']:.0f} frames/s "
        "for every organ, which are settings of a loop and a display",
        "contact: refit of the tree and a ball query; deformation: the substeps that springs of "
        "the file, or of the test bed, need",
        "  in a held press of 3 mm; whole tick: both, the tool's balance, the force and the alarm. "
        "CPU time, one core",
        f"frames: {width} x {height}, the organ's own appearance, edges smoothed, no shadows, "
        "positions and normals",
        f"  new in each; by the clock, on {report['processors']} processors: {report['graphics']}",
    ]
    return "\n".join(lines + [f"missing: {sentence}" for sentence in report["missing"]])
