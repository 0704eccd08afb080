# SPDX-License-Identifier: BSD-3-Clause
"""The verb `palpate bench`: rows, the paper's Table 1, and the plot of cost against vertices."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from palpate.bench.bodies import list_bodies
from palpate.bench.meshes import (
    SIZES,
    BenchMesh,
    generate_meshes,
    is_organ,
    read_published,
    read_shipped,
    read_surface,
)
from palpate.bench.part_costs import describe_part_costs, measure_part_costs
from palpate.bench.rows import Options, bench_meshes, describe_rows, list_works
from palpate.command.output import add_output
from palpate.command.terminal import make_harmless
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import PICTURE

BUDGET, QUICK_BUDGET = 0.4, 0.05
"""[s] CPU time a row."""


def add_bench(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--organ", action="append", metavar="NAME", help="a shipped organ; may be repeated"
    )
    parser.add_argument(
        "--scene",
        type=Path,
        action="append",
        help="published file (.palpate), and what each of its parts costs; may be repeated",
    )
    parser.add_argument(
        "--mesh", type=Path, action="append", help="OBJ of `palpate import`; may be repeated"
    )
    parser.add_argument(
        "--vertices",
        type=int,
        action="append",
        help="size of a generated ellipsoid; may be repeated. Without any of these four: every "
        "shipped organ, and " + ", ".join(map(str, SIZES)) + " vertices",
    )
    parser.add_argument(
        "--work",
        action="append",
        choices=list_works(),
        help="what is timed; may be repeated; without it everything",
    )
    parser.add_argument("--budget", type=quantity("s"), help="CPU time a row (400ms; quick: 50ms)")
    parser.add_argument("--quick", action="store_true", help="less time a row, nothing generated")
    parser.add_argument(
        "--table1", action="store_true", help="Table 1 of the paper, with measured figures"
    )
    add_output(
        parser,
        "--chart",
        writes=PICTURE,
        metavar="FILE.png",
        help="cost against vertices, 1k to 500k",
    )


def run_bench(call: argparse.Namespace) -> Report:
    named = call.organ or call.scene or call.mesh or call.vertices
    if call.table1 or call.chart:
        return run_special(call, named)
    meshes, options = choose_meshes(call, bool(named)), choose_options(call)
    # bodies are shipped organs, with constants of their own
    bodies = list_bodies(call.organ or ()) if call.organ or not named else []
    report = bench_meshes(meshes, options, say, bodies)
    return {**report, "scenes": [measure_part_costs(path) for path in call.scene or ()]}


def choose_meshes(call: argparse.Namespace, named: bool) -> list[BenchMesh]:
    meshes = read_shipped(call.organ or ()) if call.organ or not named else []
    # a scene of several organs, or of layers, has no one surface under both laws
    meshes += [read_published(path) for path in call.scene or () if is_organ(path)]
    meshes += [read_surface(path) for path in call.mesh or ()]
    sizes = call.vertices or (() if named or call.quick else SIZES)
    return meshes + generate_meshes(sizes)


def choose_options(call: argparse.Namespace) -> Options:
    budget = call.budget or (QUICK_BUDGET if call.quick else BUDGET)
    works = tuple(work for work in list_works() if not call.work or work in call.work)
    return Options(budget=budget, works=works)


def run_special(call: argparse.Namespace, named: object) -> Report:
    """Table 1 or the chart: what they show is fixed."""
    if call.table1 and call.chart:
        raise WrongCall("--table1: got --chart beside it, expected one of them")
    if named or call.work:
        raise WrongCall(
            "--table1, --chart: got meshes or works beside it, expected none: they choose their own"
        )
    budget = choose_options(call).budget
    if call.table1:
        from palpate.bench.table1 import measure_table1

        return measure_table1(budget, say)
    from palpate.bench.chart import measure_scaling, save_scaling_chart

    report = measure_scaling(budget, call.quick, say)
    save_scaling_chart(call.chart, report)
    return {"picture": str(call.chart), **report}


def say(text: str) -> None:
    """What is being done now, on standard error; the report alone goes to standard output."""
    print(make_harmless(text), file=sys.stderr, flush=True)


def describe_bench(report: Report) -> str:
    if "table1" in report:
        from palpate.bench.table1 import describe_table1

        return describe_table1(report)
    if "picture" in report:
        from palpate.bench.chart import describe_scaling

        return describe_scaling(report)
    lines = [describe_rows(report)]
    for measured in report["scenes"]:
        lines += ["", *describe_part_costs(measured)]
    return "\n".join(lines)


BENCH = Verb(
    "bench",
    "time steps, queries and ticks beside their naive forms",
    "palpate bench --organ gallbladder --quick --json",
    add_bench,
    run_bench,
    describe_bench,
    failed=lambda report: bool(report["missing"]),
)
