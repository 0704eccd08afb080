# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts that ship are those of the organs that ship: one row in ten gives the same errors."""

from __future__ import annotations

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
