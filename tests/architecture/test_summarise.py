# SPDX-License-Identifier: BSD-3-Clause
"""What decides whether the tests passed is itself held to account."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tree import CHECKOUT

PASSED = """[doctest] test cases:  5 |  5 passed | 0 failed | 0 skipped"""
FAILED = """[doctest] test cases:  5 |  3 passed | 2 failed | 0 skipped"""


def ctest(status: str, output: str) -> str:
    return (
        f'<testsuite><testcase name="mesh" classname="mesh" status="{status}">'
        f"<system-out>{output}</system-out></testcase></testsuite>"
    )


def pytest_case(inside: str) -> str:
    return (
        '<testsuites><testsuite><testcase classname="tests.t" name="holds">'
        f"{inside}</testcase></testsuite></testsuites>"
    )


def summarise(tmp_path: Path, *results: str, allowed: str | None = None) -> tuple[int, str]:
    """Exit code and last line for these result files."""
    code, lines = print_summary(tmp_path, *results, allowed=allowed)
    return code, lines[-1]


def print_summary(
    tmp_path: Path, *results: str, allowed: str | None = None
) -> tuple[int, list[str]]:
    """Exit code and all lines for these result files."""
    files = [tmp_path / f"{i}.xml" for i in range(len(results))]
    for file, text in zip(files, results, strict=True):
        file.write_text(text, encoding="utf-8")
    options = [] if allowed is None else ["--every-skip-allowed-by", allowed]
    done = subprocess.run(
        [sys.executable, CHECKOUT / "tests/summarise.py", *files, *options],
        capture_output=True,
        encoding="utf-8",
    )
    return done.returncode, done.stdout.splitlines()


def test_an_executable_counts_by_its_test_cases(tmp_path):
    code, line = summarise(tmp_path, ctest("run", PASSED), pytest_case(""))

    assert (code, line) == (0, "6 passed, 0 failed, 0 skipped")


def test_what_a_test_proved_here_is_printed(tmp_path):
    case = pytest_case('<properties><property name="proved" value="the same bytes"/></properties>')

    _, lines = print_summary(tmp_path, case)

    assert lines[0] == "proved by holds: the same bytes"


def test_the_files_that_took_the_most_processor_time_are_named_first(tmp_path):
    def took(seconds: float) -> str:
        return pytest_case(
            f'<properties><property name="processor_s" value="{seconds}"/></properties>'
        )

    _, lines = print_summary(tmp_path, took(1.5), took(0.25))

    assert lines == ["   1.8 s of processor time: tests.t", "2 passed, 0 failed, 0 skipped"]


def test_a_failed_case_fails_the_whole(tmp_path):
    code, line = summarise(tmp_path, ctest("fail", FAILED), pytest_case("<failure/>"))

    assert (code, line) == (1, "3 passed, 3 failed, 0 skipped")


def test_an_executable_that_died_is_a_failure_whatever_it_said_before(tmp_path):
    assert summarise(tmp_path, ctest("fail", ""))[1] == "0 passed, 1 failed, 0 skipped"
    assert summarise(tmp_path, ctest("fail", PASSED))[1] == "5 passed, 1 failed, 0 skipped"


def test_a_case_that_could_not_run_counts_as_skipped(tmp_path):
    code, line = summarise(
        tmp_path,
        ctest("run", "SKIPPED: no organ\n" + PASSED),
        pytest_case('<skipped message="no display"/>'),
    )

    assert (code, line) == (0, "4 passed, 0 failed, 2 skipped")


def test_results_that_are_missing_or_empty_are_a_failure(tmp_path):
    code, _ = summarise(tmp_path, ctest("run", PASSED), "<testsuites/>")
    assert code == 1

    missing = subprocess.run(
        [sys.executable, CHECKOUT / "tests/summarise.py", tmp_path / "none.xml"],
        capture_output=True,
    )
    assert missing.returncode == 1


def test_a_skip_fails_where_everything_can_be_had(tmp_path):
    result = ctest("run", "SKIPPED: no organ\n" + PASSED)

    assert summarise(tmp_path, result, allowed="cannot be had here")[0] == 1
    assert summarise(tmp_path, result, allowed="no organ")[0] == 0
