# SPDX-License-Identifier: BSD-3-Clause
"""Adds up what ctest and pytest reported: counts, failures, and why tests were skipped.

    python tests/summarise.py RESULTS.xml ... [--every-skip-allowed-by PATTERN ...]

A doctest executable counts by its test cases. A C++ test that cannot run here prints a line
`SKIPPED: reason` and returns; it counts as skipped. With --every-skip-allowed-by, a skip whose
reason matches none of the patterns is a failure: on a machine where everything can be had,
nothing may be left out.

A test that can prove more on one machine than on another says what it proved in a property of that
name, which is printed. So are the files of Python tests that took the most processor time.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

COSTLY = 10
"""How many of the files that took the most processor time are named."""

CASES = re.compile(r"\[doctest\] test cases: *\d+ *\| *(\d+) passed *\| *(\d+) failed")
SKIPPED = re.compile(r"^SKIPPED: *(.+)$", re.MULTILINE)


@dataclass
class Outcome:
    """What a suite did."""

    passed: int = 0
    failed: list[str] = field(default_factory=list)
    skipped: Counter[str] = field(default_factory=Counter)
    """How often, by reason."""
    proved: list[str] = field(default_factory=list)
    """By tests that can prove more or less."""
    processor: Counter[str] = field(default_factory=Counter)
    """[s] by file."""

    def add(self, other: Outcome) -> None:
        self.passed += other.passed
        self.failed += other.failed
        self.skipped += other.skipped
        self.proved += other.proved
        self.processor.update(other.processor)


def read_ctest_case(case: ElementTree.Element) -> Outcome:
    """One executable: as many tests as doctest says it holds, or one."""
    name, output = case.get("name", "?"), case.findtext("system-out") or ""
    skipped = Counter(reason.strip() for reason in SKIPPED.findall(output))
    found = CASES.search(output)
    passed, failed = (int(found[1]), int(found[2])) if found else (1, 0)
    if case.get("status") != "run" and failed == 0:  # crashed, timed out, or is not doctest's
        passed, failed = (passed if found else 0), 1
    return Outcome(max(passed - skipped.total(), 0), [f"C++ {name}"] * failed, skipped)


def read_pytest_case(case: ElementTree.Element) -> Outcome:
    outcome = Outcome()
    said = [(p.get("name"), p.get("value", "")) for p in case.iter("property")]
    for name, value in said:
        if name == "processor_s":
            outcome.processor[case.get("classname", "?")] += float(value)
    skip = case.find("skipped")
    if case.find("failure") is not None or case.find("error") is not None:
        outcome.failed = [f"{case.get('classname')}::{case.get('name')}"]
    elif skip is not None:
        outcome.skipped[skip.get("message") or "no reason given"] += 1
    else:
        outcome.passed = 1
        outcome.proved = [f"{case.get('name')}: {what}" for name, what in said if name == "proved"]
    return outcome


def read_results(path: Path) -> Outcome:
    """The results in one file; a file that is missing or holds no test is a failure."""
    outcome = Outcome()
    if not path.exists():
        return Outcome(failed=[f"{path.name} was not written"])
    root = ElementTree.parse(path).getroot()
    for case in root.iter("testcase"):
        is_ctest = case.get("status") is not None
        outcome.add(read_ctest_case(case) if is_ctest else read_pytest_case(case))
    if outcome == Outcome():
        outcome.failed.append(f"{path.name} holds no test")
    return outcome


def main() -> int:
    parser = argparse.ArgumentParser(description="Adds up test results.")
    parser.add_argument("results", nargs="+", type=Path)
    parser.add_argument("--every-skip-allowed-by", nargs="*", metavar="PATTERN")
    call = parser.parse_args()

    total = Outcome()
    for path in call.results:
        total.add(read_results(path))
    for name, used in total.processor.most_common(COSTLY):
        print(f"{used:6.1f} s of processor time: {name}")
    for what in total.proved:
        print(f"proved by {what}")
    for reason, count in sorted(total.skipped.items()):
        print(f"skipped {count}: {reason}")
    if call.every_skip_allowed_by is not None:
        allowed = [re.compile(pattern) for pattern in call.every_skip_allowed_by]
        for reason, count in sorted(total.skipped.items()):
            if not any(pattern.search(reason) for pattern in allowed):
                total.failed += [f"may not be skipped here: {reason}"] * count
    for name, count in Counter(total.failed).items():
        print(f"FAILED {name}" + (f" ({count} cases)" if count > 1 else ""))
    skipped = total.skipped.total()
    print(f"{total.passed} passed, {len(total.failed)} failed, {skipped} skipped")
    return 1 if total.failed or total.passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
