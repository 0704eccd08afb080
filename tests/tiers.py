# SPDX-License-Identifier: BSD-3-Clause
"""Which tests `./run test` runs, which `./run landing` adds, and which are left to `./run verify`.

    python tests/tiers.py long.txt build/results/release/pytest.xml
    python tests/tiers.py longest.txt build/results/landing/pytest.xml ...

regenerate the lists of tests from measured times: what a landing adds, by what `./run test` took,
and what only `./run verify` runs, by what a landing took. A listed test stays listed while it takes
more than half of the list's limit, or is not among the results. Of a test with several cases the
quickest is not listed, however long it takes.
"""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

TESTS = Path(__file__).parent
KEPT = {"long.txt": "# everyday: ", "longest.txt": "# landing: "}
"""The lists, and with what a line of theirs begins that keeps a test out whatever it takes."""
LIMITS = {"long.txt": 1.5, "longest.txt": 5.0}
"""[s] of processor time, by list: what took longer is listed."""


def keep_everyday(cases: Iterable[Any], everyday: Collection[Any]) -> list[Any]:
    """For `parametrize`: the cases as they are, those outside of `everyday` at a landing alone."""
    return [
        case if case in everyday else pytest.param(case, marks=pytest.mark.landing)
        for case in cases
    ]


def read_list(name: str) -> set[str]:
    """Tests as `module.path::name[case]`, which is how results name them."""
    lines = (TESTS / name).read_text(encoding="utf-8").splitlines()
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


def find_samples(times: dict[str, float]) -> set[str]:
    """The quickest case of each test that has several."""
    quickest: dict[str, str] = {}
    for name in sorted(times, key=times.__getitem__):
        quickest.setdefault(name.partition("[")[0], name)
    return {name for name in quickest.values() if "[" in name}


def main(name: str, *results: str) -> None:
    file, limit, listed = TESTS / name, LIMITS[name], read_list(name)
    times = read_times(map(Path, results))
    head = [line for line in file.read_text(encoding="utf-8").splitlines() if line[:1] == "#"]
    kept = {line.removeprefix(KEPT[name]) for line in head} | find_samples(times)
    long = {test for test, took in times.items() if took > (limit / 2 if test in listed else limit)}
    long |= listed - set(times)
    file.write_text("\n".join([*head, *sorted(long - kept), ""]), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
