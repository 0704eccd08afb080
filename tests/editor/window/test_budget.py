# SPDX-License-Identifier: GPL-3.0-or-later
"""The budget bar: what every part of a scene takes of a tick, in the Test and Publish stages."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import pytest
from hands import log_of
from palpate_editor.views.budget import BODY, CONTACT, TOOL, Budget, Part, read_budget
from palpate_editor.views.budget_bar import BudgetBar, colour_of
from PySide6.QtGui import QColor
from test_live_stage import LONG, press, soft_organ
from touch_context import open_context

pytestmark = [pytest.mark.window, pytest.mark.landing]

from palpate_editor.views.touch import TestPanel  # noqa: E402

US = 1e-6


def cost_of(median: float, p99: float):
    return SimpleNamespace(median=median * US, p99=p99 * US)


def make_costs(tick: float = 500.0, p99: float = 700.0, ticks: int = 900, alarm: bool = False):
    return SimpleNamespace(
        ticks=ticks,
        tick=cost_of(tick, p99),
        bodies=(cost_of(300, 400),),
        instruments=(cost_of(10, 20),),
        pairs=(cost_of(100, 250),),
        alarm=alarm,
    )


def make_budget(**costs) -> Budget:
    return read_budget(make_costs(**costs), 1000.0, ["liver"], ["Tool"], "{tool} on {body}")


@pytest.fixture
def bar(qtbot):
    made = BudgetBar("nothing yet")
    qtbot.addWidget(made)
    made.resize(400, 160)
    made.show()
    return made


def test_a_budget_has_every_body_tool_and_pair_by_name():
    budget = make_budget()

    assert budget.parts == (
        Part(BODY, 0, "liver", 300 * US, 400 * US),
        Part(TOOL, 0, "Tool", 10 * US, 20 * US),
        Part(CONTACT, 0, "Tool on liver", 100 * US, 250 * US),
    )
    assert budget.period == 1e-3
    assert read_budget(make_costs(ticks=0), 1000.0, ["a"], ["b"], "{tool}{body}") is None


def test_the_bar_says_the_shares_of_a_tick_and_every_part(bar):
    bar.show_budget(make_budget())

    assert bar.words.text() == "50 % of a tick, p99 70 %"
    assert bar.words.property("tone") == "warning"
    assert [(name.text(), value.text()) for _, name, value in bar.rows] == [
        ("liver", "300\N{NO-BREAK SPACE}µs"),
        ("Tool", "10\N{NO-BREAK SPACE}µs"),
        ("Tool on liver", "100\N{NO-BREAK SPACE}µs"),
    ]
    spoken, table = bar.accessibleDescription(), bar.toolTip()
    for words in ("liver: 300", "Tool on liver: 100", "p99 250"):
        assert words in spoken
    for words in ("liver", "400", "Whole tick", "500", "700", "1 000", "<table>"):
        assert words in table.replace("\N{NARROW NO-BREAK SPACE}", " ")
    assert bar.accessibleName() == "Cost of a tick"


def test_the_parts_are_drawn_as_long_as_their_share_and_a_line_at_the_p99(bar):
    bar.show_budget(make_budget())
    stack = bar.stack
    picture = stack.grab().toImage()
    middle = picture.height() // 2

    def colour_at(share: float) -> QColor:
        return picture.pixelColor(round(share * (picture.width() - 1)), middle)

    body, tool, contact = bar.budget.parts
    assert colour_at(0.15) == colour_of(body)
    assert colour_at(0.29) == colour_of(body)
    assert colour_at(0.305) == colour_of(tool)
    assert colour_at(0.36) == colour_of(contact)
    assert colour_at(0.60) not in [colour_of(part) for part in bar.budget.parts]
    line = colour_at(0.701)
    assert line != colour_at(0.6)
    assert stack.place(0.7e-3) == pytest.approx(0.7 * stack.width())


def test_a_tick_that_takes_too_long_is_red_and_its_limit_is_drawn(bar):
    bar.show_budget(make_budget(tick=900.0, p99=2000.0))

    assert bar.words.property("tone") == "bad"
    assert bar.stack.place(1e-3) == pytest.approx(0.5 * bar.stack.width())
    picture = bar.stack.grab().toImage()
    limit = picture.pixelColor(round(0.5 * picture.width()) + 1, picture.height() // 2)
    assert limit == QColor("#d64545")


def test_an_alarm_is_said_and_waiting_empties_the_bar(bar):
    bar.show_budget(make_budget(alarm=True))
    assert "An alarm ended the press" in bar.words.text()

    bar.wait("later")

    assert bar.words.text() == bar.toolTip() == bar.accessibleDescription() == "later"
    assert all(name.text() == value.text() == "" for _, name, value in bar.rows)


def test_what_stands_below_a_bar_stays_there_when_it_is_measured(bar):
    before = bar.layout().totalHeightForWidth(bar.width())

    bar.show_budget(make_budget())

    assert bar.layout().totalHeightForWidth(bar.width()) == before


def test_a_run_in_the_test_stage_fills_its_bar(qtbot, settings):
    with open_context(qtbot, soft_organ(), settings) as context:
        panel = TestPanel(context)
        for widget in (panel, panel.plot, panel.costs):
            qtbot.addWidget(widget)
        panel.show()
        assert panel.budget.budget is None
        assert panel.budget.words.text() == "Measured while the organ is felt."
        outcome = press(panel, qtbot)

        budget = panel.budget.budget
        assert [part.name for part in budget.parts] == ["ball", "Tool", "Tool on ball"]
        assert budget.median == outcome.report.part_costs.tick.median > 0.0
        panel.stop()


def test_the_publish_stage_presses_the_organ_in_the_background(window, qtbot):
    """One job for a scene, begun where a person sees what comes of it."""
    window.session.restore(soft_organ(), None)
    panel = window.publish_panel
    assert panel.budget.budget is None

    window.show_stage("publish")

    qtbot.waitUntil(lambda: panel.budget.budget is not None, timeout=LONG)
    assert [part.name for part in panel.budget.budget.parts] == ["ball", "Tool", "Tool on ball"]
    measured = panel.pressed
    window.show_stage("test")
    window.show_stage("publish")
    assert panel.pressed is measured


def test_what_is_late_is_published_once_a_box_is_ticked(window, qtbot, tmp_path):
    late = replace(soft_organ(), title="late")
    late = replace(late, model=replace(late.model, stiffness=2e6, home_stiffness=1e6))
    window.session.restore(late, None)
    panel = window.publish_panel
    window.show_stage("publish")
    qtbot.waitUntil(lambda: panel.slow.isVisible(), timeout=LONG)
    assert window.publishing.refuses()

    panel.slow.click()

    assert not window.publishing.refuses()
    window.publishing.publish(tmp_path / "late.palpate")
    qtbot.waitUntil((tmp_path / "late.palpate").is_file, timeout=LONG)
    qtbot.waitUntil(lambda: "palpate publish" in log_of(window), timeout=LONG)
    assert "--slow" in log_of(window)
    window.session.restore(soft_organ(), None)
    qtbot.waitUntil(lambda: not panel.slow.isVisible(), timeout=LONG)
    assert not window.publishing.slow
