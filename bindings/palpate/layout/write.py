# SPDX-License-Identifier: BSD-3-Clause
"""Writes what a trainee opens, once nothing forbids it."""

from __future__ import annotations

from pathlib import Path

from palpate import FileError, scenario
from palpate.layout.check import Checked
from palpate.layout.document import Layout
from palpate.layout.publish import make_scenario


def write_checked(out: Path, layout: Layout, checked: Checked) -> bool:
    """Writes the scene of a layout that was checked; False where that found an error. Raises
    FileError or OSError."""
    if checked.scene is None or checked.assembly is None or checked.has_errors:
        return False
    made = make_scenario(layout, checked.assembly, checked.scene)
    try:
        scenario.write(out, made)
    except ValueError as problem:
        raise FileError(str(out), "", str(problem), "a scene that a file holds") from None
    return True
