# SPDX-License-Identifier: BSD-3-Clause
"""Which tests `./run test` runs; `./run landing` runs the others.

    python tests/tiers.py RESULTS.xml ...    regenerates tests/long.txt from measured times

A listed test stays listed while it takes more than half of LIMIT, or is not among the results.
"""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

LONG = Path(__file__).with_name("long.txt")
"""Tests that took more than LIMIT of processor time, one a line; lines that begin with # stay."""
LIMIT = 1.5
"""[s]"""


def keep_everyday(cases: Iterable[Any], everyday: Collection[Any]) -> list[Any]:
    """For `parametrize`: the cases as they are, those outside of `everyday` at a landing alone."""
    return [
        case if case in everyday else pytest.param(case, marks=pytest.mark.landing)
        for case in cases
    ]


def read_long() -> set[str]:
    """As `module.path::name[case]`, which is how results name tests."""
    lines = LONG.read_text(encoding="utf-8").splitlines()
    return {line for line in lines if line and not line.startswith("#")}


def name_test(node: str) -> str:
    """The name in the results of pytest's `path/module.py::name[case]`."""
    path, _, name = node.partition(".py::")
    return f"{path.replace('/', '.')}::{name}"


def read_times(results: Iterable[Path]) -> dict[str, float]:
    """[s] of processor time, by test."""
    times = {}
    for case in (c for path in results for c in ElementTree.parse(path).getroot().iter("testcase")):
        for said in case.iter("property"):
            if said.get("name") == "processor_s":
                name = f"{case.get('classname')}::{case.get('name')}"
                times[name] = float(said.get("value", ""))
    return times


def main(*results: str) -> None:
    times, listed = read_times(map(Path, results)), read_long()
    head = [line for line in LONG.read_text(encoding="utf-8").splitlines() if line[:1] == "#"]
    kept_everyday = {line.removeprefix("# everyday: ") for line in head}
    long = {name for name, took in times.items() if took > (LIMIT / 2 if name in listed else LIMIT)}
    long |= listed - set(times)
    LONG.write_text("\n".join([*head, *sorted(long - kept_everyday), ""]), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
