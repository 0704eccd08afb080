# SPDX-License-Identifier: GPL-3.0-or-later
"""What the advisor says of the organs that ship, from the charts that ship, without a run."""

from __future__ import annotations

import pytest
from palpate.study.advice import Targets
from palpate.study.chart_file import read_chart
from palpate_editor.advise import advise_organ
from palpate_editor.document.files import read_organ
from palpate_meshes.catalogue import PUBLISHED
from tiers import keep_everyday

CHARTS = PUBLISHED.parent / "charts"
DEPTH = 0.01
"""[m] A trainee presses and pulls so far."""
SHAPE = {"spleen": 0.05, "kidney": 0.03, "liver": 0.0725}
"""Targets of the table of core/ACCURACY.md [accuracy: advised]."""


@pytest.mark.parametrize("name", keep_everyday(SHAPE, list(SHAPE)[:1]))
def test_the_solids_that_ship_are_the_advisors_choice(name):
    organ, chart = read_organ(PUBLISHED / f"{name}.organ"), read_chart(CHARTS / f"{name}.json")

    advised = advise_organ(organ, chart, Targets(0.10, SHAPE[name], 1000.0, DEPTH), scored=False)

    assert advised.advice.fits and advised.advice.keeps_own


@pytest.mark.landing
@pytest.mark.parametrize("name", SHAPE)
def test_for_a_shallow_press_alone_a_linear_solid_would_do(name):
    organ, chart = read_organ(PUBLISHED / f"{name}.organ"), read_chart(CHARTS / f"{name}.json")

    advised = advise_organ(organ, chart, Targets(0.10, SHAPE[name], 1000.0), scored=False)

    assert advised.advice.fits
    assert advised.advice.choice.configuration.kind == "linear_solid"
