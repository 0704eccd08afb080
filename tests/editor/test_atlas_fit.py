# SPDX-License-Identifier: GPL-3.0-or-later
"""Where an organ is on its atlas, from what is foretold alone."""

from __future__ import annotations

import math
from dataclasses import replace

import palpate
import pytest
from charted import make_block
from made_up_atlases import LIMIT, make_atlas
from palpate.study.atlas import LIMITED
from palpate.study.step_limit import LIMIT_SHARE, foretell_limit
from palpate_editor.atlas import draw_atlas
from palpate_editor.atlas_fit import find_line, find_mark, say_mark
from palpate_editor.atlas_jobs import Plan, run_job
from palpate_editor.atlas_spots import DAMPINGS, Spot, build_tissue
from palpate_editor.chart_jobs import pack_document
from palpate_editor.document import Organ
from palpate_editor.job_pool import run_here


def make_organ(**material: float) -> Organ:
    """The block, of the made up atlas's material and of what is given."""
    organ = make_block()
    values = {"young_modulus": 5e3, "damping_ratio": 0.3} | material
    return replace(organ, material=replace(organ.material, **values))


def test_the_organ_as_the_atlas_knows_it_is_where_the_atlas_says():
    mark = find_mark(make_atlas(), make_organ())

    assert mark.stiffness == 1.0
    assert mark.limit == pytest.approx(LIMIT)
    assert mark.step == pytest.approx(0.5e-3)  # 0.9 ms of 1 ms would do, a tick takes two
    assert mark.margin == pytest.approx(2.0)


@pytest.mark.parametrize("factor", [1e-3, 0.03, 7.0, 1e4])
def test_the_limit_falls_as_the_root_of_stiffness_between_the_rows_and_beyond(factor):
    mark = find_mark(make_atlas(), make_organ(young_modulus=factor * 5e3))

    assert mark.stiffness == pytest.approx(factor)
    assert mark.limit == pytest.approx(LIMIT / math.sqrt(factor), rel=1e-6)
    assert mark.step <= LIMIT_SHARE * mark.limit


def test_more_damping_shortens_the_step_and_less_lengthens_it():
    limits = [
        find_mark(make_atlas(), make_organ(damping_ratio=ratio)).limit
        for ratio in (0.0, 0.1, 0.3, 0.6, 1.0)
    ]

    assert limits == sorted(limits, reverse=True)
    assert limits[0] == pytest.approx(1.1 * LIMIT)
    assert limits[-1] == pytest.approx(0.5 * LIMIT)


def test_least_substeps_count_and_what_was_assessed_comes_first():
    organ = make_organ()
    organ = replace(organ, hand=replace(organ.hand, substeps=5))

    assert find_mark(make_atlas(), organ).step == pytest.approx(0.2e-3)
    assert find_mark(make_atlas(), organ, known=0.15e-3).step == pytest.approx(1e-3 / 8)


def test_what_holds_every_step_has_no_limit_and_what_is_not_there_no_mark():
    organ = make_organ()
    implicit = replace(organ, model=replace(organ.model, integrator="implicit_euler"))
    shell = replace(organ, model=replace(organ.model, kind="shell"))

    mark = find_mark(make_atlas(), implicit)
    assert mark.limit is None
    assert mark.margin == math.inf
    assert "holds every step" in say_mark(mark, implicit)
    assert find_mark(make_atlas(), shell) is None
    assert "no step" in say_mark(None, shell)
    assert find_line(make_atlas(), shell) == []
    # the map shows the usual integrator where its own has no limit
    assert find_line(make_atlas(), implicit)[0].integrator == "symplectic_euler"


def test_chosen_constants_are_as_stiff_as_their_springs():
    organ = make_organ()
    model = replace(organ.model, kind="mass_spring", constants="chosen", stiffness=200.0)

    mark = find_mark(make_atlas("mass_spring"), replace(organ, model=model))

    assert mark.stiffness == 4.0


def test_the_mark_of_changed_constants_is_where_the_tissue_itself_is_foretold():
    """Not a made up atlas: rows of the block, and the block with other constants."""
    organ = make_block()
    spots = [Spot("solid", 1.0, damping, "own") for damping in DAMPINGS]
    points = [(spot, ("symplectic_euler",)) for spot in spots]
    atlas = draw_atlas(Plan(pack_document(organ)), runner=run_here(run_job), points=points)
    assert all(row.outcome == LIMITED for row in atlas.rows)

    for young, ratio, allowed in ((3e4, 0.3, 0.02), (8e3, 0.6, 0.05), (2e3, 0.15, 0.05)):
        material = replace(organ.material, young_modulus=young, damping_ratio=ratio)
        other = replace(organ, material=material)
        tissue = build_tissue(other, Spot("solid", 1.0, "own", "own"))
        exact = foretell_limit(tissue, palpate.Integrator.symplectic_euler)

        assert find_mark(atlas, other).limit == pytest.approx(exact, rel=allowed)
