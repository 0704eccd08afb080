# SPDX-License-Identifier: GPL-3.0-or-later
"""./run bench --authoring: every work is done, and what is no matter of time is as was asked."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[1] / "bench" / "bench_authoring.py"
WORKS = (
    "memory", "import and doctor", "fill", "Clean up", "Stitch borders", "Fill holes",
    "Smooth, 10 steps", "Remove crossings", "Wrap", "decimate",
)  # fmt: skip


@pytest.mark.landing
def test_every_work_is_timed_and_its_result_is_what_was_asked():
    done = subprocess.run(
        [sys.executable, str(BENCH), "--quick", "--json"], capture_output=True, encoding="utf-8"
    )

    assert done.returncode == 0, done.stderr
    rows = {row["work"]: row for row in json.loads(done.stdout)["rows"]}
    assert tuple(rows) == WORKS
    assert all(row["value"] > 0.0 for row in rows.values())
    assert rows["memory"]["unit"] == "MB" and rows["memory"]["value"] < 1000.0
    assert float(rows["decimate"]["found"].split(", ")[1].split()[0]) >= 20.0
    assert 9_000 <= int(rows["fill"]["found"].split()[0]) <= 11_000


def test_another_option_is_refused():
    done = subprocess.run(
        [sys.executable, str(BENCH), "--quickly-not"], capture_output=True, encoding="utf-8"
    )

    assert done.returncode == 2 and "--quickly-not" in done.stderr
