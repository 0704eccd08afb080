# SPDX-License-Identifier: BSD-3-Clause
"""What tests/bench compares with other engines: the common work, its gate, its tables; no clock."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import numpy as np
import pytest

BENCH = Path(__file__).resolve().parents[1] / "bench"
sys.path[:0] = [str(BENCH), str(BENCH / "peers")]

import body as common  # noqa: E402
import compare_peers  # noqa: E402
import palpate_engine  # noqa: E402
import press as pressing  # noqa: E402
import ratio_chart  # noqa: E402
import table  # noqa: E402


def test_the_shell_has_exactly_the_counts_it_promises():
    shell = common.build_body(600)

    assert len(shell.x) == shell.vertices == 600
    assert len(shell.edges) == 3 * 600 - 6
    assert len(shell.triangles) == 2 * 600 - 4
    assert len(shell.fixed) == 30
    assert shell.mass * 600 == pytest.approx(1050.0 * 4.0 / 3.0 * math.pi * 52.5e-6)


def test_tethers_hold_as_many_newtons_per_metre_and_vertex_as_homes():
    shell, homes = common.build_body(600, tethered=True), common.build_body(600)

    tethers = shell.edges[shell.edges[:, 1] >= 600]
    assert homes.home * 600 == pytest.approx(common.STIFFNESS * len(tethers), rel=1e-9)
    assert set(range(600, len(shell.x))) <= set(shell.fixed.tolist())


def test_the_ball_comes_down_evenly_and_stays():
    assert common.place_ball(0.0) == pytest.approx(0.030 + 0.005 + 0.001)
    assert common.place_ball(0.1) == pytest.approx(0.036 - 0.0055)
    assert common.place_ball(0.2) == common.place_ball(0.3) == pytest.approx(0.025)


def test_force_is_what_the_momentum_and_the_pulls_do_not_explain():
    shell = common.build_body(60)
    dt, pushed = 1e-3, 0.5  # N, upwards on the free vertices
    free = shell.free
    meter = common.ForceMeter(shell)
    acceleration = pushed / (free.sum() * shell.mass)

    def at(time: float) -> np.ndarray:
        x = shell.x.copy()
        # so little that springs to what is held pull with less than a thousandth
        x[free, 2] += 0.5 * acceleration * time**2 * 1e-9
        return x

    for time in (0.0, 0.01, 0.02):
        meter.read(time, at(time), at(time + dt), dt)

    assert meter.force() == pytest.approx(-1e-9 * pushed, rel=0.2)


def test_a_pull_of_homes_at_rest_is_balanced_by_the_ball():
    shell = common.build_body(60)
    meter = common.ForceMeter(shell)
    x = shell.x.copy()
    top = int(x[:, 2].argmax())
    x[top, 2] -= 1e-3

    meter.read(0.0, x, x, 1e-3)
    meter.read(1.0, x, x, 1e-3)

    assert meter.force() == pytest.approx(1e-3 * shell.home)


def test_palpate_presses_the_common_shell_with_a_steady_force():
    shell = common.build_body(600)
    tissue = palpate_engine.Tissue(palpate_engine.build_scene(shell, 1e-3, 3e7), 1e-3)
    engine = pressing.Engine(tissue.step, tissue.positions, tissue.contacts)

    row = pressing.press(engine, shell, 1e-3)

    assert row["force"] > 0.0
    assert row["contacts"] > 0.5
    assert row["steps"] == 50


def test_an_engine_that_blows_up_says_when():
    shell = common.build_body(60)
    away = shell.x + 1.0
    engine = pressing.Engine(lambda height: None, lambda: away, lambda: 0)

    assert pressing.press(engine, shell, 1e-3) == {"why": "blew up at 0.150 s"}


class Told:
    """A runner that has been told what every run gives."""

    def __init__(self, forces: dict[float, float]):
        self.forces = forces

    def loop(self, vertices, step, **_):
        return {"median_us": 100.0, "p99_us": 110.0, "force": 1.0}

    def ask(self, peer, vertices, step, variant):
        return {"dt_ms": step, "force": self.forces[step], "median_us": 50.0, "p99_us": 60.0}


PEER = compare_peers.Peer("Some", "some.py", (1.0, 0.5, 0.25), "vertices")


def test_a_step_whose_force_is_more_than_a_tenth_off_does_not_count():
    row = compare_peers.measure(Told({1.0: 1.5, 0.5: 1.09, 0.25: 1.0}), PEER, 600, 1.0, 0.3)

    assert row["passes"]
    assert row["dt_ms"] == 0.5
    assert row["force_error"] == pytest.approx(0.09)
    assert row["step_ratio"] == pytest.approx(0.5)
    assert row["real_time_factor"] == pytest.approx(10.0)


def test_an_engine_without_a_step_that_passes_says_what_was_tried():
    row = compare_peers.measure(Told({1.0: 1.5, 0.5: 0.5, 0.25: 1.2}), PEER, 600, 1.0, 0.3)

    assert not row["passes"]
    assert row["tried"][1] == "0.5 ms: force -50%, 50 us"
    assert "no step passes the gate" in table.describe_row(row)


def test_an_engine_that_cannot_be_run_fails_the_whole(tmp_path, monkeypatch):
    runner = compare_peers.Runner("anchor", sys.executable, tmp_path)
    monkeypatch.setattr(runner, "loop", Told({}).loop)
    peer = compare_peers.Peer("Missing", "no_such_engine.py", (1.0,), "vertices")
    monkeypatch.setattr(compare_peers, "PEERS", (peer,))
    rows, missing = [], []

    compare_peers.measure_size(runner, 600, rows, missing)

    assert len(missing) == 1
    assert missing[0].startswith("Missing: 600 vertices: no_such_engine.py:")


def test_the_largest_shell_lies_where_the_real_time_factor_crosses_one():
    rows = [
        {"peer": "Some", "vertices": n, "real_time_factor": f}
        for n, f in ((600, 10.0), (6000, 0.1))
    ]

    assert table.find_largest(rows, "Some") == pytest.approx(600 * 10**0.5)
    assert table.find_largest(rows[:1], "Some") == math.inf
    assert table.find_largest(rows[1:], "Some") == 0.0
    assert table.find_largest(rows, "Other") is None


def test_quoted_rows_are_marked_and_are_ratios_of_todays_plain_loop():
    rows = compare_peers.quote(5400, 100.0)

    jolt = next(row for row in rows if row["peer"] == "Jolt, XPBD, 1 substep")
    assert jolt["median_us"] == pytest.approx(190.0)
    assert jolt["real_time_factor"] == pytest.approx(1000.0 / 190.0)
    assert all("(quoted)" in table.describe_row(row) for row in rows)


def test_the_chart_of_ratios_is_drawn_with_what_could_not_be_compared(tmp_path):
    report = {
        "rows": {
            "rows": [
                {
                    "mesh": "gallbladder",
                    "work": "mss_step",
                    "substeps": None,
                    "ratio_to_naive": 7.0,
                },
                {
                    "mesh": "spleen",
                    "work": "solid_step",
                    "substeps": None,
                    "ratio_to_naive": 3.0,
                },
                {
                    "mesh": "liver",
                    "work": "solid_step",
                    "substeps": None,
                    "ratio_to_naive": 4.0,
                },
            ]
        },
        "trees": {
            "rows": [
                {"work": "refit", "library": "Embree refit", "ratio_to_palpate": 9.0},
                {"work": "closest", "library": "FCL", "ratio_to_palpate": None},
                {"work": "refit", "library": "Palpate", "ratio_to_palpate": 1.0},
            ]
        },
        "peers": {
            "rows": [
                {"peer": "Palpate", "vertices": 5400, "passes": True, "real_time_factor": 6.0},
                {"peer": "Slow", "vertices": 5400, "passes": True, "real_time_factor": 0.5},
                {"peer": "Fast", "vertices": 5400, "quoted": True, "real_time_factor": 12.0},
                {"peer": "Wrong", "vertices": 5400, "passes": False, "tried": []},
            ]
        },
    }
    out = tmp_path / "ratios.png"

    ratio_chart.save_ratio_chart(out, report)

    assert out.read_bytes().startswith(b"\x89PNG")
    rows = ratio_chart.bars_of_rows(report["rows"])
    assert [bar.label for bar in rows] == ["mass-spring step", "step of a solid (spleen)"]
    bars = ratio_chart.bars_of_peers(report["peers"])
    assert [(bar.label, bar.ratio) for bar in bars] == [
        ("Slow", 12.0),
        ("Fast (quoted)", 0.5),
        ("Wrong", None),
    ]
    assert [bar.words for bar in ratio_chart.bars_of_trees(report["trees"])] == [
        "",
        "its results differ: not compared",
    ]
    json.dumps(report)
