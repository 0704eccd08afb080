# SPDX-License-Identifier: BSD-3-Clause
"""A second of what tests/bench/play_a_minute.py measures for a minute: facts, and no clock."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))

import play_a_minute  # noqa: E402


@pytest.fixture(scope="module")
def report(tmp_path_factory, qapp):
    folder = tmp_path_factory.mktemp("minute")
    return play_a_minute.measure(folder, seconds=1.0, vertices=600, size=(320, 240))


def test_every_tick_of_a_played_run_was_run_and_recorded_or_counted_as_missed(report):
    assert report["ticks"] + report["missed_ticks"] == 1000
    assert report["rows"] == report["ticks"]
    assert report["complete"]
    assert report["record_gaps"] == 0
    assert report["trouble"] == ""


def test_what_was_played_with_a_mouse_replays_bit_by_bit(report):
    assert report["replay_equal"]


def test_frames_are_drawn_while_it_is_played(report):
    assert report["frames"] > 3
    assert 0 <= report["frames_missed"] < report["frames"]
    assert report["draw_p50_ms"] <= report["draw_p99_ms"]
    assert report["frame_interval_p50_ms"] <= report["frame_interval_p99_ms"]
    assert report["host"] in ("FboView", "GLView")
