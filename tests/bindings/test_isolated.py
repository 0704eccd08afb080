# SPDX-License-Identifier: BSD-3-Clause
"""What stands in the current folder is data: no process of ours imports it."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from hostile_names import list_run, make_hostile_folder
from palpate.system.display import require_display
from palpate.system.isolated import build_command, build_verb


@pytest.fixture
def hostile(tmp_path, monkeypatch):
    folder = make_hostile_folder(tmp_path / "organs")
    monkeypatch.chdir(folder)
    return folder


def test_the_folder_of_these_tests_does_run_where_nothing_is_isolated(hostile):
    """Else none of the tests below could fail."""
    subprocess.run([sys.executable, "-c", "import PySide6"], capture_output=True, check=False)

    assert list_run(hostile) != ""


@pytest.mark.parametrize(
    "words", [build_verb("--version"), build_command("-c", "import PySide6, numpy, palpate")]
)
def test_another_python_of_ours_imports_nothing_from_the_current_folder(words, hostile):
    done = subprocess.run(words, capture_output=True, encoding="utf-8", check=False)

    assert done.returncode == 0, done.stderr
    assert list_run(hostile) == ""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="cannot be had here: a display")
def test_the_search_for_a_display_imports_nothing_from_the_current_folder(hostile, monkeypatch):
    monkeypatch.delenv("QT_QPA_PLATFORM", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setitem(os.environ, "DISPLAY", ":98765")

    with pytest.raises(RuntimeError, match="cannot be reached"):
        require_display("nothing")

    assert list_run(hostile) == ""
