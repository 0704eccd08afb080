# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts that ship are those of the organs that ship: one row in ten gives the same errors."""

from __future__ import annotations

import re
import shlex

import pytest
from palpate.cli.main import main
from palpate.study.chart_file import read_chart
from palpate_meshes.catalogue import PUBLISHED

CHARTS = PUBLISHED.parent / "charts"
NAMES = sorted(path.stem for path in CHARTS.glob("*.json"))


@pytest.mark.parametrize("name", NAMES)
def test_a_chart_has_sixty_points_or_more(name):
    chart = read_chart(CHARTS / f"{name}.json")

    assert chart.complete
    assert len(chart.list_ran()) >= 60


@pytest.mark.landing
@pytest.mark.parametrize("name", NAMES)
def test_a_row_in_ten_has_the_same_errors_again(name, capsys):
    organ, chart = PUBLISHED / f"{name}.organ", CHARTS / f"{name}.json"

    assert main(["chart", str(organ), "--rerun", str(chart)]) == 0, capsys.readouterr().err


@pytest.mark.landing
def test_the_chart_of_an_atlas_kidney_is_of_what_its_lines_make(shared_data, tmp_path, capsys):
    text = (CHARTS.parent / "README.md").read_text(encoding="utf-8").split("## Charts")[1]
    *lines, charted = re.findall(r"^    palpate (.*)$", text, re.MULTILINE)
    organ, chart = tmp_path / "atlas_kidney.organ", CHARTS / "atlas" / "kidney.json"

    for line in lines:
        words = [str(organ) if word == organ.name else word for word in shlex.split(line)]
        if words[1].endswith(".glb"):
            words[1] = str(shared_data(f"organs/{words[1]}"))
        assert main([*words, "--force"]) == 0

    words = shlex.split(charted)
    place = words[words.index("--place") + 1]
    assert len(read_chart(chart).list_ran()) >= 60
    rerun = ["chart", str(organ), "--place", place, "--rerun", str(chart)]
    assert main(rerun) == 0, capsys.readouterr().err
