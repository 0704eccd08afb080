# SPDX-License-Identifier: BSD-3-Clause
"""Writes what a part of ./run verify gave into its row of tests/VERIFIED.md.

    verified.py PART --seconds N [--results XML ... | --fuzz LOG | --soak JSON] [--failed]

PART is what was run: `sweeps PLACE`, asan, tsan, clang, plain, wheels, soak or `fuzz READER`. Other
rows stay as they are, so parts may be run one by one, each on a commit of its own.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from dataclasses import astuple, dataclass
from datetime import UTC, datetime
from pathlib import Path

from summarise import Outcome, read_results

PAGE = Path(__file__).with_name("VERIFIED.md")
READERS = ("read_scenario", "organ", "record", "script", "scene_file", "device", "host", "law")
PLACES = ("core", "meshes", "bindings", "editor", "other")
PARTS = ("asan", "tsan", "clang", "plain", "wheels", "soak")
ORDER = (
    *(f"sweeps {place}" for place in PLACES),
    *PARTS,
    *(f"fuzz {reader}" for reader in READERS),
)
HEAD = "| part | commit | date (UTC) | seconds | what ran | coverage | failures |"
ROW = re.compile(r"^\| ([a-z_ ]+) \| (.*) \| (.*) \| (.*) \| (.*) \| (.*) \| (.*) \|$")


@dataclass
class Row:
    part: str
    commit: str
    date: str
    seconds: str
    ran: str
    coverage: str
    failures: str

    def line(self) -> str:
        return "| " + " | ".join(astuple(self)) + " |"


def describe_commit() -> str:
    """The short hash, with a plus where files differ from it."""

    def git(*words: str) -> str:
        done = subprocess.run(
            ["git", *words], cwd=PAGE.parent, capture_output=True, encoding="utf-8", check=True
        )
        return done.stdout.strip()

    changed = git("status", "--porcelain", "--untracked-files=no", "--", ":!VERIFIED.md")
    return git("rev-parse", "--short", "HEAD") + ("+" if changed else "")


def read_rows(text: str) -> dict[str, Row]:
    rows = (ROW.match(line) for line in text.splitlines())
    return {row[1]: Row(*row.groups()) for row in rows if row and row[1] in ORDER}


def write_page(text: str, row: Row) -> str:
    """The page with this row in its place; what stands before the table stays."""
    rows = read_rows(text) | {row.part: row}
    before = text.split(HEAD)[0]
    lines = [HEAD, "|---|---|---|---|---|---|---|"]
    return before + "\n".join(lines + [rows[name].line() for name in ORDER if name in rows]) + "\n"


def read_fuzz_log(text: str) -> tuple[str, str, str]:
    """Executions, coverage and failures as libFuzzer and Atheris print them."""
    counts = re.findall(r"^#(\d+)\b.*?cov: (\d+) ft: (\d+)", text, re.MULTILINE)
    executed = re.findall(r"^stat::number_of_executed_units: (\d+)", text, re.MULTILINE)
    if not counts:
        return "nothing", "", "no input was tried"
    runs = executed[-1] if executed else counts[-1][0]
    broken = re.findall(r"Test unit written to \S*?([^\s/]+)$", text, re.MULTILINE)
    coverage = f"{counts[-1][1]} edges, {counts[-1][2]} features"
    return f"{runs} executions", coverage, ", ".join(broken) or "none"


def read_tests(paths: list[Path]) -> tuple[str, str, str]:
    total = Outcome()
    for path in paths:
        total.add(read_results(path))
    ran = f"{total.passed} tests passed, {total.skipped.total()} skipped"
    return ran, "", ", ".join(sorted(set(total.failed))) or "none"


def read_soak(path: Path) -> tuple[str, str, str]:
    report = json.loads(path.read_text(encoding="utf-8"))
    ran = (
        f"{sum(report['runs'].values())} runs, {report['ticks']} ticks, "
        f"{report['missed_ticks']} missed; memory "
        f"{report.get('memory_slope_mb_per_minute', 0.0):+.3f} MB/min, "
        f"{report['descriptors']} descriptors, drift {report['drift_max_ms']:.1f} ms at most"
    )
    return ran, "", "; ".join(report["failures"]) or "none"


def main() -> int:
    parser = argparse.ArgumentParser(description="Writes a row of tests/VERIFIED.md.")
    parser.add_argument("part", choices=ORDER)
    parser.add_argument("--seconds", required=True, type=float)
    parser.add_argument("--commit", help="what ran, where it is not what is checked out")
    parser.add_argument("--failed", action="store_true", help="whatever the results say")
    parser.add_argument("--ran", default="", help="in words, where there are no results")
    found = parser.add_mutually_exclusive_group()
    found.add_argument("--results", nargs="+", type=Path)
    found.add_argument("--fuzz", type=Path)
    found.add_argument("--soak", type=Path)
    call = parser.parse_args()

    ran, coverage, failures = call.ran, "", "none"
    if call.results:
        ran, coverage, failures = read_tests(call.results)
    elif call.fuzz:
        ran, coverage, failures = read_fuzz_log(
            call.fuzz.read_text(errors="replace", encoding="utf-8")
        )
    elif call.soak:
        ran, coverage, failures = read_soak(call.soak)
    if call.failed and failures == "none":
        failures = "it ended with an error"
    now = datetime.now(UTC).strftime("%Y-%m-%d %H:%M")
    commit = call.commit or describe_commit()
    row = Row(call.part, commit, now, f"{call.seconds:.0f}", ran, coverage, failures)
    PAGE.write_text(write_page(PAGE.read_text(encoding="utf-8"), row), encoding="utf-8")
    print(row.line())
    return 0 if failures == "none" else 1


if __name__ == "__main__":
    sys.exit(main())
