# SPDX-License-Identifier: BSD-3-Clause
"""The page of what was verified last says what ran, and only of what ran."""

from __future__ import annotations

import sys

import pytest
from tree import CHECKOUT, read

sys.path.insert(0, str(CHECKOUT / "tests"))
from verified import HEAD, ORDER, Row, read_fuzz_log, read_rows, write_page  # noqa: E402

LOG = """#2	INITED cov: 31 ft: 40 corp: 1/4b exec/s: 0 rss: 30Mb
#9000	REDUCE cov: 334 ft: 1763 corp: 304/198Kb lim: 1540 exec/s: 199 rss: 432Mb L: 58/1525
#9100	DONE   cov: 335 ft: 1764 corp: 304/198Kb lim: 1540 exec/s: 199 rss: 432Mb
stat::number_of_executed_units: 9100
"""


def row(part: str, seconds: str = "900") -> Row:
    return Row(part, "1a2b3c4", "2026-11-22 08:00", seconds, "9100 executions", "", "none")


def test_a_part_changes_its_own_row_only():
    page = write_page("# Title\n\nText.\n\n" + HEAD + "\n|---|\n", row("fuzz law"))
    page = write_page(page, row("asan"))
    page = write_page(page, row("fuzz law", "1800"))

    assert page.startswith("# Title\n\nText.\n\n" + HEAD)
    assert read_rows(page) == {"asan": row("asan"), "fuzz law": row("fuzz law", "1800")}
    assert page.index("| asan |") < page.index("| fuzz law |")


def test_executions_and_coverage_are_those_that_libfuzzer_counted():
    assert read_fuzz_log(LOG) == ("9100 executions", "335 edges, 1764 features", "none")


def test_an_input_that_broke_a_reader_is_a_failure():
    broken = LOG + "artifact_prefix='b/'; Test unit written to b/law-crash-87b8\n"

    assert read_fuzz_log(broken)[2] == "law-crash-87b8"


def test_a_fuzzer_that_tried_nothing_is_a_failure():
    assert read_fuzz_log("ERROR: no such file")[2] == "no input was tried"


@pytest.mark.parametrize("part", ORDER)
def test_every_part_can_be_asked_for(part):
    name = part.removeprefix("fuzz ").removeprefix("sweeps ")

    assert name in read("run"), f"./run verify knows no {name}"
