# SPDX-License-Identifier: BSD-3-Clause
"""The multi-rate charts that are committed: of the scenes that ship, and as they come out again.

palpate multirate meshes/published/gallbladder.palpate --out meshes/charts/multirate
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest
from palpate.runs.press import find_top
from palpate.runs.run import read_scene
from palpate.study.multirate import (
    FULL,
    MODES,
    WEAK,
    HandWay,
    draw_rows,
    find_weak_spring,
)

MESHES = Path(__file__).resolve().parents[2] / "meshes"
CHARTS = MESHES / "charts" / "multirate"
NAMES = ("gallbladder", "spleen")
TARGET = 0.05
"""[-] rms of force: what a hand lets pass [accuracy: targets]."""
SAME = 0.02
"""[-] by which a row may come out otherwise on another machine, whose vector code rounds otherwise;
of the largest force, whatever the row is."""


def read_rows(name: str) -> dict[tuple[str, int], dict[str, float]]:
    """By mode and rate."""
    content = json.loads((CHARTS / f"{name}.json").read_text(encoding="utf-8"))
    return {(row["mode"], round(row["rate"])): row for row in content["rows"]}


@pytest.mark.parametrize("name", NAMES)
def test_a_chart_is_of_the_scene_that_ships(name):
    content = json.loads((CHARTS / f"{name}.json").read_text(encoding="utf-8"))
    scene = MESHES / "published" / f"{name}.palpate"

    assert content["format"] == "palpate multirate"
    assert content["scene"] == scene.name
    assert content["scene_sha256"] == hashlib.sha256(scene.read_bytes()).hexdigest()
    assert {(FULL, 1000), (WEAK, 1000)} < set(read_rows(name))
    for mode in MODES:
        drawn = {rate for kind, rate in read_rows(name) if kind == mode}
        assert drawn >= {30, 59, 100, 250, 500, 1000}
    for ending in ("png", "svg"):
        assert (CHARTS / f"{name}.{ending}").stat().st_size > 10_000


@pytest.mark.parametrize("name", NAMES)
def test_only_the_local_stiffness_is_passive_at_every_rate_and_jumps_no_more_than_the_tissue(name):
    rows = read_rows(name)
    full = rows[FULL, 1000]

    for (mode, rate), row in rows.items():
        if mode == "local_stiffness":
            assert row["margin"] > 0.0
            assert row["jump"] <= max(10e-3, 2.0 * full["jump"])
            if rate >= 59:
                assert row["rms"] < TARGET
    assert rows["hold", 30]["margin"] < -0.4
    assert rows["hold", 30]["jump"] > 20.0 * full["jump"]


@pytest.mark.parametrize(("name", "tissue"), [("gallbladder", 49.0), ("spleen", 58.0)])
def test_a_device_that_bears_less_misses_less_than_behind_what_is_always_passive(name, tissue):
    # behind the spring of 9 K nine tenths of a tissue are felt, behind P alone P/(P + K)
    rows, (passive, _) = read_rows(name), find_weak_spring(1000.0)
    full, weak = rows[FULL, 1000], rows[WEAK, 1000]

    assert 0.0 < weak["rms"] < tissue / (passive + tissue)
    assert weak["jump"] <= max(10e-3, 2.0 * full["jump"])
    # a device of that damping takes up a tenth of what the hand puts in, which none of this counts
    assert weak["margin"] > -0.02


def test_up_to_60_hz_it_is_better_than_both_also_of_a_curved_wall():
    for name in NAMES:
        rows = read_rows(name)
        for rate in (30, 59):
            told = rows["local_stiffness", rate]["rms"]
            assert told < rows["hold", rate]["rms"]
            assert told < rows["extrapolation", rate]["rms"]


@pytest.mark.landing
def test_a_part_of_a_chart_comes_out_again():
    scene, kept = read_scene(MESHES / "published" / "gallbladder.palpate"), read_rows("gallbladder")
    way = HandWay(find_top(scene), scene.instruments[0].tool.radius)

    for row in draw_rows(scene, way, [30.0]):
        was = kept[row.mode, round(row.rate)]
        for field in ("rms", "largest", "press", "slip", "release", "margin"):
            assert getattr(row, field) == pytest.approx(was[field], abs=SAME), (row.mode, field)
        assert row.jump == pytest.approx(was["jump"], rel=0.1, abs=1e-3)
