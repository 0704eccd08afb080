# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts that ship are those of the organs that ship: one row in ten gives the same errors."""

from __future__ import annotations

import re
import shlex
from dataclasses import replace
from pathlib import Path

import pytest
from palpate.cli.main import main
from palpate.cli.press import read_point
from palpate.scene.scene_parts import INTEGRATORS
from palpate.study.chart_file import read_chart
from palpate.study.track import SPEED
from palpate_editor.chart_jobs import Plan, pack_document
from palpate_editor.chart_pool import run_in_processes
from palpate_editor.chart_rerun import EVERY, rerun_chart
from palpate_editor.truth import Press, solve_truth
from palpate_editor.verbs.files import open_any
from palpate_meshes.catalogue import PUBLISHED

CHARTS = PUBLISHED.parent / "charts"
NAMES = sorted(path.stem for path in CHARTS.glob("*.json"))


@pytest.mark.parametrize("name", NAMES)
def test_a_chart_has_sixty_points_or_more(name):
    chart = read_chart(CHARTS / f"{name}.json")

    assert chart.complete
    assert len(chart.list_ran()) >= 60


def rerun_quick_rows(
    organ: Path, chart: Path, place: tuple[float, ...] | None = None
) -> list[dict]:
    """A row in ten, without those of a minute each, which are of other integrators."""
    document, drawn = open_any(organ), read_chart(chart)
    plan = Plan(
        organ=pack_document(document),
        truth=solve_truth(document, Press(place)),
        path="press",
        speed=SPEED,
    )
    rows = [row for row in drawn.rows[::EVERY] if row.configuration.integrator == INTEGRATORS[0]]
    assert len(rows) >= 4
    return rerun_chart(chart, plan, replace(drawn, rows=tuple(rows)), run_in_processes(1), every=1)


@pytest.mark.landing
@pytest.mark.parametrize("name", NAMES)
def test_quick_rows_of_one_in_ten_have_the_same_errors_again(name):
    for row in rerun_quick_rows(PUBLISHED / f"{name}.organ", CHARTS / f"{name}.json"):
        assert row["same"], row


@pytest.mark.verify
@pytest.mark.parametrize("name", NAMES)
def test_a_row_in_ten_has_the_same_errors_again(name, capsys):
    organ, chart = PUBLISHED / f"{name}.organ", CHARTS / f"{name}.json"

    assert main(["chart", str(organ), "--rerun", str(chart)]) == 0, capsys.readouterr().out


@pytest.mark.verify
def test_the_chart_of_an_atlas_kidney_is_of_what_its_lines_make(shared_data, tmp_path):
    text = (CHARTS.parent / "README.md").read_text(encoding="utf-8").split("## Charts")[1]
    said = re.findall(r"^    palpate (.*)$", text, re.MULTILINE)
    *lines, charted = [line for line in said if "atlas_kidney.organ" in line]
    organ, chart = tmp_path / "atlas_kidney.organ", CHARTS / "atlas" / "kidney.json"

    for line in lines:
        words = [str(organ) if word == organ.name else word for word in shlex.split(line)]
        if words[1].endswith(".glb"):
            words[1] = str(shared_data(f"organs/{words[1]}"))
        assert main([*words, "--force"]) == 0

    words = shlex.split(charted)
    place = tuple(map(float, read_point(words[words.index("--place") + 1])))
    assert len(read_chart(chart).list_ran()) >= 60
    for row in rerun_quick_rows(organ, chart, place):
        assert row["same"], row
