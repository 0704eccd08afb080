# SPDX-License-Identifier: BSD-3-Clause
"""What an advisor chooses, of charts made up by hand."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest
from made_up_charts import make_chart, make_row
from palpate.study.advice import (
    DISPLACEMENT,
    FORCE,
    NOTHING,
    STEP,
    TIME,
    TRUTH,
    Steps,
    Targets,
    advise,
)

TARGETS = Targets(force_error=0.10, displacement_error=0.10, rate=1000.0)
EASY = Steps(count=10, limit=1.0)


def chart_of(*rows, force_error: float = 0.01):
    chart = make_chart()
    held = replace(chart.truth, force_error=force_error, displacement_error=0.01)
    rows = tuple(replace(row, number=i, own=i == 0) for i, row in enumerate(rows))
    return replace(chart, truth=held, rows=rows)


def ask(*rows, targets=TARGETS, steps=None, force_error: float = 0.01):
    chart = chart_of(*rows, force_error=force_error)
    return advise(chart, targets, lambda row: (steps or {}).get(row.number, EASY))


def test_the_cheapest_that_meets_every_target_is_chosen():
    advice = ask(
        make_row(0, cost=4e-4, error=0.01),
        make_row(1, cost=1e-4, error=0.30),
        make_row(2, cost=2e-4, error=0.05),
        make_row(3, cost=3e-4, error=0.02),
    )

    assert advice.fits and advice.choice.row.number == 2
    assert not advice.keeps_own and advice.own.row.number == 0
    assert (advice.tried, advice.ran) == (4, 4)
    assert advice.binding == FORCE  # the next cheaper is 31 % off
    assert advice.cheaper.row.number == 1 and advice.cheaper.misses[0].name == FORCE
    assert advice.better.row.number == 3


def test_a_better_force_on_a_worse_shape_is_not_the_next_better():
    def with_shape(row, shape: float):
        return replace(row, total=replace(row.total, displacement=shape))

    choice = with_shape(make_row(0, cost=2e-4, error=0.05), 0.05)
    springs = with_shape(make_row(1, cost=1e-5, error=0.02), 0.30)
    solid = with_shape(make_row(2, cost=4e-4, error=0.03), 0.05)

    assert ask(choice, springs, solid).better.row.number == 2
    assert ask(choice, springs).better is None


def test_the_errors_of_row_and_truth_are_added():
    rows = make_row(0, error=0.08), make_row(1, cost=2e-4, error=0.03)

    assert ask(*rows, force_error=0.02).choice.row.number == 0
    assert ask(*rows, force_error=0.021).choice.row.number == 1
    assert ask(*rows, force_error=0.021).binding == TRUTH  # 8 % alone would do
    needs = {need.name: need for need in ask(*rows, force_error=0.02).choice.needs}
    assert needs[FORCE].value == pytest.approx(0.10) and needs[FORCE].margin == pytest.approx(0.0)
    assert needs[DISPLACEMENT].value == pytest.approx(0.05)


def test_an_organ_that_is_pressed_deeper_than_charted_is_no_linear_solid():
    linear = make_row(1, cost=1e-4, error=0.02)
    linear = replace(linear, configuration=replace(linear.configuration, kind="linear_solid"))
    rows = make_row(0, cost=2e-4, error=0.03), linear
    depth = abs(make_chart().way.depth)

    for deep, number in (0.0, 1), (depth, 1), (1.01 * depth, 0):
        advice = ask(*rows, targets=replace(TARGETS, depth=deep))
        assert advice.choice.row.number == number
        assert advice.tried == 2 and advice.own.row.number == 0
    alone = ask(linear, targets=replace(TARGETS, depth=2.0 * depth))
    assert alone.choice is None and alone.ran == 0


def test_half_as_much_again_as_the_p99_is_within_a_tick():
    # the p99 of a made-up row is 1.5 times its median
    just = make_row(0, cost=1e-3 / 1.5 / 1.5 * 0.999, error=0.01)
    slow = make_row(0, cost=1e-3 / 1.5 / 1.5 * 1.001, error=0.01)

    assert ask(just).fits
    advice = ask(slow)
    assert not advice.fits and advice.choice.row.number == 0
    assert advice.binding == TIME
    assert advice.choice.worst.value == pytest.approx(1.001e-3)


def test_a_step_too_near_the_limit_gets_more_of_them_and_costs_that_many_times_more():
    # a tick of 1 ms in 10 steps of 0.1 ms, of a limit of 0.11 ms: 0.91 of it
    row = make_row(0, cost=1e-4, error=0.05)
    advice = ask(row, steps={0: Steps(10, 1.1e-4)})

    assert advice.fits
    assert advice.choice.configuration.substeps == 12  # 1 ms / (0.8 x 0.11 ms) = 11.4
    assert advice.choice.cost.median == pytest.approx(1.2e-4)
    assert advice.choice.cost.p99 == pytest.approx(1.2 * 1.5e-4)
    step = advice.choice.needs[-1]
    assert step.name == STEP and step.value == pytest.approx(1.0 / (12 * 0.11))
    assert not advice.keeps_own  # it came with fewer


def test_steps_that_a_tick_in_touch_has_anyway_cost_nothing_more():
    # one step of 1 ms, of a limit of 1 ms: two are needed, and three are made in touch
    advice = ask(make_row(0, cost=1e-4, error=0.05), steps={0: Steps(1, 1e-3)})

    assert advice.choice.configuration.substeps == 2
    assert advice.choice.cost.median == pytest.approx(1e-4)


def test_a_step_that_has_room_stays_as_it_is():
    advice = ask(make_row(0, error=0.05), steps={0: Steps(10, 1.25e-4)})

    assert advice.keeps_own and advice.choice.configuration.substeps == 0
    assert advice.choice.needs[-1].value == pytest.approx(0.8)
    assert ask(make_row(0, error=0.05), steps={0: Steps(1, inf)}).choice.needs[-1].value == 0.0


def test_steps_that_are_added_can_make_another_row_the_cheapest():
    rows = make_row(0, cost=1e-4, error=0.05), make_row(1, cost=1.5e-4, error=0.05)

    assert ask(*rows).choice.row.number == 0
    assert ask(*rows, steps={0: Steps(10, 0.6e-4)}).choice.row.number == 1  # 21 steps, 2.1 times


def test_of_costs_that_cannot_be_told_apart_the_most_accurate_is_taken():
    # medians are known to 10 %
    rows = make_row(0, cost=1e-4, error=0.08), make_row(1, cost=1.15e-4, error=0.04)
    assert ask(*rows).choice.row.number == 1

    rows = make_row(0, cost=1e-4, error=0.08), make_row(1, cost=1.3e-4, error=0.04)
    assert ask(*rows).choice.row.number == 0

    equal = make_row(0, error=0.05), make_row(1, error=0.05)
    assert ask(*equal).choice.row.number == 0
    assert ask(*equal).cheaper is None and ask(*equal).binding == NOTHING


def test_where_one_cost_is_hardly_known_nothing_certainly_cheaper_is_passed_over():
    wide = make_row(0, cost=2e-4, error=0.08)
    wide = replace(wide, cost=replace(wide.cost, least=1e-4, most=1e-3))
    cheap, dear = make_row(1, cost=2.5e-4, error=0.07), make_row(2, cost=4e-4, error=0.02)

    assert ask(wide, cheap, dear).choice.row.number == 1


def test_where_none_fits_the_nearest_miss_says_what_it_misses_and_by_how_much():
    advice = ask(
        make_row(0, cost=5e-3, error=0.01),  # 11 times too slow
        make_row(1, cost=1e-4, error=0.14),  # 15 % of 10 %
        make_row(2, cost=1e-5, error=0.50),
    )

    assert not advice.fits and advice.choice.row.number == 1
    assert [need.name for need in advice.choice.misses] == [FORCE]
    assert advice.choice.misses[0].margin == pytest.approx(-0.5)
    assert advice.binding == FORCE
    assert advice.cheaper.row.number == 2 and advice.better.row.number == 0


def test_the_nearest_miss_counts_the_steps_that_it_lacks():
    near = make_row(0, cost=4e-4, error=0.10)  # 11 % of 10 %, but steps three times too long
    far = make_row(1, cost=1e-4, error=0.12)

    assert ask(near, far).choice.row.number == 0
    assert ask(near, far, steps={0: Steps(3, 1.2e-4)}).choice.row.number == 1


def test_a_truth_that_is_not_good_enough_binds():
    advice = ask(make_row(0, error=0.01), make_row(1, error=0.005), force_error=0.12)

    assert not advice.fits and advice.choice.row.number == 1
    assert advice.binding == TRUTH
    assert advice.better is None  # which of the two is better it cannot tell


def test_what_nobody_looked_at_meets_no_target():
    row = make_row(0, error=0.01)
    blind = replace(row, total=replace(row.total, displacement=None))

    advice = ask(blind)
    assert not advice.fits and advice.binding == DISPLACEMENT
    assert advice.choice.worst.value is None
    assert ask(blind, make_row(1, cost=3e-4, error=0.02)).choice.row.number == 1


def test_where_no_row_ran_there_is_nothing_to_choose():
    for rows in ([], [make_row(0, reason="inside out"), make_row(1, reason="too stiff")]):
        advice = ask(*rows)
        assert advice.choice is None and not advice.fits and not advice.keeps_own
        assert (advice.tried, advice.ran, advice.binding) == (len(rows), 0, NOTHING)
        assert advice.cheaper is advice.better is advice.own is None


def test_rows_that_failed_or_wait_for_their_cost_are_no_candidates():
    waiting = replace(make_row(1, cost=1e-5, error=0.01), cost=None)
    failed = make_row(2, reason="tetrahedron 7 turned inside out")

    advice = ask(make_row(0, error=0.05), waiting, failed)
    assert advice.choice.row.number == 0 and advice.cheaper is None
    assert (advice.tried, advice.ran) == (3, 1)


def test_the_limit_is_asked_for_few_rows_only():
    asked = []

    def find_steps(row):
        asked.append(row.number)
        return EASY

    rows = [make_row(i, cost=1e-5 * 2**i, error=0.5 / 2**i) for i in range(6)]
    advice = advise(chart_of(*rows), TARGETS, find_steps)

    assert advice.choice.row.number == 3  # 6 % and 1 %
    assert sorted(set(asked)) == [0, 2, 3, 4]  # it, its neighbours, and what the organ came with
