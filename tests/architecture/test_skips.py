# SPDX-License-Identifier: BSD-3-Clause
"""A C++ test that cannot run here says so, or it would count as passed."""

from __future__ import annotations

import re

from tree import files_under, read_code

CASE = re.compile(r"^TEST_CASE\(.*?^}", re.MULTILINE | re.DOTALL)
EARLY = re.compile(
    r"^  if \([^\n]*\) (?:return;|\{\n(?:    [^\n]*\n)*?    return;\n  \})", re.MULTILINE
)
"""A return of the test case itself, not of a lambda or of a loop within it."""


def test_no_test_case_returns_before_its_end_without_saying_that_it_was_skipped():
    files = [name for name in files_under("tests", ".cpp") if "/examples/" not in name]
    cases = [(name, case[0]) for name in files for case in CASE.finditer(read_code(name))]
    assert len(cases) > 500

    wrong = [
        f"{name}: {case.splitlines()[0]}: {early[0].splitlines()[0].strip()}"
        for name, case in cases
        for early in EARLY.finditer(case)
    ]

    assert wrong == []
