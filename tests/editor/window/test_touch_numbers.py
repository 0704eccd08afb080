# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a run as they are kept, plotted and written; and what strokes make of values."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from palpate.runs.pinch import Pinch
from palpate.runs.press import PressScript
from palpate_editor.brush import build_neighbours
from palpate_editor.views.touch import ForcePlot, LiveCosts
from palpate_editor.views.touch.force_trace import ForceTrace, write_csv
from palpate_editor.views.touch.press_form import write_command
from palpate_editor.views.touch.stroke import FixStroke, SmoothStroke, StiffnessStroke
from palpate_editor.views.touch.trial import name_forces, round_up

pytestmark = [pytest.mark.window, pytest.mark.landing]


def trace_of(*sizes: float, name: str = "run") -> ForceTrace:
    """A row every second, pushing along x."""
    trace = ForceTrace(name)
    for time, size in enumerate(sizes):
        trace.add(float(time), [size, 0.0, 0.0])
    return trace


def frame(cost: float, lateness: float = 0.0, missed: int = 0, tick: int = 999):
    return SimpleNamespace(cost=cost, lateness=lateness, missed_ticks=missed, tick=tick)


# ---------------------------------------------------------------- the trace


def test_a_trace_grows_beyond_its_first_room_and_keeps_every_row():
    trace = trace_of(*range(3000))
    assert len(trace) == 3000
    assert trace.size[2999] == 2999.0 and trace.force[17].tolist() == [17.0, 0.0, 0.0]


def test_a_row_that_is_not_later_than_the_last_is_left_out():
    trace = trace_of(1.0, 2.0)
    trace.add(1.0, [9.0, 0.0, 0.0])
    assert len(trace) == 2 and trace.find_peak() == (1.0, 2.0)


def test_the_peak_is_the_greatest_magnitude_and_nothing_where_nothing_was_felt():
    trace = trace_of(0.0, 1.0)
    trace.add(5.0, [0.0, -3.0, 4.0])
    assert trace.find_peak() == (5.0, 5.0)
    assert trace_of(0.0, 0.001).find_peak() is None
    assert ForceTrace("empty").find_peak() is None


def test_the_table_names_every_run_and_its_units():
    text = write_csv([trace_of(0.5, name='a "soft" one'), trace_of(2.0, name="b")])
    assert text.splitlines() == [
        "run,time_s,force_x_N,force_y_N,force_z_N,force_N",
        '"a ""soft"" one",0.0000,0.5,0,0,0.5',
        "b,0.0000,2,0,0,2",
    ]


# ---------------------------------------------------------------- the plot


@pytest.fixture
def plot(qtbot):
    made = ForcePlot()
    qtbot.addWidget(made)
    made.resize(600, 220)
    with qtbot.waitExposed(made):
        made.show()
    return made


def fill(plot, name: str, *sizes: float, step: float = 0.1):
    plot.begin(name)
    for i, size in enumerate(sizes):
        plot.add(step * i, [size, 0.0, 0.0])


def test_the_plot_keeps_the_newest_runs_to_compare_and_says_their_peaks(plot):
    for i in range(6):
        fill(plot, f"Press {i}", 0.0, 1.0 + i)
        plot.finish()
    assert [trace.name for trace in plot.traces] == [f"Press {i}" for i in (2, 3, 4, 5)]
    key = plot._key.text()
    assert "Press 5: 6.00 N" in key and "Press 2: 3.00 N" in key and "Press 1" not in key


def test_the_plot_follows_the_last_ten_seconds_of_a_long_run(plot, qtbot):
    fill(plot, "long", *np.ones(400))  # 40 s
    qtbot.waitUntil(lambda: plot._plot.viewRange()[0][1] > 39.0)
    low, high = plot._plot.viewRange()[0]
    assert low == pytest.approx(29.9, abs=0.3) and high == pytest.approx(39.9, abs=0.3)
    plot.show_all()
    assert plot._plot.viewRange()[0][0] <= 0.0


def test_clearing_forgets_old_runs_but_not_the_one_that_goes_on(plot):
    fill(plot, "old", 1.0)
    plot.finish()
    fill(plot, "new", 1.0, 2.0)
    plot.clear()
    assert [trace.name for trace in plot.traces] == ["new"] and len(plot.traces[0]) == 0
    plot.add(3.0, [1.0, 0.0, 0.0])
    assert len(plot.traces[0]) == 1
    plot.finish()
    plot.clear()
    assert plot.traces == []


