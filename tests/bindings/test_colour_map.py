# SPDX-License-Identifier: BSD-3-Clause
import matplotlib
import numpy as np
import pytest
from palpate.render.colour_map import (
    COLOUR_MAPS,
    build_cool_warm,
    build_legend,
    build_viridis,
    choose_range,
    choose_ticks,
    format_ticks,
)


def luminance(colours):
    linear = (colours / 255.0) ** 2.2
    return linear @ [0.2126, 0.7152, 0.0722]


@pytest.mark.parametrize("name", COLOUR_MAPS)
def test_a_colour_map_has_256_colours(name):
    colours = COLOUR_MAPS[name]()

    assert colours.shape == (256, 3)
    assert colours.dtype == np.uint8


def test_viridis_is_viridis():
    expected = np.round(255 * np.array(matplotlib.colormaps["viridis"].colors))

    assert np.array_equal(build_viridis(), expected)


def test_viridis_runs_from_dark_violet_to_yellow_and_grows_lighter_all_the_way():
    colours = build_viridis()

    assert colours[0].tolist() == [68, 1, 84]
    assert colours[-1].tolist() == [253, 231, 37]
    # neighbours may tie once rounded to eight bits
    assert (np.diff(luminance(colours[::5])) > 0.0).all()


def test_cool_warm_follows_the_published_table():
    # matplotlib interpolates the table in steps of 1/32, we compute every colour
    expected = 255 * matplotlib.colormaps["coolwarm"](np.arange(256))[:, :3]

    assert np.abs(build_cool_warm() - expected).max() < 6


def test_cool_warm_is_blue_below_zero_red_above_and_grey_at_zero():
    colours = build_cool_warm().astype(int)

    assert colours[0, 2] > colours[0, 0] + 100
    assert colours[-1, 0] > colours[-1, 2] + 100
    assert np.ptp(colours[127:129], axis=1).max() <= 3


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (0.0, 5.87, (0.0, 6.0)),
        (0.3, 7.3, (0.0, 8.0)),
        (4.1, 4.9, (4.0, 5.0)),
        (-1.0, 2.2, (-3.0, 3.0)),
        (-3.0, -1.0, (-3.0, 0.0)),
        (0.0, 0.0, (0.0, 1.0)),
        (2e-7, 9.3e-7, (0.0, 1e-6)),
    ],
)
def test_an_automatic_range_has_round_ends_around_the_values(low, high, expected):
    assert choose_range(low, high) == pytest.approx(expected)


@pytest.mark.parametrize("seed", range(20))
def test_an_automatic_range_holds_all_values_and_both_its_ends_are_ticks(seed):
    random = np.random.default_rng(seed)
    values = random.normal(random.normal(), 1.0, 50) * 10.0 ** random.integers(-8, 8)

    legend = build_legend(values)

    slack = 1e-9 * (legend.high - legend.low)
    assert legend.low - slack <= values.min() and values.max() <= legend.high + slack
    assert 3 <= len(legend.ticks) <= 8
    if legend.colour_map == "viridis":
        assert legend.ticks[0] == pytest.approx(legend.low, abs=slack)
        assert legend.ticks[-1] == pytest.approx(legend.high, abs=slack)
    assert not legend.below and not legend.above


def test_labels_say_what_their_ticks_are_worth():
    ticks = choose_ticks(0.0, 2.5)

    exponent, labels = format_ticks(ticks)

    assert exponent == 0
    assert labels == ("0.0", "0.5", "1.0", "1.5", "2.0", "2.5")
    assert ticks == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0, 2.5])


def test_very_small_values_share_a_power_of_ten():
    legend = build_legend([0.0, 9.3e-7])

    values = [float(label) * 10.0**legend.exponent for label in legend.labels]
    assert values == pytest.approx(legend.ticks)
    assert max(len(label) for label in legend.labels) <= 4


def test_values_of_both_signs_get_the_diverging_map_with_zero_in_its_middle():
    legend = build_legend([-1.0, 2.2])

    assert legend.colour_map == "cool_warm"
    assert legend.low == -legend.high
    assert "0" in legend.labels
    assert build_legend([-1.0, 2.2], colour_map="viridis").colour_map == "viridis"


def test_a_given_range_is_kept_and_says_what_lies_beyond_it():
    legend = build_legend([0.0, 3.0, 9.0], value_range=(1.0, 4.0))

    assert (legend.low, legend.high) == (1.0, 4.0)
    assert legend.below and legend.above
    assert all(1.0 <= tick <= 4.0 for tick in legend.ticks)


@pytest.mark.parametrize(
    ("options", "word"),
    [
        ({"values": [0.0, np.nan]}, "finite"),
        ({"values": []}, "at least one"),
        ({"values": [1.0], "value_range": (2.0, 2.0)}, "ascending"),
        ({"values": [1.0], "value_range": (0.0, np.inf)}, "finite"),
        ({"values": [1.0], "colour_map": "jet"}, "viridis"),
    ],
)
def test_a_legend_of_nonsense_is_refused(options, word):
    with pytest.raises(ValueError, match=word):
        build_legend(**options)
