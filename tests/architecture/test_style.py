# SPDX-License-Identifier: BSD-3-Clause
"""Formatters decide, nobody discusses it: `./run format` repairs what fails here."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tree import CHECKOUT, source_files

BIN = Path(sys.executable).parent


def complaints(*command: str | Path) -> str:
    done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, encoding="utf-8")
    return "" if done.returncode == 0 else done.stdout + done.stderr


def test_clang_format_has_nothing_to_change():
    files = [name for name in source_files() if name.endswith((".h", ".cpp"))]
    assert files

    assert complaints(BIN / "clang-format", "--dry-run", "-Werror", *files) == ""


def test_ruff_finds_no_fault():
    assert complaints(BIN / "ruff", "check", "--output-format=concise") == ""


def test_ruff_format_has_nothing_to_change():
    assert complaints(BIN / "ruff", "format", "--check") == ""
