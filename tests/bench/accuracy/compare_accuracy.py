# SPDX-License-Identifier: BSD-3-Clause
"""Palpate beside MuJoCo, PositionBasedDynamics and Newton at equal accuracy: `./run bench
--accuracy`.

    compare_accuracy.py --anchor ANCHOR --python PEERS_PYTHON [--quick] [--json]
                        [--beside REPORT.json] [--chart FILE.png]

Every engine presses the same ball to the same depths into a solid spleen and a thin wall (work.py),
on the meshes and steps of ladder.py, one thread each, between two runs of the plain loop. Of an
engine's configurations that feel the truth within a tenth at both depths the cheapest counts:
processor time per simulated second, in touch. Fails, with a sentence, where an engine that should
have run gave no row.

With --beside, of the other engines only what was cheapest in that report is run again; their other
rows are taken from it as they are.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

from accuracy_chart import save_accuracy_chart
from accuracy_table import describe
from ladder import LADDER, SOLID, WALL, Entry, Try
from work import BUDGET, GATE, passes, read_work

sys.path.insert(0, str(Path(__file__).parents[1] / "peers"))
from compare_peers import APART, Failure, Runner  # noqa: E402  (beside this folder)

HERE = Path(__file__).parent
WORKS = (*SOLID, *WALL)
TIMEOUT = 900.0
"""[s] by the clock, for one run: Newton compiles its kernels for minutes the first time."""
TRIES = 2
"""Where the plain loop before and after differs by more than APART; then it is told."""
ANCHOR_VERTICES, ANCHOR_STEP = 2000, 1.0
"""Of the plain loop, [ms]."""
NOT_COMPARED = (
    "SOFA: quoted, no row: no package of v25.12 in the index, built from source for the study of "
    "2026-11-21, where its corotational tetrahedra were not run",
    "PyBullet: no row: its neo-Hookean bodies are read from files of tetrahedra whose contact "
    "force its Python does not tell",
)
"""Engines that are not compared here, and why."""


def write_works(folder: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(HERE / "write_work.py"), str(folder), *WORKS],
        stdout=subprocess.DEVNULL,
    )
    if done.returncode != 0:
        raise Failure(f"write_work.py ended with {done.returncode}")


def ask(runner: Runner, entry: Entry, name: str, words: tuple[str, ...]) -> dict:
    python = sys.executable if entry.ours else runner.python
    program = [python, str(HERE / entry.program), str(runner.folder), name, *words]
    return runner.run(program, TIMEOUT)


def measure(runner: Runner, entry: Entry, name: str, attempt: Try) -> dict:
    """One configuration, with the plain loop's cost before and after; again where they differ."""
    for _ in range(TRIES):
        before = runner.loop(ANCHOR_VERTICES, ANCHOR_STEP)["median_us"]
        row = ask(runner, entry, name, attempt.words)
        after = runner.loop(ANCHOR_VERTICES, ANCHOR_STEP)["median_us"]
        apart = abs(after / before - 1.0)
        if apart <= APART or "cpu_per_second" not in row:
            break
    anchor = (before + after) / 2.0
    row = {"work": name, "engine": entry.engine, "words": " ".join(attempt.words), **row}
    row |= {"anchor_us": anchor, "anchors_apart": apart, "passes": passes(row)}
    if "cpu_per_second" in row:
        row["ratio_to_loop"] = row["cpu_per_second"] / (anchor * 1e-6 / (1e-3 * ANCHOR_STEP))
    return row


def find_best(
    rows: list[dict], work: str, engine: str, longest: float | None = None
) -> dict | None:
    """The cheapest that passes, of steps of at most `longest` [ms]; None where none does."""
    fit = [
        row
        for row in rows
        if row["work"] == work
        and row["engine"] == engine
        and row["passes"]
        and (longest is None or row["dt_ms"] <= longest + 1e-9)
    ]
    return min(fit, key=lambda row: row["cpu_per_second"], default=None)


