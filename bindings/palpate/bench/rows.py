# SPDX-License-Identifier: BSD-3-Clause
"""The rows of `palpate bench`: every work on every mesh, and which of them are missing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import palpate
from palpate.bench.bodies import BenchBody
from palpate.bench.lateness import (
    LOOP,
    SECONDS_PER_BUDGET,
    choose_mesh,
    describe_loop,
    measure_loop,
)
from palpate.bench.meshes import BenchMesh
from palpate.command.verb import Report

PRESSED = 20_000
"""Vertices up to which a press is held: it asks larger surfaces for so many substeps (100k: 29 to
87, 500k: 77 to 388) that nobody could feel them."""


@dataclass(frozen=True)
class Options:
    """What is timed and for how long."""

    budget: float = 0.4
    """[s] CPU time a row."""
    works: tuple[str, ...] = field(default_factory=lambda: tuple(list_works()))
    air_substeps: tuple[int, ...] = (1, 12)
    """Of ticks with the hand in the air: a row for each."""
    press: bool = True
    """And a row for each tick with a press held, on up to PRESSED vertices."""

    def count_ticks(self, mesh: BenchMesh) -> int:
        """Rows of a tick of this mesh."""
        return len(self.air_substeps) + self.holds(mesh)

    def holds(self, mesh: BenchMesh) -> bool:
        return self.press and mesh.vertices <= PRESSED


def list_works() -> list[str]:
    """All that can be timed here: works of surfaces, those of bodies, and the live loop."""
    return [*palpate.bench_works(), *palpate.bench_body_works(), LOOP]


def bench_meshes(
    meshes: Sequence[BenchMesh],
    options: Options,
    say: Callable[[str], None] = lambda text: None,
    bodies: Sequence[BenchBody] = (),
) -> Report:
    """`rows`, `loop`, and under `missing` in words what could not be timed and why."""
    rows: list[Report] = []
    reasons: dict[tuple[str, str], str] = {}
    for mesh in meshes:
        say(f"{mesh.name}: {mesh.vertices} vertices")
        scenes = mesh.build()
        for work in palpate.bench_works():
            if work not in options.works:
                continue
            try:
                rows += time_work(mesh, scenes, work, options)
            except RuntimeError as problem:  # the ends of ours and the naive form disagree, ...
                reasons[mesh.name, work] = str(problem)
    wanted = [body for body in bodies if set(body.works) & set(options.works)]
    for body in wanted:
        say(f"{body.name}: {body.kind}")
        try:
            rows += time_body(body, options)
        except RuntimeError as problem:
            reasons[body.name, body.kind] = str(problem)
    missing = find_missing(rows, meshes, options, reasons)
    missing += find_missing_of_bodies(rows, wanted, options, reasons)
    loops = run_loop(meshes, options, missing, say) if LOOP in options.works and meshes else []
    return {"rows": rows, "loop": loops, "missing": missing}


def run_loop(
    meshes: Sequence[BenchMesh],
    options: Options,
    missing: list[str],
    say: Callable[[str], None],
) -> list[Report]:
    """The row of the live loop, or why there is none among what is missing."""
    mesh, duration = choose_mesh(meshes), SECONDS_PER_BUDGET * options.budget
    say(f"{mesh.name}: the live loop for {duration:g} s")
    try:
        return [measure_loop(mesh, mesh.build()[0], duration)]
    except RuntimeError as problem:
        missing.append(f"{mesh.name}: {LOOP}: {problem}")
        return []


def time_work(
    mesh: BenchMesh, scenes: tuple[palpate.Scene, palpate.Scene], work: str, options: Options
) -> list[Report]:
    chosen = palpate.BenchOptions(
        budget=options.budget,
        works=[work],
        air_substeps=list(options.air_substeps),
        press=options.holds(mesh),
    )
    return [
        report_row(row, mesh.name, mesh.constants) for row in palpate.run_bench(*scenes, chosen)
    ]


def time_body(body: BenchBody, options: Options) -> list[Report]:
    chosen = palpate.BenchOptions(
        budget=options.budget,
        works=[work for work in body.works if work in options.works],
        air_substeps=list(options.air_substeps),
        press=options.press,
    )
    rows = palpate.run_body_bench(body.build(), chosen)
    return [report_row(row, body.name, "from tissue") for row in rows]


def report_row(row: palpate.BenchRow, mesh: str, constants: str) -> Report:
    return {
        "work": row.work,
        "mesh": mesh,
        "vertices": row.vertices,
        "substeps": row.substeps or None,
        "median_us": 1e6 * row.median,
        "p99_us": 1e6 * row.p99,
        "naive_median_us": 1e6 * row.naive_median,
        "ratio_to_naive": row.ratio_to_naive,
        "ns_per_element": row.ns_per_element(),
        "share_of_bound": row.share_of_bound or None,
        "simd_target": row.simd_target,
        "compiler_flags": row.compiler_flags,
        "physics": row.physics,
        "constants": constants,
    }


def find_missing_of_bodies(
    rows: Sequence[Report],
    bodies: Sequence[BenchBody],
    options: Options,
    reasons: dict[tuple[str, str], str],
) -> list[str]:
    """A sentence for each work of each body without its rows."""
    missing = []
    for body in bodies:
        for work in body.works:
            if work not in options.works:
                continue
            air = 1 if body.kind == "linear" else len(options.air_substeps)
            wanted = air + options.press if work.endswith("_tick") else 1
            found = sum(row["mesh"] == body.name and row["work"] == work for row in rows)
            if found != wanted:
                why = reasons.get((body.name, body.kind), "no reason given")
                missing.append(f"{body.name}: {work}: {found} of {wanted} rows: {why}")
    return missing


def find_missing(
    rows: Sequence[Report],
    meshes: Sequence[BenchMesh],
    options: Options,
    reasons: dict[tuple[str, str], str],
) -> list[str]:
    """A sentence for each work of each mesh without its rows."""
    missing = []
    for mesh in meshes:
        for work in options.works:
            if work not in palpate.bench_works():
                continue
            wanted = options.count_ticks(mesh) if work.endswith("_tick") else 1
            found = sum(row["mesh"] == mesh.name and row["work"] == work for row in rows)
            if found != wanted:
                why = reasons.get((mesh.name, work), "no reason given")
                missing.append(f"{mesh.name}: {work}: {found} of {wanted} rows: {why}")
    return missing


def describe_rows(report: Report) -> str:
    if not report["rows"]:
        return "\n".join([describe_loop(row) for row in report["loop"]] + describe_missing(report))
    lines = [
        f"{'work':18} {'mesh':16} {'vertices':>8} {'substeps':>8} {'median us':>10} {'p99 us':>10} "
        f"{'ns each':>11} {'of bound':>8} {'x naive':>8}"
    ]
    for row in report["rows"]:
        share = row["share_of_bound"]
        lines.append(
            f"{row['work']:18} {row['mesh']:16} {row['vertices']:8d} "
            f"{row['substeps'] or '-':>8} {row['median_us']:10.2f} {row['p99_us']:10.2f} "
            f"{row['ns_per_element']:11.2f} "
            + (f"{share:8.0%}" if share else f"{'-':>8}")
            + f" {row['ratio_to_naive']:8.2f}"
        )
    lines += describe_columns(report["rows"])
    lines += [describe_loop(row) for row in report["loop"]]
    return "\n".join(lines + describe_missing(report))


def describe_missing(report: Report) -> list[str]:
    return [f"missing: {sentence}" for sentence in report["missing"]]


def describe_columns(rows: Sequence[Report]) -> list[str]:
    """What the columns mean, and what is the same in all rows."""
    builds = sorted(
        {f"{row['simd_target'] or 'plain code'}; {row['compiler_flags']}" for row in rows}
    )
    return [
        "ticks at 1 and 12 substeps: the hand in the air; then a press held, at what that asks",
        f"  for, on up to {PRESSED} vertices",
        "ns each: per link, triangle, prism, tetrahedron or query, per particle of a response, or",
        "  per tick",
        "of bound: the least time by this machine's arithmetic and memory, over the median",
        "x naive: how many times faster than the plain form in double, in the same process, with",
        "  the same flags, order of particles, terms and steps; its ends are compared first",
        *builds,
    ]
