# SPDX-License-Identifier: BSD-3-Clause
"""What is run when: what takes long stays out of the everyday tests, and is found by name."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

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
    file.write_text(TESTS)
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-c", CHECKOUT / "pyproject.toml", "-p", "conftest"]
        + ["--collect-only", "-q", *options, file],
        env={**os.environ, "PYTHONPATH": str(CHECKOUT / "tests")},
        capture_output=True,
        text=True,
    )
    return {line.split("::")[1] for line in done.stdout.splitlines() if "::" in line}


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
    steps = [line for line in (CHECKOUT / ".ci/run").read_text().splitlines() if "step " in line]
    for command in ("./run test", "./run landing", "./run windows"):
        assert any(line.endswith(command) for line in steps), command
