# SPDX-License-Identifier: BSD-3-Clause
"""What is run when: what takes long stays out of the everyday tests, and is found by name."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import tiers
from tiers import name_test, read_long
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


def test_what_is_listed_as_long_is_left_out_by_name():
    listed = sorted(read_long())[0]
    module, name = listed.split("::")
    file = CHECKOUT / (module.replace(".", "/") + ".py")

    assert name_test(f"{module.replace('.', '/')}.py::{name}") == listed
    assert name not in collect_of(file)
    assert name in collect_of(file, "-m", "landing")


def test_every_test_that_is_listed_as_long_exists():
    missing = []
    for listed in read_long():
        module, name = listed.split("::")
        file = CHECKOUT / (module.replace(".", "/") + ".py")
        function = name.partition("[")[0]
        if not file.exists() or f"def {function}(" not in file.read_text(encoding="utf-8"):
            missing.append(listed)

    assert missing == []


def test_the_list_is_written_by_what_tests_took_and_keeps_what_is_everyday(tmp_path, monkeypatch):
    monkeypatch.setattr(tiers, "LONG", tmp_path / "long.txt")
    tiers.LONG.write_text(
        "# kept\n# everyday: a::journey\na::left\na::quick_now\na::still\n", encoding="utf-8"
    )
    took = {"journey": 9.0, "new": 1.6, "still": 0.8, "quick_now": 0.7, "quick": 1.4}
    cases = "".join(
        f'<testcase classname="a" name="{name}"><properties>'
        f'<property name="processor_s" value="{s}"/></properties></testcase>'
        for name, s in took.items()
    )
    (tmp_path / "results.xml").write_text(f"<testsuites>{cases}</testsuites>", encoding="utf-8")

    tiers.main(str(tmp_path / "results.xml"))

    written = "# kept\n# everyday: a::journey\na::left\na::new\na::still\n"
    assert tiers.LONG.read_text(encoding="utf-8") == written
