# SPDX-License-Identifier: BSD-3-Clause
"""Minutes of random handling in real time: nothing may grow, leak or end unexpectedly.

    .venv/bin/python tests/soak/soak.py MINUTES [--seed N] [--json FILE]     (./run soak 30)

Missed ticks are reported and fail nothing: they are the machine's as much as the program's.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from handling import Operator, Outcome

WARM_UP = 0.25
"""Share of the time after which memory must no longer grow."""
MOST_GROWTH = 8.0
"""[MB] of resident memory from the second quarter to the last: what fragments, not what leaks."""


@dataclass
class Sample:
    """What the process holds between two runs."""

    time: float
    memory: float
    """[MB] resident"""
    descriptors: int
    threads: int


@dataclass
class Diary:
    """All that was seen, for the report."""

    seed: int
    samples: list[Sample] = field(default_factory=list)
    outcomes: list[Outcome] = field(default_factory=list)
    failure: str = ""


def take_sample(begun: float) -> Sample:
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[1])
    memory = pages * os.sysconf("SC_PAGE_SIZE") / 1e6
    count = [len(os.listdir(f"/proc/self/{what}")) for what in ("fd", "task")]
    return Sample(time.perf_counter() - begun, memory, *count)


def handle(minutes: float, diary: Diary, folder: Path) -> None:
    """Runs until the time is over or something ends as it should not."""
    begun = time.perf_counter()
    operator = Operator(folder, diary.seed)
    while time.perf_counter() - begun < 60.0 * minutes:
        try:
            diary.outcomes.append(operator.run_once())
        except Exception as problem:
            diary.failure = f"run {len(diary.outcomes)}: {type(problem).__name__}: {problem}"
            return
        diary.samples.append(take_sample(begun))
    if len(os.listdir(folder)) > 3:
        diary.failure = f"left behind: {sorted(os.listdir(folder))}"


def measure_growth(samples: list[Sample]) -> dict[str, float]:
    """Memory after the warm-up: its slope, and what the last quarter has more than the second."""
    times = np.array([sample.time for sample in samples])
    memory = np.array([sample.memory for sample in samples])
    late = times >= WARM_UP * times[-1]
    if len(samples) < 16:
        return {"memory_mb": float(memory[-1])}
    second = late & (times < 0.5 * times[-1])
    last = times >= 0.75 * times[-1]
    return {
        "memory_mb": float(memory[-1]),
        "memory_slope_mb_per_minute": 60.0 * float(np.polyfit(times[late], memory[late], 1)[0]),
        "memory_growth_mb": float(np.median(memory[last]) - np.median(memory[second])),
    }


def find_failures(diary: Diary, growth: dict[str, float]) -> list[str]:
    failures = [diary.failure] if diary.failure else []
    if growth.get("memory_growth_mb", 0.0) > MOST_GROWTH:
        failures.append(f"memory grew by {growth['memory_growth_mb']:.1f} MB after the warm-up")
    for what in ("descriptors", "threads"):
        counts = [getattr(sample, what) for sample in diary.samples]
        late = counts[int(WARM_UP * len(counts)) :]
        if late and late[-1] > late[0]:
            failures.append(f"{what} grew from {late[0]} to {late[-1]}")
    return failures


def write_report(diary: Diary) -> dict[str, Any]:
    growth = measure_growth(diary.samples) if diary.samples else {}
    drifts = [1e3 * outcome.drift for outcome in diary.outcomes if outcome.drift is not None]
    return {
        "seconds": diary.samples[-1].time if diary.samples else 0.0,
        "seed": diary.seed,
        "runs": dict(Counter(outcome.kind for outcome in diary.outcomes)),
        "ticks": sum(outcome.ticks for outcome in diary.outcomes),
        "missed_ticks": sum(outcome.missed for outcome in diary.outcomes),
        "drift_median_ms": float(np.median(drifts)) if drifts else None,
        "drift_max_ms": max(drifts) if drifts else None,
        "descriptors": diary.samples[-1].descriptors if diary.samples else 0,
        "threads": diary.samples[-1].threads if diary.samples else 0,
        **growth,
        "failures": find_failures(diary, growth),
    }


def describe(report: dict[str, Any]) -> str:
    runs = sum(report["runs"].values())
    ended = "; ".join(report["failures"]) or "nothing grew, leaked or ended unexpectedly"
    drift = report["drift_max_ms"]
    return (
        f"{report['seconds'] / 60:.1f} minutes, {runs} runs, {report['ticks']} ticks, "
        f"{report['missed_ticks']} missed; memory {report.get('memory_mb', 0.0):.0f} MB, "
        f"{report.get('memory_slope_mb_per_minute', 0.0):+.3f} MB a minute; "
        f"{report['descriptors']} descriptors, {report['threads']} threads; "
        f"drift at most {0.0 if drift is None else drift:.1f} ms: {ended}"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description="Random handling in real time.")
    parser.add_argument("minutes", type=float)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path, help="write the report there too")
    call = parser.parse_args()
    if not 0.0 < call.minutes <= 24 * 60:
        parser.error(f"minutes: got {call.minutes:g}, expected more than 0 and at most a day")
    diary = Diary(call.seed)
    with tempfile.TemporaryDirectory() as folder:
        handle(call.minutes, diary, Path(folder))
    report = write_report(diary)
    if call.json:
        call.json.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    print(json.dumps(report))
    print(describe(report))
    return 1 if report["failures"] else 0


if __name__ == "__main__":
    sys.exit(main())