def find_both(rows: list[dict], engine: str) -> dict | None:
    """The cheapest configuration that passes at every place of the solid, as its costliest row."""
    rows = [row for row in rows if row["engine"] == engine and row["work"] in SOLID]
    fit = []
    for words in dict.fromkeys(row["words"] for row in rows):
        alike = [row for row in rows if row["words"] == words]
        if len(alike) == len(SOLID) and all(row["passes"] for row in alike):
            costlier = max(alike, key=lambda row: row["cpu_per_second"])
            errors = [error for row in alike for error in row["errors"]]
            fit.append({**costlier, "errors": errors})
    return min(fit, key=lambda row: row["cpu_per_second"], default=None)


def find_kept(report: dict | None, entry: Entry, name: str, attempt: Try) -> dict | None:
    """The row of a report that need not be run again: of another engine, and not its cheapest."""
    if report is None or entry.ours:
        return None
    words = " ".join(attempt.words)
    best = report["best"][name][entry.engine].values()
    if words in [found["words"] for found in best if found is not None]:
        return None
    wanted = (name, entry.engine, words)
    rows = [row for row in report["rows"] if (row["work"], row["engine"], row["words"]) == wanted]
    return {**rows[0], "kept": True} if rows else None


def run_ladder(
    runner: Runner, quick: bool, before: dict | None = None
) -> tuple[list[dict], list[str]]:
    """Rows, and a sentence on each that is missing; `before` is the report to run beside."""
    rows: list[dict] = []
    missing: list[str] = []
    for name in WORKS:
        for entry in LADDER:
            for attempt in entry.tries[name]:
                if quick and not attempt.quick:
                    continue
                kept = find_kept(before, entry, name, attempt)
                if kept is not None:
                    rows.append(kept)
                    continue
                print(f"{name}: {entry.engine} {' '.join(attempt.words)}", file=sys.stderr)
                try:
                    rows.append(measure(runner, entry, name, attempt))
                except Failure as failure:
                    missing.append(f"{entry.engine}: {name}: {failure}")
    return rows, missing


def make_report(works: dict[str, dict], rows: list[dict], missing: list[str]) -> dict:
    """What was found, and of every engine the cheapest that passes."""
    engines = [entry.engine for entry in LADDER]
    best = {
        name: {
            engine: {
                "any_step": summarise(find_best(rows, name, engine)),
                "one_ms": summarise(find_best(rows, name, engine, 1.0)),
            }
            for engine in engines
        }
        for name in works
    }
    return {
        "gate": GATE,
        "budget_s": BUDGET,
        "works": works,
        "best": best,
        "best_at_both_places": {engine: summarise(find_both(rows, engine)) for engine in engines},
        "rows": rows,
        "not_compared": list(NOT_COMPARED),
        "missing": missing,
    }


def summarise(row: dict | None) -> dict | None:
    keys = ("words", "cells", "dt_ms", "errors", "cpu_per_second", "ratio_to_loop")
    return None if row is None else {key: row[key] for key in keys}


def main() -> int:
    parser = argparse.ArgumentParser(description="Palpate beside others at equal accuracy")
    parser.add_argument("--anchor", required=True, help="the program built from anchor.cpp")
    parser.add_argument("--python", required=True, help="Python of the peers' environment")
    parser.add_argument("--accuracy", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="a few configurations of each")
    parser.add_argument("--json", action="store_true", help="report as JSON on standard output")
    parser.add_argument(
        "--beside",
        type=Path,
        metavar="REPORT.json",
        help="run others' cheapest rows of this report alone, and take the rest from it",
    )
    parser.add_argument("--chart", type=Path, metavar="FILE.png", help="cost against error")
    call = parser.parse_args()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    with tempfile.TemporaryDirectory() as folder:
        write_works(Path(folder))
        runner = Runner(call.anchor, call.python, Path(folder))
        works = {name: asdict(read_work(runner.folder / f"{name}.json")) for name in WORKS}
        before = json.loads(call.beside.read_text("utf-8")) if call.beside else None
        report = make_report(works, *run_ladder(runner, call.quick, before))
    print(json.dumps(report, indent=2) if call.json else describe(report))
    if call.chart:
        save_accuracy_chart(call.chart, report)
    for sentence in report["missing"]:
        print(f"bench: missing: {sentence}", file=sys.stderr)
    return 1 if report["missing"] else 0


if __name__ == "__main__":
    sys.exit(main())