def test_both_themes_draw_the_curve_in_their_own_colour(plot):
    fill(plot, "run", 0.0, 1.0, 0.0)
    plot.finish()
    pictures = {}
    for theme in ("dark", "light"):
        plot.use_theme(theme)
        pictures[theme] = plot.grab().toImage()
    assert pictures["dark"] != pictures["light"]


def test_a_disk_that_refuses_is_a_sentence(plot, tmp_path):
    fill(plot, "run", 1.0)
    plot.finish()
    said = []
    plot.failed.connect(said.append)
    (tmp_path / "taken.csv").mkdir()
    plot.export_csv(tmp_path / "taken.csv")
    assert len(said) == 1 and said[0].startswith("The forces were not exported: ")


# ---------------------------------------------------------------- costs


def test_costs_are_shares_of_the_millisecond(qtbot):
    costs = LiveCosts()
    qtbot.addWidget(costs)
    for cost in (0.0002, 0.0004, 0.0003):
        costs.show_frame(frame(cost, lateness=0.00005, missed=3), 1000.0)
    assert costs.text("cost").split() == ["0.300", "ms", "30", "%"]
    assert costs.text("lateness").split() == ["0.050", "ms", "5", "%"]
    assert costs.text("missed") == "3 / 1000"

    costs.show_margin(0.00025, 2.0)
    assert costs.text("margin").split() == ["0.250", "ms", "50", "%"]
    costs.clear()
    assert costs.text("cost") == costs.text("margin")


# ---------------------------------------------------------------- strokes


def test_a_stroke_halfway_to_four_times_is_two_times():
    stroke = StiffnessStroke(np.ones(3), 4.0, 1.0)
    stroke.add(np.array([0, 1]), np.array([1.0, 0.5]))
    stroke.add(np.array([1]), np.array([0.25]))  # reached farther before
    assert stroke.values.tolist() == [4.0, 2.0, 1.0]
    edit = stroke.edit()
    assert edit.vertices.tolist() == [0, 1] and edit.values.tolist() == [4.0, 2.0]


def test_a_stroke_that_changes_nothing_is_no_edit():
    assert StiffnessStroke(np.ones(3), 4.0, 1.0).edit() is None
    fixed = np.array([True, False])
    stroke = FixStroke(fixed, True)
    stroke.add(np.array([0]), np.ones(1))
    assert stroke.edit() is None and fixed.tolist() == [True, False]


def test_smoothing_takes_a_peak_towards_its_neighbours_and_leaves_an_even_organ():
    neighbours = build_neighbours(np.array([[0, 1, 2], [0, 2, 3]]), 4)
    stroke = SmoothStroke(np.array([5.0, 1.0, 1.0, 1.0]), neighbours)
    stroke.add(np.array([0]), np.ones(1))
    assert stroke.values.tolist() == [3.0, 1.0, 1.0, 1.0]

    even = SmoothStroke(np.full(4, 2.0), neighbours)
    even.add(np.arange(4), np.ones(4))
    assert even.edit() is None


# ---------------------------------------------------------------- words


def test_the_legend_ends_at_round_numbers():
    assert [round_up(x) for x in (0.0011, 0.002, 0.0021, 0.03)] == pytest.approx(
        [0.002, 0.002, 0.005, 0.05]
    )


def test_the_command_line_says_all_that_differs_from_a_plain_press():
    plain = write_command("a.palpate", PressScript(6e-3), None)
    assert " ".join(plain) == "palpate press a.palpate --depth 6mm --speed 30mm/s --hold 300ms"
    full = write_command("a.palpate", PressScript(6e-3, 4e-3), np.array([0.01, -0.02, 0.0]))
    assert full[-1] == "--at=10.000,-20.000,0.000" and "4mm" in full


def test_jaws_that_press_have_a_row_beside_the_force_of_their_instrument():
    one, other = (
        SimpleNamespace(force=np.array([0.0, 0.0, size]), turn_limited=False) for size in (3.0, 1.5)
    )
    pinch = Pinch(6.24, 357e3)

    assert name_forces(SimpleNamespace(instruments=(one,)), {}) == [("Force", "3.00 N")]
    assert name_forces(SimpleNamespace(instruments=(one,)), {0: pinch}) == [
        ("Force", "3.00 N"),
        ("Jaws", "6.2 N, 357 kPa > 330"),
    ]
    two = name_forces(SimpleNamespace(instruments=(one, other)), {1: pinch})
    assert [name for name, _ in two] == ["Force 1", "Force 2", "Jaws 2"]
    one.turn_limited = True
    assert name_forces(SimpleNamespace(instruments=(one,)), {})[1:] == [
        ("Turning", "held by tissue")
    ]
