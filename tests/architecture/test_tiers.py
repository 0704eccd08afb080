# SPDX-License-Identifier: BSD-3-Clause
"""What is run when: what takes long stays out of the everyday tests, and is found by name."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import tiers
from tiers import LIMITS, name_test, read_list
from tree import CHECKOUT

TESTS = """
import pytest

def test_a_sample(): pass

@pytest.mark.landing
def test_all_scenes(): pass

@pytest.mark.window
@pytest.mark.landing
def test_a_rare_dialog(): pass

@pytest.mark.verify
def test_the_whole_sweep(): pass
"""


def collect(folder: Path, *options: str) -> set[str]:
    """The names of the tests of a file that pytest, with our settings, would run."""
    file = folder / "test_sweeps.py"
    file.write_text(TESTS, encoding="utf-8")
    return collect_of(file, *options)


def collect_of(file: Path, *options: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-c", CHECKOUT / "pyproject.toml", "-p", "conftest"]
        + ["--collect-only", "-q", *options, file],
        env={**os.environ, "PYTHONPATH": str(CHECKOUT / "tests")},
        capture_output=True,
        encoding="utf-8",
    )
    return {line.partition("::")[2] for line in done.stdout.splitlines() if "::" in line}


def test_a_sweep_stays_out_of_the_everyday_tests(tmp_path):
    assert collect(tmp_path) == {"test_a_sample"}


def test_a_sweep_runs_where_the_mark_verify_is_asked_for(tmp_path):
    assert collect(tmp_path, "-m", "verify") == {"test_the_whole_sweep"}


def test_what_a_landing_asks_stays_out_too_and_is_found_by_its_mark(tmp_path):
    assert collect(tmp_path, "-m", "landing and not window") == {"test_all_scenes"}


def test_every_test_of_windows_runs_where_windows_are_asked_for(tmp_path):
    assert collect(tmp_path, "-m", "window") == {"test_a_rare_dialog"}


def test_a_landing_runs_all_three():
    """In .ci/run: the everyday tests, those that they leave out, and every window."""
    steps = [
        line
        for line in (CHECKOUT / ".ci/run").read_text(encoding="utf-8").splitlines()
        if "step " in line
    ]
    for command in ("./run test", "./run landing", "./run windows"):
        assert any(line.endswith(command) for line in steps), command


@pytest.mark.parametrize(("name", "asked"), [("long.txt", "landing"), ("longest.txt", "verify")])
def test_what_is_listed_is_left_out_by_name(name, asked):
    longer = read_list("longest.txt") if name == "long.txt" else set()
    listed = sorted(read_list(name) - longer)[0]
    module, test = listed.split("::")
    file = CHECKOUT / (module.replace(".", "/") + ".py")

    assert name_test(f"{module.replace('.', '/')}.py::{test}") == listed
    assert test not in collect_of(file)
    assert test in collect_of(file, "-m", asked)


def test_what_is_too_long_for_a_landing_runs_where_the_mark_verify_is_asked_for_alone():
    listed = sorted(read_list("longest.txt"))[0]
    module, test = listed.split("::")
    file = CHECKOUT / (module.replace(".", "/") + ".py")

    assert test not in collect_of(file, "-m", "landing")
    assert test not in collect_of(file, "-m", "window")


@pytest.mark.parametrize("name", LIMITS)
def test_every_test_that_is_listed_exists(name):
    missing = []
    for listed in read_list(name):
        module, test = listed.split("::")
        file = CHECKOUT / (module.replace(".", "/") + ".py")
        function = test.partition("[")[0]
        if not file.exists() or f"def {function}(" not in file.read_text(encoding="utf-8"):
            missing.append(listed)

    assert missing == []


@pytest.fixture
def lists(tmp_path, monkeypatch) -> Path:
    """A folder with lists of tests that are of no project."""
    monkeypatch.setattr(tiers, "TESTS", tmp_path)
    (tmp_path / "long.txt").write_text(
        "# kept\n# everyday: a::journey\na::left\na::quick_now\na::still\n", encoding="utf-8"
    )
    (tmp_path / "longest.txt").write_text(
        "# kept\n# landing: a::safety\na::hours\na::minutes_now\n", encoding="utf-8"
    )
    return tmp_path


def write_results(file: Path, took: dict[str, float]) -> str:
    cases = "".join(
        f'<testcase classname="a" name="{name}"><properties>'
        f'<property name="processor_s" value="{s}"/></properties></testcase>'
        for name, s in took.items()
    )
    file.write_text(f"<testsuites>{cases}</testsuites>", encoding="utf-8")
    return str(file)


def test_the_list_is_written_by_what_tests_took_and_keeps_what_is_everyday(lists):
    took = {"journey": 9.0, "new": 1.6, "still": 0.8, "quick_now": 0.7, "quick": 1.4}
    tiers.main("long.txt", write_results(lists / "results.xml", took))

    written = "# kept\n# everyday: a::journey\na::left\na::new\na::still\n"
    assert (lists / "long.txt").read_text(encoding="utf-8") == written


def test_what_takes_too_long_for_a_landing_is_left_to_verify_but_for_a_case_of_each_test(lists):
    took = {"safety": 70.0, "minutes_now": 2.4, "alone": 21.0}
    took |= {"sweep[1]": 40.0, "sweep[2]": 30.0, "sweep[3]": 50.0, "sweep[4]": 19.0}
    took |= {"long[1]": 100.0, "long[2]": 90.0}
    tiers.main("longest.txt", write_results(lists / "results.xml", took))

    written = "# kept\n# landing: a::safety\na::alone\na::hours\na::long[1]\n"
    written += "a::sweep[1]\na::sweep[2]\na::sweep[3]\n"
    assert (lists / "longest.txt").read_text(encoding="utf-8") == written
